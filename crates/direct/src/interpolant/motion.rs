//! The whole collision of an interval of dampings, step by step, with its energy of error.

use super::arc::{Flow, Step, unit_row};
use super::defect::{Course, units};
use super::jets::{Jets, Range, quotient};
use crate::compression::ratio;
use crate::coordinate::Coordinate;
use crate::error::DirectError;
use crate::fixed::{BOUND_BITS, lower_bound, upper_bound, zero};
use crate::stepper::Stepper;
use num_rational::BigRational;
use restitution::End;
use restitution_real::Ball;
use rug::Integer;

/// How errors are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Measure {
    /// `|v^2 - V^2|` at equal coordinates (Prop. 1): where the bodies move.
    Speed,
    /// `|F(y,v) - F(Y,v)|` at equal velocities (Prop. 3): where the force is positive.
    Force,
}

/// Where a step ends and the next one starts: jets, with the energy of the error.
#[derive(Clone, Debug)]
pub(crate) struct State {
    pub(crate) z: Vec<Integer>,
    pub(crate) v: Vec<Integer>,
    pub(crate) energy: Ball,
    pub(crate) measure: Measure,
}

/// One step with its proof.
pub(crate) struct Leg {
    /// The motion in the time of the step.
    pub(crate) course: Course,
    pub(crate) reached: State,
    /// Bound of the energy of the error all along, in the time of the step.
    pub(crate) energy: Ball,
    /// The pace of that time, a jet, and bounds of it.
    pub(crate) pace: Jets,
    pub(crate) paces: Range,
}

impl Leg {
    /// A velocity of the step, a jet, in the time of the collision, and what was lost by the division.
    pub(crate) fn in_common_time(&self, velocity: &Jets, bits: u32) -> Option<(Jets, Ball)> {
        let mut lost = zero();
        let fixed = velocity.rounded(1, velocity.width, bits, &mut lost);
        let quotient = Jets::constant(&quotient(fixed.row(0), self.pace.row(0), bits)?, bits);
        let missed = fixed.plus(&self.pace.product(&quotient).negative()).size() + lost;
        Some((quotient, upper_bound(&(missed / &self.paces.low))))
    }
}

/// What stays the same on all steps.
pub(crate) struct Motion {
    pub(crate) flow: Flow,
    pub(crate) coordinate: Coordinate,
    /// Bounds of the damping.
    pub(crate) u: Range,
    /// `a + 1`.
    pub(crate) elastic_step: BigRational,
    /// Bits that the part cut off may not exceed.
    pub(crate) prec: u32,
    /// Where contact ends.
    pub(crate) end: End,
}

/// Above this speed compression is measured by the speed.
const SLOW: f64 = 0.75;
/// Deviations of the pace from 1, summed, up to which it is used.
const LARGEST_DEVIATION: f64 = 0.75;
/// By how much the pace to zero force must fall with each degree: soon after the turning point, where the velocities
/// of an interval still differ in size, what is cut off of it would be the largest error of all.
const RATE: f64 = 0.01;
/// Relative neighbourhood, `2^-6`, in which the bounds of the force hold.
const ROOM: i32 = -6;

impl Motion {
    /// The impact.
    pub(crate) fn impact(&self) -> State {
        let mut v = vec![Integer::new(); self.flow.width];
        v[0] = Integer::from(1) << self.flow.bits;
        State { z: vec![Integer::new(); self.flow.width], v, energy: zero(), measure: Measure::Speed }
    }

    /// A stepper with a length for the first step.
    pub(crate) fn stepper(&self) -> Stepper {
        let mut stepper = Stepper::new(self.prec, self.flow.order);
        let (b, q) = (ratio(&self.coordinate.damping), ratio(&self.coordinate.q));
        let reach = (b / (self.u.high.to_f64() * q).max(1e-300)).powf(1.0 / b).min(1.0);
        stepper.start_with(0.25 * reach * q);
        stepper
    }

