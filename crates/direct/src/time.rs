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
/// Shares of the length found at few bits that are tried in turn.
const SHARES: [f64; 3] = [1.0, 0.9, 0.81];
/// Trials of one step's length.
const TRIALS: usize = 12;
/// Steps of one collision.
const STEPS: usize = 100;

/// Follows the motion until it is well on its way out; `None` where this does not pay or is not proved.
pub(crate) fn impact_to_way_out(equation: &Equation, end: End) -> Option<PhasePoint> {
    let chart = pays(equation.prec, equation.u.to_f64()).then(|| TimeChart::of(equation)).flatten()?;
    let trial = equation.at(TRIAL_BITS);
    let one = Float::with_val(equation.prec, 1);
    let mut at = FixedPoint { z: Integer::new(), v: Integer::from(1) << equation.prec };
    let mut point = PhasePoint { z: Float::new(equation.prec), v: one, energy: zero() };
    let (mut length, mut farthest) = (1.0 / (1.0 + equation.u.to_f64()), Float::new(BOUND_BITS));
    for _ in 0..STEPS {
        let small = at.cut(equation.prec - TRIAL_BITS);
        match trial_length(&trial, &chart, &small, end, length) {
            Some(next) => length = next,
            None => return point.v.is_sign_negative().then_some(point),
        }
        let TimeStep { end: next, reached } = SHARES.iter().find_map(|share| {
            let pace = chart.pace(length * share);
            let step = TimeArc::expand(equation, &chart, &at, &pace, degree(equation)).prove(&point)?;
            is_in_contact(equation, &step.reached, end).then_some(step)
        })?;
        (at, point) = (next, reached);
        farthest = farthest.max(&Float::with_val(BOUND_BITS, &point.z));
        if is_well_out(&point, &farthest) {
            return Some(point);
        }
    }
    None
}

/// Whether few long steps cost less than many short ones.
fn pays(bits: u32, u: f64) -> bool {
    bits >= LEAST_BITS && u <= MOST_DAMPING
}

/// Whether a point on the way out has left more than half of the way behind.
fn is_well_out(point: &PhasePoint, farthest: &Float) -> bool {
    point.v.is_sign_negative() && Float::with_val(BOUND_BITS, &point.z * 2u32) < *farthest
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
        z: from_fixed(&from.z, bits, bits).mid().clone(),
        v: from_fixed(&from.v, bits, bits).mid().clone(),
        energy: zero(),
    };
    let wanted = 1.0 / DEGREE_PER_BIT + 0.1;
    let (mut length, mut best) = (first, None);
    for _ in 0..TRIALS {
        let arc = TimeArc::expand(equation, chart, from, &chart.pace(length), degree(equation));
        let factor = (arc.slope() - wanted).exp2();
        let proved = || arc.prove(&start).is_some_and(|step| is_in_contact(equation, &step.reached, end));
        let fits = factor >= 0.99 && proved();
        if fits {
            best = Some(length);
        }
        match change(factor, fits, best.is_some()) {
            Some(change) => length *= change,
            None => break,
        }
    }
    best
}

/// By how much to change the length of a trial, `factor` short of what its coefficients have room for; `None` to end with the best.
fn change(factor: f64, fits: bool, one_fitted: bool) -> Option<f64> {
    match (fits, one_fitted) {
        (true, _) => (factor >= 1.06).then(|| factor.min(1.5)),
        (false, true) => None,
        (false, false) => Some(if factor < 1.0 { (0.98 * factor).max(0.3) } else { 0.7 }),
    }
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

    #[test]
    fn long_steps_are_taken_at_many_bits_and_moderate_damping() {
        for (bits, u, is) in
            [(600, 8.0, true), (599, 1.0, false), (900, 8.5, false), (900, 0.0, true), (599, 9.0, false)]
        {
            assert_eq!(pays(bits, u), is, "{bits} {u}");
        }
        let at = |z: f64, v: f64| PhasePoint {
            z: Float::with_val(80, z),
            v: Float::with_val(80, v),
            energy: zero(),
        };
        let farthest = Float::with_val(BOUND_BITS, 1);
        for (z, v, is) in [(0.5, -1.0, false), (0.49, -1.0, true), (0.49, 1.0, false), (0.6, -1.0, false)] {
            assert_eq!(is_well_out(&at(z, v), &farthest), is, "{z} {v}");
        }
    }

    #[test]
    fn a_trial_grows_as_far_as_there_is_room_and_shrinks_where_it_did_not_fit() {
        for (factor, fits, one_fitted, wanted) in [
            (1.06, true, true, Some(1.06)),
            (1.059, true, true, None),
            (1.4, true, true, Some(1.4)),
            (2.0, true, true, Some(1.5)),
            (1.2, false, true, None),
            (0.5, false, true, None),
            (0.5, false, false, Some(0.98 * 0.5)),
            (0.2, false, false, Some(0.3)),
            (1.0, false, false, Some(0.7)),
            (3.0, false, false, Some(0.7)),
        ] {
            assert_eq!(change(factor, fits, one_fitted), wanted, "{factor} {fits} {one_fitted}");
        }
    }

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
