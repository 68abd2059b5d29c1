//! Rational powers of rational numbers to any number of digits.

use num_rational::{BigRational, Ratio};
use restitution_real::Ball;
use rug::Float;
use rug::ops::Pow;

/// Returns `x^(p/q)` of a positive rational number in a ball of `bits` bits.
///
/// `z = x^(-1/q)` by Newton's iteration `z <- z (1 + r/q)`, `r = 1 - x z^q`, which doubles the right bits
/// and needs no division but by `q`; `x^(p/q) = z^-p`.
///
/// # Error bound
///
/// The radius. The last step is its own proof: exactly, `x^(-1/q) = z (1-r)^(-1/q)`, and for `|r| <= 1/2`, `q >= 2`,
/// `|(1-r)^(-1/q) - 1 - r/q| <= r^2`, because `(1-r)^(-1/q)` has the coefficients `(1/q)_k/k! <= 1/q` and their
/// sum from `k = 2` on is at most `r^2/(q (1-|r|))`. Cost: `O(M(bits) log q)`.
///
/// # Panics
///
/// If `x` is not positive.
pub(crate) fn rational_power(x: &BigRational, exponent: Ratio<i64>, bits: u32) -> Ball {
    let (p, q) = (*exponent.numer(), *exponent.denom());
    let prec = bits.saturating_add(guard(p));
    if q == 1 {
        return Ball::from_rational(x, prec).powi(p).with_prec(bits);
    }
    inverse_root(x, q, prec).powi(-p).with_prec(bits)
}

/// Bits that a power loses, and some to spare.
fn guard(p: i64) -> u32 {
    64 + 2 * bits_of(p)
}

fn bits_of(n: i64) -> u32 {
    64 - n.unsigned_abs().leading_zeros()
}

/// `x^(-1/q)`.
fn inverse_root(x: &BigRational, q: i64, bits: u32) -> Ball {
    let start = Float::with_val(128, Ball::from_rational(x, 128).mid());
    let guess = start.pow(-(Float::with_val(128, 1) / q));
    let mut z = Ball::exact(guess);
    let mut known: u32 = 60;
    // Each step doubles the known bits, less what z^q loses.
    let loss = 8 + bits_of(q);
    let mut steps = vec![bits];
    while let Some(&last) = steps.last()
        && last > known
    {
        steps.push(last / 2 + loss);
    }
    steps.pop();
    for prec in steps.into_iter().rev() {
        z = newton_step(x, q, z.mid(), prec.saturating_add(loss));
        known = prec;
    }
    let _ = known;
    z.with_prec(bits)
}

/// One step from the number `z`, with its error; the whole line if `z` is not close.
fn newton_step(x: &BigRational, q: i64, z: &Float, prec: u32) -> Ball {
    let z = Ball::exact(z.clone()).with_prec(prec);
    let residual = Ball::from_integer(1, prec) - Ball::from_rational(x, prec) * z.powi(q);
    let size = residual.abs_up();
    if size > 0.5 {
        return Ball::whole_line(prec);
    }
    let size = Ball::exact(size);
    let error = (&z * &size * &size).abs_up();
    let step = &residual / Ball::from_integer(q, 64);
    (&z + &z * step).widened(&error)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(p: i64, q: i64) -> BigRational {
        BigRational::new(p.into(), q.into())
    }

    /// By MPFR, with the bits asked for.
    #[test]
    fn powers_are_those_of_mpfr() {
        for (x, p, q) in [
            (ratio(2, 1), 1, 2),
            (ratio(2, 1), -3, 5),
            (ratio(7, 1_000_000), 5, 1),
            (ratio(123_456_789, 2), 17, 12),
            (ratio(1, 3), 1, 9973),
            (ratio(3, 2), -1001, 7),
        ] {
            for bits in [64, 130, 2000] {
                let found = rational_power(&x, Ratio::new(p, q), bits);
                let wide = bits + 100;
                let base = Ball::from_rational(&x, wide).mid().clone();
                let expected = base.pow(Float::with_val(wide, p) / q);
                let error = Float::with_val(wide, found.mid() - &expected).abs();
                let slack = Float::with_val(64, &expected >> (bits + 60));
                assert!(error <= Float::with_val(64, found.rad() + &slack), "{x} {p}/{q} {bits}");
                assert!(*found.rad() <= Float::with_val(64, &expected >> (bits - 2)), "{x} {p}/{q} {bits}");
            }
        }
    }

    #[test]
    fn powers_have_bits_to_lose() {
        assert_eq!([0, 1, -3, 1000].map(bits_of), [0, 1, 2, 10]);
        assert_eq!([1, -3, 1000].map(guard), [66, 68, 84]);
    }

    /// From places that are off by a known part; what is proved is at most twice the square of the residual.
    #[test]
    fn a_step_proves_its_result_or_nothing() {
        for (x, q) in [(2i64, 2i64), (2, 9), (10, 3), (5, 4)] {
            let x = ratio(x, 1);
            let root = Ball::from_rational(&x, 400).mid().clone().pow(-(Float::with_val(400, 1) / q));
            for off in [0.0f64, 1e-30, -1e-30, 1e-3, -1e-3, 0.04, -0.04, 0.25, -0.25] {
                let start = Float::with_val(200, &root * (1.0 + off));
                let residual = (1.0 - (1.0 + off).powi(q as i32)).abs();
                let found = newton_step(&x, q, &start, 200);
                if residual > 0.501 {
                    assert!(!found.is_finite(), "{x} {q} {off}");
                    continue;
                }
                assert!(found.is_finite());
                let error = Float::with_val(400, found.mid() - &root).abs();
                assert!(error <= *found.rad(), "{x} {q} {off}: {found:?}");
                let most = root.to_f64() * residual * residual * 1.3 + 1e-55;
                assert!(found.rad().to_f64() <= most, "{x} {q} {off}: {} {most}", found.rad().to_f64());
                let least = root.to_f64() * residual * residual * 0.7;
                assert!(found.rad().to_f64() >= least, "{x} {q} {off}");
            }
        }
    }
}