    /// Takes one step from a state; `None` if it is too long to prove.
    pub(crate) fn step(&self, from: &State, length: f64) -> Option<(Leg, f64)> {
        let step = Step::near(length, ratio(&self.coordinate.q))?;
        let flow = self.flow.at_pace(self.pace(from));
        let pace = Jets::constant(&flow.pace, flow.bits);
        let start = pace.product(&Jets::constant(&from.v, flow.bits));
        let fixed = start.rounded(1, flow.width, flow.bits, &mut zero());
        let coordinate = flow.solve(&from.z, fixed.row(0), step);
        let slope = decay(&coordinate, &flow);
        let course = Course::measure(&flow, coordinate, step);
        if !is_little(&course.cut_off, self.prec) {
            return None;
        }
        let paces = pace.range();
        let first = Jets::constant(course.velocity.row(0), course.velocity.bits);
        let missed = first.plus(&start.negative()).size() + units(flow.width, flow.bits) * &paces.high;
        let (energy, left) = match from.measure {
            Measure::Speed => self.by_speed(from, &course, &paces, &missed)?,
            Measure::Force => self.by_force(from, &course, &missed)?,
        };
        let mut leg = Leg { reached: from.clone(), course, energy, pace, paces };
        let end = Jets::constant(&leg.course.velocity.end(), leg.course.velocity.bits);
        let (velocity, lost) = leg.in_common_time(&end, flow.bits)?;
        let pull = match from.measure {
            Measure::Speed => zero(),
            Measure::Force => self.force(&leg.course.place, &leg.course.speed, &missed)?.pull(),
        };
        let slack = slack(&velocity.range(), &pull, &lost);
        leg.reached = State {
            z: leg.course.coordinate.end(),
            v: velocity.coefficients,
            energy: upper_bound(&(left / (&leg.paces.low * &leg.paces.low) + slack)),
            measure: from.measure,
        };
        Some((leg, slope))
    }

    /// The pace at which all motions of the interval would reach the end together, going on as they do;
    /// 1 but on the way out. It has no part in a proof.
    fn pace(&self, from: &State) -> Vec<Integer> {
        let even = || unit_row(self.flow.width, self.flow.bits);
        let outward = from.measure == Measure::Speed && self.range(&from.v).high.is_negative();
        let pace = outward.then(|| {
            let time = self.time_left(from)?;
            quotient(&time, &time[..1], self.flow.bits)
        });
        let moderate = |pace: &Vec<Integer>| {
            let size = |part: &[Integer]| crate::fixed::size(part, self.flow.bits).mid().to_f64();
            let (all, last) = (size(&pace[1..]), size(&pace[pace.len() - 1..]));
            let known = self.end == End::ZeroCompression || last <= all * RATE.powi(pace.len() as i32 - 2);
            all < LARGEST_DEVIATION && known
        };
        pace.flatten().filter(moderate).unwrap_or_else(even)
    }

    /// The time to the end of contact at the speed that is had, up to a constant factor.
    ///
    /// To zero compression `z/|v|`, to zero force the balance `z^n + u v` over `z^(n-1) |v|`.
    fn time_left(&self, from: &State) -> Option<Vec<Integer>> {
        let bits = self.flow.bits;
        if self.end == End::ZeroCompression {
            return quotient(&from.z, &from.v, bits);
        }
        let times = |x: &[Integer], y: &[Integer]| self.flow.jet_product(x, y);
        let power = (1..self.flow.elastic).fold(unit_row(self.flow.width, bits), |p, _| times(&p, &from.z));
        let mut balance = times(&power, &from.z);
        balance.iter_mut().zip(times(&self.flow.u, &from.v)).for_each(|(b, d)| *b += d);
        quotient(&balance, &times(&power, &from.v), bits)
    }

    /// Prop. 1: the energy all along and at the end.
    fn by_speed(&self, from: &State, course: &Course, paces: &Range, missed: &Ball) -> Option<(Ball, Ball)> {
        let (slowest, fastest) = (course.speed.least()?, course.speed.largest());
        let energy = &from.energy * &paces.high * &paces.high;
        let start = upper_bound(&(energy + slack(&course.speed, &zero(), missed)));
        let grown = upper_bound(&(fastest.shifted(1) * &course.defect));
        let energy = upper_bound(&(&start + &grown));
        if !(&slowest * &slowest - &energy).is_positive() {
            return None;
        }
        // |v|/(|v| + |P|) >= 2/5 as long as |v^2 - P^2| < P^2.
        let low = Ball::exact(positive(&course.place.low).mid().clone());
        let friction = &self.u.low * &paces.low * low.pow(&(&self.coordinate.damping - one()));
        let rate = lower_bound(&(friction * &course.length * Ball::from_ratio(4, 5, BOUND_BITS)));
        let kept = upper_bound(&(-positive(&rate)).exp());
        Some((energy, upper_bound(&(start * kept + grown))))
    }

