//! Values of iterated Beta integrals over a whole collision, with proof.

use crate::ClosedError;
use num_rational::{BigRational, Ratio};
use num_traits::{One, ToPrimitive, Zero};
use restitution_real::Ball;
use rug::Float;
use rug::float::Round;
use rug::ops::Pow;

/// The largest number of terms that is summed.
const MOST_TERMS: u64 = 50_000_000;

/// Returns `M(p_1, ..., p_r)`, the iterated Beta integral over a whole collision, in a ball of `bits` bits.
///
/// ```text
/// M(p_1, ..., p_r) = int_(-1 < v_r < ... < v_1 < 1) prod (1-v_i^2)^(p_i - 1) v_i^2 dv_i,      p_i > 0
/// ```
///
/// `M(p) = B(p, 3/2)`. The path is cut at `v^2 = 1/2`. On the outer pieces an integral is `z^sigma` times a power series
/// in `z = 1 - v^2 <= 1/2`, times `sqrt(1-z)` if its length is odd; in the middle it is `(1-v^2)^sigma` times a power
/// series in `v`; in both, `sigma` is the sum of the exponents and the coefficients obey a recurrence of two terms from
/// those of the integral without its first letter. Values over pieces are put together by Chen's rule.
///
/// # Error bound
///
/// The radius: rounding is counted by balls, the tails are bounded in `docs/closed-forms.md`, section 8.
/// Cost: `O(r^2 bits)` operations on numbers of `bits` bits.
///
/// # Errors
///
/// [`ClosedError::TooManyTerms`] if the exponents are so large that more than 5 10^7 terms would be summed.
///
/// # Examples
///
/// ```
/// use num_rational::Ratio;
/// use restitution_closed::{beta, iterated_beta};
///
/// let p = Ratio::new(3, 5);
/// let twice = iterated_beta(&[p, p], 200)?; // B(3/5, 3/2)^2/2
/// assert!(twice.overlaps(&(beta(p, 200) * beta(p, 200)).shifted(-1)));
/// # Ok::<(), restitution_closed::ClosedError>(())
/// ```
pub fn iterated_beta(exponents: &[Ratio<i64>], bits: u32) -> Result<Ball, ClosedError> {
    let length = exponents.len();
    let prec = working_bits(bits, length);
    // outer[i][j], inner[i][j]: the integrals of the letters i..j over -1 .. -c and over 0 .. c, c = sqrt(1/2).
    let table = |series: Series| -> Result<Vec<Vec<Ball>>, ClosedError> {
        let mut table = vec![vec![Ball::one(); length + 1]; length + 1];
        for end in 1..=length {
            for (start, value) in series.values(&exponents[..end], prec)?.into_iter().enumerate() {
                table[start][end] = value;
            }
        }
        Ok(table)
    };
    let (outer, inner) = (table(Series::Outer)?, table(Series::Inner)?);
    let reversed = exponents.iter().rev().copied().collect::<Vec<_>>();
    let mirrored = |series: Series| -> Result<Vec<Vec<Ball>>, ClosedError> {
        let mut table = vec![vec![Ball::one(); length + 1]; length + 1];
        for end in 1..=length {
            for (start, value) in series.values(&reversed[..end], prec)?.into_iter().enumerate() {
                table[length - end][length - start] = value;
            }
        }
        Ok(table)
    };
    let (outer_back, inner_back) = (mirrored(Series::Outer)?, mirrored(Series::Inner)?);
    // The innermost letters come first on the path: -1 .. -c, then -c .. 0, 0 .. c, c .. 1.
    let path = join(&join(&outer_back, &inner), &join(&inner_back, &outer));
    Ok(path[0][length].with_prec(bits))
}

/// Bits of working precision for so many letters.
fn working_bits(bits: u32, length: usize) -> u32 {
    bits + 64 + 8 * u32::try_from(length).unwrap_or(u32::MAX / 16)
}

/// The last letters, of which there are `i + 1`.
fn last_letters(exponents: &[Ratio<i64>], i: usize) -> &[Ratio<i64>] {
    &exponents[exponents.len() - 1 - i..]
}

/// Chen's rule: the integrals over a path of two pieces; `later` belongs to the second, the first letters.
fn join(later: &[Vec<Ball>], earlier: &[Vec<Ball>]) -> Vec<Vec<Ball>> {
    let length = later.len() - 1;
    let mut joined = vec![vec![Ball::one(); length + 1]; length + 1];
    for start in 0..length {
        for end in start + 1..=length {
            let term = |cut: usize| &later[start][cut] * &earlier[cut][end];
            joined[start][end] = (start + 1..=end).fold(term(start), |sum, cut| sum + term(cut));
        }
    }
    joined
}

