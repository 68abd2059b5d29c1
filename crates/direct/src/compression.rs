//! From impact to slow compression, in the coordinate `z`.

use crate::equation::Equation;
use crate::error::DirectError;
use crate::fixed::{BOUND_BITS, upper_bound, zero};
use crate::phase_arc::{PhaseArc, PhasePoint};
use crate::stepper::Stepper;
use num_rational::BigRational;
use num_traits::One;
use restitution_real::Ball;
use rug::Float;

/// The speed below which compression is followed in velocity instead of coordinate.
const SLOW: f64 = 0.75;

/// From impact until the speed has fallen to [`SLOW`].
pub(crate) fn compress(equation: &Equation, stepper: &mut Stepper) -> Result<PhasePoint, DirectError> {
    let mut point = impact(equation);
    let u = equation.u.to_f64();
    let b = ratio(&equation.coordinate.damping);
    let reach = (b / (u * ratio(&equation.coordinate.q)).max(1e-300)).powf(1.0 / b).min(1.0);
    stepper.start_with(if point.z.is_zero() { 0.25 * reach } else { 0.2 * logarithm(&point.z).abs() });
    while point.v > SLOW {
        point = stepper.step(f64::INFINITY, |length| {
            let end = equation.coordinate.advance(&point.z, length);
            PhaseArc::follow(equation, &point, &end).map(|arc| (arc.reached, arc.slope))
        })?;
    }
    Ok(point)
}

/// The start: `z = 0` where the phase plane is analytic there, else a point close to it (Prop. 4).
fn impact(equation: &Equation) -> PhasePoint {
    let one = Float::with_val(equation.prec, 1);
    if equation.coordinate.crosses_zero() {
        return PhasePoint { z: Float::new(equation.prec), v: one, energy: zero() };
    }
    let c = &equation.coordinate;
    // Of the velocity, 1, no more than a quarter may be lost by friction: Prop. 1 is about a P without zero.
    let lost = (4.0 * ratio(&c.q)).log2() + logarithm(equation.u.mid()) / std::f64::consts::LN_2;
    let quarter = two_to_the(-lost.max(0.0), equation.prec);
    let z = near_zero(equation).min(&quarter);
    let ball = Ball::exact(z.clone());
    let (q, front) = (equation.rational(&c.q), equation.rational(&c.q) * &equation.u);
    let fallen = q * ball.pow(&c.elastic) / equation.rational(&c.elastic) + front * ball;
    let v = Ball::one() - &fallen;
    let energy = upper_bound(&first_order_defect(equation, &z, &fallen))
        + upper_bound(&(Ball::exact(v.rad().clone()).with_prec(BOUND_BITS).shifted(2)));
    PhasePoint { z, v: Float::with_val(equation.prec, v.mid()), energy: upper_bound(&energy) }
}

/// A coordinate so small that the neglected part of `v` is below the working precision.
///
/// The neglected part of `v^2` is about `z^A` times what has fallen, `z^min(A,B)`.
pub(crate) fn near_zero(equation: &Equation) -> Float {
    let c = &equation.coordinate;
    let bits = f64::from(equation.prec) / ratio(&(&c.elastic + c.elastic.clone().min(c.damping.clone())));
    two_to_the(-bits, equation.prec)
}

/// `2^exponent`, about, for any exponent.
pub(crate) fn two_to_the(exponent: f64, prec: u32) -> Float {
    Float::with_val(prec, Float::with_val(53, exponent).exp2())
}

/// `ln z`, about, for a `z` of any size.
pub(crate) fn logarithm(z: &Float) -> f64 {
    Float::with_val(53, z.ln_ref()).to_f64()
}

/// `2 Int_0^z q z^(A-1) (fallen speed) dz`, a bound of the energy's error of the first-order solution.
pub(crate) fn first_order_defect(equation: &Equation, z: &Float, fallen: &Ball) -> Ball {
    let c = &equation.coordinate;
    let z = Ball::exact(z.clone()).with_prec(equation.prec);
    (equation.rational(&(&c.q / &c.elastic)) * z.pow(&c.elastic) * fallen.abs()).shifted(1)
}

pub(crate) fn ratio(q: &BigRational) -> f64 {
    num_traits::ToPrimitive::to_f64(q).unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `P = 1 - q u z - (q/A) z^A` beside a branch point, with `2 (q/A) z^A (1 - P)` for its error, Prop. 4.
    #[test]
    fn a_motion_beside_a_branch_point_starts_close_to_it() {
        let (q, a): (f64, f64) = (6.0 / 11.0, 20.0 / 11.0);
        for (u, z) in [
            (0.5, f64::exp2(-80.0 / (a + 1.0))),
            (1e12, 0.25 / (q * 1e12)),
            (1e-6, f64::exp2(-80.0 / (a + 1.0))),
        ] {
            let equation = Equation::new(&"7/3,5/6".parse().unwrap(), &Ball::from_f64(u, 80), 80);
            let start = impact(&equation);
            let found = start.z.to_f64();
            assert!((found / z - 1.0).abs() < 1e-9, "{u}: {found} {z}");
            let (damping, elastic) = (q * u * found, q / a * found.powf(a));
            let lost = Float::with_val(100, 1u32 - &start.v).to_f64();
            assert!((lost / (damping + elastic) - 1.0).abs() < 1e-9, "{u}: {lost}");
            // The rest is what a speed of 80 bits is off by.
            let rounding = f64::exp2(-76.0);
            let defect = 2.0 * elastic * (damping + elastic);
            let energy = start.energy.to_f64();
            assert!(energy >= defect && energy < 1.001 * defect + rounding, "{u}: {energy:e} {defect:e}");
        }
        let equation = Equation::new(&"7/3,5/6".parse().unwrap(), &Ball::from_f64(1.0, 80), 80);
        let defect = first_order_defect(&equation, &Float::with_val(80, 0.5), &Ball::from_f64(-0.75, 80));
        assert!((defect.to_f64() / (2.0 * q / a * 0.5_f64.powf(a) * 0.75) - 1.0).abs() < 1e-12);
        let spheres = Equation::new(&"3/2,1/2".parse().unwrap(), &Ball::from_f64(1.0, 80), 80);
        let start = impact(&spheres);
        assert!(start.z.is_zero() && start.v == 1 && start.energy.upper().is_zero());
    }
}
