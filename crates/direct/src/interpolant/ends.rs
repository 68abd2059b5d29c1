//! Where contact ends, for every damping of an interval at once.

use super::jets::{Jets, quotient};
use super::motion::{Leg, Motion};
use crate::fixed::{BOUND_BITS, lower_bound, upper_bound};
use num_rational::BigRational;
use num_traits::One;
use restitution::End;
use restitution_real::Ball;
use rug::Integer;

/// What a step on the way out shows of the end of contact.
pub(crate) enum Found {
    /// It lies beyond, for every damping.
    Beyond,
    /// It lies in the step for every damping.
    Here(Exit),
}

/// The exit velocity, negative, as a jet with a bound of its error.
pub(crate) struct Exit {
    pub(crate) velocity: Jets,
    pub(crate) error: Ball,
}

/// Halvings and Newton steps towards the end.
const HALVINGS: u32 = 16;
const NEWTON_STEPS: u32 = 12;
/// Relative neighbourhood of the end, `2^-6`, in which it must lie.
const ROOM: i32 = -6;

impl Motion {
    /// Seeks the end of contact in a step; `None` if a step of another length must be tried.
    pub(crate) fn end_of_contact(&self, leg: &Leg) -> Option<Found> {
        let course = &leg.course;
        let events = match self.end {
            End::ZeroCompression => &course.coordinate,
            End::ZeroForce => &course.balance,
        };
        let after = Jets::constant(&events.end(), events.bits).range();
        if after.low.is_positive() {
            // At zero force the balance is positive again beyond a small compression below 0.
            let place = Jets::constant(&course.coordinate.end(), course.coordinate.bits).range();
            return place.low.is_positive().then_some(Found::Beyond);
        }
        if !after.high.is_negative() {
            return None;
        }
        let theta = Jets::constant(&root(events)?, events.bits);
        let inside = theta.range();
        let early = inside.low.is_negative();
        if early || (inside.high - Ball::from_integer(1, BOUND_BITS)).is_positive() {
            return None;
        }
        match self.end {
            End::ZeroCompression => self.at_zero_compression(leg, &theta),
            End::ZeroForce => self.at_zero_force(leg, &theta),
        }
        .map(Found::Here)
    }

    /// The velocity where `z = 0`: `z` falls from above to below 0 with speed `h |v|/q`, so an error of
    /// `z` at `theta` moves the place by at most `q/(h min|v|)` times that.
    fn at_zero_compression(&self, leg: &Leg, theta: &Jets) -> Option<Exit> {
        let course = &leg.course;
        let slowest = course.speed.least()?;
        let (place, place_error) = course.coordinate.at(theta);
        let (velocity, velocity_error) = course.velocity.at(theta);
        let pace = Ball::from_rational(&self.coordinate.q, BOUND_BITS) / (&course.length * &slowest);
        let moved = (place.size() + place_error) * pace;
        let bend = course.velocity.derivative().size();
        self.leave(leg, &velocity, velocity_error + moved * bend + &leg.energy / slowest)
    }

    /// The velocity where the force vanishes (Prop. 5).
    fn at_zero_force(&self, leg: &Leg, theta: &Jets) -> Option<Exit> {
        let (course, c) = (&leg.course, &self.coordinate);
        let slowest = course.speed.least()?;
        let (place, place_error) = course.coordinate.at(theta);
        let (velocity, velocity_error) = course.velocity.at(theta);
        let (balance, balance_error) = course.balance.at(theta);
        let off = upper_bound(&(&leg.energy / &slowest));
        let damping = &self.u.high * &leg.paces.high;
        let delta = balance.size() + balance_error + &course.balance_error + damping * &off;
        let delta = upper_bound(&(delta / (&leg.paces.low * &leg.paces.low)));
        // Of the motion itself, not of its polynomial.
        let slowest = lower_bound(&((slowest - &off) / &leg.paces.high));
        let place = place.range();
        let one = Ball::from_integer(1, BOUND_BITS);
        let low = lower_bound(&((place.low - &place_error) * (&one - one.shifted(ROOM))));
        let high = upper_bound(&((place.high + &place_error) * (&one + one.shifted(ROOM))));
        if !low.is_positive() || !slowest.is_positive() {
            return None;
        }
        let least = |power: &BigRational| {
            let (x, y) = (lower_bound(&low.pow(power)), lower_bound(&high.pow(power)));
            if (&x - &y).is_positive() { y } else { x }
        };
        let power = c.force_power();
        let rise = Ball::from_rational(&power, BOUND_BITS) * least(&(&power - BigRational::one()));
        let rise = lower_bound(&rise.shifted(-1));
        let width = upper_bound(&(&delta / &rise));
        let q = Ball::from_rational(&c.q, BOUND_BITS);
        let pull = upper_bound(&(q * high.pow(&(&c.damping - BigRational::one())) / &slowest).shifted(1));
        let bent = upper_bound(&(&pull * &delta * &self.u.high));
        let near = (low.shifted(ROOM) - &width).is_positive() && (rise - bent).is_positive();
        let mut exit = near.then(|| self.leave(leg, &velocity, velocity_error + off)).flatten()?;
        exit.error = upper_bound(&(exit.error + pull * delta * width));
        Some(exit)
    }

    /// A velocity of the step, known within `error`, in the time of the collision.
    fn leave(&self, leg: &Leg, velocity: &Jets, error: Ball) -> Option<Exit> {
        let (velocity, lost) = leg.in_common_time(velocity, self.flow.bits)?;
        Some(Exit { velocity, error: upper_bound(&(error / &leg.paces.low + lost)) })
    }
}

/// The place between 0 and `2^bits` where a condition begins to hold, to half of the part `2^-HALVINGS`.
fn halved(bits: u32, holds: impl Fn(&Integer) -> bool) -> Integer {
    let mut half = Integer::from(1) << (bits - 1);
    let mut middle = half.clone();
    for _ in 0..HALVINGS {
        half >>= 1;
        if holds(&middle) { middle -= &half } else { middle += &half }
    }
    middle
}

/// The zero in `theta` of a polynomial that falls from above to below 0, as a jet, approximately.
fn root(events: &Jets) -> Option<Vec<Integer>> {
    let bits = events.bits;
    let column: Vec<Integer> = (0..events.rows()).map(|k| events.row(k)[0].clone()).collect();
    let column = Jets { width: 1, bits, coefficients: column };
    let constant = |value: &Integer| Jets::constant(std::slice::from_ref(value), bits);
    let mut theta = vec![Integer::new(); events.width];
    theta[0] = halved(bits, |middle| column.at(&constant(middle)).0.row(0)[0].is_negative());
    let derivative = events.derivative();
    for _ in 0..NEWTON_STEPS {
        let place = Jets::constant(&theta, bits);
        let (value, slope) = (events.at(&place).0, derivative.at(&place).0);
        let correction = quotient(value.row(0), slope.row(0), bits)?;
        theta.iter_mut().zip(&correction).for_each(|(t, c)| *t -= c);
    }
    Some(theta)
}

#[cfg(test)]
mod tests;
