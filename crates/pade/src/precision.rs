use crate::PadeError;

/// Asks `question` with more and more bits until it is decided.
///
/// The precision starts at `start_bits` and doubles while the inner answer is
/// [`PadeError::Undecided`]. The outer result is for what can fail besides: giving the coefficients
/// with that many bits.
///
/// # Errors
///
/// [`PadeError::PrecisionExhausted`] once the next step would exceed `limit_bits`; every other error
/// as it is.
///
/// # Examples
///
/// ```
/// use restitution_pade::{PadeError, with_precision};
///
/// let needs_200 = |bits: u32| -> Result<_, PadeError> {
///     Ok(if bits < 200 { Err(PadeError::Undecided { what: "it" }) } else { Ok(bits) })
/// };
/// assert_eq!(with_precision(64, 1024, needs_200), Ok(256));
/// assert!(matches!(with_precision(64, 128, needs_200), Err(PadeError::PrecisionExhausted { .. })));
/// ```
pub fn with_precision<T, E: From<PadeError>>(
    start_bits: u32,
    limit_bits: u32,
    mut question: impl FnMut(u32) -> Result<Result<T, PadeError>, E>,
) -> Result<T, E> {
    let mut bits = start_bits.max(1);
    loop {
        match question(bits)? {
            Err(PadeError::Undecided { what }) if bits > limit_bits / 2 => {
                return Err(PadeError::PrecisionExhausted { what, reached_bits: bits }.into());
            }
            Err(PadeError::Undecided { .. }) => bits *= 2,
            decided => return Ok(decided?),
        }
    }
}

#[cfg(test)]
mod tests;
