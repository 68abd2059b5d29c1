//! The force law of a collision and what its exponents decide.
//!
//! A [`ForceLaw`] is the one value that carries the exponents of
//!
//! ```text
//! x'' + u x^gamma x' + x^a = 0,    x(0) = 0,  x'(0) = 1
//! ```
//!
//! through the whole project; no other place writes `3/2` or `1/2` down.

mod error;
pub mod exact;
mod force_law;

pub use error::LawError;
pub use force_law::{ForceLaw, Lattice};

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
