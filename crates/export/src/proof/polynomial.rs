//! What a form is in exact arithmetic: a polynomial.

use restitution::forms::Number;
use restitution_real::Ball;
use rug::Float;
use std::ops::Mul;

/// Bits of the coefficients; what rounding leaves is in the balls.
pub(super) const PREC: u32 = 192;

/// `Sum_j c_j x^j` on `-1 <= x <= 1`.
#[derive(Clone)]
pub(super) struct Polynomial(Vec<Ball>);

impl Polynomial {
    pub(super) fn constant(c: &Float) -> Self {
        Self(vec![Ball::exact(c.clone()).with_prec(PREC)])
    }

    pub(super) fn ball(c: Ball) -> Self {
        Self(vec![c])
    }

    /// `middle + half_width x`.
    pub(super) fn line(middle: &Float, half_width: &Float) -> Self {
        Self([middle, half_width].map(|c| Ball::exact(c.clone()).with_prec(PREC)).to_vec())
    }

    /// The polynomial of these coefficients in another.
    pub(super) fn composed(coefficients: &[Ball], inner: &Self) -> Self {
        coefficients.iter().rev().fold(Self(Vec::new()), |sum, c| {
            let product = sum * inner.clone();
            product.plus(&Self(vec![c.clone()]))
        })
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        let zero = Ball::from_integer(0, PREC);
        let at = |x: &Self, k: usize| x.0.get(k).unwrap_or(&zero).clone();
        Self((0..self.0.len().max(other.0.len())).map(|k| at(self, k) + at(other, k)).collect())
    }

    pub(super) fn scaled(&self, factor: &Ball) -> Self {
        Self(self.0.iter().map(|c| c * factor).collect())
    }

    /// The coefficients of the Chebyshev polynomials, by Horner's rule: `x T_k = (T_(k+1) + T_|k-1|)/2`.
    fn chebyshev(&self) -> Vec<Ball> {
        let mut out = vec![Ball::from_integer(0, PREC); self.0.len() + 1];
        for c in self.0.iter().rev() {
            let mut next = vec![Ball::from_integer(0, PREC); out.len()];
            for (k, a) in out.iter().enumerate().take(self.0.len() - 1) {
                let (up, half) = (k + 1, a.shifted(-1));
                next[up] = &next[up] + if k == 0 { a } else { &half };
                if k > 0 {
                    next[k - 1] = &next[k - 1] + half;
                }
            }
            next[0] = &next[0] + c;
            out = next;
        }
        out
    }

    /// A constant near it, and an upper bound of the absolute value: the sum of the Chebyshev coefficients without signs.
    pub(super) fn size(&self) -> (f64, f64) {
        let own = self.chebyshev();
        let sum = own.iter().fold(Ball::from_integer(0, PREC), |sum, c| sum + c.abs());
        let constant = own.first().map_or(0.0, |c| c.mid().to_f64().abs());
        (constant, sum.upper().to_f64_round(rug::float::Round::Up))
    }
}

impl Mul for Polynomial {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let mut out = vec![Ball::from_integer(0, PREC); (self.0.len() + other.0.len()).saturating_sub(1)];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                out[i + j] = &out[i + j] + a * b;
            }
        }
        if self.0.is_empty() || other.0.is_empty() { Self(Vec::new()) } else { Self(out) }
    }
}

impl Number for Polynomial {
    fn of(&self, constant: f64) -> Self {
        Self::constant(&Float::with_val(53, constant))
    }

    fn multiply_add(self, b: Self, c: Self) -> Self {
        (self * b).plus(&c)
    }

    fn negated(self) -> Self {
        Self(self.0.iter().map(|c| -c).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chebyshev_polynomial_is_bounded_by_one() {
        let exact = |x: f64| Float::with_val(PREC, x);
        let x = Polynomial::line(&exact(0.0), &exact(1.0));
        let (mut before, mut last) = (x.of(1.0), x.clone());
        for _ in 2..=9 {
            let next = x.of(2.0) * x.clone() * last.clone();
            (before, last) = (last, next.plus(&before.negated()));
        }
        let (constant, largest) = last.size();
        assert!(constant < 1e-50 && (1.0..1.0 + 1e-15).contains(&largest), "{constant} {largest}");
        assert_eq!(x.of(-3.0).plus(&x).size(), (3.0, 4.0));
    }

    /// Sums, products, compositions and multiples have the values of their parts.
    #[test]
    fn operations_are_those_of_their_values() {
        let of = |numbers: &[i64]| Polynomial(numbers.iter().map(|&c| Ball::from_integer(c, PREC)).collect());
        let value = |p: &Polynomial, x: i64| {
            let x = Ball::from_integer(x, PREC);
            p.0.iter().rev().fold(Ball::from_integer(0, PREC), |sum, c| sum * &x + c).mid().to_f64()
        };
        let (p, q, none) = (of(&[3, -1, 0, 2]), of(&[-5, 4]), of(&[]));
        for x in [-3, -1, 0, 1, 2] {
            let (a, b) = (value(&p, x), value(&q, x));
            assert_eq!(value(&p.plus(&q), x), a + b);
            assert_eq!(value(&q.plus(&p), x), a + b);
            assert_eq!(value(&(p.clone() * q.clone()), x), a * b);
            assert_eq!(value(&(p.clone() * none.clone()), x), 0.0);
            assert_eq!(value(&p.scaled(&Ball::from_integer(-7, PREC)), x), -7.0 * a);
            assert_eq!(value(&p.clone().negated(), x), -a);
            assert_eq!(value(&p.clone().multiply_add(q.clone(), q.clone()), x), a * b + b);
            assert_eq!(value(&Polynomial::composed(&p.0, &q), x), value(&p, b as i64));
        }
        // 3 - x + 2 x^3 = 3 T_0 + x/2 T_1 + T_3/2.
        let chebyshev: Vec<f64> = p.chebyshev().iter().map(|c| c.mid().to_f64()).collect();
        assert_eq!(chebyshev, [3.0, 0.5, 0.0, 0.5, 0.0]);
        assert_eq!((p.size(), none.size()), ((3.0, 4.0), (0.0, 0.0)));
    }
}
