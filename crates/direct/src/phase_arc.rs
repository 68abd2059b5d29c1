//! One Taylor step of the phase plane, `v` as a function of `z`.

use crate::envelope::{Envelope, upper_half};
use crate::field::Field;
use crate::fixed::{BOUND_BITS, from_fixed, lower_bound, power_of_two, size, to_fixed, unit, upper_bound};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};
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
    pub(crate) fn follow(field: &Field, from: &PhasePoint, end: &Float) -> Option<Self> {
        let (bits, order) = (field.prec, field.order);
        let scale = i64::from(from.v.get_exp()?);
        let sides = Sides::expand(field, &from.z, end, scale)?;
        let start =
            to_fixed(&Ball::exact(from.v.clone()).shifted(i32::try_from(-scale).ok()?), bits, &mut zero());
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

    /// The true velocity at the part `theta` of the step.
    pub(crate) fn velocity(&self, theta: &Ball) -> Ball {
        let mut sum = Ball::zero();
        for c in self.coefficients.iter().rev() {
            sum = sum * theta + from_fixed(c, self.bits, self.bits + 16);
        }
        velocity_near(&sum.shifted(i32::try_from(self.scale).unwrap_or(0)), &self.energy)
    }
}

pub(crate) fn zero() -> Ball {
    Ball::exact(Float::new(BOUND_BITS))
}

/// Bounds of `|P|` from below and above on `0 <= theta <= 1`: those of its chord, less or more the bend.
fn extremes(coefficients: &[Integer], bits: u32) -> (Ball, Ball) {
    let start = coefficients[0].clone().abs();
    let end = Integer::from(&coefficients[0] + &coefficients[1]).abs();
    let bend = size(&coefficients[2..], bits);
    let ball = |n: &Integer| from_fixed(n, bits, BOUND_BITS);
    (ball((&start).min(&end)) - &bend, upper_bound(&(ball((&start).max(&end)) + bend)))
}

/// Whether the cut-off costs no more than a dozen bits of the working precision.
pub(crate) fn lower_is_within(tail: &Ball, bits: u32) -> bool {
    tail.is_finite() && !(tail - power_of_two(14 - i64::from(bits))).is_positive()
}

/// Both sides of `v v' = -(elastic + damping v)` as polynomials in `theta`, in units of the scale.
struct Sides {
    elastic: Vec<Integer>,
    damping: Vec<Integer>,
    /// Bound of `Int |error|` of each.
    elastic_error: Ball,
    damping_error: Ball,
    /// `2 q u |z_1^B - z_0^B|/B` in units of the scale.
    friction: Ball,
}

impl Sides {
    /// Expands `h q z^(A-1)` and `h q u z^(B-1)` about `z_0`.
    fn expand(field: &Field, z0: &Float, z1: &Float, scale: i64) -> Option<Self> {
        let c = &field.coordinate;
        let exact = |z: &Float| Ball::exact(z.clone()).with_prec(field.prec);
        let (from, to) = (Ball::exact(z0.clone()), Ball::exact(z1.clone()));
        let h = (&to - &from).with_prec(field.prec);
        let shift = |n: i64| i32::try_from(n).ok();
        let front = &h * field.rational(&c.q);
        let elastic = powers(&c.elastic, &exact(z0), &h, field)?.times(&front.shifted(shift(-2 * scale)?));
        let damping =
            powers(&c.damping, &exact(z0), &h, field)?.times(&(&front * &field.u).shifted(shift(-scale)?));
        let (mut elastic_error, mut damping_error) = (elastic.tail, damping.tail);
        let fix = |balls: &[Ball], error: &mut Ball| -> Vec<Integer> {
            balls.iter().map(|b| to_fixed(b, field.prec, error)).collect()
        };
        let elastic = fix(&elastic.terms, &mut elastic_error);
        let damping: Vec<Integer> = fix(&damping.terms, &mut damping_error);
        let span = (exact(z1).pow(&c.damping) - exact(z0).pow(&c.damping)).abs();
        let work = span * &field.u * field.rational(&(&c.q / &c.damping)).shifted(shift(1 - scale)?);
        let friction = lower_bound(&work).with_prec(BOUND_BITS);
        let friction = if friction.is_positive() { friction } else { zero() };
        Some(Self { elastic, damping, elastic_error, damping_error, friction })
    }

    /// The degrees `>= order` of `damping * P` and of `elastic`, integrated and doubled.
    fn overflow(&self, coefficients: &[Integer], bits: u32) -> Ball {
        let order = coefficients.len() - 1;
        let mut sum = zero();
        for j in 1..self.damping.len() {
            let first = (order - j).min(order);
            let part = size(&coefficients[first..], bits) * size(&self.damping[j..=j], bits);
            sum += part;
        }
        if self.elastic.len() > order {
            sum += size(&self.elastic[order..], bits);
        }
        sum
    }

