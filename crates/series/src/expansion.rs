//! From the trajectories to the coefficients, at one working precision.

use crate::inverse_collision::restitution;
use crate::turning_point::TurningPoint;
use crate::{Quantity, SeriesError, TailBound, Trajectories, TurningPointSum, Units, turning_time};
use num_traits::Zero;
use restitution_law::ForceLaw;
use restitution_real::Ball;

/// The expansions in `u` that the inverse collision needs and gives.
pub(crate) struct Expansion {
    /// `y_0 .. y_N`, the maximal compression (A23).
    pub compression: Vec<Ball>,
    /// `C_0 .. C_N`, the restitution (A30).
    pub restitution: Vec<Ball>,
}

/// Derives both expansions to the given order with balls of `bits` bits.
///
/// Units are chosen so that `T = 1`: all coefficients then live at one absolute precision and every
/// series is summed at 1. The sums leave out less than `2^-tail_bits`, and their radii say so.
pub(crate) fn expand(
    law: &ForceLaw,
    order: usize,
    bits: u32,
    (tail, tail_bits): (&TailBound, u32),
    watch: &mut dyn FnMut(usize),
) -> Result<Expansion, SeriesError> {
    let time = turning_time(law, bits);
    let units = Units { elastic: time.pow(&law.elastic_step()), damping: time.pow(&law.damping_step()) };
    let last = tail.damping_order();
    let trajectories = Trajectories::derive_watched(law, last, tail.terms_for(tail_bits), &units, watch);
    let (position, velocity) = sums_at_turning_point(&trajectories, tail)?;
    let mut compression = TurningPoint::new(law, &units, position, velocity)?.compression()?;
    // What is not known of Y is y_N of even order N, which cancels from C_N: any value will do.
    compression.resize(order + 1, Ball::zero());
    let restitution = restitution(law, &compression)?;
    Ok(Expansion { compression: compression.iter().map(|y| y * &time).collect(), restitution })
}

/// The damping order to which trajectories are needed: `C_N` of even order follows from the lower ones,
/// `y_N` does not.
pub(crate) fn damping_order_for(quantity: Quantity, order: usize) -> usize {
    if quantity != Quantity::Compression && order >= 2 && order.is_multiple_of(2) { order - 1 } else { order }
}

/// `x_n(T)` and `x_n'(T)` in units where `T = 1`; `x_0'(T)` is exactly zero.
fn sums_at_turning_point(
    trajectories: &Trajectories<Ball>,
    tail: &TailBound,
) -> Result<(Vec<Ball>, Vec<Ball>), SeriesError> {
    let mut position = Vec::new();
    let mut velocity = Vec::new();
    for n in 0..=trajectories.damping_order() {
        let mut sum = Ball::zero();
        let mut slope = Ball::zero();
        for (j, q) in trajectories.coefficients(n)?.iter().enumerate() {
            let exponent = trajectories.exponent(n, j);
            slope +=
                q * Ball::from_integer(*exponent.numer(), 64) / Ball::from_integer(*exponent.denom(), 64);
            sum += q;
        }
        let left_out = |part| tail.tail_at_turning_point(part, n, trajectories.terms());
        position.push(sum.widened(&left_out(TurningPointSum::Position)));
        velocity.push(if n == 0 {
            Ball::zero()
        } else {
            slope.widened(&left_out(TurningPointSum::Velocity))
        });
    }
    Ok((position, velocity))
}
