//! Both sides of the phase plane's equation as polynomials on one step.

use crate::equation::Equation;
use crate::fixed::{BOUND_BITS, lower_bound, size, to_fixed, upper_bound, zero};
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};
use restitution_real::Ball;
use rug::{Float, Integer};

/// Both sides of `v v' = -(elastic + damping v)` as polynomials in `theta`, in units of the scale.
pub(crate) struct Sides {
    pub(crate) elastic: Vec<Integer>,
    pub(crate) damping: Vec<Integer>,
    /// Bound of `Int |error|` of each.
    pub(crate) elastic_error: Ball,
    pub(crate) damping_error: Ball,
    /// `2 q u |z_1^B - z_0^B|/B` in units of the scale.
    friction: Ball,
}

impl Sides {
    /// Expands `q z^(A-1) dz/dtheta` and `q u z^(B-1) dz/dtheta` on the way from `z_0` to `z_1`.
    ///
    /// The way is `z = z_0 + (z_1 - z_0) theta` where the phase plane is analytic at zero, else
    /// `z = z_0 (z_1/z_0)^theta`, for which the branch point lies at infinity.
    pub(crate) fn expand(equation: &Equation, z0: &Float, z1: &Float, scale: i64) -> Option<Self> {
        let c = &equation.coordinate;
        let exact = |z: &Float| Ball::exact(z.clone()).with_prec(equation.prec);
        let way = Way::between(equation, z0, z1);
        let shift = |n: i64| i32::try_from(n).ok();
        let q = equation.rational(&c.q);
        let elastic = way.expand(&c.elastic, equation)?.times(&q.shifted(shift(-2 * scale)?));
        let damping = way.expand(&c.damping, equation)?.times(&(q * &equation.u).shifted(shift(-scale)?));
        let (mut elastic_error, mut damping_error) = (elastic.tail, damping.tail);
        let fix = |balls: &[Ball], error: &mut Ball| -> Vec<Integer> {
            balls.iter().map(|b| to_fixed(b, equation.prec, error)).collect()
        };
        let elastic = fix(&elastic.terms, &mut elastic_error);
        let damping: Vec<Integer> = fix(&damping.terms, &mut damping_error);
        let span = (exact(z1).pow(&c.damping) - exact(z0).pow(&c.damping)).abs();
        let work = span * &equation.u * equation.rational(&(&c.q / &c.damping)).shifted(shift(1 - scale)?);
        let friction = lower_bound(&work).with_prec(BOUND_BITS);
        let friction = if friction.is_positive() { friction } else { zero() };
        Some(Self { elastic, damping, elastic_error, damping_error, friction })
    }

    /// The degrees `>= order` of `damping * P` and of `elastic`, integrated and doubled.
    pub(crate) fn overflow(&self, coefficients: &[Integer], bits: u32) -> Ball {
        let order = coefficients.len() - 1;
        let mut sum = zero();
        for j in 0..self.damping.len() {
            let first = (order - j).min(order);
            let part = size(&coefficients[first..], bits) * size(&self.damping[j..=j], bits);
            sum += part;
        }
        sum + size(self.elastic.get(order..).unwrap_or_default(), bits)
    }

    /// `exp(-Int 2 h q u z^(B-1)/(|v| + |P|))`, an upper bound of how much the error's energy keeps.
    pub(crate) fn decay(&self, fastest: &Ball, energy: &Ball) -> Ball {
        let fastest = fastest + upper_bound(&(fastest * fastest + energy).sqrt());
        upper_bound(&(-(&self.friction / fastest)).exp())
    }
}

/// The terms of a power series in `theta`.
struct Terms {
    terms: Vec<Ball>,
    /// Bound of the sum of the terms left out.
    tail: Ball,
}

impl Terms {
    fn times(mut self, factor: &Ball) -> Self {
        for term in &mut self.terms {
            *term = &*term * factor;
        }
        self.tail = upper_bound(&(self.tail * factor.abs()));
        self
    }
}

