//! One Taylor step of the phase plane, `v` as a function of `z`.

use crate::envelope::{Envelope, upper_half};
use crate::equation::Equation;
use crate::fixed::{
    BOUND_BITS, exact_fixed, from_fixed, lower_bound, power_of_two, size, unit, upper_bound, zero,
};
use crate::online::Online;
use crate::phase_sides::Sides;
use restitution_real::Ball;
use rug::{Float, Integer};

/// A point of the phase plane: where `z` is exact, the true speed has `|v^2 - speed^2| <= energy`.
#[derive(Clone, Debug)]
pub(crate) struct PhasePoint {
    pub(crate) z: Float,
    /// The approximate velocity, exact as a number; negative on the way out.
    pub(crate) v: Float,
    /// Bound of the error of `v^2`.
    pub(crate) energy: Ball,
}

impl PhasePoint {
    /// The true velocity.
    pub(crate) fn velocity(&self) -> Ball {
        let v = Ball::exact(self.v.clone());
        velocity_near(&v, &self.energy)
    }
}

/// Returns the ball of all velocities with `|V^2 - v^2| <= energy` and the sign of `v`.
///
/// ```text
/// |V - v| = |V^2 - v^2|/(|V| + |v|) <= energy/|v|
/// ```
pub(crate) fn velocity_near(v: &Ball, energy: &Ball) -> Ball {
    let speed = lower_bound(&v.abs());
    if !speed.is_positive() || !(&speed * &speed - energy).is_positive() {
        return Ball::whole_line(v.prec());
    }
    v.clone().widened(&(energy / speed).upper())
}

/// The Taylor polynomial of `v` on `z = z_0 + h theta`, `0 <= theta <= 1`, with a proved remainder.
///
/// With `P(theta) = scale Sum c_k theta^k` the energy of the error obeys docs/direct-integration.md,
/// Prop. 1: it only shrinks, but for the defect of the polynomial.
#[derive(Clone, Debug)]
pub(crate) struct PhaseArc {
    pub(crate) start: Float,
    pub(crate) end: Float,
    coefficients: Vec<Integer>,
    bits: u32,
    /// Binary logarithm of the scale.
    scale: i64,
    /// Bound of `|v^2 - P^2|` all along the arc.
    pub(crate) energy: Ball,
    /// Bits lost per degree, which tells how long the next step may be.
    pub(crate) slope: f64,
    /// The point reached.
    pub(crate) reached: PhasePoint,
}

impl PhaseArc {
    /// Follows the motion from `from` to the coordinate `end`; `None` if the step is too long to prove.
    pub(crate) fn follow(equation: &Equation, from: &PhasePoint, end: &Float) -> Option<Self> {
        let (bits, order) = (equation.prec, equation.order);
        let scale = i64::from(from.v.get_exp()?);
        let sides = Sides::expand(equation, &from.z, end, scale)?;
        let start = exact_fixed(&Ball::exact(from.v.clone()).shifted(i32::try_from(-scale).ok()?), bits)?;
        let coefficients = taylor(&sides, start, order, bits);

        let total = size(&coefficients, bits);
        let head = size(&coefficients[..1], bits);
        let start_energy = upper_bound(&(from.energy.with_prec(BOUND_BITS) * power_of_two(-2 * scale)));
        let envelope = Envelope::tightest(&coefficients, bits);
        let tail = upper_half(envelope, envelope, order) + sides.overflow(&coefficients, bits);
        if !lower_is_within(&tail, bits) {
            return None;
        }
        // 2 Int |defect|: divisions, both sides, the degrees beyond the order (Prop. 2).
        let rounding = &head * unit(bits) * Ball::from_integer(2 * order as i64, BOUND_BITS);
        let two = Ball::from_integer(2, BOUND_BITS);
        let defect = rounding + two * (&sides.elastic_error + &sides.damping_error * &total) + tail;
        let energy = upper_bound(&(&start_energy + &defect));
        let (slowest, fastest) = extremes(&coefficients, bits);
        let lowest = lower_bound(&slowest);
        if !lowest.is_positive() || !(&lowest * &lowest - &energy).is_positive() {
            return None;
        }
        let decay = sides.decay(&fastest, &energy);
        let end_energy = upper_bound(&(start_energy * decay + defect));

        let sum: Integer = coefficients.iter().sum();
        let v = from_fixed(&sum, bits, bits);
        let rounding = Ball::exact(v.rad().clone()) * (v.abs() + v.abs());
        let unscale = power_of_two(2 * scale);
        let reached = PhasePoint {
            z: end.clone(),
            v: v.shifted(i32::try_from(scale).ok()?).mid().clone(),
            energy: upper_bound(
                &((end_energy + upper_bound(&rounding) * Ball::from_integer(2, BOUND_BITS)) * &unscale),
            ),
        };
        let energy = upper_bound(&(energy * unscale));
        Some(Self {
            start: from.z.clone(),
            end: end.clone(),
            coefficients,
            bits,
            scale,
            energy,
            slope: envelope.decay_seen(order),
            reached,
        })
    }

