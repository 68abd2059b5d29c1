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
    spread.is_finite().then(|| TurningPoint { v: point.v.clone(), y: y.mid().clone(), energy, spread })
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
        if serves_coordinate(&point, &least_force) {
            return Ok(point);
        }
    }
}

/// Whether the bodies part fast enough: more kinetic than potential energy, or half the force gone.
fn serves_coordinate(point: &TurningPoint, least_force: &Ball) -> bool {
    let kinetic = Float::with_val(BOUND_BITS, point.v.square_ref()) / 2u32;
    point.v.is_sign_negative() && (kinetic > point.y || least_force.mid() < &0.5)
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

#[cfg(test)]
mod tests {
    use super::*;
    use restitution_law::ForceLaw;

    /// Spheres at `z = 1`: `y = 2/5`, `K = u`.
    fn equation(u: f64) -> Equation {
        Equation::new(&ForceLaw::viscoelastic_spheres(), &Ball::from_f64(u, 80), 80)
    }

    fn number(x: f64) -> Float {
        Float::with_val(80, x)
    }

    #[test]
    fn an_error_of_the_speed_is_one_of_the_potential_energy() {
        let point = PhasePoint { z: number(1.0), v: number(0.5), energy: Ball::from_f64(0.01, BOUND_BITS) };
        let turning = enter(&equation(0.5), &point).expect("a sound point");
        // |v - V| <= 0.02, dy/dv <= v: 0.02 (0.5 + 0.02), times the force 1 + 0.52 K with K = 1/2, a little more around.
        let spread = turning.spread.to_f64();
        assert!((0.0104..0.01041).contains(&spread), "{spread}");
        let energy = turning.energy.to_f64();
        assert!((0.013_104..0.0132).contains(&energy), "{energy}");
        let unknown = PhasePoint { energy: Ball::whole_line(BOUND_BITS), ..point };
        assert!(enter(&equation(0.5), &unknown).is_none());
    }

    #[test]
    fn the_coordinate_serves_again_where_bodies_part_fast_or_half_the_force_is_gone() {
        let serves = |v: f64, y: f64, least_force: f64| {
            let (energy, spread) = (Ball::from_f64(0.0, 64), Ball::from_f64(0.0, 64));
            let point = TurningPoint { v: number(v), y: number(y), energy, spread };
            serves_coordinate(&point, &Ball::from_f64(least_force, 64))
        };
        assert!(!serves(-2.0, 2.0, 0.5) && serves(-2.0, 1.99, 0.5) && serves(-2.0, 2.0, 0.49));
        assert!(!serves(2.0, 1.0, 0.1) && !serves(-0.1, 1.0, 0.6));
    }

    #[test]
    fn the_coordinate_serves_where_the_speed_has_room_and_the_force_a_bound() {
        let back = |u: f64, v: f64, off: f64| {
            return_to_phase(&equation(u), number(1.0), number(v), Ball::from_f64(off, BOUND_BITS))
        };
        // 8 off < v^2, at speeds on both sides of 1.
        for v in [-0.5, -1.0, -1.5] {
            let limit = v * v / 8.0;
            let point = back(0.2, v, 0.9 * limit).expect("room");
            assert!((point.energy.to_f64() / (1.8 * limit) - 1.0).abs() < 1e-9, "{v}");
            for beyond in [1.0, 1.1, 1.5] {
                assert!(back(0.2, v, beyond * limit).is_none(), "{v} {beyond}");
            }
        }
        // |v| K <= 2 for speeds up to half more.
        assert!(back(1.2, -0.9, 1e-6).is_some());
        assert!(back(1.7, -0.9, 1e-6).is_none());
    }
}
