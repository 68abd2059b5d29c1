//! Exact power series of the damped collision and the expansion coefficients they give.
//!
//! | to know | ask |
//! |---|---|
//! | coefficients of `epsilon` and of the largest compression, to any order with any number of proved digits | [`coefficients`], of a [`Quantity`] |
//! | the trajectory as exact series in time | [`Trajectories`], or [`TimeOrder`] up to a power of time |
//! | the end at zero force | [`DelayedRecovery`], exact |
//! | bounds of what is cut off | [`TailBound`] |
//! | the approximate theory of the paper's section III | [`ApproximateTheory`] |
//! | half the duration of the undamped collision | [`turning_time`] |
//!
//! Trajectories come from modular arithmetic, coefficients from fixed-point numbers whose errors are proved afterwards: docs/error-bounds.md has the
//! theorems, docs/notation.md the names.

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
