//! Exact power series of the damped collision and the expansion coefficients they give.

mod approximate;
mod bounds;
mod certified;
mod coefficients;
mod delayed_recovery;
mod error;
mod fractional_series;
mod kernels;
mod modular;
mod print;
mod recurrence;
mod time_order;
mod trajectories;
mod turning_time;
mod vanishing;

pub use approximate::ApproximateTheory;
pub use bounds::{BoundError, TailBound, TurningPointSum};
pub use coefficients::{Quantity, coefficients, coefficients_watched, memory_estimate};
pub use delayed_recovery::DelayedRecovery;
pub use error::SeriesError;
pub use fractional_series::FractionalSeries;
pub use time_order::TimeOrder;
pub use trajectories::Trajectories;
pub use turning_time::turning_time;

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
