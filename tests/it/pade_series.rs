//! Exact test series for the Padé tests.

use num_rational::BigRational;
use num_traits::{One, Zero};

/// The fraction `n/d`.
pub fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

/// Whole coefficients.
pub fn ints(values: &[i64]) -> Vec<BigRational> {
    values.iter().map(|&n| ratio(n, 1)).collect()
}

/// `exp(x)`.
pub fn exponential(len: usize) -> Vec<BigRational> {
    let factorial = |k: usize| (1..=k).fold(BigRational::one(), |f, j| f / ratio(j as i64, 1));
    (0..len).map(factorial).collect()
}

/// `cos(x)`: even, so its table consists of blocks of side 2.
pub fn cosine(len: usize) -> Vec<BigRational> {
    let sign = |k: usize| [1, 0, -1, 0][k % 4];
    exponential(len).into_iter().enumerate().map(|(k, c)| c * ratio(sign(k), 1)).collect()
}

/// The series of `num/den` with `den[0] != 0`, by long division.
pub fn quotient(num: &[i64], den: &[i64], len: usize) -> Vec<BigRational> {
    let mut rest = ints(num);
    rest.resize(len + den.len(), BigRational::zero());
    (0..len)
        .map(|k| {
            let c = &rest[k] / ratio(den[0], 1);
            for (j, d) in den.iter().enumerate() {
                rest[k + j] -= &c * ratio(*d, 1);
            }
            c
        })
        .collect()
}

/// `1 + x + x^2 + x^4 + x^8 + x^16 + ...`: blocks of growing side.
pub fn lacunary(len: usize) -> Vec<BigRational> {
    (0..len).map(|k| ratio(i64::from(k == 0 || k.is_power_of_two()), 1)).collect()
}

/// The approximate theory, eq. (27): `eps + s eps^(3/5) = 1`, by Lagrange's inversion.
///
/// ```text
/// eps_n = (-1)^n/n binomial(3n/5, n - 1)
/// ```
pub fn approximate_theory(len: usize) -> Vec<BigRational> {
    let coefficient = |n: usize| {
        let top = ratio(3 * n as i64, 5);
        let binomial =
            (1..n).fold(BigRational::one(), |b, j| b * (&top - ratio(j as i64 - 1, 1)) / ratio(j as i64, 1));
        binomial * ratio(if n.is_multiple_of(2) { 1 } else { -1 }, n as i64)
    };
    (0..len).map(|n| if n == 0 { BigRational::one() } else { coefficient(n) }).collect()
}

/// `sum (-1/2)^k (k^2 + 3)/(k + 3) x^k`: nothing vanishes by accident.
pub fn generic(len: usize) -> Vec<BigRational> {
    let coefficient = |k: usize| ratio((k * k + 3) as i64, k as i64 + 3) * ratio(-1, 2).pow(k as i32);
    (0..len).map(coefficient).collect()
}
