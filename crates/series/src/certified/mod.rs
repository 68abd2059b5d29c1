//! The certified way: approximations in fixed point, and one proof for each object afterwards.
mod attempt;
mod damped;
mod inverse;
mod inverse_proof;
mod motion_proof;
mod one_variable;
mod plan;
mod power_rows;
mod response;
mod sketch;
mod turning;
mod turning_proof;
mod undamped;
mod units;

pub(crate) use attempt::{Expansion, LARGEST_ORDER};
pub(crate) use plan::{Goal, Unproved, expand, memory_estimate};