    /// `exp(-Int 2 h q u z^(B-1)/(|v| + |P|))`, an upper bound of how much the error's energy keeps.
    fn decay(&self, fastest: &Ball, energy: &Ball) -> Ball {
        let fastest = fastest + upper_bound(&(fastest * fastest + energy).sqrt());
        upper_bound(&(-(&self.friction / fastest)).exp())
    }
}

/// The binomial series of `(z_0 + h theta)^(n-1)`.
struct Powers {
    terms: Vec<Ball>,
    /// Bound of the sum of the terms left out.
    tail: Ball,
}

impl Powers {
    fn times(mut self, factor: &Ball) -> Self {
        for term in &mut self.terms {
            *term = &*term * factor;
        }
        self.tail = upper_bound(&(self.tail * factor.abs()));
        self
    }
}

/// The largest degree that is expanded to its end.
pub(crate) const LARGEST_DEGREE: i64 = 32;

fn powers(n: &BigRational, z: &Ball, h: &Ball, field: &Field) -> Option<Powers> {
    let exponent = n - BigRational::one();
    let short = exponent < BigRational::from_integer(LARGEST_DEGREE.into());
    if exponent.is_integer() && short {
        return Some(Powers { terms: polynomial(exponent.to_integer().to_i64()?, z, h), tail: zero() });
    }
    branch(&exponent, z, h, field)
}

/// `Binomial(m, j) z^(m-j) h^j` for an integer `m >= 0`.
fn polynomial(m: i64, z: &Ball, h: &Ball) -> Vec<Ball> {
    let mut binomial = Integer::from(1);
    (0..=m)
        .map(|j| {
            let term = z.powi(m - j) * h.powi(j) * Ball::from_big_integer(&binomial, z.prec());
            binomial *= m - j;
            binomial /= j + 1;
            term
        })
        .collect()
}

/// The same for any exponent, cut off at the order.
///
/// From `j = order` on the ratio of terms is at most `|h/z| max(1, (m - order)/(order + 1))`.
fn branch(m: &BigRational, z: &Ball, h: &Ball, field: &Field) -> Option<Powers> {
    let ratio = h / z;
    let mut term = z.pow(m);
    let mut terms = Vec::with_capacity(field.order);
    for j in 0..field.order {
        terms.push(term.clone());
        let j = BigInt::from(j);
        let factor = (m - BigRational::from_integer(j.clone())) / BigRational::from_integer(j + 1);
        term = term * &ratio * field.rational(&factor);
    }
    let order = BigRational::from_integer(field.order.into());
    let growth = ((m - &order) / (order + BigRational::one())).max(BigRational::one());
    let ratio = upper_bound(&(ratio.abs() * field.rational(&growth)));
    let left = Ball::from_integer(1, BOUND_BITS) - &ratio;
    if !left.is_positive() {
        return None;
    }
    Some(Powers { terms, tail: upper_bound(&(upper_bound(&term.abs()) / left)) })
}

/// Solves `2 c_0 c_k = (2/k) g_(k-1) - Sum_(0<i<k) c_i c_(k-i)`, `g = -(elastic + damping P)`.
///
/// All integers are in units of `2^-bits`; each division leaves less than `2 c_0` units.
fn taylor(sides: &Sides, start: Integer, order: usize, bits: u32) -> Vec<Integer> {
    let mut c = Vec::with_capacity(order + 1);
    let double = Integer::from(&start * 2);
    c.push(start);
    for k in 1..=order {
        let mut side = sides.elastic.get(k - 1).map_or_else(Integer::new, |e| Integer::from(e << bits));
        for (j, b) in sides.damping.iter().enumerate().take(k) {
            side += b * &c[k - 1 - j];
        }
        let divisor = Integer::from(&double * k as u64);
        let products = symmetric_products(&c, k) * k as u64;
        let dividend = -(side * 2u32) - products;
        c.push(dividend / divisor);
    }
    c
}

/// `Sum_(0<i<k) c_i c_(k-i)` with half the products.
fn symmetric_products(c: &[Integer], k: usize) -> Integer {
    let half = k.div_ceil(2);
    let mut sum = Integer::new();
    for i in 1..half {
        sum += &c[i] * &c[k - i];
    }
    sum *= 2;
    if k.is_multiple_of(2) {
        sum += c[k / 2].square_ref();
    }
    sum
}