/// Which power series.
#[derive(Clone, Copy)]
enum Series {
    /// From `z = 0`, `v = -1`, to `z = 1/2`.
    Outer,
    /// From `v = 0` to `v = sqrt(1/2)`.
    Inner,
}

/// One integral on the way: the letters from some place to the end, their number and the sum of their exponents.
struct Suffix {
    odd: bool,
    length: i64,
    /// `sigma = numerator/denominator`
    numerator: i64,
    denominator: i64,
    /// The latest coefficient, and the sum of all at `1/2`.
    latest: Ball,
    sum: Ball,
}

impl Series {
    /// The integrals of `exponents[i..]` for every `i`.
    fn values(self, exponents: &[Ratio<i64>], prec: u32) -> Result<Vec<Ball>, ClosedError> {
        Ok(self.values_of(exponents, self.terms(exponents, prec)?, prec))
    }

    /// The same from so many terms.
    fn values_of(self, exponents: &[Ratio<i64>], terms: u64, prec: u32) -> Vec<Ball> {
        let mut suffixes: Vec<Suffix> = Vec::new();
        for i in (0..exponents.len()).rev() {
            let sigma: Ratio<i64> = exponents[i..].iter().sum();
            let length = i64::try_from(exponents.len() - i).unwrap_or(i64::MAX);
            let (numerator, denominator) = (*sigma.numer(), *sigma.denom());
            let zero = Ball::from_integer(0, prec);
            suffixes.push(Suffix {
                odd: length % 2 == 1,
                length,
                numerator,
                denominator,
                latest: zero.clone(),
                sum: zero,
            });
        }
        for n in 0..terms {
            // The empty integral is 1.
            let mut before = Ball::from_integer(i64::from(n == 0), prec);
            let mut before_previous = Ball::from_integer(i64::from(n == 1), prec);
            for suffix in &mut suffixes {
                let next = self.next(suffix, i64::try_from(n).unwrap_or(i64::MAX), &before, &before_previous);
                before_previous = std::mem::replace(&mut suffix.latest, next.clone());
                suffix.sum += next.shifted(-i32::try_from(n).unwrap_or(i32::MAX));
                before = next;
            }
        }
        let value = |(i, suffix): (usize, &Suffix)| {
            let letters = last_letters(exponents, i);
            let sum = suffix.sum.clone().widened(&self.tail(suffix, letters, terms));
            self.scaled(sum, suffix, prec)
        };
        suffixes.iter().enumerate().rev().map(value).collect()
    }

    /// The coefficient `n` of a suffix; `before` is that of the suffix without its first letter, `before_previous` the one before.
    ///
    /// ```text
    /// outer, odd length:   (sigma+n) u_n = (sigma+n-1/2) u_(n-1) + (w_n - w_(n-1))/2
    /// outer, even length:  (sigma+n) u_n = (w_n - w_(n-1))/2
    /// inner, length r:     (3r+2n) u_n = (3r+2n-2+2 sigma) u_(n-1) + w_n
    /// ```
    fn next(self, suffix: &Suffix, n: i64, before: &Ball, before_previous: &Ball) -> Ball {
        let (a, b) = (suffix.numerator, suffix.denominator);
        let whole = |n: i64| Ball::from_integer(n, 64);
        match self {
            Self::Outer => {
                let mut sum = (before - before_previous) * whole(b);
                if suffix.odd {
                    sum += &suffix.latest * whole(2 * (a + b * n) - b);
                }
                sum / whole(2 * (a + b * n))
            }
            Self::Inner => {
                let power = 3 * suffix.length + 2 * n;
                let previous = &suffix.latest * whole(b * (power - 2) + 2 * a);
                (previous + before * whole(b)) / whole(b * power)
            }
        }
    }

    /// Terms that leave out less than `2^-prec`.
    fn terms(self, exponents: &[Ratio<i64>], prec: u32) -> Result<u64, ClosedError> {
        let sigma: Ratio<i64> = exponents.iter().sum();
        let sigma = sigma.ceil().to_integer().to_u64().unwrap_or(u64::MAX);
        let letters = exponents.len() as u64;
        // The tails grow at most like (3r+2N)^sigma and like the product of 1/p.
        let small: u64 =
            exponents.iter().map(|p| u64::from(64 - (*p.denom() / p.numer()).leading_zeros())).sum();
        let logarithm = 8 + u64::from(64 - (u64::from(prec) + sigma + letters).leading_zeros());
        // At least nine times sigma: the tail's `N >= 4 sigma` holds.
        let growth = if matches!(self, Self::Inner) { sigma.saturating_mul(logarithm) } else { 0 };
        let terms = (u64::from(prec) + small + 32 + logarithm).saturating_add(growth);
        if terms > MOST_TERMS {
            return Err(ClosedError::TooManyTerms { terms });
        }
        Ok(terms)
    }

