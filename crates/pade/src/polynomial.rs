//! Polynomials as coefficient slices, lowest degree first; no trailing exact zeros once trimmed.

use crate::PadeError;
use restitution_real::{Field, ZeroTest};

/// Coefficients, the constant term first.
pub(crate) type Polynomial<F> = Vec<<F as Field>::Number>;

/// The value at `x`, by Horner's rule.
pub(crate) fn evaluate<F: Field>(field: &F, p: &[F::Number], x: &F::Number) -> F::Number {
    p.iter().rev().fold(field.zero(), |value, c| field.add(&field.mul(&value, x), c))
}

/// The derivative.
pub(crate) fn derivative<F: Field>(field: &F, p: &[F::Number]) -> Polynomial<F> {
    let coefficients = (1..).zip(p.iter().skip(1));
    coefficients.map(|(j, c)| field.mul(c, &field.ratio(j, 1))).collect()
}

/// The whole product.
pub(crate) fn product<F: Field>(field: &F, a: &[F::Number], b: &[F::Number]) -> Polynomial<F> {
    if a.is_empty() || b.is_empty() {
        return Vec::new();
    }
    product_trunc(field, a, b, a.len() + b.len() - 1)
}

/// The first `len` coefficients of the product, term by term.
///
/// Degrees are small here, and a sum of terms keeps exact zeros exact, as a packed product of balls
/// does not.
pub(crate) fn product_trunc<F: Field>(
    field: &F,
    a: &[F::Number],
    b: &[F::Number],
    len: usize,
) -> Polynomial<F> {
    let mut out = vec![field.zero(); len];
    for (i, x) in a.iter().enumerate().take(len) {
        for (y, c) in b.iter().zip(&mut out[i..]) {
            *c = field.add(c, &field.mul(x, y));
        }
    }
    out
}

/// `a - b`.
pub(crate) fn difference<F: Field>(field: &F, a: &[F::Number], b: &[F::Number]) -> Polynomial<F> {
    let term = |k: usize| match (a.get(k), b.get(k)) {
        (Some(x), Some(y)) => field.sub(x, y),
        (Some(x), None) => x.clone(),
        (None, Some(y)) => field.neg(y),
        (None, None) => field.zero(),
    };
    (0..a.len().max(b.len())).map(term).collect()
}

/// Drops leading coefficients that are exactly zero.
pub(crate) fn trim<F: Field>(field: &F, p: &mut Polynomial<F>, what: &'static str) -> Result<(), PadeError> {
    while let Some(leading) = p.last() {
        match field.zero_test(leading) {
            ZeroTest::Zero => p.pop(),
            ZeroTest::NonZero => return Ok(()),
            ZeroTest::Undecided => return Err(PadeError::Undecided { what }),
        };
    }
    Ok(())
}

/// The first index whose coefficient is not zero, `None` if all are exactly zero.
pub(crate) fn lowest<F: Field>(
    field: &F,
    p: &[F::Number],
    what: &'static str,
) -> Result<Option<usize>, PadeError> {
    for (k, c) in p.iter().enumerate() {
        match field.zero_test(c) {
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
pub(crate) fn divide<F: Field>(
    field: &F,
    a: &[F::Number],
    b: &[F::Number],
) -> (Polynomial<F>, Polynomial<F>) {
    let mut rest = a.to_vec();
    let Some(leading) = b.last() else { return (Vec::new(), rest) };
    let mut quotient = vec![field.zero(); (a.len() + 1).saturating_sub(b.len())];
    for k in (0..quotient.len()).rev() {
        let Some(top) = rest.pop() else { break };
        let factor = field.div(&top, leading);
        for (r, c) in rest[k..].iter_mut().zip(b) {
            *r = field.sub(r, &field.mul(&factor, c));
        }
        quotient[k] = factor;
    }
    (quotient, rest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_rational::BigRational;
    use restitution_real::Rationals;

    fn poly(p: &[i64]) -> Vec<BigRational> {
        p.iter().map(|&c| BigRational::from_integer(c.into())).collect()
    }

    #[test]
    fn division_undoes_the_product() {
        let (a, b, r) = (poly(&[1, -2, 0, 5]), poly(&[3, 0, 2]), poly(&[7, 1]));
        let mut dividend = product(&Rationals, &a, &b);
        dividend[0] += &r[0];
        dividend[1] += &r[1];
        assert_eq!(divide(&Rationals, &dividend, &b), (a, r));
    }

    #[test]
    fn products_with_nothing_are_nothing() {
        assert!(product(&Rationals, &poly(&[]), &poly(&[1, 2, 3])).is_empty());
        assert!(product(&Rationals, &poly(&[1, 2, 3]), &poly(&[])).is_empty());
    }

    #[test]
    fn values_and_slopes() {
        let p = poly(&[1, 2, 3]);
        assert_eq!(evaluate(&Rationals, &p, &poly(&[2])[0]), poly(&[17])[0]);
        assert_eq!(derivative(&Rationals, &p), poly(&[2, 6]));
    }
}
