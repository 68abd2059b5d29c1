//! Padé approximants of exact and certified series.
//!
//! An [`Approximant`] `P/Q` of a power series comes from [`approximant`], or from [`two_point`] when
//! it must meet an expansion at infinity too. Everything is generic over an [`OrderedField`](restitution_real::OrderedField): with exact
//! rationals every question has an answer, with balls a question whose answer hangs on a number that
//! may be zero is answered by [`PadeError::Undecided`], and [`with_precision`] asks again with more
//! bits. [`verdict`] says what an approximant is good for.

mod accuracy;
mod approximant;
mod continued_fraction;
mod error;
mod null_vector;
mod pade_type;
mod places;
mod polynomial;
mod precision;
mod rational_function;
mod table_one;
mod two_point;
mod verdict;
mod zeros;

pub use accuracy::{Reach, Sample, WorstError, grid, largest_error, largest_reach, relative_error};
pub use approximant::{Approximant, Contact, approximant};
pub use continued_fraction::{ContinuedFraction, Link};
pub use error::PadeError;
pub use pade_type::PadeType;
pub use places::places;
pub use precision::with_precision;
pub use rational_function::RationalFunction;
pub use table_one::table_one;
pub use two_point::{AtInfinity, two_point};
pub use verdict::{Bounds, Trend, Verdict, verdict};
pub use zeros::{Interval, sign_changes, zeros};

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
