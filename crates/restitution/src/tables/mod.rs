//! Generated; see `restitution export`.
pub(crate) mod zero_compression;
pub(crate) mod zero_force;
