//! What is promised of the f64 functions, read from the one table of bounds.

use restitution::bounds;

/// Units in the last place by which `epsilon` may rise between two arguments in order: rounding, where it is flat.
pub const RISE_ULP: f64 = bounds::STEP_UP.size;
/// Largest error of `epsilon`, in units in the last place.
pub const EPSILON_ULP: f64 = bounds::EPSILON.size;
/// Largest error of `1 - epsilon`, in units in the last place.
pub const LOSS_ULP: f64 = bounds::ONE_MINUS_EPSILON.size;
/// Largest error of `epsilon` from a velocity, in units in the last place.
pub const VELOCITY_ULP: f64 = bounds::EPSILON_OF_VELOCITY.size;
/// Relative distance of the coefficient at `u_of_epsilon` from the one asked for.
pub const INVERSE: f64 = bounds::INVERSE.size;
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