    /// The coordinate at the part `theta` of the step.
    pub(crate) fn coordinate(&self, equation: &Equation, theta: &Ball) -> Ball {
        let exact = |z: &Float| Ball::exact(z.clone()).with_prec(equation.prec);
        let (start, end) = (exact(&self.start), exact(&self.end));
        if equation.coordinate.crosses_zero() {
            return &start + (end - &start) * theta;
        }
        &start * ((end / &start).ln() * theta).exp()
    }

    /// The true velocity at the part `theta` of the step, computed with `prec` bits.
    pub(crate) fn velocity(&self, theta: &Ball, prec: u32) -> Ball {
        let mut sum = zero();
        for c in self.coefficients.iter().rev() {
            sum = sum * theta + from_fixed(c, self.bits, prec + 16);
        }
        velocity_near(&sum.shifted(i32::try_from(self.scale).unwrap_or(0)), &self.energy)
    }
}

/// Bounds of `|P|` from below and above on `0 <= theta <= 1`: those of its chord, less or more the bend.
///
/// A chord that changes its sign has a negative one from below, however far beyond zero it ends.
fn extremes(coefficients: &[Integer], bits: u32) -> (Ball, Ball) {
    let start = coefficients[0].clone().abs();
    let end = Integer::from(&coefficients[0] + &coefficients[1]);
    let end = if coefficients[0].is_negative() { -end } else { end };
    let bend = size(&coefficients[2..], bits);
    let ball = |n: &Integer| from_fixed(n, bits, BOUND_BITS);
    let fastest = ball(&start).union(&ball(&end)).abs_up();
    (ball((&start).min(&end)) - &bend, upper_bound(&(Ball::exact(fastest) + bend)))
}

/// Whether the cut-off costs no more than a dozen bits of the working precision.
pub(crate) fn lower_is_within(tail: &Ball, bits: u32) -> bool {
    tail.is_finite() && !(tail - power_of_two(14 - i64::from(bits))).is_positive()
}

/// Solves `2 c_0 c_k = (2/k) g_(k-1) - Sum_(0<i<k) c_i c_(k-i)`, `g = -(elastic + damping P)`.
///
/// All integers are in units of `2^-bits`; each division leaves less than `2 c_0` units.
fn taylor(sides: &Sides, start: Integer, order: usize, bits: u32) -> Vec<Integer> {
    let mut c = Vec::with_capacity(order + 1);
    let double = Integer::from(&start * 2);
    let (mut square, mut damped) = (Online::new(order, bits), Damped::new(&sides.damping, order, bits));
    c.push(start);
    for k in 1..=order {
        let mut side = sides.elastic.get(k - 1).map_or_else(Integer::new, |e| Integer::from(e << bits));
        side += damped.next(&c);
        let divisor = Integer::from(&double * k as u64);
        let products = square.square(&c) * k as u64;
        let dividend = -(side * 2u32) - products;
        c.push(dividend / divisor);
    }
    c
}

/// The coefficients of `damping * P` in turn: by the definition where the damping has a few terms only.
struct Damped<'a> {
    /// The damping, moved up by one degree.
    damping: Vec<Integer>,
    few: &'a [Integer],
    online: Online,
}

impl<'a> Damped<'a> {
    fn new(damping: &'a [Integer], order: usize, bits: u32) -> Self {
        if damping.len() < FEW_TERMS {
            return Self { damping: Vec::new(), few: damping, online: Online::new(0, 1) };
        }
        let moved = std::iter::once(Integer::new()).chain(damping.iter().cloned()).collect();
        Self { damping: moved, few: &[], online: Online::new(order, bits) }
    }

