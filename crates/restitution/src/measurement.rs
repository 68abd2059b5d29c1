//! A table of measured coefficients of restitution.

use core::fmt;

/// The largest coefficient that is taken for a noisy measurement: beyond it the rebound has four times the
/// energy of the impact, and a percentage or a wrong column is likelier than noise.
pub const LARGEST_MEASURED_EPSILON: f64 = 2.0;

/// One measured pair: impact velocity `g` and coefficient of restitution.
///
/// # Examples
///
/// ```
/// use restitution::{FitError, Measurement};
///
/// let noisy = Measurement::new(0.001, 1.02)?; // noise may lift a coefficient above 1
/// assert_eq!(noisy.epsilon(), 1.02);
///
/// assert_eq!(Measurement::new(0.001, 57.0), Err(FitError::Epsilon { value: 57.0 }));
/// # Ok::<(), FitError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    velocity: f64,
    epsilon: f64,
}

impl Measurement {
    /// Returns the pair of impact velocity (m/s, or any unit: `g*` comes out in the same) and coefficient.
    ///
    /// # Errors
    ///
    /// [`FitError::Velocity`] for a velocity that is not positive and finite, [`FitError::Epsilon`] for a
    /// coefficient outside (0, 2].
    pub fn new(velocity: f64, epsilon: f64) -> Result<Self, FitError> {
        if !(velocity > 0.0 && velocity.is_finite()) {
            return Err(FitError::Velocity { value: velocity });
        }
        if !(epsilon > 0.0 && epsilon <= LARGEST_MEASURED_EPSILON) {
            return Err(FitError::Epsilon { value: epsilon });
        }
        Ok(Self { velocity, epsilon })
    }

    /// The impact velocity.
    pub fn velocity(&self) -> f64 {
        self.velocity
    }

    /// The coefficient of restitution.
    pub fn epsilon(&self) -> f64 {
        self.epsilon
    }
}

/// Why a table of measurements does not give a characteristic velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum FitError {
    /// An impact velocity must be positive and finite.
    Velocity {
        /// The value that was given.
        value: f64,
    },
    /// A measured coefficient must be positive, and noise lifts none above 2.
    Epsilon {
        /// The value that was given.
        value: f64,
    },
    /// One parameter and its error need two rows.
    TooFewRows {
        /// The rows at hand.
        rows: usize,
    },
    /// All rows have the same velocity: nothing is said about the curve.
    OneVelocity {
        /// That velocity.
        velocity: f64,
    },
    /// No row lost energy.
    NoDamping {
        /// The rows, all with a coefficient of at least 1.
        rows: usize,
    },
    /// The scatter is so large that `u` is known to no better than half of itself.
    Uninformative {
        /// The standard error of `u`, relative to `u`.
        relative_error: f64,
    },
    /// The velocities span more than f64 can hold.
    OutOfRange,
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Velocity { value } => {
                write!(f, "an impact velocity of {value:?} cannot be used: give a positive number")
            }
            Self::Epsilon { value } => write!(
                f,
                "a measured coefficient of {value:?} cannot be used: give a number above 0 and at most 2, not a percentage"
            ),
            Self::TooFewRows { rows } => write!(
                f,
                "a fit and its error need at least 2 rows, and there are {rows}: invert a single pair instead"
            ),
            Self::OneVelocity { velocity } => write!(
                f,
                "all rows have the velocity {velocity:?}, which says nothing about the curve: average them and invert the pair instead"
            ),
            Self::NoDamping { rows } => write!(
                f,
                "none of the {rows} rows has a coefficient below 1, so no damping can be seen: measure at higher velocities"
            ),
            Self::Uninformative { relative_error } => write!(
                f,
                "the scatter leaves u uncertain by {:.0} %, so that the data say nothing about g*: give more rows or better ones",
                100.0 * relative_error
            ),
            Self::OutOfRange => {
                write!(f, "the fitted g* is beyond the range of f64: check the units of the velocities")
            }
        }
    }
}

impl core::error::Error for FitError {}
