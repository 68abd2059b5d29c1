use num_rational::BigRational;

/// Why a pair of exponents is not a force law.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LawError {
    /// The elastic exponent must be positive.
    #[error("the elastic exponent must be positive, not {a}: give A > 0, such as 3/2")]
    ElasticExponent {
        /// The exponent that was given.
        a: BigRational,
    },
    /// The damping exponent must exceed -1.
    #[error("the damping exponent must be greater than -1, not {gamma}: give GAMMA > -1, such as 1/2")]
    DampingExponent {
        /// The exponent that was given.
        gamma: BigRational,
    },
    /// The exponents have no common unit of a sensible size.
    #[error(
        "the exponents {law} are too fine or too large: use fractions with a common denominator up to 10^6"
    )]
    TooFine {
        /// The exponents that were given, as A,GAMMA.
        law: String,
    },
    /// The exponent of the rate must be positive: without motion there is no dissipation.
    #[error("the exponent of the rate must be positive, not {beta}: give beta > 0, such as 1")]
    RateExponent {
        /// The exponent that was given.
        beta: BigRational,
    },
    /// An exponent is longer or larger than anyone needs.
    #[error(transparent)]
    Number(#[from] crate::exact::NumberError),
    /// The text is not a pair of exponents.
    #[error("'{text}' is not a force law: write it as A,GAMMA with fractions or decimals, such as 3/2,1/2")]
    NotALaw {
        /// The text that was given.
        text: String,
    },
}
