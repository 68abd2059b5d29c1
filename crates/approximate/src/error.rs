use num_rational::BigRational;
use restitution_direct::DirectError;
use restitution_law::ForceLaw;
use restitution_pade::PadeError;
use restitution_series::SeriesError;

/// Why the coefficient of restitution has no such approximant, or none was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ApproximateError {
    /// At zero force the coefficient is no power series in `s` or `u`.
    #[error(
        "with the end of contact at zero force there is no power series in {variable}: give --variable sqrt-u"
    )]
    NoPowerSeries {
        /// The variable asked for.
        variable: &'static str,
    },
    /// At zero force the coefficient expands in another root of the damping.
    #[error(
        "with the law {law} and the end of contact at zero force eps expands in powers of u^(1/{steps}), not of sqrt(u): choose another law or end the contact at zero compression"
    )]
    OtherRoot {
        /// The force law.
        law: Box<ForceLaw>,
        /// The root that it expands in.
        steps: i64,
    },
    /// At zero force the coefficient does not fall off like a whole power.
    #[error(
        "with the end of contact at zero force eps does not fall off like a whole power of sqrt(u): leave --at-infinity out, or end the contact at zero compression"
    )]
    NoWholePowerAtZeroForce,
    /// The coefficient does not fall off like a whole power of the variable.
    #[error(
        "with the law {law} eps does not fall off like a whole power of {variable} (u ~ g^({exponent})): leave --at-infinity out"
    )]
    NoWholePower {
        /// The force law.
        law: Box<ForceLaw>,
        /// Its velocity exponent.
        exponent: Box<BigRational>,
        /// The variable.
        variable: &'static str,
    },
    /// The whole range lies where the bodies do not separate.
    #[error(
        "beyond u = {} the bodies never separate and there is no value to compare with: give --range with a smaller end",
        crate::decimal(end)
    )]
    BeyondCriticalDamping {
        /// A little less than the critical damping.
        end: Box<BigRational>,
    },
    /// The law and what is asked of it do not go together.
    #[error(transparent)]
    Law(DirectError),
    /// The law has no expansion to the end at zero force.
    #[error(transparent)]
    NoDelayedRecovery(SeriesError),
    /// The coefficients were not found.
    #[error(transparent)]
    Coefficients(SeriesError),
    /// A value to compare with was not found.
    #[error(transparent)]
    Value(DirectError),
    /// The approximant.
    #[error(transparent)]
    Pade(#[from] PadeError),
}

impl ApproximateError {
    /// Whether the request is at fault, and not what came of it.
    pub fn is_request_at_fault(&self) -> bool {
        match self {
            Self::Coefficients(_) | Self::Value(_) => false,
            Self::Pade(error) => {
                !matches!(error, PadeError::Undecided { .. } | PadeError::PrecisionExhausted { .. })
            }
            _ => true,
        }
    }
}
