//! From impact to slow compression, in the coordinate `z`.

use crate::error::DirectError;
use crate::field::Field;
use crate::fixed::{BOUND_BITS, upper_bound};
use crate::phase_arc::{PhaseArc, PhasePoint, zero};
use crate::stepper::Stepper;
use num_rational::BigRational;
use num_traits::One;
use restitution_real::Ball;
use rug::Float;

/// The speed below which compression is followed in velocity instead of coordinate.
const SLOW: f64 = 0.75;

/// From impact until the speed has fallen to [`SLOW`].
pub(crate) fn compress(field: &Field, stepper: &mut Stepper) -> Result<PhasePoint, DirectError> {
    let mut point = impact(field);
    let u = field.u.to_f64();
    let b = ratio(&field.coordinate.damping);
    let reach = (b / (u * ratio(&field.coordinate.q)).max(1e-300)).powf(1.0 / b).min(1.0);
    stepper.start_with(if point.z.is_zero() { 0.25 * reach } else { 0.2 * point.z.to_f64() });
    while point.v > SLOW {
        let limit = if field.coordinate.crosses_zero() { f64::INFINITY } else { point.z.to_f64() / 2.0 };
        point = stepper.step(limit, |length| {
            let end = Float::with_val(field.prec, &point.z + length);
            PhaseArc::follow(field, &point, &end).map(|arc| (arc.reached, arc.slope))
        })?;
    }
    Ok(point)
}

/// The start: `z = 0` where the phase plane is analytic there, else a point close to it (Prop. 4).
fn impact(field: &Field) -> PhasePoint {
    let one = Float::with_val(field.prec, 1);
    if field.coordinate.crosses_zero() {
        return PhasePoint { z: Float::new(field.prec), v: one, energy: zero() };
    }
    let z = near_zero(field);
    let ball = Ball::exact(z.clone());
    let c = &field.coordinate;
    let (q, front) = (field.rational(&c.q), field.rational(&c.q) * &field.u);
    let fallen = q * ball.pow(&c.elastic) / field.rational(&c.elastic) + front * ball;
    let v = Ball::one() - &fallen;
    let energy = upper_bound(&first_order_defect(field, &z, &fallen))
        + upper_bound(&(Ball::exact(v.rad().clone()).with_prec(BOUND_BITS).shifted(2)));
    PhasePoint { z, v: Float::with_val(field.prec, v.mid()), energy: upper_bound(&energy) }
}

/// A coordinate so small that the neglected part of `v` is below the working precision.
pub(crate) fn near_zero(field: &Field) -> Float {
    let a = ratio(&field.coordinate.elastic);
    let bits = f64::from(field.prec) / (a + 1.0);
    Float::with_val(field.prec, (-bits).exp2())
}

/// `2 Int_0^z q z^(A-1) (fallen speed) dz`, a bound of the energy's error of the first-order solution.
pub(crate) fn first_order_defect(field: &Field, z: &Float, fallen: &Ball) -> Ball {
    let c = &field.coordinate;
    let z = Ball::exact(z.clone()).with_prec(field.prec);
    (field.rational(&(&c.q / &c.elastic)) * z.pow(&c.elastic) * fallen.abs()).shifted(1)
}

pub(crate) fn ratio(q: &BigRational) -> f64 {
    num_traits::ToPrimitive::to_f64(q).unwrap_or(f64::NAN)
}
