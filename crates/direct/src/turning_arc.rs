//! One Taylor step around the turning point, the potential energy `y` as a function of `v`.

use crate::envelope::{Envelope, upper_half};
use crate::equation::Equation;
use crate::fixed::{BOUND_BITS, from_fixed, lower_bound, power_of_two, size, unit, upper_bound, zero};
use crate::phase_arc::lower_is_within;
use crate::turning_point::TurningPoint;
use crate::turning_series::{Problem, Series};
use num_rational::BigRational;
use num_traits::Signed;
use restitution_real::Ball;
use rug::Float;

/// What the step from one velocity to the next gives.
pub(crate) struct TurningStep {
    pub(crate) reached: TurningPoint,
    /// Bits lost per degree, which tells how long the next step may be.
    pub(crate) slope: f64,
    /// A lower bound of `1 + v K` along the step, below 1 on the way out.
    pub(crate) least_force: Ball,
}

/// Follows the motion from `from` to the velocity `end < from.v`; `None` if the step is too long to prove.
///
/// ```text
/// (1 + v K) dy/dv = -v,    d(y K)/dv = (1 - c) K dy/dv,    c = (a - gamma)/(a + 1)
/// ```
///
/// The remainder is that of docs/direct-integration.md, Prop. 3.
pub(crate) fn follow(equation: &Equation, from: &TurningPoint, end: &Float) -> Option<TurningStep> {
    let problem = Problem::pose(equation, from, end)?;
    let series = problem.solve(equation)?;
    let start_energy = upper_bound(&(from.energy.with_prec(BOUND_BITS) * power_of_two(-problem.scale)));
    let (range, defect, slope) =
        ROOMS.iter().find_map(|&room| within(equation, &problem, &series, &start_energy, room))?;
    let energy = upper_bound(&(start_energy * range.decay + defect));
    let (y, rounding) = series.end(equation.prec);
    let unscale = power_of_two(problem.scale);
    let reached = TurningPoint {
        v: end.clone(),
        y: y.shifted(i32::try_from(problem.scale).ok()?).mid().clone(),
        energy: upper_bound(&((&energy + &rounding * range.greatest_force) * &unscale)),
        spread: upper_bound(&((energy / &range.least_force + rounding) * unscale)),
    };
    Some(TurningStep { reached, slope, least_force: range.least_force })
}

/// Binary logarithms of the neighbourhoods of the polynomial, relative to it, that are tried.
const ROOMS: [i32; 2] = [-6, -2];

/// The bounds of a step, if they hold in a neighbourhood that the motion does not leave.
fn within(
    equation: &Equation,
    problem: &Problem,
    series: &Series,
    start_energy: &Ball,
    room: i32,
) -> Option<(Range, Ball, f64)> {
    let range = Range::of(equation, problem, series, room)?;
    let (defect, slope) = defect(equation, problem, series, &range)?;
    let along = upper_bound(&(start_energy + &defect));
    (&range.room * &range.least_force - along).is_positive().then_some((range, defect, slope))
}

/// What the functions of a step can be at most and at least, in units of its scales.
struct Range {
    /// The part of `y` that changes, `Sum_(k>0) |y_k|`.
    change: Ball,
    /// A lower bound of the polynomial.
    lowest: Ball,
    /// How far from the polynomial the bounds of `K` still hold.
    room: Ball,
    /// `(y/y')^|c|` at most, for two values of the polynomial.
    bend: Ball,
    least_force: Ball,
    greatest_force: Ball,
    /// How much of the error's energy is kept at most.
    decay: Ball,
}

impl Range {
    fn of(equation: &Equation, problem: &Problem, series: &Series, room: i32) -> Option<Self> {
        let bits = equation.prec;
        let change = size(&series.y[1..], bits);
        let start = from_fixed(&series.y[0], bits, BOUND_BITS);
        let lowest = lower_bound(&(&start - &change));
        if !lowest.is_positive() {
            return None;
        }
        let room = lowest.shifted(room);
        let c = exponent(equation).abs();
        let bend = upper_bound(&((&start + &change) / &lowest).pow(&c));
        let wide = upper_bound(&((&start + &change + &room) / (&lowest - &room)).pow(&c));
        let ratio = from_fixed(&series.ratio[0], bits, BOUND_BITS);
        let most = upper_bound(&((&ratio + &problem.ratio_error) * &wide));
        let least = positive(lower_bound(&((ratio - &problem.ratio_error) / wide)));
        let one = Ball::from_integer(1, BOUND_BITS);
        let (inward, outward) = fastest(&problem.start_v, &problem.end_v, problem.velocity_scale)?;
        let least_force = lower_bound(&(&one - outward * &most));
        let greatest_force = upper_bound(&(&one + inward * &most));
        let rate = lower_bound(&(problem.length() * least / &greatest_force));
        least_force.is_positive().then(|| Self {
            change,
            lowest,
            room,
            bend,
            least_force,
            greatest_force,
            decay: upper_bound(&(-rate).exp()),
        })
    }
}