    /// Prop. 3: the energy all along and at the end.
    fn by_force(&self, from: &State, course: &Course, missed: &Ball) -> Option<(Ball, Ball)> {
        let force = self.force(&course.place, &course.speed, missed)?;
        let fastest = course.speed.largest();
        let shifted = missed * (&fastest + missed + force.pull());
        let energy = upper_bound(&(&from.energy + shifted + &fastest * &course.defect));
        // The velocity must fall all along: h z^(A-1) (1 + v K) > |defect|.
        let falling =
            course.place.low.pow(&(&self.coordinate.elastic - one())) * &course.length * &force.least;
        let proved = (falling - &course.largest_defect).is_positive()
            && (&force.room * &force.least - &energy).is_positive();
        proved.then(|| (energy.clone(), energy))
    }

    /// Bounds of `1 + v K`, `K = u z^(B-A)`, within `2^-6` of the potential energy.
    pub(crate) fn force(&self, place: &Range, speed: &Range, off: &Ball) -> Option<Force> {
        if !place.low.is_positive() {
            return None;
        }
        let one_ball = Ball::from_integer(1, BOUND_BITS);
        let part = one_ball.shifted(ROOM);
        let low = lower_bound(&(&place.low * (&one_ball - &part)));
        let high = upper_bound(&(&place.high * (&one_ball + &part)));
        let power = -self.coordinate.force_power();
        let ends = [low.pow(&power), high.pow(&power)].map(|x| upper_bound(&(x * &self.u.high)));
        let [x, y] = ends;
        let ratio = if (&x - &y).is_positive() { x } else { y };
        let backward = positive(&upper_bound(&-&speed.low)) + off;
        let forward = positive(&speed.high) + off;
        let least = lower_bound(&(&one_ball - backward * &ratio));
        let greatest = upper_bound(&(&one_ball + forward * &ratio));
        let energy = place.low.pow(&self.coordinate.elastic) / self.step_of_energy();
        let room = lower_bound(&(energy * &part));
        least.is_positive().then_some(Force { least, greatest, room, ratio })
    }

    /// `a + 1`, so that `y = z^A/(a + 1)`.
    fn step_of_energy(&self) -> Ball {
        Ball::from_rational(&self.elastic_step, BOUND_BITS)
    }

    /// Measures the error by the force from here on; `None` if that is not possible yet.
    pub(crate) fn by_force_from(&self, state: &State) -> Option<State> {
        let (place, speed) = (self.range(&state.z), self.range(&state.v));
        let off = upper_bound(&(&state.energy / speed.least()?));
        // |dy/dv| <= |v| on the way in.
        let spread = upper_bound(&(&off * (speed.largest() + &off)));
        let force = self.force(&place, &speed, &off)?;
        let energy = upper_bound(&(&spread * &force.greatest));
        let proved = off.is_finite() && (force.room - spread).is_positive();
        proved.then(|| State { energy, measure: Measure::Force, ..state.clone() })
    }

    /// Measures the error by the speed from here on; `None` if that is not possible yet.
    pub(crate) fn by_speed_from(&self, state: &State) -> Option<State> {
        let (place, speed) = (self.range(&state.z), self.range(&state.v));
        let force = self.force(&place, &speed, &zero())?;
        let off = upper_bound(&(&state.energy / &force.least));
        let least = speed.least()?;
        // |d(v^2)/dy| = 2 |1 + v K| <= 2 as long as |v| K <= 2, here for speeds up to half more.
        let ratio = upper_bound(&(&force.ratio * speed.largest() * Ball::from_ratio(3, 2, BOUND_BITS)));
        let two = Ball::from_integer(2, BOUND_BITS);
        let room = &least * &least - off.shifted(3);
        let proved = speed.high.is_negative()
            && room.is_positive()
            && (&force.room - &off).is_positive()
            && !(ratio - two).is_positive();
        proved.then(|| State { energy: off.shifted(1), measure: Measure::Speed, ..state.clone() })
    }

