//! The Taylor coefficients of a step around the turning point, in fixed point.

use crate::equation::Equation;
use crate::fixed::{exact_fixed, from_fixed, to_fixed, zero};
use crate::online::Online;
use crate::turning_point::{TurningPoint, friction_ratio};
use num_rational::BigRational;
use restitution_real::Ball;
use restitution_real::convert::rug_integer;
use rug::{Float, Integer};

/// One step in its own units: `v = v_0 + h theta` in `2^velocity_scale`, `y` in `2^scale`.
pub(crate) struct Problem {
    pub(crate) start_v: Float,
    pub(crate) end_v: Float,
    pub(crate) scale: i64,
    pub(crate) velocity_scale: i64,
    /// `1 - c = (gamma + 1)/(a + 1)`.
    pub(crate) one_minus_c: BigRational,
    /// Bound of the error of `-h v`, integrated.
    pub(crate) right_error: Ball,
    /// Bound of the error of `K` at the start.
    pub(crate) ratio_error: Ball,
    v: Integer,
    h: Integer,
    right: [Integer; 2],
    y: Integer,
    ratio: Integer,
    bits: u32,
}

impl Problem {
    /// Poses the step from a point to a velocity; `None` if it has no fixed-point form.
    pub(crate) fn pose(equation: &Equation, from: &TurningPoint, end: &Float) -> Option<Self> {
        let bits = equation.prec;
        let exact = |x: &Float| Ball::exact(x.clone());
        let h = exact(&Float::with_val(2 * bits + 64, end - &from.v));
        let velocity_scale = i64::from(from.v.get_exp().unwrap_or(i32::MIN).max(h.mid().get_exp()?));
        let scale = i64::from(from.y.get_exp()?);
        let (in_y, in_v) = (i32::try_from(-scale).ok()?, i32::try_from(-velocity_scale).ok()?);
        let (mut right_error, mut ratio_error) = (zero(), zero());
        let mut right =
            |x: Ball| to_fixed(&(-(&h * x).with_prec(bits)).shifted(in_y), bits, &mut right_error);
        let right = [right(exact(&from.v)), right(h.clone())];
        let ratio = friction_ratio(equation, &exact(&from.y).with_prec(bits)).shifted(-in_v);
        Some(Self {
            v: exact_fixed(&exact(&from.v).shifted(in_v), bits)?,
            h: exact_fixed(&h.shifted(in_v), bits)?,
            y: exact_fixed(&exact(&from.y).shifted(in_y), bits)?,
            ratio: to_fixed(&ratio, bits, &mut ratio_error),
            one_minus_c: equation.law.damping_step() / equation.law.elastic_step(),
            start_v: from.v.clone(),
            end_v: end.clone(),
            scale,
            velocity_scale,
            right_error,
            ratio_error,
            right,
            bits,
        })
    }

    /// The length `|h|` in units of the velocity's scale.
    pub(crate) fn length(&self) -> Ball {
        from_fixed(&self.h, self.bits, crate::fixed::BOUND_BITS).abs()
    }

    /// Solves the two relations for the coefficients in turn; each division truncates.
    ///
    /// ```text
    /// k y_k (1 + v_0 K_0) = right_(k-1) - h M_(k-2) - v_0 (M_(k-1) - k y_k K_0),   M = K y'
    /// y_0 K_k = (1-c) M_(k-1)/k - Sum_(i=1)^k y_i K_(k-i)
    /// ```
    pub(crate) fn solve(&self, equation: &Equation) -> Option<Series> {
        let (bits, order) = (equation.prec, equation.order);
        let (top, bottom) = (rug_integer(self.one_minus_c.numer()), rug_integer(self.one_minus_c.denom()));
        let force = (Integer::from(1) << bits) + (Integer::from(&self.v * &self.ratio) >> bits);
        if force <= 0 {
            return None;
        }
        let weighted = Integer::from(&bottom * &self.y);
        let mut derivative = vec![Integer::new()];
        let (mut moved, mut powers) = (Online::new(order, bits), Online::new(order, bits));
        let mut s = Series {
            y: vec![self.y.clone()],
            ratio: vec![self.ratio.clone()],
            product: Vec::with_capacity(order),
            force,
        };
        for k in 1..=order {
            let known = moved.product(&derivative, &s.ratio);
            let mut side = self.right.get(k - 1).map_or_else(Integer::new, |r| Integer::from(r << bits));
            if k >= 2 {
                side -= &self.h * &s.product[k - 2];
            }
            side -= &self.v * Integer::from(&known >> bits);
            let coefficient = side / Integer::from(&s.force * k as u64);
            derivative.push(Integer::from(&coefficient * k as u64));
            s.y.push(coefficient);
            let product = known + &derivative[k] * &s.ratio[0];
            s.product.push(Integer::from(&product >> bits));
            let mut rest = powers.product(&s.y, &s.ratio) + &s.y[k] * &s.ratio[0];
            rest *= &bottom;
            rest *= k as u64;
            s.ratio.push((product * &top - rest) / Integer::from(&weighted * k as u64));
        }
        Some(s)
    }
}

/// The coefficients of `y`, of `K` and of the product `K y'`, in units of `2^-bits`.
pub(crate) struct Series {
    pub(crate) y: Vec<Integer>,
    pub(crate) ratio: Vec<Integer>,
    pub(crate) product: Vec<Integer>,
    /// `1 + v K` at the start, rounded down.
    pub(crate) force: Integer,
}

impl Series {
    /// The polynomial `y` at the end of the step, and the rounding of it.
    pub(crate) fn end(&self, bits: u32) -> (Ball, Ball) {
        let sum: Integer = self.y.iter().sum();
        let y = from_fixed(&sum, bits, bits);
        let rounding = Ball::exact(y.rad().clone());
        (y, rounding)
    }
}
