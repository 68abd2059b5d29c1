//! How large the coefficients are that a sum leaves out.
//!
//! What is bounded: every coefficient `q_(n,j)` of the trajectories beyond a finite head, for all
//! elastic indices `j` and all damping orders up to the one asked for. Where it is valid and why:
//! `docs/error-bounds.md`, theorem 1. A [`TailBound`] is found once per law and order, at low
//! precision, and serves sums of any precision.

mod decay;
mod error;
mod head;
mod majorant;
mod search;
mod tail_bound;

pub use decay::TurningPointSum;
pub use error::BoundError;
pub use tail_bound::TailBound;
