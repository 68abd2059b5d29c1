//! Exact power series of the damped collision and the expansion coefficients they give.

mod approximate;
mod bounds;
mod certified;
mod coefficients;
mod damped;
mod delayed_recovery;
mod error;
mod expansion;
mod field;
mod field_ball;
mod field_rational;
mod fractional_series;
mod inverse_collision;
mod kernels;
mod linearised;
mod modular;
mod print;
mod trajectories;
mod turning_point;
mod turning_time;
mod undamped;

pub use approximate::ApproximateTheory;
pub use bounds::{BoundError, TailBound, TurningPointSum};
pub use coefficients::{Quantity, coefficients, coefficients_watched, memory_estimate};
pub use delayed_recovery::DelayedRecovery;
pub use error::SeriesError;
pub use field::{Field, ZeroTest};
pub use fractional_series::FractionalSeries;
pub use trajectories::{Trajectories, Units};
pub use turning_time::turning_time;

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
