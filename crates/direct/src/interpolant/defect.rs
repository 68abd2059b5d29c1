//! What a polynomial motion leaves over in the equation of motion, exactly.

use super::arc::{Flow, Step};
use super::jets::{Jets, Range};
use crate::fixed::{BOUND_BITS, from_fixed, upper_bound, zero};
use restitution_real::Ball;
use rug::Integer;

/// A polynomial motion of one step, with the bounds that every proof about it needs.
///
/// `v = (q/h) dz/dtheta` holds exactly, by definition of `v`, the velocity in the time of the step.
pub(crate) struct Course {
    pub(crate) coordinate: Jets,
    pub(crate) velocity: Jets,
    /// `c^2 z^elastic + c u z^damping v`, within `balance_error`.
    pub(crate) balance: Jets,
    pub(crate) balance_error: Ball,
    /// Bounds of `z` and of `v`.
    pub(crate) place: Range,
    pub(crate) speed: Range,
    /// Bounds of the defect `dv/dtheta + h (...)`: the largest value, and the integral.
    pub(crate) largest_defect: Ball,
    pub(crate) defect: Ball,
    /// The part of the defect that a shorter step makes smaller.
    pub(crate) cut_off: Ball,
    /// `h`.
    pub(crate) length: Ball,
}

/// A polynomial near another function, with a bound of the distance in the norm of its coefficients.
struct Near {
    jets: Jets,
    error: Ball,
}

impl Near {
    /// `|x y - X Y| <= |x| dy + |y| dx + dx dy + rounding`, each in the norm, in which products are
    /// bounded by products.
    fn times(&self, other: &Self, flow: &Flow) -> Self {
        let mut error =
            &self.jets.size() * &other.error + &other.jets.size() * &self.error + &self.error * &other.error;
        let product = self.jets.product(&other.jets);
        let jets = product.rounded(flow.order + 1, flow.width, flow.bits, &mut error);
        Self { jets, error: upper_bound(&error) }
    }
}

impl Course {
    /// Measures a motion: every product is exact, what is rounded or cut off is counted.
    pub(crate) fn measure(flow: &Flow, coordinate: Jets, step: Step) -> Self {
        let bits = flow.bits;
        let velocity = velocity(&coordinate, step);
        let powers = Powers::new(flow, &coordinate);
        let row = |jet: &[Integer]| Near { jets: Jets::constant(jet, bits), error: zero() };
        let pace = row(&flow.pace);
        let mut error = zero();
        let fixed = velocity.rounded(flow.order, flow.width, bits, &mut error);
        let pull = row(&flow.u).times(&pace, flow).times(&Near { jets: fixed, error }, flow);
        let damped = powers.times(flow.damping, pull, flow);
        let elastic = powers.get(flow.elastic, flow).times(&pace.times(&pace, flow), flow);
        let balance = Near {
            jets: damped.jets.plus(&elastic.jets),
            error: upper_bound(&(damped.error + elastic.error)),
        };
        let common = powers.get(flow.common, flow);
        // h = q 2^shift/rate; the defect times rate and the denominator of q is a whole number.
        let force = common.jets.product(&balance.jets);
        let force_error = &common.jets.size() * &balance.error
            + &balance.jets.size() * &common.error
            + &common.error * &balance.error;
        let (q, rate) = (&flow.q, Integer::from(step.rate));
        let scale = rate * &q.1;
        let mut change = velocity.derivative();
        change.coefficients.iter_mut().for_each(|c| *c *= &scale);
        let mut pushed = force;
        pushed.coefficients.iter_mut().for_each(|c| {
            *c *= &q.0;
            *c <<= step.shift;
        });
        let defect = change.plus(&pushed);
        let scale = Ball::from_big_integer(&scale, BOUND_BITS);
        let length = Ball::from_big_integer(&(Integer::from(&q.0) << step.shift), BOUND_BITS) / &scale;
        let approximation = upper_bound(&(&length * force_error));
        let bound = |x: Ball| upper_bound(&(upper_bound(&(x / &scale)) + &approximation));
        Self {
            largest_defect: bound(defect.size()),
            defect: bound(defect.integral()),
            cut_off: upper_bound(&(tail(&defect, flow) / &scale)),
            place: coordinate.range(),
            speed: velocity.range(),
            coordinate,
            velocity,
            balance: balance.jets,
            balance_error: balance.error,
            length,
        }
    }
}

/// The rows of the defect beyond the order, without the columns beyond the width.
fn tail(defect: &Jets, flow: &Flow) -> Ball {
    (flow.order.saturating_sub(1)..defect.rows()).fold(zero(), |sum, k| {
        sum + crate::fixed::size(&defect.row(k)[..flow.width.min(defect.width)], defect.bits)
    })
}

/// `v = (q/h) dz/dtheta = rate 2^-shift dz/dtheta`, exactly.
fn velocity(coordinate: &Jets, step: Step) -> Jets {
    let mut out = coordinate.derivative();
    out.coefficients.iter_mut().for_each(|c| *c *= step.rate);
    out.bits += step.shift;
    out
}

/// Powers of the coordinate.
struct Powers {
    coordinate: Jets,
    known: Vec<(u32, Near)>,
}

impl Powers {
    fn new(flow: &Flow, coordinate: &Jets) -> Self {
        let mut powers = Self { coordinate: coordinate.clone(), known: Vec::new() };
        for n in flow.powers() {
            let power = powers.get(n / 2, flow).times(&powers.get(n.div_ceil(2), flow), flow);
            powers.known.push((n, power));
        }
        powers
    }

    fn get(&self, n: u32, flow: &Flow) -> Near {
        if n == 0 {
            return Near { jets: Jets::constant(&[Integer::from(1) << flow.bits], flow.bits), error: zero() };
        }
        match self.known.iter().find(|(m, _)| *m == n) {
            Some((_, power)) => Near { jets: power.jets.clone(), error: power.error.clone() },
            None => Near { jets: self.coordinate.clone(), error: zero() },
        }
    }

    /// `z^n` times something.
    fn times(&self, n: u32, other: Near, flow: &Flow) -> Near {
        if n == 0 { other } else { self.get(n, flow).times(&other, flow) }
    }
}

/// A number of units of `2^-bits` as a bound.
pub(crate) fn units(count: usize, bits: u32) -> Ball {
    from_fixed(&Integer::from(count), bits, BOUND_BITS)
}

#[cfg(test)]
mod tests;