    /// `Sum_(j<k) damping_j c_(k-1-j)` for `k` coefficients `c`.
    fn next(&mut self, c: &[Integer]) -> Integer {
        if self.damping.is_empty() {
            return self.few.iter().zip(c.iter().rev()).map(|(b, c)| Integer::from(b * c)).sum();
        }
        self.online.product_with_known(c, &self.damping)
    }
}

/// Terms from which on a product of series is worth its set-up.
const FEW_TERMS: usize = 33;

#[cfg(test)]
mod exactly;

#[cfg(test)]
mod tests {
    use super::*;
    use restitution_law::ForceLaw;

    fn energy(value: f64) -> Ball {
        Ball::from_f64(value, BOUND_BITS)
    }

    #[test]
    fn a_velocity_is_known_as_long_as_the_error_leaves_its_sign() {
        // |V - v| <= energy/|v| while energy < v^2; speeds on both sides of 1 and 2, where v^2 is v + v.
        for v in [-0.5, 0.75, 1.5, -3.0] {
            let ball = Ball::from_f64(v, 64);
            let near = velocity_near(&ball, &energy(0.9 * v * v));
            let (off, bound) = (near.rad().to_f64(), 0.9 * v.abs());
            assert!(off >= bound && off < 1.001 * bound, "{v}: {near:?}");
            for beyond in [1.0, 1.1, 1.9] {
                let unknown = velocity_near(&ball, &energy(beyond * v * v));
                assert!(!unknown.is_finite(), "{v} {beyond}: {unknown:?}");
            }
        }
        assert!(!velocity_near(&Ball::from_f64(0.0, 64), &energy(1e-9)).is_finite());
        assert!(
            !velocity_near(&Ball::from_f64(1.0, 64).widened(&Float::with_val(64, 1)), &energy(0.0))
                .is_finite()
        );
    }

    /// Its rounding is far below what the arc leaves over.
    #[test]
    fn a_velocity_on_an_arc_has_the_error_of_the_arc() {
        let equation = Equation::new(&ForceLaw::viscoelastic_spheres(), &Ball::from_ratio(1, 2, 80), 80);
        let from = PhasePoint { z: Float::with_val(80, 0.25), v: Float::with_val(80, -1), energy: zero() };
        let arc = PhaseArc::follow(&equation, &from, &Float::with_val(80, 0.2)).unwrap();
        let velocity = arc.velocity(&Ball::from_ratio(1, 2, 80), 80);
        assert!(velocity.is_negative());
        let wanted = arc.energy.to_f64() / velocity.to_f64().abs();
        assert!((velocity.rad().to_f64() / wanted - 1.0).abs() < 0.001, "{velocity:?} {wanted:e}");
    }

    #[test]
    fn an_arc_whose_error_could_bring_the_motion_to_rest_is_refused() {
        // A short arc at v = 1 keeps most of its speed: the energy of the error has to stay below the square of it.
        let equation = Equation::new(&ForceLaw::viscoelastic_spheres(), &Ball::from_ratio(1, 2, 80), 80);
        let (z, end) = (Float::with_val(80, 0.25), Float::with_val(80, 0.2501));
        let arc = |value: f64| {
            let from = PhasePoint { z: z.clone(), v: Float::with_val(80, 1), energy: energy(value) };
            PhaseArc::follow(&equation, &from, &end)
        };
        assert!(arc(0.95).is_some_and(|arc| arc.energy.to_f64() < 0.96));
        for value in [1.0, 1.2, 1.5, 2.0, 3.9, 5.0] {
            assert!(arc(value).is_none(), "{value}");
        }
    }

    #[test]
    fn a_polynomial_that_changes_its_sign_has_no_least_speed() {
        // 1 - 3 theta ends at -2, farther from zero than it began; bent by 1/4 it is no better.
        for signs in [1, -1] {
            let c = [4, -12, 1].map(|c| Integer::from(c * signs));
            let (slowest, fastest) = extremes(&c, 2);
            assert_eq!((slowest.to_f64(), fastest.to_f64()), (-2.25, 2.25));
        }
        let (slowest, fastest) = extremes(&[-4, 2, 0].map(Integer::from), 2);
        assert_eq!((slowest.to_f64(), fastest.to_f64()), (0.5, 1.0));
    }
}