    /// An upper bound of the terms from `count` on, at `1/2`.
    ///
    /// ```text
    /// outer:  10 sqrt(N) 2^-N prod 0.7072/p,      inner:  6 (3r+2N)^sigma 2^-N prod 1/(2p),  N >= 4 sigma
    /// ```
    fn tail(self, suffix: &Suffix, letters: &[Ratio<i64>], count: u64) -> Float {
        let up = |x: f64| Float::with_val_round(64, x, Round::Up).0;
        let each = match self {
            Self::Outer => 0.7072,
            Self::Inner => 0.5,
        };
        let product = letters.iter().fold(up(1.0), |product, p| product * up(each) * *p.denom() / *p.numer());
        let growth = match self {
            Self::Outer => 10.0 * up(count as f64).sqrt(),
            Self::Inner => {
                let sigma = up(suffix.numerator as f64) / suffix.denominator;
                6.0 * up(3.0 * suffix.length as f64 + 2.0 * count as f64).pow(sigma)
            }
        };
        // A handful of roundings to 64 bits are covered by a millionth more.
        (growth * product * 1.000_001) >> u32::try_from(count).unwrap_or(u32::MAX)
    }

    /// The integral from its power series: times `z^sigma sqrt(1-z)` or `v^(3r) (1-v^2)^sigma` at `z = v^2 = 1/2`.
    fn scaled(self, sum: Ball, suffix: &Suffix, prec: u32) -> Ball {
        let sigma = BigRational::new(suffix.numerator.into(), suffix.denominator.into());
        let half = BigRational::new(1.into(), 2.into());
        let halves = match self {
            Self::Outer if suffix.odd => sigma + half,
            Self::Outer => sigma,
            Self::Inner => sigma + half * BigRational::from_integer((3 * suffix.length).into()),
        };
        if halves.is_zero() {
            return sum;
        }
        let exponent = Ratio::new(
            -halves.numer().to_i64().unwrap_or(i64::MAX),
            halves.denom().to_i64().unwrap_or(i64::MAX),
        );
        sum * crate::root::rational_power(&BigRational::from_integer(2.into()), exponent, prec)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::beta;

    fn ratios(exponents: &[(i64, i64)]) -> Vec<Ratio<i64>> {
        exponents.iter().map(|&(p, q)| Ratio::new(p, q)).collect()
    }

    /// The integral of polynomials, exactly: coefficients of `int (1-v^2)^(p-1) v^2 f(v) dv` from -1, from the last letter on.
    fn of_integers(exponents: &[i64]) -> BigRational {
        let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
        let mut f = vec![ratio(1, 1)];
        for &p in exponents.iter().rev() {
            let times = |f: &[BigRational], g: &[i64]| {
                let mut out = vec![ratio(0, 1); f.len() + g.len()];
                for (i, a) in f.iter().enumerate() {
                    for (j, &b) in g.iter().enumerate() {
                        out[i + j] += a * ratio(b, 1);
                    }
                }
                out
            };
            f = (1..p).fold(times(&f, &[0, 0, 1]), |f, _| times(&f, &[1, 0, -1]));
            let mut integral = vec![ratio(0, 1)];
            integral.extend(f.iter().enumerate().map(|(k, c)| c / ratio(k as i64 + 1, 1)));
            let signs = integral.iter().enumerate().map(|(k, c)| if k % 2 == 0 { c.clone() } else { -c });
            let at_start = signs.fold(ratio(0, 1), |sum, c| sum + c);
            integral[0] -= at_start;
            f = integral;
        }
        f.into_iter().fold(ratio(0, 1), |sum, c| sum + c)
    }

    #[test]
    fn integrals_of_polynomials_are_fractions() {
        for exponents in [&[1][..], &[3], &[1, 1], &[1, 2], &[5, 2], &[1, 2, 3], &[3, 1, 2], &[2, 2, 5, 1]] {
            let exact = of_integers(exponents);
            let letters: Vec<_> = exponents.iter().map(|&p| Ratio::from_integer(p)).collect();
            let found = iterated_beta(&letters, 150).unwrap();
            assert!(found.overlaps(&Ball::from_rational(&exact, 300)), "{exponents:?}");
            assert!(found.to_digits(42).is_some(), "{exponents:?}: {found:?}");
        }
    }

    /// Products of integrals are sums of integrals of their letters in all orders.
    #[test]
    fn shuffles_are_products() {
        let bits = 200;
        let of = |exponents: &[(i64, i64)]| iterated_beta(&ratios(exponents), bits).unwrap();
        let (a, b, c) = ((3, 5), (7, 4), (1, 9));
        assert!(of(&[a]).overlaps(&beta(Ratio::new(3, 5), bits)));
        let pair = of(&[a, b]) + of(&[b, a]);
        assert!(pair.overlaps(&(of(&[a]) * of(&[b]))));
        let three = of(&[a, b, c]) + of(&[a, c, b]) + of(&[c, a, b]);
        assert!(three.overlaps(&(of(&[a, b]) * of(&[c]))));
        assert!(pair.to_digits(56).is_some() && three.to_digits(56).is_some());
    }

    /// Few terms with what they leave out hold the value.
    #[test]
    fn tails_are_above_what_is_left_out() {
        for letters in [ratios(&[(3, 5)]), ratios(&[(1, 9), (7, 4)]), ratios(&[(2, 1), (1, 2), (3, 7)])] {
            for series in [Series::Outer, Series::Inner] {
                let full = series.values(&letters, 300).unwrap();
                for terms in [24, 40, 100] {
                    let few = series.values_of(&letters, terms, 300);
                    for (few, full) in few.iter().zip(&full) {
                        let left = (few.mid().clone() - full.mid()).abs();
                        assert!(
                            left <= *few.rad() && few.rad() < &Float::with_val(64, 1e-3),
                            "{letters:?} {terms}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn tails_and_numbers_of_terms_are_those_of_their_formulas() {
        let letters = ratios(&[(1, 9), (7, 4)]);
        let zero = || Ball::from_integer(0, 64);
        let suffix =
            Suffix { odd: false, length: 2, numerator: 67, denominator: 36, latest: zero(), sum: zero() };
        let close = |found: Float, expected: f64| {
            let quotient = found.to_f64() / (expected * 1.000_001);
            assert!((quotient - 1.0).abs() < 1e-12, "{quotient}");
        };
        let power = 2f64.powi(-100);
        close(Series::Outer.tail(&suffix, &letters, 100), 100.0 * power * 0.7072 * 9.0 * 0.7072 * 4.0 / 7.0);
        let growth = 206f64.powf(67.0 / 36.0);
        close(Series::Inner.tail(&suffix, &letters, 100), 6.0 * growth * power * 4.5 * 2.0 / 7.0);
        // 300 bits, 4 for the small exponent, 32 to spare and the logarithm 8 + 9; inside sigma of it.
        let terms = [Series::Outer, Series::Inner].map(|series| series.terms(&letters, 300).unwrap());
        assert_eq!(terms, [300 + 4 + 32 + 17, 300 + 4 + 32 + 17 + 34]);
        // With sigma and the letters, 4, from 252 bits on the logarithm is one more.
        let other = |prec| Series::Outer.terms(&letters, prec).unwrap();
        assert_eq!([250, 251, 252, 256].map(other), [250 + 52, 251 + 52, 252 + 53, 256 + 53]);
        assert_eq!([(100, 1), (100, 5)].map(|(bits, length)| working_bits(bits, length)), [172, 204]);
        let three = ratios(&[(1, 2), (3, 4), (5, 6)]);
        assert_eq!([0, 1, 2].map(|i| last_letters(&three, i)), [&three[2..], &three[1..], &three[..]]);
        // Where sigma is large no more terms than anybody sums.
        assert!(matches!(
            Series::Inner.terms(&ratios(&[(6_000_000, 1)]), 64),
            Err(ClosedError::TooManyTerms { .. })
        ));
        for exponents in [ratios(&[(1, 1000)]), ratios(&[(50, 1), (80, 3)]), ratios(&[(1, 3); 6])] {
            let sigma: Ratio<i64> = exponents.iter().sum();
            let (numerator, denominator) = (*sigma.numer(), *sigma.denom());
            let length = exponents.len() as i64;
            let suffix =
                Suffix { odd: length % 2 == 1, length, numerator, denominator, latest: zero(), sum: zero() };
            for series in [Series::Outer, Series::Inner] {
                let terms = series.terms(&exponents, 200).unwrap();
                let most = Float::with_val(64, 1u32) >> 200u32;
                assert!(series.tail(&suffix, &exponents, terms) < most, "{exponents:?}");
            }
        }
    }
}
