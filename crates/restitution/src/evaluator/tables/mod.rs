//! The constants of the evaluator, written by `restitution export`.

pub(crate) mod constants;
pub(crate) mod tiers;
pub(crate) mod zero_compression;
pub(crate) mod zero_force;
