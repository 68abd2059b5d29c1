//! Padé approximants of the coefficient of restitution, judged by certified values.
//!
//! [`Expansion`] is the coefficient as a series in a variable, with its certified values and what is known at infinity; [`judge`]
//! finds an approximant of it, proves the digits of its constants and says where its poles and zeros are; [`error_on_range`] and
//! [`error_reach`] compare it with certified values; [`recommended`] tries them all.

mod error;
mod expansion;
mod judgement;
mod recommended;
mod shown;

pub use error::ApproximateError;
pub use expansion::{Expansion, Variable};
pub use judgement::{
    Constant, GRID, Judged, Request, constants, error_on_range, error_reach, first_bits, judge, nearest,
    shown, shown_places,
};

pub use recommended::{
    Candidate, Goal, KNOWN, ONE_POINT_COST, Reached, Span, TWO_POINT_COST, WIDEST, recommended,
};
pub use shown::{decimal, error_bound, error_text};

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
