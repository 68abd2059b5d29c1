//! The search for the precision that proves the digits.

use crate::error::DirectError;
use restitution_real::{Ball, RealError};

/// Bits of working precision beyond those of the digits: what one collision loses.
const GUARD_BITS: u32 = 44;
/// The working precision at which the search for digits ends.
const LARGEST_PRECISION: u32 = 1 << 18;

/// Bits beyond the first ones after which a speed that no run tells from 0, or a motion without a step that can be proved,
/// is given up: the time grows like their cube, and what is that small is no rebound that anybody measures.
const FAINT_BITS: u32 = 512;

/// The working precision with which to try `digits` digits first.
pub(crate) fn first_precision(digits: usize) -> u32 {
    u32::try_from(digits).unwrap_or(u32::MAX).saturating_mul(10) / 3 + GUARD_BITS
}

/// Raises the precision, from `first` bits on, until the digits are proved.
pub(crate) fn proved(
    digits: usize,
    first: u32,
    mut enclose: impl FnMut(u32) -> Result<Ball, DirectError>,
) -> Result<Ball, DirectError> {
    let mut prec = first;
    while prec <= LARGEST_PRECISION {
        let last = prec >= first.saturating_add(FAINT_BITS);
        match enclose(prec) {
            Ok(ball) if ball.to_digits(digits).is_some() => return Ok(ball),
            Ok(ball) if !ball.is_finite() && last => return Err(DirectError::Faint { bits: prec }),
            Ok(_) => {}
            Err(DirectError::StepVanished { .. }) if !last => {}
            Err(error) => return Err(error),
        }
        prec += prec / 2;
    }
    Err(RealError::PrecisionExhausted { digits, reached_bits: prec }.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::ops::Pow;

    #[test]
    fn ten_bits_hold_three_digits() {
        assert_eq!([0, 3, 20, 1000].map(first_precision), [44, 54, 110, 3377]);
    }

    #[test]
    fn a_speed_that_no_precision_tells_from_rest_is_given_up() {
        let mut tried = Vec::new();
        let found = proved(10, 80, |prec| {
            tried.push(prec);
            Ok(Ball::whole_line(prec))
        });
        assert!(matches!(found, Err(DirectError::Faint { bits: 607 })), "{found:?}");
        assert_eq!(tried, [80, 120, 180, 270, 405, 607]);
        // What is known at last is given, and a finite enclosure is improved as before.
        let late = |prec| if prec < 400 { Ball::whole_line(prec) } else { Ball::from_ratio(1, 3, prec) };
        assert!(proved(10, 80, |prec| Ok(late(prec))).is_ok());
        let slowly =
            |prec: u32| Ball::from_ratio(1, 3, prec).widened(&rug::Float::with_val(32, 0.5).pow(prec / 32));
        assert!(proved(10, 80, |prec| Ok(slowly(prec))).is_ok());
        // Steps that vanish are tried again as long.
        let vanished = || DirectError::StepVanished { length: "1e-9".into() };
        let few = |prec| if prec < 405 { Err(vanished()) } else { Ok(Ball::from_ratio(1, 3, prec)) };
        assert!(proved(10, 80, few).is_ok());
        assert!(matches!(proved(10, 80, |_| Err(vanished())), Err(DirectError::StepVanished { .. })));
    }
}
