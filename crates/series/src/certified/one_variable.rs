//! Series in the damping alone, in fixed point: reciprocal, exponential, composition.

use crate::kernels::{Fixed, Workshop};
use rug::Integer;

/// The constant 1 as a series of one term.
pub(crate) fn one(shop: &Workshop) -> Fixed {
    Fixed::from_integers(&[Integer::from(1) << shop.bits()], shop.width())
}

/// The constant 1 as a series of so many terms.
pub(crate) fn one_padded(shop: &Workshop, len: usize) -> Fixed {
    let mut one = one(shop);
    one.extend(&Fixed::zero(len - 1, shop.width()));
    one
}

/// `1/s` to the length of `s`, by Newton's iteration `z <- z (2 - z s)`.
pub(crate) fn reciprocal(shop: &Workshop, series: &Fixed) -> Fixed {
    let unit = Integer::from(1) << (2 * shop.bits());
    let mut z = Fixed::from_integers(&[unit / series.integer(0)], shop.width());
    while z.len() < series.len() {
        let known = z.len();
        let next = (2 * known).min(series.len());
        let defect = shop.products(&[(1, series, &z)], known..next);
        z.extend(&shop.product(&defect, &z, next - known).negated());
    }
    z
}

/// The series `H` with constant term 1 and `theta H = rate H`, `theta = v d/dv`, `rate_0 = 0`.
///
/// Newton's iteration with `1/H` carried along: `H <- H (1 + theta^(-1)((rate H - theta H)/H))`.
pub(crate) fn exponential(shop: &Workshop, rate: &Fixed) -> Fixed {
    let len = rate.len();
    let (mut h, mut inverse) = (one(shop), one(shop));
    while h.len() < len {
        let known = h.len();
        let next = (2 * known).min(len);
        let new = next - known;
        // The defect rate H - theta H vanishes below `known`; there theta H has no further terms.
        let defect = shop.products(&[(1, rate, &h)], known..next);
        let quotient = shop.product(&defect, &inverse, new).scaled(|i| (1, (known + i) as i64));
        h.extend(&shop.product(&h, &quotient, new));
        let overlap = shop.products(&[(1, &h, &inverse)], known..next);
        inverse.extend(&shop.product(&overlap, &inverse, new).negated());
    }
    h
}

/// `exp(q L)` for `L` without constant term and `q = numerator/denominator`.
pub(crate) fn power_of_exponential(
    shop: &Workshop,
    l: &Fixed,
    (numerator, denominator): (i64, i64),
) -> Fixed {
    let rate = l.scaled(|k| (numerator * k as i64, denominator));
    exponential(shop, &rate)
}

/// `outer(inner)` below `v^len` for an inner series without constant term.
///
/// Paterson and Stockmeyer: about `2 sqrt(len)` products and `len^2/2` multiplications of numbers.
pub(crate) fn compose(shop: &Workshop, outer: &[Integer], inner: &Fixed, len: usize) -> Fixed {
    let step = len.isqrt().max(1);
    let mut powers = vec![one(shop)];
    for i in 1..=step {
        powers.push(shop.product(&powers[i - 1], inner, len));
    }
    let giant = powers.pop().unwrap_or_else(|| one(shop));
    let baby: Vec<Vec<Integer>> =
        powers.iter().map(|power| (0..power.len()).map(|j| power.integer(j)).collect()).collect();
    let mut sum = Fixed::zero(len, shop.width());
    for block in (0..outer.len().min(len).div_ceil(step)).rev() {
        let from = block * step;
        let coefficients = &outer[from..outer.len().min(from + step)];
        // The sum is multiplied by inner^from: only so many terms of it count.
        let needed = len - from;
        let mut values = vec![Integer::new(); needed];
        for (i, (c, power)) in coefficients.iter().zip(&baby).enumerate() {
            for (value, w) in values.iter_mut().zip(power).skip(i) {
                *value += c * w;
            }
        }
        values.iter_mut().for_each(|value| *value >>= shop.bits());
        let mut next = shop.product(&sum, &giant, needed);
        next.add(&Fixed::from_integers(&values, shop.width()));
        sum = next;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_has_as_many_terms_as_asked_for() {
        let shop = Workshop::new(128, 40, (2, 1));
        for len in 1..6 {
            let one = one_padded(&shop, len);
            let expected = (0..len).map(|k| Integer::from(i32::from(k == 0)) << 128).collect::<Vec<_>>();
            assert_eq!((0..one.len()).map(|k| one.integer(k)).collect::<Vec<_>>(), expected);
        }
    }
}
