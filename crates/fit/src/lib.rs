//! From tables of collisions as people measure them to the law they follow.
//!
//! [`Data`] reads a file in whatever form it comes; [`fit`](fn@fit) finds the characteristic velocity of its rows, [`adequacy`] tests whether a
//! viscoelastic collision describes them at all, [`compare`] holds other laws against them, and [`stiffness`] finds what
//! durations of contacts say. [`MeasuredLoss`] is a single collision, as exactly as it was typed.

mod adequacy;
mod data;
mod error;
mod fit;
mod laws;
mod measured_loss;
mod measurement;
mod problem;
pub mod sheet;
mod stiffness;

pub use adequacy::{Adequacy, Departure, FALSE_ALARMS, TABLES_PER_FALSE_ALARM, Test, adequacy};
pub use data::{Data, DataError, DataOptions, Method};
pub use error::FitError;
pub use fit::{Fit, Loss, fit};
pub use laws::{Law, LawFit, compare};
pub use measured_loss::MeasuredLoss;
pub use measurement::{LARGEST_MEASURED_EPSILON, Measurement, STANDARD_GRAVITY, bounces};
pub use stiffness::{Stiffness, stiffness};

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
