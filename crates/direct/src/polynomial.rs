//! Polynomials in floats of many bits, for tests that compute a defect from the equation of motion alone.

use rug::{Float, Integer};

/// Bits beside which every rounding of a step is large.
pub(crate) const BITS: u32 = 400;

/// `Sum c_k theta^k`.
pub(crate) type Polynomial = Vec<Float>;

pub(crate) fn number<T>(x: T) -> Float
where
    Float: rug::Assign<T>,
{
    Float::with_val(BITS, x)
}

/// Integers in units of `2^unit`.
pub(crate) fn of_integers(c: &[Integer], unit: i64) -> Polynomial {
    c.iter().map(|c| number(c) << i32::try_from(unit).unwrap()).collect()
}

pub(crate) fn plus(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let at = |x: &Polynomial, k: usize| x.get(k).cloned().unwrap_or_else(|| number(0));
    (0..a.len().max(b.len())).map(|k| at(a, k) + at(b, k)).collect()
}

pub(crate) fn times(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let mut out = vec![number(0); a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            out[i + j] += number(x * y);
        }
    }
    out
}

pub(crate) fn scaled(a: &Polynomial, factor: &Float) -> Polynomial {
    a.iter().map(|c| number(c * factor)).collect()
}

pub(crate) fn power(a: &Polynomial, n: u32) -> Polynomial {
    (0..n).fold(vec![number(1)], |p, _| times(&p, a))
}

pub(crate) fn derivative(a: &Polynomial) -> Polynomial {
    a.iter().enumerate().skip(1).map(|(k, c)| number(c * k as u32)).collect()
}

pub(crate) fn at(a: &Polynomial, theta: &Float) -> Float {
    a.iter().rev().fold(number(0), |sum, c| sum * theta + c)
}

/// `Sum |c_k|/(k + 1)`, a bound of the integral of the absolute value.
pub(crate) fn integral(a: &Polynomial) -> f64 {
    a.iter().enumerate().map(|(k, c)| number(c / (k as u32 + 1)).abs().to_f64()).sum()
}

pub(crate) fn norm(a: &Polynomial) -> f64 {
    a.iter().map(|c| c.clone().abs().to_f64()).sum()
}
