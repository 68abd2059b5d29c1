//! What is promised of the f64 functions, as `docs/evaluator.md` and the documentation of each state it.

/// Units in the last place by which `epsilon` may rise between two arguments in order: rounding, where it is flat.
pub const RISE_ULP: u64 = 1;
/// Largest error of `epsilon`, of `1 - epsilon`, and of `epsilon` from a velocity, in units in the last place.
pub const EPSILON_ULP: f64 = 2.0;
/// See [`EPSILON_ULP`].
pub const LOSS_ULP: f64 = 4.0;
/// See [`EPSILON_ULP`].
pub const VELOCITY_ULP: f64 = 3.0;
/// Relative distance of the coefficient at `u_of_epsilon` from the one asked for; as
/// `docs/evaluator.md` and `inverse.rs` state it.
pub const INVERSE: f64 = 1e-15;
/// `epsilon + (1 - epsilon)` from both functions against 1: their bounds, in units of 2^-53.
pub const SUM: f64 = 6.0 * f64::EPSILON / 2.0;

/// Whether a batch gives what single calls give: to the bit.
pub fn same(single: f64, batch: f64) -> bool {
    single.to_bits() == batch.to_bits() || (single.is_nan() && batch.is_nan())
}

/// Whether `x` is a number from 0 on, -0 included: what has a coefficient of restitution.
pub fn is_damping(x: f64) -> bool {
    x >= 0.0
}

/// The distance of two numbers of equal sign in steps from neighbour to neighbour.
pub fn steps(one: f64, other: f64) -> u64 {
    one.to_bits().abs_diff(other.to_bits())
}
