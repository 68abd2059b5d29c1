use restitution_series::SeriesError;

/// Why a closed form or its value could not be given.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ClosedError {
    /// The coefficients asked for go beyond those that Beta values alone give.
    #[error("orders beyond {largest} need more than Beta values, and {order} was asked for: lower the order")]
    BeyondBeta {
        /// The order asked for.
        order: usize,
        /// The largest that Beta values give.
        largest: usize,
    },
    /// The order is beyond what is derived.
    #[error(
        "closed forms are derived up to order {largest} in u, and {order} was asked for: ask for a lower order"
    )]
    BeyondAlgebra {
        /// The order asked for, in whole powers of `u`.
        order: usize,
        /// The largest.
        largest: usize,
    },
    /// A value lies so close to zero, or to a tie, that the largest precision did not prove its digits.
    #[error("{digits} digits could not be proved with {bits} bits: ask for fewer")]
    Precision {
        /// The digits asked for.
        digits: usize,
        /// The precision that was not enough.
        bits: u32,
    },
    /// The exponents are so large that the series of a constant would be endless.
    #[error(
        "a constant of this order needs {terms} terms: lower the order, or take a law with smaller (GAMMA+1)/(A+1)"
    )]
    TooManyTerms {
        /// The number of terms.
        terms: u64,
    },
    /// The law has no such end of contact.
    #[error(transparent)]
    Series(#[from] SeriesError),
}
