//! Polynomials as coefficient slices, lowest degree first; no trailing exact zeros once trimmed.

use crate::PadeError;
use restitution_series::{Field, ZeroTest};

/// The value at `x`, by Horner's rule.
pub(crate) fn evaluate<F: Field>(p: &[F], x: &F) -> F {
    p.iter().rev().fold(F::zero(), |value, c| value * x + c)
}

/// The derivative.
pub(crate) fn derivative<F: Field>(p: &[F]) -> Vec<F> {
    let weights = |j: usize| (i64::try_from(j).unwrap_or(i64::MAX), 1);
    let scaled = F::scale_each(p, &weights);
    scaled.into_iter().skip(1).collect()
}

/// The whole product.
pub(crate) fn product<F: Field>(a: &[F], b: &[F]) -> Vec<F> {
    if a.is_empty() || b.is_empty() {
        return Vec::new();
    }
    product_trunc(a, b, a.len() + b.len() - 1)
}

/// The first `len` coefficients of the product, term by term.
///
/// Degrees are small here, and a sum of terms keeps exact zeros exact, as a packed product of balls
/// does not.
pub(crate) fn product_trunc<F: Field>(a: &[F], b: &[F], len: usize) -> Vec<F> {
    let mut out = vec![F::zero(); len];
    for (i, x) in a.iter().enumerate().take(len) {
        for (y, c) in b.iter().zip(&mut out[i..]) {
            *c = std::mem::replace(c, F::zero()) + x.times(y);
        }
    }
    out
}

/// `a - b`.
pub(crate) fn difference<F: Field>(a: &[F], b: &[F]) -> Vec<F> {
    let at = |p: &[F], k: usize| p.get(k).cloned().unwrap_or_else(F::zero);
    (0..a.len().max(b.len())).map(|k| at(a, k) - at(b, k)).collect()
}

/// Drops leading coefficients that are exactly zero.
pub(crate) fn trim<F: Field>(p: &mut Vec<F>, what: &'static str) -> Result<(), PadeError> {
    while let Some(leading) = p.last() {
        match leading.zero_test() {
            ZeroTest::Zero => p.pop(),
            ZeroTest::NonZero => return Ok(()),
            ZeroTest::Undecided => return Err(PadeError::Undecided { what }),
        };
    }
    Ok(())
}

/// The first index whose coefficient is not zero, `None` if all are exactly zero.
pub(crate) fn lowest<F: Field>(p: &[F], what: &'static str) -> Result<Option<usize>, PadeError> {
    for (k, c) in p.iter().enumerate() {
        match c.zero_test() {
            ZeroTest::Zero => {}
            ZeroTest::NonZero => return Ok(Some(k)),
            ZeroTest::Undecided => return Err(PadeError::Undecided { what }),
        }
    }
    Ok(None)
}

/// Quotient and remainder of `a` by `b`, whose last coefficient is not zero.
///
/// The leading terms cancel by construction, so the remainder has fewer coefficients than `b`
/// whatever the rounding; it is not trimmed further.
pub(crate) fn divide<F: Field>(a: &[F], b: &[F]) -> (Vec<F>, Vec<F>) {
    let mut rest = a.to_vec();
    let Some(leading) = b.last() else { return (Vec::new(), rest) };
    let mut quotient = vec![F::zero(); (a.len() + 1).saturating_sub(b.len())];
    for k in (0..quotient.len()).rev() {
        let Some(top) = rest.pop() else { break };
        let factor = top / leading;
        for (r, c) in rest[k..].iter_mut().zip(b) {
            *r = std::mem::replace(r, F::zero()) - factor.times(c);
        }
        quotient[k] = factor;
    }
    (quotient, rest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_rational::BigRational;

    fn poly(p: &[i64]) -> Vec<BigRational> {
        p.iter().map(|&c| BigRational::from_integer(c.into())).collect()
    }

    #[test]
    fn division_undoes_the_product() {
        let (a, b, r) = (poly(&[1, -2, 0, 5]), poly(&[3, 0, 2]), poly(&[7, 1]));
        let mut dividend = product(&a, &b);
        dividend[0] += &r[0];
        dividend[1] += &r[1];
        assert_eq!(divide(&dividend, &b), (a, r));
    }

    #[test]
    fn values_and_slopes() {
        let p = poly(&[1, 2, 3]);
        assert_eq!(evaluate(&p, &poly(&[2])[0]), poly(&[17])[0]);
        assert_eq!(derivative(&p), poly(&[2, 6]));
    }
}
