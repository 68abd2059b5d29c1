//! Exact power series of the damped collision and the expansion coefficients they give.

mod field;

pub use field::{Field, ZeroTest};
