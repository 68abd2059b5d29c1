//! From tables of collisions as people measure them to the law they follow.
//!
//! [`Data`] reads a file in whatever form it comes.

mod adequacy;
mod data;
mod error;
mod fit;
mod laws;
mod measurement;
mod problem;
pub mod sheet;
mod stiffness;

pub use adequacy::{Adequacy, Departure, FALSE_ALARMS, Test, adequacy};
pub use data::{Data, DataError, DataOptions, Method};
pub use error::FitError;
pub use fit::{Fit, Loss, fit};
pub use laws::{Law, LawFit, compare};
pub use measurement::{LARGEST_MEASURED_EPSILON, Measurement, STANDARD_GRAVITY, bounces};
pub use stiffness::{Stiffness, stiffness};

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