/// How the coordinate runs with `theta`.
enum Way {
    /// `z = start + length theta`.
    Straight { start: Ball, length: Ball },
    /// `z = start exp(length theta)`.
    Exponential { start: Ball, length: Ball },
}

impl Way {
    fn between(equation: &Equation, z0: &Float, z1: &Float) -> Self {
        let (from, to) = (Ball::exact(z0.clone()), Ball::exact(z1.clone()));
        let start = from.with_prec(equation.prec);
        if equation.coordinate.crosses_zero() {
            return Self::Straight { start, length: (&to - &from).with_prec(equation.prec) };
        }
        Self::Exponential { start, length: (to.with_prec(equation.prec + 16) / from).ln() }
    }

    /// The series of `z^(n-1) dz/dtheta`; `None` if it is too long.
    fn expand(&self, n: &BigRational, equation: &Equation) -> Option<Terms> {
        match self {
            Self::Straight { start, length } => {
                let degree = (n - BigRational::one()).to_integer().to_i64()?;
                Some(Terms { terms: binomial(degree, start, length), tail: zero() }.times(length))
            }
            Self::Exponential { start, length } => {
                let rate = length * equation.rational(n);
                Some(exponential(&rate, equation.order)?.times(&(start.pow(n) * length)))
            }
        }
    }
}

/// `Binomial(m, j) z^(m-j) h^j`, the terms of `(z + h theta)^m` for an integer `m >= 0`.
fn binomial(m: i64, z: &Ball, h: &Ball) -> Vec<Ball> {
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

/// The terms `rate^k/k!` of `exp(rate theta)`, cut off at the order.
///
/// From there on the ratio of terms is at most `|rate|/(order + 1)`.
fn exponential(rate: &Ball, order: usize) -> Option<Terms> {
    let mut term = Ball::from_integer(1, rate.prec());
    let mut terms = Vec::with_capacity(order);
    for k in 1..=order {
        let next = &term * rate / Ball::from_integer(i64::try_from(k).ok()?, rate.prec());
        terms.push(std::mem::replace(&mut term, next));
    }
    let ratio = rate.abs() / Ball::from_integer(i64::try_from(order + 1).ok()?, BOUND_BITS);
    let left = lower_bound(&(Ball::from_integer(1, BOUND_BITS) - upper_bound(&ratio)));
    left.is_positive().then(|| Terms { terms, tail: upper_bound(&(upper_bound(&term.abs()) / left)) })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Degrees 2 and more of `damping * P` and of `elastic`, for a `P` of degree 2.
    #[test]
    fn what_is_beyond_the_order_is_summed() {
        let numbers = |c: &[i32]| -> Vec<Integer> { c.iter().copied().map(Integer::from).collect() };
        let overflow = |elastic: &[i32]| {
            let (elastic, damping) = (numbers(elastic), numbers(&[3, -5]));
            let sides =
                Sides { elastic, damping, elastic_error: zero(), damping_error: zero(), friction: zero() };
            sides.overflow(&numbers(&[7, -11, 13]), 0).to_f64()
        };
        let damped = f64::from(3 * 13 + 5 * (11 + 13));
        assert_eq!(overflow(&[1, 2]), damped);
        assert_eq!(overflow(&[1]), damped);
        assert_eq!(overflow(&[1, 2, -4, 8]), damped + 12.0);
    }

    /// `1/3!`, over one less the ratio 1/4 of the terms.
    #[test]
    fn the_tail_of_an_exponential_is_that_of_a_geometric_series() {
        let found = exponential(&Ball::from_integer(1, 80), 3).unwrap();
        assert_eq!(found.terms.iter().map(Ball::to_f64).collect::<Vec<_>>(), [1.0, 1.0, 0.5]);
        let tail = found.tail.to_f64();
        assert!((tail / (1.0 / 6.0 / 0.75) - 1.0).abs() < 1e-15, "{tail}");
        assert!(exponential(&Ball::from_f64(3.99, 80), 3).is_some());
        assert!(exponential(&Ball::from_integer(4, 80), 3).is_none());
    }
}
