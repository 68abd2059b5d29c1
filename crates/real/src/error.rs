/// Why a certified number could not be given.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RealError {
    /// The working precision was raised to its limit and the digits were still not there.
    #[error(
        "{digits} digits could not be proved with {reached_bits} bits of working precision: ask for fewer digits"
    )]
    PrecisionExhausted {
        /// The digits that were asked for.
        digits: usize,
        /// The working precision that was reached.
        reached_bits: u32,
    },
}
