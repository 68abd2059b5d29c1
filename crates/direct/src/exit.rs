//! The way out to zero compression, in the coordinate `z`.

use crate::compression::{first_order_defect, near_zero};
use crate::error::DirectError;
use crate::field::Field;
use crate::fixed::upper_bound;
use crate::phase_arc::{PhaseArc, PhasePoint, velocity_near};
use crate::stepper::Stepper;
use num_traits::One;
use restitution_real::Ball;
use rug::Float;

/// Follows the way out to zero compression; `seen` gets every arc and may end the motion early.
pub(crate) fn to_zero_compression(
    field: &Field,
    stepper: &mut Stepper,
    start: PhasePoint,
    mut seen: impl FnMut(&PhaseArc) -> Result<Option<Ball>, DirectError>,
) -> Result<Ball, DirectError> {
    let last = if field.coordinate.crosses_zero() { Float::new(field.prec) } else { near_zero(field) };
    let mut point = start;
    while point.z > last {
        let z = point.z.to_f64();
        let limit = if field.coordinate.crosses_zero() { z } else { z / 2.0 };
        let arc = stepper.step(limit, |length| {
            let mut end = Float::with_val(field.prec, &point.z - length);
            if end < last || length >= z {
                end.clone_from(&last);
            }
            PhaseArc::follow(field, &point, &end).map(|arc| (arc.clone(), arc.slope))
        })?;
        if let Some(result) = seen(&arc)? {
            return Ok(result);
        }
        point = arc.reached;
    }
    Ok(if last.is_zero() { point.velocity().abs() } else { across_branch(field, &point) })
}

/// From a coordinate near zero to zero itself, by the first-order solution (Prop. 4).
///
/// ```text
/// P(z) = c - q u z - (q/(A c)) z^A,    c < 0
/// ```
fn across_branch(field: &Field, point: &PhasePoint) -> Ball {
    let c = &field.coordinate;
    let z = Ball::exact(point.z.clone()).with_prec(field.prec);
    let (damping, elastic) =
        (field.rational(&c.q) * &field.u * &z, field.rational(&(&c.q / &c.elastic)) * z.pow(&c.elastic));
    let v = Ball::exact(point.v.clone());
    let mut exit = &v + &damping;
    for _ in 0..4 {
        exit = Ball::exact((&v + &damping + &elastic / &exit).mid().clone());
    }
    let missed = (&exit - &damping - &elastic / &exit - &v).abs() * (v.abs() + Ball::one()).shifted(1);
    let fallen = &damping + (&elastic / &exit).abs();
    let defect = first_order_defect(field, &point.z, &fallen) / exit.abs();
    velocity_near(&exit, &upper_bound(&(upper_bound(&missed) + upper_bound(&defect) + &point.energy))).abs()
}