/// The largest speeds inward and outward of a motion whose velocity falls from `start` to `end`, in units of `2^scale`, rounded up.
fn fastest(start: &Float, end: &Float, scale: i64) -> Option<(Ball, Ball)> {
    let shift = i32::try_from(-scale).ok()?;
    let largest = |v: Ball| positive(upper_bound(&v.shifted(shift)));
    Some((largest(Ball::exact(start.clone())), largest(-Ball::exact(end.clone()))))
}

/// `Int |defect|` of the step and the decay of its coefficients; `None` if too much was cut off.
fn defect(equation: &Equation, problem: &Problem, series: &Series, range: &Range) -> Option<(Ball, f64)> {
    let (bits, order) = (equation.prec, equation.order);
    let slope = Envelope::tightest(&series.y, bits).slope.min(Envelope::tightest(&series.ratio, bits).slope);
    let in_y = Envelope::with_slope(&series.y, bits, slope);
    let in_ratio = Envelope::with_slope(&series.ratio, bits, slope);
    let tail = upper_half(in_y, in_ratio, order);
    let last = size(&series.product[order - 1..], bits);
    // The error of y is that of F over the force 1 + v K, which may be huge.
    let start_force = from_fixed(&series.force, bits, BOUND_BITS) + unit(bits);
    let size_bits = series.force.significant_bits().saturating_sub(bits + 1);
    if !lower_is_within(&((&tail + &last) * power_of_two(-i64::from(size_bits))), bits) {
        return None;
    }
    let n = Ball::from_integer(i64::try_from(order).ok()?, BOUND_BITS);
    let one = Ball::from_integer(1, BOUND_BITS);
    let start = from_fixed(&series.y[0], bits, BOUND_BITS);
    // (i) the equation of motion with the computed K
    let rounding =
        unit(bits) * (&n * (start_force + Ball::from_integer(3, BOUND_BITS)) + &range.change + &one);
    let motion = rounding + &problem.right_error + tail.shifted(1) + last + unit(bits);
    // (ii) the distance of the computed K from the true power of the polynomial
    let weight = &one + equation.rational(&problem.one_minus_c).with_prec(BOUND_BITS);
    let power = unit(bits) * n * (start + one) + tail * weight;
    let ratio_off = &range.bend * (&problem.ratio_error + power / &range.lowest);
    let total = motion + ratio_off.shifted(1) * &range.change;
    let relative = Envelope { top: in_ratio.top - f64::from(size_bits), ..in_ratio };
    Some((upper_bound(&total), in_y.decay_seen(order).min(relative.decay_seen(order))))
}

/// `c = (a - gamma)/(a + 1)`.
fn exponent(equation: &Equation) -> BigRational {
    (equation.law.a() - equation.law.gamma()) / equation.law.elastic_step()
}

fn positive(bound: Ball) -> Ball {
    if bound.is_positive() { bound } else { zero() }
}

#[cfg(test)]
mod exactly;

#[cfg(test)]
mod tests {
    use super::*;
    use restitution_law::ForceLaw;

    /// Spheres at `u = 1/2` around `x = 1`, where `y = 2/5` and `K = 1/2`: a short step, begun with an error.
    fn step(v: f64, energy: f64) -> Option<TurningStep> {
        let equation = Equation::new(&ForceLaw::viscoelastic_spheres(), &Ball::from_ratio(1, 2, 80), 80);
        let energy = Ball::from_f64(energy, BOUND_BITS);
        let from = TurningPoint {
            v: Float::with_val(80, v),
            y: Float::with_val(80, 0.4),
            spread: energy.clone(),
            energy,
        };
        follow(&equation, &from, &Float::with_val(80, v - 1.0 / 1024.0))
    }

    #[test]
    fn speeds_are_rounded_up_both_ways() {
        // 65 bits and more: a speed outward that is rounded down would give the force too much.
        let v = Float::with_val(100, 0.75) + (Float::with_val(100, 1) >> 90u32);
        let exactly = Ball::exact(v.clone()).shifted(-3);
        let (inward, outward) = fastest(&v, &-v.clone(), 3).unwrap();
        for speed in [inward, outward] {
            assert!((&speed - &exactly).is_positive() && (speed - &exactly).abs_up() < 1e-19);
        }
        let (inward, outward) = fastest(&-v.clone(), &v, 3).unwrap();
        assert!(inward.mid().is_zero() && outward.mid().is_zero());
    }

    #[test]
    fn the_motion_has_to_stay_where_the_bounds_of_the_force_hold() {
        // A quarter of y around the polynomial is the widest neighbourhood: energies up to 0.1 times the least force,
        // which is 1 on the way in and 1 - 0.9 K (5/3)^(2/5) = 0.448 at the speed 0.9 on the way out.
        for (v, least) in [(0.5, 1.0), (-0.9, 0.448)] {
            let reached = step(v, 0.09 * least).expect("room").reached;
            assert!(reached.energy.to_f64() < 0.09 * least && reached.energy.to_f64() > 0.08 * least, "{v}");
            for beyond in [0.11, 0.15, 0.3] {
                assert!(step(v, beyond * least).is_none(), "{v} {beyond}");
            }
        }
    }

