//! From slow compression through the turning point to the way out, in the velocity `v`.

use crate::equation::Equation;
use crate::error::DirectError;
use crate::fixed::{BOUND_BITS, upper_bound};
use crate::phase_arc::PhasePoint;
use crate::stepper::{Stepper, rounded_to_step};
use crate::turning_arc::follow;
use crate::turning_point::{TurningPoint, friction_ratio};
use num_rational::BigRational;
use num_traits::One;
use restitution_real::Ball;
use rug::Float;

/// From slow compression to a point on the way out where the coordinate serves again.
pub(crate) fn rebound(
    equation: &Equation,
    stepper: &mut Stepper,
    from: &PhasePoint,
) -> Result<PhasePoint, DirectError> {
    let turning = enter(equation, from).ok_or_else(|| stepper.vanished())?;
    let rebounding = turn(equation, stepper, turning)?;
    leave(equation, &rebounding).ok_or_else(|| stepper.vanished())
}

/// Passes from `v(z)` to `y(v)` at the velocity of the point.
pub(crate) fn enter(equation: &Equation, point: &PhasePoint) -> Option<TurningPoint> {
    let y = equation.potential(&point.z);
    let speed = Ball::exact(point.v.clone()).with_prec(BOUND_BITS);
    let off = upper_bound(&(&point.energy / &speed));
    // |dy/dv| <= |v| on the way in, where 1 + v K >= 1.
    let rounding = Ball::exact(y.rad().clone());
    let spread = upper_bound(&(&off * (&speed + &off) + rounding));
    let around = y.with_prec(BOUND_BITS).widened(&spread.upper());
    let force = Ball::one() + (&speed + &off) * friction_ratio(equation, &around);
    let energy = upper_bound(&(&spread * upper_bound(&force)));
    let proved = off.is_finite() && spread.is_finite();
    proved.then(|| TurningPoint { v: point.v.clone(), y: y.mid().clone(), energy, spread })
}

/// From slow compression through the turning point until the coordinate serves again.
fn turn(
    equation: &Equation,
    stepper: &mut Stepper,
    start: TurningPoint,
) -> Result<TurningPoint, DirectError> {
    let mut point = start;
    stepper.start_with(0.1 * point.v.to_f64());
    loop {
        let (next, least_force) = stepper.step(f64::INFINITY, |length| {
            let target = Float::with_val(equation.prec, &point.v - length);
            let end = rounded_to_step(&target, length);
            follow(equation, &point, &end).map(|s| ((s.reached, s.least_force), s.slope))
        })?;
        point = next;
        let kinetic = Float::with_val(BOUND_BITS, point.v.square_ref()) / 2u32;
        if point.v < 0 && (kinetic > point.y || least_force.mid() < &0.5) {
            return Ok(point);
        }
    }
}

/// Passes from `y(v)` back to `v(z)` on the way out.
fn leave(equation: &Equation, point: &TurningPoint) -> Option<PhasePoint> {
    let y = Ball::exact(point.y.clone());
    let inverse = BigRational::one() / &equation.coordinate.elastic;
    let z = (&y * equation.rational(&equation.law.elastic_step())).pow(&inverse).mid().clone();
    let off = upper_bound(&((equation.potential(&z) - &y).abs().with_prec(BOUND_BITS) + &point.spread));
    return_to_phase(equation, z, point.v.clone(), off)
}

/// The point `(z, v)` of the way out where, at velocity `v`, the potential energy is that of `z` up to `off`.
pub(crate) fn return_to_phase(equation: &Equation, z: Float, v: Float, off: Ball) -> Option<PhasePoint> {
    let y = equation.potential(&z);
    let speed = Ball::exact(v.clone()).abs().with_prec(BOUND_BITS);
    // |d(v^2)/dy| = 2 |1 - |v| K| <= 2 as long as |v| K <= 2, here for speeds up to half more.
    let around = y.with_prec(BOUND_BITS).widened(&off.upper());
    let ratio =
        upper_bound(&(friction_ratio(equation, &around) * &speed * Ball::from_ratio(3, 2, BOUND_BITS)));
    let room = &speed * &speed - off.shifted(3);
    let proved = room.is_positive() && !(ratio - Ball::from_integer(2, BOUND_BITS)).is_positive();
    proved.then(|| PhasePoint { z, v, energy: off.shifted(1) })
}
