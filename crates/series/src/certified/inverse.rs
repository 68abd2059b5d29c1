//! The coefficient of restitution from the largest compression, by the inverse collision, in fixed point.

use super::one_variable::{compose, power_of_exponential, reciprocal};
use crate::kernels::{Fixed, Workshop};
use rug::Integer;

/// The exponents of the inverse collision `eps^q y(w) = y(v)`, `w = -v eps^p`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Exponents {
    /// `q = 2/(a+1)`.
    pub elastic: (i64, i64),
    /// `p = (2 gamma - a + 1)/(a + 1)`.
    pub velocity: (i64, i64),
}

/// `-v eps^p` for `eps = exp L`, below `v^len`, with `L` to at least as many terms.
pub(crate) fn image(shop: &Workshop, l: &Fixed, exponents: Exponents, len: usize) -> Fixed {
    power_of_exponential(shop, &l.truncated(len), exponents.velocity).stepped().negated()
}

/// `ln eps` below `v^len`, by Newton's iteration on `exp(q L) y(-v exp(p L)) = y(v)`:
///
/// ```text
/// L <- L - (eps^q y(w) - y(v))/M,    M = eps^q (q y(w) + p w y'(w))
/// ```
pub(crate) fn logarithm(shop: &Workshop, y: &Fixed, exponents: Exponents, len: usize) -> Fixed {
    let integers: Vec<Integer> = (0..y.len()).map(|k| y.integer(k)).collect();
    let slope: Vec<Integer> = integers.iter().enumerate().map(|(k, c)| Integer::from(c * k as u64)).collect();
    let mut l = Fixed::zero(1, shop.width());
    while l.len() < len {
        let known = l.len();
        let next = (2 * known).min(len);
        l.extend(&Fixed::zero(next - known, shop.width()));
        let w = image(shop, &l, exponents, next);
        let power = power_of_exponential(shop, &l, exponents.elastic);
        let at_image = compose(shop, &integers, &w, next);
        let mut defect = shop.product(&power, &at_image, next);
        defect.add(&y.truncated(next).negated());
        let new = next - known;
        let derivative = derivative(shop, &power, &at_image, &compose(shop, &slope, &w, new), exponents, new);
        let step = shop.product(&defect.beyond(known), &reciprocal(shop, &derivative), new);
        l = l.truncated(known);
        l.extend(&step.negated());
    }
    l
}

/// `M = eps^q (q y(w) + p w y'(w))` below `v^len`; `slope` is `w y'(w)`.
pub(crate) fn derivative(
    shop: &Workshop,
    power: &Fixed,
    at_image: &Fixed,
    slope: &Fixed,
    exponents: Exponents,
    len: usize,
) -> Fixed {
    let mut sum = at_image.truncated(len).scaled(|_| exponents.elastic);
    sum.add(&slope.truncated(len).scaled(|_| exponents.velocity));
    shop.product(power, &sum, len)
}
