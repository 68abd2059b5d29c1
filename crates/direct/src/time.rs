//! From impact through the turning point to the way out, in few long steps of time.

use crate::equation::Equation;
use crate::fixed::{BOUND_BITS, from_fixed, zero};
use crate::phase_arc::PhasePoint;
use crate::time_arc::{TimeArc, TimeStep};
use crate::time_series::{FixedPoint, TimeChart};
use restitution::End;
use restitution_real::Ball;
use rug::{Float, Integer};

/// Working precision from which on long steps cost less than the many of the phase plane.
const LEAST_BITS: u32 = 600;
/// Damping up to which there are few such steps.
const MOST_DAMPING: f64 = 8.0;
/// Working precision at which the length of a step is found.
const TRIAL_BITS: u32 = 320;
/// Degree per bit: steps of a third of the distance to the next singularity.
const DEGREE_PER_BIT: f64 = 0.55;
/// Trials of one step's length.
const TRIALS: usize = 12;
/// Steps of one collision.
const STEPS: usize = 100;

/// Follows the motion until it is well on its way out; `None` where this does not pay or is not proved.
pub(crate) fn impact_to_way_out(equation: &Equation, end: End) -> Option<PhasePoint> {
    if equation.prec < LEAST_BITS || equation.u.to_f64() > MOST_DAMPING {
        return None;
    }
    let chart = TimeChart::of(equation)?;
    let trial = Equation { prec: TRIAL_BITS, u: equation.u.with_prec(TRIAL_BITS), ..equation.clone() };
    let one = Float::with_val(equation.prec, 1);
    let mut at = FixedPoint { z: Integer::new(), v: Integer::from(1) << equation.prec };
    let mut point = PhasePoint { z: Float::new(equation.prec), v: one, energy: zero() };
    let (mut length, mut farthest) = (1.0 / (1.0 + equation.u.to_f64()), Float::new(BOUND_BITS));
    for _ in 0..STEPS {
        let small = at.cut(equation.prec - TRIAL_BITS);
        match trial_length(&trial, &chart, &small, end, length) {
            Some(next) => length = next,
            None => return (point.v < 0).then_some(point),
        }
        let TimeStep { end: next, reached } = (0..3).find_map(|shorter| {
            let pace = chart.pace(length * 0.9f64.powi(shorter));
            let step = TimeArc::expand(equation, &chart, &at, &pace, degree(equation)).prove(&point)?;
            is_in_contact(equation, &step.reached, end).then_some(step)
        })?;
        (at, point) = (next, reached);
        farthest = farthest.max(&Float::with_val(BOUND_BITS, &point.z));
        if point.v < 0 && Float::with_val(BOUND_BITS, &point.z * 2u32) < farthest {
            return Some(point);
        }
    }
    None
}

fn degree(equation: &Equation) -> usize {
    (f64::from(equation.prec) * DEGREE_PER_BIT) as usize + 10
}

/// The longest step whose coefficients fall fast enough and that ends before the contact does, found at few bits.
///
/// `None` if there is none of a useful length.
fn trial_length(
    equation: &Equation,
    chart: &TimeChart,
    from: &FixedPoint,
    end: End,
    first: f64,
) -> Option<f64> {
    let bits = equation.prec;
    let start = PhasePoint {
        z: from_fixed(&from.z, bits, bits + 32).mid().clone(),
        v: from_fixed(&from.v, bits, bits + 32).mid().clone(),
        energy: zero(),
    };
    let wanted = 1.0 / DEGREE_PER_BIT + 0.1;
    let (mut length, mut best) = (first, None);
    for _ in 0..TRIALS {
        let arc = TimeArc::expand(equation, chart, from, &chart.pace(length), degree(equation));
        let factor = (arc.slope() - wanted).exp2();
        let proved = || arc.prove(&start).is_some_and(|step| is_in_contact(equation, &step.reached, end));
        if factor >= 0.99 && proved() {
            best = Some(length);
            if factor < 1.06 {
                break;
            }
            length *= factor.min(1.5);
        } else if best.is_some() {
            break;
        } else {
            length *= if factor < 1.0 { (0.98 * factor).max(0.3) } else { 0.7 };
        }
    }
    best
}

/// Whether contact is proved to go on at a point: coordinate and, where it ends there, force are positive.
fn is_in_contact(equation: &Equation, at: &PhasePoint, end: End) -> bool {
    let (z, v) = (Ball::exact(at.z.clone()).with_prec(equation.prec), at.velocity());
    z.is_positive()
        && (end == End::ZeroCompression || v.is_positive() || equation.balance(&z, &v.abs()).is_positive())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Spheres at `u = 1/2`: on the way out the force is positive while `|v| < 2 z^2`.
    #[test]
    fn contact_goes_on_where_its_end_is_proved_to_lie_ahead() {
        let equation = Equation::new(&"3/2,1/2".parse().unwrap(), &Ball::from_ratio(1, 2, 80), 80);
        let is_in_contact = |z: f64, v: f64, energy: f64, end: End| {
            let (z, v) = (Float::with_val(80, z), Float::with_val(80, v));
            is_in_contact(&equation, &PhasePoint { z, v, energy: Ball::from_f64(energy, BOUND_BITS) }, end)
        };
        for (v, energy) in [(0.5, 0.0), (-0.5, 0.0), (-1.9, 0.0), (-2.1, 0.0), (-1.9, 1.0), (-0.1, 1.0)] {
            assert!(is_in_contact(1.0, v, energy, End::ZeroCompression));
            assert!(!is_in_contact(0.0, v, energy, End::ZeroCompression));
            assert!(!is_in_contact(-0.1, v, energy, End::ZeroCompression));
            let ahead = v > -2.0 && energy == 0.0;
            assert_eq!(is_in_contact(1.0, v, energy, End::ZeroForce), ahead, "{v} {energy}");
            assert!(!is_in_contact(-1.0, v, energy, End::ZeroForce), "{v}");
        }
        // The speed may be 2 z^2 where v^2 may be off by that.
        assert!(is_in_contact(1.0, -1.9, 0.18, End::ZeroForce));
        assert!(!is_in_contact(1.0, -1.9, 0.2, End::ZeroForce));
    }
}
