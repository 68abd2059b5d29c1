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

/// `Psi(y)` for spheres, from the phase plane between zero force and exit instead of the trajectory.
///
/// In units of the point of zero force `P' = m (z - z^3/P)` with `x = z^2`, `P(1) = 1`; `N(m) = P(0)` is
/// found by powers of `m` in polynomials of `z`, then `Psi = 1/N` at `y = m N^(1/2)`: the coefficient of
/// `y^n` is that of `m^(n-1)` in `(1/N)' N^(-n/2)/n` (Lagrange).
pub fn delayed_recovery(len: usize) -> Vec<BigRational> {
    let multiply = |a: &[BigRational], b: &[BigRational], len: usize| -> Vec<BigRational> {
        let term = |n: usize, i: usize| a.get(i).zip(b.get(n - i)).map(|(x, y)| x * y);
        (0..len).map(|n| (0..=n).filter_map(|i| term(n, i)).sum()).collect()
    };
    let (mut p, mut inverse) = (vec![ints(&[1])], vec![ints(&[1])]);
    for n in 1..len {
        // The integral of -x^(3/2) r from 0, term by term: z^i gives z^(i+5)/((i+5)/2).
        let mut next = vec![BigRational::zero(); 5];
        next.extend(inverse[n - 1].iter().enumerate().map(|(i, c)| -c * ratio(2, i as i64 + 5)));
        if n == 1 {
            next[3] += ratio(2, 3);
        }
        next[0] = -next.iter().sum::<BigRational>();
        p.push(next);
        let sum = (1..=n).map(|i| multiply(&p[i], &inverse[n - i], 5 * n + 1));
        let zero = vec![BigRational::zero(); 5 * n + 1];
        let total = sum.fold(zero, |total, part| total.iter().zip(part).map(|(a, b)| a - b).collect());
        inverse.push(total);
    }
    let exit: Vec<_> = p.iter().map(|p| p[0].clone()).collect();
    // Powers N^q by Miller's recurrence.
    let power = |q: BigRational| {
        let mut out = vec![BigRational::one()];
        for n in 1..len {
            let weight = |i: usize| &q * ratio(i as i64, 1) - ratio((n - i) as i64, 1);
            let sum: BigRational = (1..=n).map(|i| weight(i) * &exit[i] * &out[n - i]).sum();
            out.push(sum / ratio(n as i64, 1));
        }
        out
    };
    let gain = power(ratio(-1, 1));
    let slope: Vec<_> = gain.iter().enumerate().skip(1).map(|(k, c)| c * ratio(k as i64, 1)).collect();
    let coefficient = |n: usize| {
        let product = multiply(&slope, &power(ratio(-(n as i64), 2)), n);
        &product[n - 1] / ratio(n as i64, 1)
    };
    (0..len).map(|n| if n == 0 { BigRational::one() } else { coefficient(n) }).collect()
}
