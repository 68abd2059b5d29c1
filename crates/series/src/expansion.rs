//! From the trajectories to the coefficients, at one working precision.

use crate::inverse_collision::restitution;
use crate::turning_point::TurningPoint;
use crate::{SeriesError, Trajectories, Units, turning_time};
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

/// Working precision and length of the series.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort {
    /// Bits of every ball.
    pub bits: u32,
    /// Terms of every trajectory.
    pub terms: usize,
}

/// Derives both expansions to the given order.
///
/// Units are chosen so that `T = 1`: all coefficients then live at one absolute precision and every
/// series is summed at 1. Because `y_N` of even order cancels from `C_N`, it may be left out.
pub(crate) fn expand(
    law: &ForceLaw,
    order: usize,
    effort: Effort,
    watch: &mut dyn FnMut(usize),
) -> Result<Expansion, SeriesError> {
    let time = turning_time(law, effort.bits);
    let units = Units { elastic: time.pow(&law.elastic_step()), damping: time.pow(&law.damping_step()) };
    let trajectories = Trajectories::derive_watched(law, order, effort.terms, &units, watch);
    let (position, velocity) = sums_at_turning_point(&trajectories)?;
    let point = TurningPoint::new(law, &units, position, velocity)?;
    let compression = point.compression()?;
    let restitution = restitution(law, &compression)?;
    Ok(Expansion { compression: compression.iter().map(|y| y * &time).collect(), restitution })
}

/// `x_n(T)` and `x_n'(T)` in units where `T = 1`; `x_0'(T)` is exactly zero.
fn sums_at_turning_point(trajectories: &Trajectories<Ball>) -> Result<(Vec<Ball>, Vec<Ball>), SeriesError> {
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
        position.push(sum);
        velocity.push(if n == 0 { Ball::zero() } else { slope });
    }
    Ok((position, velocity))
}