    fn near(found: &Ball, wanted: f64) {
        assert!((found.to_f64() / wanted - 1.0).abs() < 1e-12, "{found:?} {wanted:e}");
    }

    /// A step of few degrees, with errors of `-h v` and of `K` by hand; in units of 1/2 for `y`.
    fn posed(v: f64, ratio_error: f64) -> (Equation, Problem, Series) {
        let equation = Equation::new(&ForceLaw::viscoelastic_spheres(), &Ball::from_ratio(1, 2, 80), 80);
        let equation = Equation { order: 6, ..equation };
        let bound = |x: f64| Ball::from_f64(x, BOUND_BITS);
        let from = TurningPoint {
            v: Float::with_val(80, v),
            y: Float::with_val(80, 0.4),
            spread: bound(0.0),
            energy: bound(0.0),
        };
        let mut problem =
            Problem::pose(&equation, &from, &Float::with_val(80, v - f64::exp2(-12.0))).unwrap();
        assert_eq!((problem.scale, problem.velocity_scale), (-1, 0));
        (problem.ratio_error, problem.right_error) = (bound(ratio_error), bound(f64::exp2(-76.0)));
        let series = problem.solve(&equation).unwrap();
        (equation, problem, series)
    }

    fn value(c: &rug::Integer) -> f64 {
        c.to_f64() * f64::exp2(-80.0)
    }

    #[test]
    fn the_functions_of_a_step_are_bounded_in_its_neighbourhood() {
        for v in [0.75, -0.625] {
            for room in ROOMS {
                let (equation, problem, series) = posed(v, 0.03125);
                let range = Range::of(&equation, &problem, &series, room).unwrap();
                let (start, ratio) = (value(&series.y[0]), value(&series.ratio[0]));
                let change: f64 = series.y[1..].iter().map(|y| value(y).abs()).sum();
                let (low, high) = (start - change, start + change);
                let room = low * f64::from(room).exp2();
                near(&range.change, change);
                near(&range.lowest, low);
                near(&range.room, room);
                near(&range.bend, (high / low).powf(0.4));
                let wide = ((high + room) / (low - room)).powf(0.4);
                let (most, least) = ((ratio + 0.03125) * wide, (ratio - 0.03125) / wide);
                let (inward, outward) = (v.max(0.0), (f64::exp2(-12.0) - v).max(0.0));
                near(&range.least_force, 1.0 - outward * most);
                near(&range.greatest_force, 1.0 + inward * most);
                near(&range.decay, f64::exp(-f64::exp2(-12.0) * least / (1.0 + inward * most)));
            }
        }
        // A force that may vanish is no bound.
        let (equation, problem, series) = posed(-0.625, 0.875);
        assert!(
            Range::of(&equation, &problem, &series, -6)
                .is_some_and(|range| range.least_force.to_f64() < 0.15)
        );
        let (equation, problem, series) = posed(-0.625, 1.125);
        assert!(Range::of(&equation, &problem, &series, -6).is_none());
    }

    #[test]
    fn what_a_step_leaves_over_is_written_out() {
        let (equation, problem, series) = posed(0.75, f64::exp2(-75.0));
        let range = Range::of(&equation, &problem, &series, -6).unwrap();
        let (found, _) = defect(&equation, &problem, &series, &range).unwrap();
        let slope = Envelope::tightest(&series.y, 80).slope.min(Envelope::tightest(&series.ratio, 80).slope);
        let [in_y, in_ratio] = [&series.y, &series.ratio].map(|c| Envelope::with_slope(c, 80, slope));
        let (tail, last) = (upper_half(in_y, in_ratio, 6).to_f64(), value(&series.product[5]).abs());
        let (unit, n, start) = (f64::exp2(-80.0), 6.0, value(&series.y[0]));
        let (change, lowest, bend) = (range.change.to_f64(), range.lowest.to_f64(), range.bend.to_f64());
        // Divisions and products in the equation of motion, what is cut off of `M`, its last degree.
        let rounding = unit * (n * (value(&series.force) + unit + 3.0) + change + 1.0);
        let motion = rounding + f64::exp2(-76.0) + 2.0 * tail + last + unit;
        // `|K - K(p)|` by the other relation, with `c = 2/5`.
        let power = unit * n * (start + 1.0) + tail * 1.6;
        let ratio_off = bend * (f64::exp2(-75.0) + power / lowest);
        near(&found, motion + 2.0 * ratio_off * change);
        assert!(tail < 1e3 * unit && last < 1e3 * unit && change * ratio_off > 1e-6 * motion);
    }

    #[test]
    fn the_defect_counts_with_the_energy_at_the_start() {
        let (equation, mut problem, series) = posed(0.75, 0.0);
        let mut of = |start: f64, error: f64| {
            problem.right_error = Ball::from_f64(error, BOUND_BITS);
            within(&equation, &problem, &series, &Ball::from_f64(start, BOUND_BITS), -2).is_some()
        };
        // A quarter of y, 0.2 in its units, times the least force 1.
        assert!(of(0.1, 0.09) && of(0.0, 0.19) && of(0.19, 0.0));
        assert!(!of(0.1, 0.11) && !of(0.0, 0.21) && !of(0.21, 0.0));
    }
}
