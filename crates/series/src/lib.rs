//! Exact power series of the damped collision and the expansion coefficients they give.

mod field;
mod field_ball;
mod field_rational;

pub use field::{Field, ZeroTest};
