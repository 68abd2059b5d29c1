//! Certified real numbers: balls on MPFR with outward rounding.
//!
//! A [`Ball`] is a midpoint and a radius; every operation returns a ball that contains the exact
//! result for every choice of exact operands inside the given balls. This is the only crate of the
//! project that rounds.

mod arithmetic;
mod ball;
pub mod convert;
mod decimal;
mod error;
mod field;
mod functions;
pub mod kronecker;
mod magnitude;

pub use ball::Ball;
pub use error::RealError;
pub use field::{Balls, Field, OrderedField, Rationals, ZeroTest};
pub use magnitude::Magnitude;

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
