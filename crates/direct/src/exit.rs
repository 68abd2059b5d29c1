//! The way out, in the coordinate `z`: to zero compression or to the zero of the force.

use crate::compression::{first_order_defect, near_zero, ratio, two_to_the};
use crate::equation::Equation;
use crate::error::DirectError;
use crate::fixed::upper_bound;
use crate::overdamping::traps;
use crate::phase_arc::{PhaseArc, PhasePoint, velocity_near};
use crate::stepper::Stepper;
use crate::zero_force::{ForceZero, locate, none_left};
use num_traits::One;
use restitution_real::Ball;
use rug::Float;

/// Follows the way out to zero compression.
///
/// # Errors
///
/// [`DirectError::Overdamped`] if the motion is proved to come to rest before.
pub(crate) fn to_zero_compression(
    equation: &Equation,
    stepper: &mut Stepper,
    start: PhasePoint,
) -> Result<Ball, DirectError> {
    let last =
        if equation.coordinate.crosses_zero() { Float::new(equation.prec) } else { near_zero(equation) };
    let mut point = start;
    while point.z > last {
        point = arc_outward(equation, stepper, &point, &last)?.reached;
        if traps(equation, &point) {
            return Err(equation.overdamped());
        }
    }
    Ok(if last.is_zero() { point.velocity().abs() } else { across_branch(equation, &point) })
}

/// Follows the way out to the zero of the force and returns the speed there.
///
/// The motion ends in one of two proofs: the force changes its sign on an arc, or it is still
/// positive where the elastic energy that is left no longer counts. Until one of them succeeds it
/// goes on; there always is a zero where `a > gamma` (docs/direct-integration.md, section 6).
pub(crate) fn to_zero_force(
    equation: &Equation,
    stepper: &mut Stepper,
    start: PhasePoint,
) -> Result<Ball, DirectError> {
    let settled = settled(equation);
    let mut point = start;
    loop {
        if let Some(speed) = none_left(equation, &point, &settled) {
            return Ok(speed);
        }
        let last = if point.z > settled {
            settled.clone()
        } else if equation.coordinate.crosses_zero() {
            Float::new(equation.prec)
        } else {
            Float::with_val(equation.prec, &point.z / 2u32)
        };
        let arc = arc_outward(equation, stepper, &point, &last)?;
        match locate(equation, &arc) {
            ForceZero::Passed(speed) => return Ok(speed),
            ForceZero::NotPassed | ForceZero::Undecided => point = arc.reached,
        }
    }
}

/// A coordinate from which on the elastic energy, `2 q z^A/A` of `v^2`, is below the working precision.
fn settled(equation: &Equation) -> Float {
    two_to_the(-f64::from(equation.prec + 2) / ratio(&equation.coordinate.elastic), equation.prec)
}

/// One arc towards `z = 0`, not beyond `last`.
fn arc_outward(
    equation: &Equation,
    stepper: &mut Stepper,
    point: &PhasePoint,
    last: &Float,
) -> Result<PhaseArc, DirectError> {
    let crosses = equation.coordinate.crosses_zero();
    let limit = if crosses { point.z.to_f64() } else { f64::INFINITY };
    stepper.step(limit, |length| {
        let mut end = equation.coordinate.advance(&point.z, -length);
        if end < *last || (crosses && length >= limit) {
            end.clone_from(last);
        }
        PhaseArc::follow(equation, point, &end).map(|arc| {
            let slope = arc.slope;
            (arc, slope)
        })
    })
}

/// From a coordinate near zero to zero itself, by the first-order solution (Prop. 4).
///
/// ```text
/// P(z) = c - q u z - (q/(A c)) z^A,    c < 0
/// ```
fn across_branch(equation: &Equation, point: &PhasePoint) -> Ball {
    let c = &equation.coordinate;
    let z = Ball::exact(point.z.clone()).with_prec(equation.prec);
    let (damping, elastic) = (
        equation.rational(&c.q) * &equation.u * &z,
        equation.rational(&(&c.q / &c.elastic)) * z.pow(&c.elastic),
    );
    let v = Ball::exact(point.v.clone());
    let mut exit = &v + &damping;
    for _ in 0..4 {
        exit = Ball::exact((&v + &damping + &elastic / &exit).mid().clone());
    }
    // Prop. 1 is about a P without zero: with a positive speed at zero the motion came to rest, or the precision is too low to
    // tell. With a negative one a zero in between would leave a defect beyond c^2, which `velocity_near` refuses (Prop. 4).
    if !exit.is_negative() {
        return Ball::whole_line(equation.prec);
    }
    let missed = (&exit - &damping - &elastic / &exit - &v).abs();
    let missed = &missed * ((v.abs() + Ball::one()).shifted(1) + &missed);
    let fallen = &damping + (&elastic / &exit).abs();
    let defect = first_order_defect(equation, &point.z, &fallen) / exit.abs();
    velocity_near(&exit, &upper_bound(&(upper_bound(&missed) + upper_bound(&defect) + &point.energy))).abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixed::BOUND_BITS;

    /// `z^A = 2^-(prec + 2)`, in spheres with `A = 5`.
    #[test]
    fn the_elastic_energy_settles_below_the_working_precision() {
        let equation = Equation::new(&"3/2,1/2".parse().unwrap(), &Ball::from_ratio(1, 2, 78), 78);
        assert_eq!(settled(&equation).to_f64(), f64::exp2(-16.0));
    }

    /// `P = c - q u z - (q/(A c)) z^A` where the iteration for `c` has not settled: what is missed counts, in `v^2`.
    #[test]
    fn the_first_order_way_to_zero_counts_what_it_misses() {
        // q = 6/11, A = 20/11, B = 1
        let (q, a, u): (f64, f64, f64) = (6.0 / 11.0, 20.0 / 11.0, 0.5);
        let equation = Equation::new(&"7/3,5/6".parse().unwrap(), &Ball::from_f64(u, 80), 80);
        for (z, v) in [(0.4_f64, -0.75_f64), (0.5, -0.9)] {
            let at = |energy: f64| {
                let (z, v) = (Float::with_val(80, z), Float::with_val(80, v));
                across_branch(&equation, &PhasePoint { z, v, energy: Ball::from_f64(energy, BOUND_BITS) })
            };
            let (damping, elastic) = (q * u * z, q / a * z.powf(a));
            let mut exit = v + damping;
            for _ in 0..4 {
                exit = v + damping + elastic / exit;
            }
            let missed = (exit - damping - elastic / exit - v).abs();
            let missed = missed * (2.0 * (v.abs() + 1.0) + missed);
            let defect = 2.0 * elastic * (damping + (elastic / exit).abs()) / exit.abs();
            for energy in [0.0, 0.01] {
                let wanted = (missed + defect + energy) / exit.abs();
                let found = at(energy);
                assert!(missed > 1e-5 && (found.mid().to_f64() + exit).abs() < 1e-12, "{missed}");
                assert!((found.rad().to_f64() / wanted - 1.0).abs() < 1e-9, "{found:?} {wanted}");
            }
            // The energy has to stay below the square of the speed.
            let left = exit * exit - missed - defect;
            assert!(at(0.999 * left).is_finite() && !at(1.001 * left).is_finite());
        }
        // A speed that is taken away by friction has no way to zero.
        let (z, v) = (Float::with_val(80, 0.4), Float::with_val(80, -0.1));
        let energy = Ball::from_f64(0.0, BOUND_BITS);
        assert!(!across_branch(&equation, &PhasePoint { z, v, energy }).is_finite());
    }
}
