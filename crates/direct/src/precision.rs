//! The search for the precision that proves the digits.

use crate::error::DirectError;
use restitution_real::{Ball, RealError};

/// Bits of working precision beyond those of the digits: what one collision loses.
const GUARD_BITS: u32 = 44;
/// The working precision at which the search for digits ends.
const LARGEST_PRECISION: u32 = 1 << 18;

/// How often a step that cannot be proved is tried again at higher precision.
const RETRIES: u32 = 4;

/// The working precision with which to try `digits` digits first.
pub(crate) fn first_precision(digits: usize) -> u32 {
    u32::try_from(digits).unwrap_or(u32::MAX / 8).saturating_mul(10) / 3 + GUARD_BITS
}

/// Raises the precision, from `first` bits on, until the digits are proved.
pub(crate) fn proved(
    digits: usize,
    first: u32,
    mut enclose: impl FnMut(u32) -> Result<Ball, DirectError>,
) -> Result<Ball, DirectError> {
    let mut prec = first;
    let mut vanished = 0;
    while prec <= LARGEST_PRECISION {
        match enclose(prec) {
            Ok(ball) if ball.to_digits(digits).is_some() => return Ok(ball),
            Ok(_) => {}
            Err(DirectError::StepVanished { .. }) if vanished < RETRIES => vanished += 1,
            Err(error) => return Err(error),
        }
        prec += prec / 2;
    }
    Err(RealError::PrecisionExhausted { digits, reached_bits: prec }.into())
}
