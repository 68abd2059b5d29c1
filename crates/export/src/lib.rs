//! `epsilon(u)` as source code: tables of polynomials made from certified values.
//!
//! [`Reference`] interpolates values of the certified integrator, [`design`] finds the cheapest table
//! that keeps a tolerance on a range, a [`Listing`] measures it, and [`Language::write`] puts it down.
//! `evaluator_tables` makes the tables of the crate `restitution` in the same way.

mod chebyshev;
mod constants;
mod design;
mod error;
mod evaluator_tables;
mod language;
mod listing;
mod near_zero;
mod pieces;
mod reference;

pub use constants::constants;
pub use design::design;
pub use error::ExportError;
pub use evaluator_tables::{tier_tables, zero_compression_tables, zero_force_tables};
pub use language::Language;
pub use listing::Listing;
pub use pieces::{Bound, Grid, Pieces, Variable};
pub use reference::Reference;
