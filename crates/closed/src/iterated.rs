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
    let prec = bits + 64 + 8 * u32::try_from(length).unwrap_or(u32::MAX / 16);
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
        let terms = self.terms(exponents, prec)?;
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
            let letters = &exponents[exponents.len() - 1 - i..];
            let sum = suffix.sum.clone().widened(&self.tail(suffix, letters, terms));
            self.scaled(sum, suffix, prec)
        };
        Ok(suffixes.iter().enumerate().rev().map(value).collect())
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
        let growth =
            if matches!(self, Self::Inner) { sigma.saturating_mul(logarithm).max(4 * sigma) } else { 0 };
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
