use crate::PadeType;

/// Why an approximant, or an answer about one, could not be given.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PadeError {
    /// The series is too short for the degrees asked for.
    #[error(
        "{asked} needs {needed} coefficients of the series and only {known} are known: ask for lower degrees or give more coefficients"
    )]
    NotEnoughCoefficients {
        /// The type that was asked for.
        asked: PadeType,
        /// The coefficients it takes, the constant term included.
        needed: usize,
        /// The coefficients that were given.
        known: usize,
    },
    /// A number decides the answer and its enclosure leaves it open, most often because it may be zero.
    #[error("{what} cannot be decided at this precision: give the coefficients to more digits")]
    Undecided {
        /// What is open.
        what: &'static str,
    },
    /// The precision was raised to its limit and the answer was still open.
    #[error(
        "{what} could not be decided with {reached_bits} bits of working precision: it may be a zero, so ask for other degrees or fewer digits"
    )]
    PrecisionExhausted {
        /// What is open.
        what: &'static str,
        /// The precision that was reached.
        reached_bits: u32,
    },
    /// The degrees do not fall off at infinity as the expansion there does.
    #[error(
        "{asked} cannot fall off like x^-{decay}: ask for a denominator {decay} degrees above the numerator"
    )]
    WrongDecay {
        /// The type that was asked for.
        asked: PadeType,
        /// The exponent of the expansion at infinity.
        decay: usize,
    },
    /// More conditions at infinity than the denominator can meet.
    #[error("{asked} can meet at most {limit} conditions at infinity, not {conditions}: give fewer")]
    TooManyConditions {
        /// The type that was asked for.
        asked: PadeType,
        /// The conditions that were given.
        conditions: usize,
        /// The degree of the denominator.
        limit: usize,
    },
    /// A denominator must have a constant term.
    #[error("the denominator vanishes at 0: cancel the common power of x first")]
    PoleAtZero,
    /// The constants of a closed formula have no value at this point.
    #[error(
        "the denominator d_0 of the closed formulas is zero for these coefficients: use the general algorithm"
    )]
    ClosedFormulaFails,
    /// A range without points.
    #[error("the range from {low} to {high} is empty: give a lower end below the upper, neither negative")]
    EmptyRange {
        /// The lower end that was given.
        low: String,
        /// The upper end that was given.
        high: String,
    },
}
