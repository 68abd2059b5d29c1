//! `epsilon(u)` as source code: tables of polynomials made from certified values.
//!
//! [`InterpolatedCurve`] interpolates values of the certified integrator, [`design`] finds the cheapest table that keeps a
//! tolerance on a range and falls from 1 in floating point too, a [`Listing`] measures it, and [`Language::write`]
//! puts it down. The tables of the crate `restitution` are made in the same way.

mod centred;
mod chebyshev;
mod constants;
mod design;
mod error;
mod evaluator_tables;
mod falling;
mod grid;
mod interpolated_curve;
mod language;
mod listing;
mod loss;
mod near_zero;
mod pieces;
pub mod proof;
mod target;
mod tier_tables;

pub use constants::constants;
pub use design::{Beyond, Request, design};
pub use error::ExportError;
pub use evaluator_tables::{zero_compression_tables, zero_force_tables};
pub use grid::Grid;
pub use interpolated_curve::InterpolatedCurve;
pub use language::{LANGUAGES, Language};
pub use listing::{CharacteristicVelocity, Listing, Observed};
pub use loss::{Loss, Variable};
pub use pieces::{Bound, Pieces, Shape};
pub use target::Law;
pub use tier_tables::tier_tables;

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
