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
            TimeArc::expand(equation, &chart, &at, &pace, degree(equation)).prove(&point)
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
        let in_contact = still_in_contact(equation, &arc.end(), end);
        if factor >= 0.99 && in_contact && arc.prove(&start).is_some() {
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

/// Whether contact goes on at a point: coordinate and, where it ends there, force are positive.
fn still_in_contact(equation: &Equation, at: &FixedPoint, end: End) -> bool {
    let ball = |n: &Integer| from_fixed(n, equation.prec, BOUND_BITS);
    let (z, v) = (ball(&at.z), ball(&at.v));
    z.is_positive()
        && (end == End::ZeroCompression || v.is_positive() || balance(equation, &z, &v).is_positive())
}

fn balance(equation: &Equation, z: &Ball, v: &Ball) -> Ball {
    equation.balance(z, &v.abs())
}
