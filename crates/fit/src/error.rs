use thiserror::Error;

/// Why a table of measurements does not give a characteristic velocity.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum FitError {
    /// An impact velocity must be positive and finite.
    #[error("an impact velocity of {value:?} cannot be used: give a positive number")]
    Velocity {
        /// The value that was given.
        value: f64,
    },
    /// A measured coefficient must be positive, and noise lifts none above 2.
    #[error(
        "a measured coefficient of {value:?} cannot be used: give a number above 0 and at most 2, not a percentage"
    )]
    Epsilon {
        /// The value that was given.
        value: f64,
    },
    /// A standard deviation must be positive and finite.
    #[error("a standard deviation of {value:?} cannot be used: give a positive number")]
    Sigma {
        /// The value that was given.
        value: f64,
    },
    /// A height must be positive and finite.
    #[error("a height of {value:?} cannot be used: give a positive number")]
    Height {
        /// The value that was given.
        value: f64,
    },
    /// The acceleration of gravity must be positive and finite.
    #[error("the acceleration of gravity must be positive, not {value:?}: give one such as 9.81 m/s^2")]
    Gravity {
        /// The value that was given.
        value: f64,
    },
    /// A collision that is inverted alone has lost something and kept something.
    #[error(
        "a coefficient of restitution of {epsilon:?} has no damping that belongs to it: give a number strictly between 0 and 1"
    )]
    NothingLost {
        /// The coefficient.
        epsilon: f64,
    },
    /// A duration must be positive and finite.
    #[error("a contact duration of {value:?} cannot be used: give a positive number")]
    Duration {
        /// The value that was given.
        value: f64,
    },
    /// Each row has one duration.
    #[error("there are {durations} durations of {rows} rows: give one for each")]
    Durations {
        /// The rows at hand.
        rows: usize,
        /// The durations at hand.
        durations: usize,
    },
    /// Two flights, that is three increasing times, make a collision.
    #[error(
        "{number} times of impacts make no collision: give at least three, each later than the one before"
    )]
    BounceTimes {
        /// The times at hand.
        number: usize,
    },
    /// Some rows have a standard deviation and some have none.
    #[error("some rows have a standard deviation and some have none: give it for all or for none")]
    MixedSigma,
    /// One parameter and its error need two rows.
    #[error("a fit and its error need at least 2 rows, and there are {rows}: invert a single pair instead")]
    TooFewRows {
        /// The rows at hand.
        rows: usize,
    },
    /// All rows have the same velocity: nothing is said about the curve.
    #[error(
        "all rows have the velocity {velocity:?}, which says nothing about the curve: average them and invert the pair instead"
    )]
    OneVelocity {
        /// That velocity.
        velocity: f64,
    },
    /// No row lost energy.
    #[error(
        "none of the {rows} rows has a coefficient below 1, so no damping can be seen: measure at higher velocities"
    )]
    NoDamping {
        /// The rows, all with a coefficient of at least 1.
        rows: usize,
    },
    /// The scatter is so large that `u` is known to no better than half of itself.
    #[error("the scatter leaves u uncertain by {percent:.0} %, so that the data say nothing about g*: give more rows or better ones", percent = 100.0 * relative_error)]
    Uninformative {
        /// The standard error of `u`, relative to `u`.
        relative_error: f64,
    },
    /// At the fitted value no row depends on `g*`.
    #[error(
        "the coefficients lie where epsilon does not change with g*, so that the data say nothing about it: check the columns, and the units of the velocities"
    )]
    Insensitive,
    /// The velocities span more than f64 can hold.
    #[error("the fitted g* is beyond the range of f64: check the units of the velocities")]
    OutOfRange,
}