    /// Bounds of a jet.
    pub(crate) fn range(&self, row: &[Integer]) -> Range {
        Jets::constant(row, self.flow.bits).range()
    }

    /// Follows the motion from impact to a point on the way out where the speed measures again.
    pub(crate) fn rebound(&self, stepper: &mut Stepper) -> Result<State, DirectError> {
        let mut state = self.impact();
        loop {
            let slow = self.range(&state.v).high.mid() < &SLOW;
            if state.measure == Measure::Speed
                && slow
                && let Some(by_force) = self.by_force_from(&state)
            {
                state = by_force;
            }
            if state.measure == Measure::Force
                && self.serves_speed(&state)
                && let Some(by_speed) = self.by_speed_from(&state)
            {
                return Ok(by_speed);
            }
            let (leg, _) = stepper.step(f64::INFINITY, |length| {
                self.step(&state, length).map(|(leg, slope)| ((leg, ()), slope))
            })?;
            state = leg.reached;
        }
    }

    /// Whether the bodies part fast enough: more kinetic than potential energy, or half the force gone.
    fn serves_speed(&self, state: &State) -> bool {
        let (place, speed) = (self.range(&state.z), self.range(&state.v));
        if !speed.high.is_negative() {
            return false;
        }
        let kinetic = (&speed.high * &speed.high).shifted(-1);
        let potential = place.high.pow(&self.coordinate.elastic) / self.step_of_energy();
        let half_gone = self.force(&place, &speed, &zero()).is_none_or(|f| f.least.mid() < &0.5);
        (kinetic - potential).is_positive() || half_gone
    }
}

/// Bounds of the force over the elastic force.
pub(crate) struct Force {
    pub(crate) least: Ball,
    pub(crate) greatest: Ball,
    /// The neighbourhood of the potential energy in which they hold.
    room: Ball,
    /// The largest `K`.
    ratio: Ball,
}

impl Force {
    /// The largest `K |y - Y|` in the neighbourhood.
    fn pull(&self) -> Ball {
        upper_bound(&(&self.ratio * &self.room))
    }
}

/// What the energy of the error grows by at most when a velocity is replaced by one that differs by `missed`.
///
/// `v^2` moves by `2 |v|`. As the motion goes on to another velocity `v` the error of `F` moves by `-v + G(y) - G(Y)`, at most
/// `|v| + K |y - Y|`; the latter is `pull`, and it is all there is at the turning point, where `v = 0`.
fn slack(speed: &Range, pull: &Ball, missed: &Ball) -> Ball {
    upper_bound(&(((speed.largest() + missed).shifted(2) + pull) * missed))
}

/// Whether no more than `2^(8-bits)` is cut off.
fn is_little(cut_off: &Ball, bits: u32) -> bool {
    (crate::fixed::power_of_two(8 - i64::from(bits)) - cut_off).lower() >= 0
}

fn one() -> BigRational {
    num_traits::One::one()
}

fn positive(bound: &Ball) -> Ball {
    if bound.is_positive() { bound.clone() } else { zero() }
}

/// Bits below which a coefficient is what rounding leaves of it and tells nothing.
const NOISE: f64 = 16.0;

/// Bits lost from one degree in `theta` to the next, over the last of them that rise above the rounding.
fn decay(coordinate: &Jets, flow: &Flow) -> f64 {
    let height = |k: usize| {
        let row = coordinate.row(k).iter().map(Integer::significant_bits).max();
        f64::from(row.unwrap_or(0))
    };
    let top = height(0).max(height(1));
    let last = (1..=flow.order).rev().find(|k| height(*k) > NOISE).unwrap_or(1);
    (last - last / 4..=last).map(|k| (top - height(k)) / k as f64).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod perturbed;
#[cfg(test)]
mod tests;
