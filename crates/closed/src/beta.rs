//! Beta values `B(3/2, s)` of rational `s` to any number of digits.

use crate::splitting::{Terms, sum};
use num_rational::Ratio;
use restitution_real::Ball;
use rug::float::Round;
use rug::{Float, Integer};

/// Returns `B(3/2, s) = int_0^1 z^(s-1) sqrt(1-z) dz` for `s > 0`, in a ball of `bits` bits.
///
/// With `0 < s <= 1`, from a WZ pair of Gauss's theorem for `2F1(s, 1/2; s+1; 1)`:
///
/// ```text
/// s (2s+1) B(3/2, s) = 2 sum_(n>=0) (-1)^n (s)_n (s+1/2)_n (1-s)_n (7n^2 + (7s+6)n + (s+1)(2s+1)) / (s+1)_(3n+2)
/// ```
///
/// Terms fall by at least 27 each; a larger `s` is brought there by `B(3/2, s+1) = s/(s+3/2) B(3/2, s)`.
///
/// # Error bound
///
/// The radius: rounding is counted by the ball, and what the sum leaves out after `N` terms is below
/// `(6/5) w(N) 27^-N`, `w` the polynomial. The identity, the bound and their proofs are in
/// `docs/closed-forms.md`, section 6. The relative width is about `2^-bits` times a few units.
///
/// Cost: `O(M(bits) log^2 bits)`; a million digits take a few seconds.
///
/// # Panics
///
/// If `s` is not positive, or its numerator or denominator exceeds `10^8`.
///
/// # Examples
///
/// ```
/// use num_rational::Ratio;
/// use restitution_closed::beta;
///
/// let half = beta(Ratio::new(1, 2), 200); // pi/2
/// assert_eq!(half.to_digits(30).as_deref(), Some("1.57079632679489661923132169164"));
/// ```
pub fn beta(s: Ratio<i64>, bits: u32) -> Ball {
    let (p, q) = (*s.numer(), *s.denom());
    assert!(p > 0 && q > 0 && p.max(q) <= 100_000_000, "a positive fraction of sensible size");
    let whole = (p - 1) / q;
    let terms = BetaTerms { p: p - whole * q, q };
    // Guard for the prefactors and the shift: each of a handful of operations costs a bit.
    terms.beta(bits + 32) * shift(terms.p, q, whole, bits + 32)
}

/// The terms for `s = p/q`, `0 < p <= q`, multiplied by `q^2`.
struct BetaTerms {
    p: i64,
    q: i64,
}

impl Terms for BetaTerms {
    /// `-(s+i-1)(s+i-1/2)(i-s)`
    fn numerator(&self, i: i64) -> Integer {
        let (p, q) = (self.p, self.q);
        -(Integer::from(p + q * (i - 1)) * (2 * p + q * (2 * i - 1)) * (q * i - p))
    }

    /// `(s+3i)(s+3i+1)(s+3i+2)`
    fn denominator(&self, i: i64) -> Integer {
        let first = self.p + 3 * self.q * i;
        Integer::from(2 * first) * (first + self.q) * (first + 2 * self.q)
    }

    /// `7n^2 + (7s+6)n + (s+1)(2s+1)`
    fn weight(&self, n: i64) -> Integer {
        let (p, q) = (self.p, self.q);
        let linear = Integer::from(7 * q) * (q * n) + Integer::from(7 * p + 6 * q) * q;
        linear * n + Integer::from(p + q) * (2 * p + q)
    }

    /// `log2 27 > 4.754`: each of the three factors of the quotient is at most 1/3.
    fn millibits_per_term(&self) -> u64 {
        4754
    }
}

impl BetaTerms {
    fn beta(&self, bits: u32) -> Ball {
        let (p, q) = (self.p, self.q);
        let count = if p == q { 1 } else { (u64::from(bits) + 16) * 1000 / self.millibits_per_term() + 2 };
        let sum = sum(self, count, bits);
        let sum = if p == q { sum } else { sum.widened(&self.tail(count)) };
        let factor = |n: i64| Ball::from_integer(n, bits);
        let above = Ball::from_big_integer(&(Integer::from(2 * q) * q), bits);
        sum * above / (factor(p) * factor(p + q)) / (factor(p + 2 * q) * factor(2 * p + q))
    }

    /// An upper bound of what the terms from `count` on add up to.
    fn tail(&self, count: u64) -> Float {
        let n = i64::try_from(count).unwrap_or(i64::MAX);
        let weight = Float::with_val_round(64, self.weight(n) * 6u32, Round::Up).0;
        let exponent = count * self.millibits_per_term() / 1000;
        // 6/4 for 6/5: the rounding of the quotient is far below the difference.
        (weight / 4u32) >> u32::try_from(exponent).unwrap_or(u32::MAX)
    }
}

/// `prod_(i=0..steps-1) (s+i)/(s+i+3/2)` for `s = p/q`.
fn shift(p: i64, q: i64, steps: i64, bits: u32) -> Ball {
    fn product(first: i64, step: i64, lo: i64, hi: i64) -> Integer {
        if hi - lo <= 8 {
            return (lo..hi).fold(Integer::from(1), |product, i| product * (first + step * i));
        }
        let middle = lo + (hi - lo) / 2;
        product(first, step, lo, middle) * product(first, step, middle, hi)
    }
    let ball = |n: Integer| Ball::from_big_integer(&n, bits);
    ball(product(2 * p, 2 * q, 0, steps)) / ball(product(2 * p + 3 * q, 2 * q, 0, steps))
}
