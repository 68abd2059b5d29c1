//! Why a material, a measurement or a code's input could not be used.

use crate::End;
use core::fmt;

/// Why a physical quantity could not be computed.
///
/// Values are in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum MaterialError {
    /// A quantity must be positive and finite.
    NotPositive {
        /// The name of the quantity.
        quantity: &'static str,
        /// The value that was given.
        value: f64,
    },
    /// A quantity must be at least zero and finite.
    Negative {
        /// The name of the quantity.
        quantity: &'static str,
        /// The value that was given.
        value: f64,
    },
    /// Poisson's ratio of a stable isotropic solid lies between -1 and 1/2.
    PoissonRatio {
        /// The value that was given.
        value: f64,
    },
    /// A coefficient of restitution that can be inverted lies strictly between 0 and 1.
    Epsilon {
        /// The value that was given.
        value: f64,
    },
    /// Eq. (4) divides by the square of Poisson's ratio.
    FormulaDiverges,
    /// The formula divides by `3 eta_2 + 2 eta_1`, or both bodies of a contact are rigid.
    NothingDeforms {
        /// What is zero.
        quantity: &'static str,
    },
    /// The inputs are sound, but the result is too large or too small for f64.
    OutOfRange {
        /// The name of the result.
        quantity: &'static str,
    },
    /// The code ends every contact at the other end.
    EndNotOffered {
        /// The code.
        code: &'static str,
        /// The end that was asked for.
        end: End,
    },
    /// The course of a collision is followed up to a certain damping.
    NotFollowed {
        /// The damping parameter `u`.
        u: f64,
    },
    /// The lines of the code name the materials of both bodies.
    MaterialsMissing {
        /// The code.
        code: &'static str,
    },
    /// No input of the code makes this coefficient.
    EpsilonNotOffered {
        /// The code.
        code: &'static str,
        /// The coefficient that was wanted.
        value: f64,
    },
    /// The time step that was asked about is outside the range where the error was measured.
    TimeStepRange {
        /// The damping parameter `u`.
        u: f64,
        /// The largest `u` of that range.
        largest: f64,
    },
}

impl fmt::Display for MaterialError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotPositive { quantity, value } => {
                write!(f, "the {quantity} is {value:?}: give a positive number")
            }
            Self::Negative { quantity, value } => {
                write!(f, "the {quantity} is {value:?}: give a number of at least 0")
            }
            Self::PoissonRatio { value } => {
                write!(f, "Poisson's ratio is {value:?}: give a number greater than -1 and at most 1/2")
            }
            Self::Epsilon { value } => write!(
                f,
                "a coefficient of restitution of {value:?} has no damping that belongs to it: give a number strictly between 0 and 1"
            ),
            Self::MaterialsMissing { code } => {
                write!(
                    f,
                    "{code} is told the materials of both bodies: give Young's modulus and Poisson's ratio"
                )
            }
            Self::FormulaDiverges => write!(
                f,
                "eq. (4) divides by the square of Poisson's ratio, which is 0: use the formula of 2015"
            ),
            Self::NothingDeforms { quantity } => {
                write!(f, "the {quantity} is 0: give at least one positive value")
            }
            Self::OutOfRange { quantity } => {
                write!(f, "the {quantity} is beyond the range of f64: check the units of the input")
            }
            Self::EndNotOffered { code, end } => {
                let (asked, other) = match end {
                    End::ZeroCompression => ("zero compression", "zero force"),
                    End::ZeroForce => ("zero force", "zero compression"),
                };
                write!(f, "{code} does not end a contact at {asked}: ask for {other}")
            }
            Self::NotFollowed { u } => write!(
                f,
                "durations are known up to u = {:?} only, and u is {u:?}: measure at a lower velocity",
                crate::LARGEST_FOLLOWED_U
            ),
            Self::EpsilonNotOffered { code, value } => {
                write!(
                    f,
                    "no input of {code} makes a coefficient of {value:.4}: give one nearer to the middle, or another code"
                )
            }
            Self::TimeStepRange { u, largest } => write!(
                f,
                "the error of a time step was measured up to u = {largest} and dt = tau/10 only, and u is {u:?}: take a smaller step or velocity"
            ),
        }
    }
}

impl core::error::Error for MaterialError {}

/// Returns `value` if it is positive and finite.
pub(crate) fn positive(quantity: &'static str, value: f64) -> Result<f64, MaterialError> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(MaterialError::NotPositive { quantity, value })
    }
}

/// Returns `value` if it is at least zero and finite.
pub(crate) fn at_least_zero(quantity: &'static str, value: f64) -> Result<f64, MaterialError> {
    if value >= 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(MaterialError::Negative { quantity, value })
    }
}

/// Returns a computed `value` if it is a normal positive number: neither overflow nor underflow.
pub(crate) fn in_range(quantity: &'static str, value: f64) -> Result<f64, MaterialError> {
    if value > 0.0 && value.is_normal() { Ok(value) } else { Err(MaterialError::OutOfRange { quantity }) }
}

/// Returns a computed `value` if it is finite: it may vanish, but neither overflow nor be undefined.
pub(crate) fn finite(quantity: &'static str, value: f64) -> Result<f64, MaterialError> {
    if value.is_finite() { Ok(value) } else { Err(MaterialError::OutOfRange { quantity }) }
}
