//! Fixed-point numbers: integers in units of `2^-bits`, every rounding counted.
//!
//! The coefficients of one Taylor step all live at one absolute precision, so products of integers
//! with a counted error serve better than balls with a radius each.

use restitution_real::Ball;
use rug::float::Round;
use rug::{Float, Integer};

/// Bits of an upper bound.
pub(crate) const BOUND_BITS: u32 = 64;

/// The bound 0.
pub(crate) fn zero() -> Ball {
    Ball::exact(Float::new(BOUND_BITS))
}

/// Rounds a ball to a multiple of `2^-bits` and adds the largest possible difference to `error`.
///
/// An infinite ball makes `error` infinite.
pub(crate) fn to_fixed(ball: &Ball, bits: u32, error: &mut Ball) -> Integer {
    let shifted = shifted(ball.mid(), i64::from(bits));
    match shifted.to_integer_round(Round::Nearest) {
        Some((value, direction)) if ball.is_finite() => {
            if !ball.is_exact() {
                *error += Ball::exact(ball.rad().clone());
            }
            if direction.is_ne() {
                *error += unit(bits);
            }
            value
        }
        _ => {
            *error = Ball::whole_line(BOUND_BITS);
            Integer::new()
        }
    }
}

/// Rounds to fixed point where nothing may be lost; `None` if something would be.
pub(crate) fn exact_fixed(ball: &Ball, bits: u32) -> Option<Integer> {
    let mut lost = zero();
    let value = to_fixed(ball, bits, &mut lost);
    (lost.is_exact() && lost.mid().is_zero()).then_some(value)
}

/// The number `value * 2^-bits`, rounded to `prec` bits.
pub(crate) fn from_fixed(value: &Integer, bits: u32, prec: u32) -> Ball {
    Ball::from_big_integer(value, prec).shifted(-to_i32(i64::from(bits)))
}

/// The unit `2^-bits`, exactly.
pub(crate) fn unit(bits: u32) -> Ball {
    power_of_two(-i64::from(bits))
}

/// `2^exponent`, exactly.
pub(crate) fn power_of_two(exponent: i64) -> Ball {
    Ball::exact(shifted(&Float::with_val(BOUND_BITS, 1), exponent))
}

/// An upper bound of a ball as an exact number of few bits.
pub(crate) fn upper_bound(ball: &Ball) -> Ball {
    if !ball.is_finite() {
        return Ball::whole_line(BOUND_BITS);
    }
    Ball::exact(Float::with_val_round(BOUND_BITS, ball.upper(), Round::Up).0)
}

/// A lower bound of a ball as an exact number of few bits.
pub(crate) fn lower_bound(ball: &Ball) -> Ball {
    if !ball.is_finite() {
        return Ball::whole_line(BOUND_BITS);
    }
    Ball::exact(Float::with_val_round(BOUND_BITS, ball.lower(), Round::Down).0)
}

/// The sum of `|c_k| 2^-bits` over a slice, rounded up.
pub(crate) fn size(coefficients: &[Integer], bits: u32) -> Ball {
    let mut sum = Integer::new();
    for c in coefficients {
        sum += &*c.as_abs();
    }
    upper_bound(&from_fixed(&sum, bits, BOUND_BITS))
}

/// `x * 2^shift` for any shift that MPFR's exponents can take.
pub(crate) fn shifted(x: &Float, shift: i64) -> Float {
    let mut out = x.clone();
    out <<= to_i32(shift);
    out
}

fn to_i32(n: i64) -> i32 {
    n.clamp(i32::MIN.into(), i32::MAX.into()) as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_to_a_unit_is_counted() {
        let mut error = Ball::exact(Float::new(BOUND_BITS));
        let third = to_fixed(&Ball::from_ratio(1, 3, 100), 4, &mut error);
        assert_eq!(third, 5);
        assert!(error.upper() >= 1.0 / 3.0 - 5.0 / 16.0);
        assert!(from_fixed(&third, 4, 64).contains(&Ball::from_ratio(5, 16, 64)));
    }

    #[test]
    fn what_is_lost_is_at_least_what_it_is_said_to_be() {
        let of = |ball: &Ball, before: f64| {
            let mut error = Ball::from_f64(before, BOUND_BITS);
            (to_fixed(ball, 4, &mut error), error.to_f64())
        };
        // Nothing, a unit for the rounding, the radius, both; the error grows.
        assert_eq!(of(&Ball::from_ratio(-5, 16, 64), 0.5), (Integer::from(-5), 0.5));
        assert_eq!(of(&Ball::from_f64(0.3, 64), 0.5), (Integer::from(5), 0.5 + 1.0 / 16.0));
        let wide = |mid: f64| Ball::from_f64(mid, 64).widened(&Float::with_val(64, 0.25));
        assert_eq!(of(&wide(0.3125), 0.5), (Integer::from(5), 0.75));
        assert_eq!(of(&wide(0.3), 0.5), (Integer::from(5), 0.75 + 1.0 / 16.0));
        let mut error = zero();
        assert_eq!(to_fixed(&Ball::whole_line(64), 4, &mut error), 0);
        assert!(!error.is_finite());
        let lossless = |ball: &Ball| exact_fixed(ball, 4);
        assert_eq!(lossless(&Ball::from_ratio(5, 16, 64)), Some(Integer::from(5)));
        for lossy in [Ball::from_f64(0.3, 64), wide(0.3125), Ball::whole_line(64)] {
            assert!(lossless(&lossy).is_none());
        }
    }

    #[test]
    fn bounds_lie_outside() {
        let third = Ball::from_ratio(1, 3, 100).widened(&Float::with_val(64, 0.125));
        let (low, high) = (lower_bound(&third), upper_bound(&third));
        assert!(low.is_exact() && high.is_exact() && low.prec() == BOUND_BITS && high.prec() == BOUND_BITS);
        assert!(*low.mid() <= third.lower() && *low.mid() > 0.2083);
        assert!(*high.mid() >= third.upper() && *high.mid() < 0.4584);
        for none in [lower_bound(&Ball::whole_line(64)), upper_bound(&Ball::whole_line(64))] {
            assert!(!none.is_finite());
        }
        assert_eq!(size(&[3, -5, 0].map(Integer::from), 4).to_f64(), 0.5);
        let many = size(&[(Integer::from(1) << 70) + 1, Integer::from(-1)], 4);
        assert!(*many.mid() > (Integer::from(1) << 66) && *many.mid() < (Integer::from(1) << 66) + 16);
        assert_eq!((unit(4).to_f64(), power_of_two(3).to_f64()), (0.0625, 8.0));
        assert_eq!(shifted(&Float::with_val(64, 3), 2), 12);
        assert_eq!(shifted(&Float::with_val(64, 3), i64::MIN), 0);
        assert!(shifted(&Float::with_val(64, 3), i64::MAX).is_infinite());
    }
}
