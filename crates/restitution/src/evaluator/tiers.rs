//! Cheaper evaluators for a stated tolerance.
//!
//! A simulation that needs `epsilon` to 1e-6 need not pay for 1e-16: the statics here have fewer and
//! lower polynomials. `restitution export` writes such a table for any tolerance and range.

pub use super::tables::tiers::{
    ZERO_COMPRESSION_1E3, ZERO_COMPRESSION_1E6, ZERO_COMPRESSION_1E9, ZERO_FORCE_1E3, ZERO_FORCE_1E6,
    ZERO_FORCE_1E9,
};
pub use super::tier::Tier;
