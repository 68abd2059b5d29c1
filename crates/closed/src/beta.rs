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
    let prec = bits.saturating_add(32);
    terms.beta(prec) * shift(terms.p, q, whole, prec)
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
        let count = if p == q { 1 } else { self.count(bits) };
        let sum = sum(self, count, bits);
        let sum = if p == q { sum } else { sum.widened(&self.tail(count)) };
        let factor = |n: i64| Ball::from_integer(n, bits);
        let above = Ball::from_big_integer(&(Integer::from(2 * q) * q), bits);
        sum * above / (factor(p) * factor(p + q)) / (factor(p + 2 * q) * factor(2 * p + q))
    }

    /// Terms that leave out `2^-bits` of the first, but for what the weight grows by.
    fn count(&self, bits: u32) -> u64 {
        (u64::from(bits) + 16) * 1000 / self.millibits_per_term() + 2
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

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Rational;

    fn fraction(p: i64, q: i64) -> Rational {
        Rational::from((p, q))
    }

    /// By MPFR's Gamma function; the digits asked for are there.
    #[test]
    fn values_are_those_of_the_gamma_function() {
        for (p, q) in [
            (1, 2),
            (1, 1),
            (3, 1),
            (40, 1),
            (2, 5),
            (1, 100_000_000),
            (99_999_999, 100_000_000),
            (100_000_000, 1_234_567),
            (237, 7),
            (1000, 3),
        ] {
            for bits in [64, 300, 1500] {
                let found = beta(Ratio::new(p, q), bits);
                let s = Float::with_val(bits + 64, fraction(p, q));
                let above = Float::with_val(bits + 64, &s + 1.5f64);
                let expected = (Float::with_val(bits + 64, 1.5f64).gamma() * s.gamma()) / above.gamma();
                let error = Float::with_val(bits + 64, found.mid() - &expected).abs();
                // MPFR's own roundings: that of s is enlarged by the logarithm of the Gamma function.
                let allowed =
                    Float::with_val(64, found.rad()) + Float::with_val(64, &expected >> (bits + 40));
                assert!(error <= allowed, "{p}/{q} {bits}");
                assert!(*found.rad() <= Float::with_val(64, &expected >> (bits - 3)), "{p}/{q} {bits}");
            }
        }
    }

    /// Quotients and weights from their formulas, times what makes them integers.
    #[test]
    fn terms_are_those_of_the_series() {
        for (p, q) in [(1, 2), (2, 5), (7, 7), (3, 1000)] {
            let (terms, s) = (BetaTerms { p, q }, fraction(p, q));
            let square = fraction(q * q, 1);
            for i in [1i64, 2, 3, 50] {
                let plus = |n: i64, d: i64| &s + fraction(n, d);
                let above = plus(i - 1, 1) * plus(2 * i - 1, 2) * (fraction(i, 1) - &s);
                let below = plus(3 * i, 1) * plus(3 * i + 1, 1) * plus(3 * i + 2, 1);
                let quotient = Rational::from((terms.numerator(i), terms.denominator(i)));
                assert_eq!(quotient, -(above / below));
                let weight = fraction(7 * i * i, 1)
                    + (Rational::from(&s * 7) + 6) * i
                    + plus(1, 1) * (Rational::from(&s * 2) + 1);
                assert_eq!(Rational::from(terms.weight(i)), weight * &square);
            }
        }
    }

    /// What is left out is in the tail, which is what its formula says.
    #[test]
    fn tails_are_above_what_is_left_out() {
        for (p, q) in [(1, 2), (2, 5), (3, 5), (1, 1000), (999, 1000)] {
            let terms = BetaTerms { p, q };
            let all = sum(&terms, 90, 600);
            for count in [1u64, 2, 3, 7, 20, 60] {
                let left = (&all - sum(&terms, count, 600)).abs_down();
                let tail = terms.tail(count);
                assert!(left <= tail, "{p}/{q} {count}");
                let formula = (Float::with_val(64, terms.weight(count as i64)) * 1.5f64)
                    >> (count * 4754 / 1000) as u32;
                assert_eq!(tail, formula);
            }
            // Beside the first term; the guard covers what the weight has grown to.
            for (bits, count) in [(50, 15), (100, 26), (3000, 636)] {
                assert_eq!(terms.count(bits), count);
                assert!(terms.tail(count) <= Float::with_val(64, terms.weight(0)) >> (bits - 8), "{bits}");
            }
        }
    }

    /// `prod (s+i)/(s+i+3/2)`, also where products are halved.
    #[test]
    fn shifts_are_products() {
        for (p, q, steps) in [(1, 2, 0), (2, 3, 1), (2, 3, 8), (1, 7, 9), (5, 9, 40)] {
            let factor = |i: i64| fraction(2 * (p + q * i), 2 * p + 2 * q * i + 3 * q);
            let exact = (0..steps).map(factor).fold(fraction(1, 1), |product, factor| product * factor);
            let found = shift(p, q, steps, 200);
            assert!(
                found.overlaps(&Ball::from_rational(&restitution_real::convert::big_rational(&exact), 300))
            );
        }
    }

    /// `Z (4n+1)(4n+3)/2` of `docs/closed-forms.md`, section 6.
    fn certificate(n: &Rational, k: &Rational, s: &Rational) -> Rational {
        let terms: [(i32, [i32; 3]); 43] = [
            (4, [4, 1, 0]),
            (3, [4, 0, 0]),
            (44, [3, 2, 0]),
            (12, [3, 1, 1]),
            (50, [3, 1, 0]),
            (8, [3, 0, 1]),
            (13, [3, 0, 0]),
            (184, [2, 3, 0]),
            (96, [2, 2, 1]),
            (283, [2, 2, 0]),
            (8, [2, 1, 2]),
            (104, [2, 1, 1]),
            (136, [2, 1, 0]),
            (5, [2, 0, 2]),
            (26, [2, 0, 1]),
            (20, [2, 0, 0]),
            (336, [1, 4, 0]),
            (256, [1, 3, 1]),
            (652, [1, 3, 0]),
            (48, [1, 2, 2]),
            (384, [1, 2, 1]),
            (447, [1, 2, 0]),
            (52, [1, 1, 2]),
            (180, [1, 1, 1]),
            (126, [1, 1, 0]),
            (13, [1, 0, 2]),
            (26, [1, 0, 1]),
            (12, [1, 0, 0]),
            (224, [0, 5, 0]),
            (224, [0, 4, 1]),
            (528, [0, 4, 0]),
            (64, [0, 3, 2]),
            (432, [0, 3, 1]),
            (474, [0, 3, 0]),
            (96, [0, 2, 2]),
            (298, [0, 2, 1]),
            (201, [0, 2, 0]),
            (44, [0, 1, 2]),
            (87, [0, 1, 1]),
            (40, [0, 1, 0]),
            (6, [0, 0, 2]),
            (9, [0, 0, 1]),
            (3, [0, 0, 0]),
        ];
        let power = |x: &Rational, n: i32| (0..n).fold(Rational::from(1), |product, _| product * x);
        terms.iter().map(|(c, [i, j, l])| power(k, *i) * power(n, *j) * power(s, *l) * *c).sum()
    }

    #[test]
    fn the_series_has_a_certificate() {
        let r = |n: i32, d: i32| Rational::from((n, d));
        // More points than the degrees of the identity in n, k and s ask for: it holds for all.
        for (i, j, l) in (0..12).flat_map(|i| (0..9).flat_map(move |j| (0..9).map(move |l| (i, j, l)))) {
            let (n, k, s) = (r(i, 1), r(j, 1), r(3 * l + 1, 7));
            let sum = |parts: &[(&Rational, i32)], c: Rational| {
                parts.iter().fold(c, |sum, (x, m)| sum + Rational::from(*x * *m))
            };
            let at = |a: i32, b: i32, g: i32, c: Rational| sum(&[(&s, a), (&n, b), (&k, g)], c);
            let next_n = at(1, 1, 1, r(0, 1))
                * at(0, 2, 1, r(1, 2))
                * at(0, 2, 1, r(3, 2))
                * at(0, 2, 0, r(1, 1))
                * at(0, 2, 0, r(2, 1))
                * at(1, 1, 0, r(1, 2))
                * at(1, -1, 0, r(-1, 1))
                / (at(1, 3, 1, r(1, 1))
                    * at(1, 3, 1, r(2, 1))
                    * at(1, 3, 1, r(3, 1))
                    * at(0, 2, 1, r(1, 1))
                    * at(0, 2, 1, r(2, 1))
                    * at(0, 2, 0, r(1, 2))
                    * at(0, 2, 0, r(3, 2)));
            let next_k =
                at(1, 1, 1, r(0, 1)) * at(0, 2, 1, r(1, 2)) / (at(1, 3, 1, r(1, 1)) * at(0, 2, 1, r(1, 1)));
            let g = |k: &Rational| {
                let below = sum(&[(&s, 1), (&n, 3), (k, 1)], r(1, 1))
                    * sum(&[(&s, 1), (&n, 3), (k, 1)], r(2, 1))
                    * sum(&[(&n, 2), (k, 1)], r(1, 1))
                    * at(0, 4, 0, r(1, 1))
                    * at(0, 4, 0, r(3, 1));
                certificate(&n, k, &s) * 2 / below
            };
            let after = g(&Rational::from(&k + 1));
            assert_eq!(Rational::from(1) - next_n, g(&k) - next_k * after, "{n} {k} {s}");
        }
    }
}
