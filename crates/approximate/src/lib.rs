//! Padé approximants of the coefficient of restitution, judged by certified values.
//!
//! [`Expansion`] is the coefficient as a series in a variable, with its certified values and what is known at infinity; [`judge`]
//! finds an approximant of it, proves the digits of its constants and says where its poles and zeros are; [`quality`] compares it
//! with certified values; [`judge_series`] does it for numbers that are given; [`map`] does so for a whole corner of the Padé table, [`recommended`] looks for the cheapest, and
//! [`published`] holds printed constants beside what they should be.

mod error;
mod expansion;
mod given;
mod judgement;
mod map;
mod published;
mod quality;
mod recommended;
mod shown;

pub use error::ApproximateError;
pub use expansion::{Expansion, Variable};
pub use given::{JudgedSeries, judge_series};
pub use judgement::{
    Constant, GRID, Judged, Request, constants, error_on_range, error_reach, judge, links, shown_places,
};
pub(crate) use judgement::{first_bits, nearest};
pub use map::{Entry, Found, map};
pub use published::{Published, published};
pub use quality::{FARTHEST, Quality, ValidRange, quality};
pub use recommended::{
    Candidate, Goal, KNOWN, ONE_POINT_COST, Reached, Span, TWO_POINT_COST, WIDEST, recommended,
};
pub use shown::{decimal, error_bound, error_text, rational_digits};

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
