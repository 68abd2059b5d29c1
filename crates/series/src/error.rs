use num_rational::Ratio;

/// Why a series operation or an expansion could not be carried out.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SeriesError {
    /// The operation needs a nonzero constant term.
    #[error("the {operation} of a series needs a constant term that is not zero")]
    ZeroConstantTerm {
        /// The operation that was asked for.
        operation: &'static str,
    },
    /// The leading coefficient has no rational power of this exponent.
    #[error("the coefficient {coefficient} has no rational power {exponent}")]
    NoPower {
        /// The leading coefficient.
        coefficient: String,
        /// The exponent asked for.
        exponent: String,
    },
    /// The result has exponents that are no multiples of the series' step.
    #[error("the result has exponents outside the multiples of 1/{unit}: give the series a finer step")]
    OffLattice {
        /// Lattice steps that make one power of `t`.
        unit: i64,
    },
    /// The result has a negative exponent.
    #[error("the result would begin with the negative power t^({exponent})")]
    NegativeExponent {
        /// The exponent.
        exponent: Ratio<i64>,
    },
    /// Two series count in different fractions of a power.
    #[error("the series have steps 1/{left} and 1/{right}: bring them to one step first")]
    DifferentSteps {
        /// Lattice steps per power on the left.
        left: i64,
        /// Lattice steps per power on the right.
        right: i64,
    },
    /// A coefficient at or beyond the truncation order was asked for.
    #[error("the coefficient of t^({exponent}) is unknown: the series is truncated at O(t^({order}))")]
    BeyondTruncation {
        /// The exponent asked for.
        exponent: Ratio<i64>,
        /// The first unknown exponent.
        order: Ratio<i64>,
    },
    /// The contact of this law does not end at zero force.
    #[error(
        "with the law {law} the force vanishes at no small compression: the zero-force end needs A > GAMMA"
    )]
    NoZeroForceEnd {
        /// The law, as A,GAMMA.
        law: String,
    },
    /// A certified number could not be given.
    #[error(transparent)]
    Real(#[from] restitution_real::RealError),
    /// The errors of the expansion could not be bounded.
    #[error(
        "no error bound could be proved for the expansion of the law {law}: choose exponents A,GAMMA nearer to 3/2,1/2"
    )]
    Unproved {
        /// The law, as A,GAMMA.
        law: String,
    },
    /// The proof holds for lower orders only.
    #[error(
        "order {order} was asked for, but errors are bounded up to order {largest} only: ask for a lower one"
    )]
    OrderTooLarge {
        /// The order asked for.
        order: usize,
        /// The largest order that is proved.
        largest: usize,
    },
    /// A damping order that was not computed was asked for.
    #[error("order {asked} in the damping was asked for, but only orders up to {known} were computed")]
    BeyondDampingOrder {
        /// The order asked for.
        asked: usize,
        /// The highest order known.
        known: usize,
    },
}
