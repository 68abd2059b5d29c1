//! From the trajectories to the coefficients in balls, for laws whose norms are too large for one proof.

use crate::certified::{Expansion, Goal};
use crate::inverse_collision::restitution;
use crate::turning_point::TurningPoint;
use crate::{SeriesError, TailBound, Trajectories, TurningPointSum, Units, turning_time};
use num_traits::Zero;
use restitution_law::ForceLaw;
use restitution_real::Ball;

/// Bits that ball arithmetic loses for each order in the damping.
const BITS_PER_ORDER: usize = 5;

/// As [`crate::certified::expand`], with balls as coefficients; `None` if the precision is exhausted.
pub(crate) fn by_balls(goal: &Goal, watch: &mut dyn FnMut(usize)) -> Result<Option<Expansion>, SeriesError> {
    let tail = TailBound::find(goal.law, goal.damping)?;
    let mut spare = BITS_PER_ORDER * goal.last + 40;
    loop {
        let bits = u32::try_from(goal.wanted + spare).ok().filter(|&bits| bits as usize <= goal.limit);
        let Some(bits) = bits else { return Ok(None) };
        // The tail is not magnified on its way to the sums, so it may take up half of what is to spare.
        let tail_bits = bits - u32::try_from(spare / 2).unwrap_or(0);
        let expansion = match expand(goal.law, goal.last, bits, (&tail, tail_bits), watch) {
            // A leading coefficient that may be zero at this precision.
            Err(SeriesError::ZeroConstantTerm { .. } | SeriesError::NoPower { .. }) => {
                spare *= 2;
                continue;
            }
            outcome => outcome?,
        };
        let missing = (goal.missing)(&expansion);
        if missing == 0 {
            return Ok(Some(expansion));
        }
        spare += missing + spare / 8 + 16;
    }
}

/// Derives both expansions to the given order with balls of `bits` bits.
///
/// Units are chosen so that `T = 1`: all coefficients then live at one absolute precision and every
/// series is summed at 1. The sums leave out less than `2^-tail_bits`, and their radii say so.
fn expand(
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
    Ok(Expansion { compression: compression.iter().map(|y| y * &time).collect(), restitution, step: 0.0 })
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
