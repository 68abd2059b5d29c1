//! How far the restitution found is from the true one (`docs/error-bounds.md`, theorem 6).

use super::inverse::{Exponents, derivative, image};
use super::one_variable::{compose, one_padded, power_of_exponential, reciprocal};
use super::sketch::{over_one_minus, within};
use super::turning_proof::PRODUCT;
use crate::kernels::{Fixed, Workshop, power_of_two};
use restitution_real::Magnitude;
use rug::Integer;

/// How far below 1 the norm of the image must stay, and with its error.
const INSIDE: f64 = 0.999;
const INSIDE_WITH_ERROR: f64 = 0.9995;
/// The least weight: below it, errors of high orders would be larger than these.
const LEAST_WEIGHT: f64 = 1e-3;
/// How large the contraction may be, and the error of the logarithm so that its square is nothing.
const CONTRACTION: f64 = 0.25;
const FIRST_ORDER: f64 = 1e-6;
/// How far the error of the logarithm may change any `eps^(q + p k)`: the image stays inside, and the second derivative
/// what it is to a part in thousands.
const LARGEST_STRETCH: f64 = 1e-4;

/// The restitution and what is proved of it: `|eps_k - eps~_k| <= error weight^(-k)` in units of the fixed point.
pub(crate) struct Restitution {
    pub series: Fixed,
    pub error: Magnitude,
    pub weight: f64,
}

fn exact(x: f64) -> Magnitude {
    Magnitude::exact(x * (1.0 + 1e-12))
}

/// A power `exp(q L)` as found, and a bound of its error in units of the fixed point.
struct Exponential {
    series: Fixed,
    norm: Magnitude,
    error: Magnitude,
}

/// A workshop and the weight of the norm.
struct Scales<'s> {
    shop: &'s Workshop,
    len: usize,
    weight: f64,
    small: Magnitude,
}

impl Scales<'_> {
    fn norm(&self, series: &Fixed) -> Magnitude {
        series.norm(i64::from(self.shop.bits()), self.weight)
    }

    /// The norm in units of the fixed point, with the rounding of the product that it came from.
    fn defect(&self, series: &Fixed) -> Magnitude {
        series.norm(0, self.weight) + exact(PRODUCT * self.len as f64)
    }

    /// With `U` found for `exp(q L)`: `theta U - q (theta L) U = kappa` gives `U = exp(q L)(1 + xi)`,
    /// `||xi|| <= x/(1-x)`, `x = ||kappa|| ||1/U||`.
    fn exponential(&self, l: &Fixed, (numerator, denominator): (i64, i64)) -> Option<Exponential> {
        let shop = self.shop;
        let series = power_of_exponential(shop, l, (numerator, denominator));
        let opposite = power_of_exponential(shop, l, (-numerator, denominator));
        let mut gap = shop.product(&series, &opposite, self.len);
        gap.add(&one_padded(shop, self.len).negated());
        let inverse = self.norm(&opposite) * over_one_minus(self.defect(&gap) * self.small)?;
        let rate = l.scaled(|k| (numerator * k as i64, denominator));
        let mut kappa = shop.product(&rate, &series, self.len);
        kappa.add(&series.scaled(|k| (k as i64, 1)).negated());
        // The rate is rounded by less than one unit a coefficient.
        let kappa = self.defect(&kappa) + exact(self.len as f64) * self.norm(&series);
        let x = kappa * inverse * self.small;
        let xi = x * over_one_minus(x)?;
        let norm = self.norm(&series) * over_one_minus(xi)?;
        let error = norm * kappa * inverse * over_one_minus(x)?;
        Some(Exponential { series, norm, error })
    }
}

/// The weight, at most 1, at which the image of the damping stays inside the unit ball.
fn weight(shop: &Workshop, image: &Fixed) -> f64 {
    let sizes: Vec<f64> = (0..image.len()).map(|k| image.size(k, i64::from(shop.bits())).to_f64()).collect();
    let norm = |weight: f64| sizes.iter().rev().fold(0.0, |sum, size| sum * weight + size);
    let (mut low, mut high) = (0.0, 1.0);
    if norm(high) <= INSIDE {
        return high;
    }
    for _ in 0..40 {
        let middle = (low + high) / 2.0;
        if norm(middle) <= INSIDE { low = middle } else { high = middle }
    }
    low
}

/// Proves how far `exp(L)` is from the restitution that belongs to the compression `y` of the given error.
///
/// `None` if the norms are too large.
pub(crate) fn prove(
    shop: &Workshop,
    y: &Fixed,
    y_error: Magnitude,
    l: &Fixed,
    exponents: Exponents,
) -> Option<Restitution> {
    let len = y.len();
    let w = image(shop, l, exponents, len);
    let weight = if len < 2 { 1.0 } else { weight(shop, &w) * (1.0 - 1e-9) };
    if weight < LEAST_WEIGHT {
        return None;
    }
    let small = power_of_two(-i64::from(shop.bits()));
    let scales = Scales { shop, len, weight, small };
    let [q, p] = [exponents.elastic, exponents.velocity];
    let [q_size, p_size] = [q, p].map(|(n, d)| exact((n as f64 / d as f64).abs()));
    let elastic = scales.exponential(l, q)?;
    let velocity = scales.exponential(l, p)?;
    let w_error = velocity.error;
    if !within(scales.norm(&w) + w_error * small, INSIDE_WITH_ERROR) {
        return None;
    }

    let coefficients: Vec<Magnitude> = (0..len).map(|k| y.size(k, i64::from(shop.bits()))).collect();
    let moment = |of: &dyn Fn(Magnitude) -> Magnitude| -> Magnitude {
        coefficients.iter().enumerate().map(|(k, &c)| c * of(exact(k as f64))).sum()
    };
    let (total, slope) = (moment(&|_| Magnitude::ONE), moment(&|k| k));
    // Every power of w up to the step, every block and every product with the giant step is rounded.
    let steps = exact(len as f64 + 3.0 * (len as f64).sqrt() + 4.0);
    let composing = |sum: Magnitude| exact((PRODUCT + 1.0) * len as f64) * steps * (Magnitude::ONE + sum);

    let integers: Vec<Integer> = (0..len).map(|k| y.integer(k)).collect();
    let slopes: Vec<Integer> =
        integers.iter().enumerate().map(|(k, c)| Integer::from(c * k as u64)).collect();
    let at_image = compose(shop, &integers, &w, len);
    let mut defect = shop.product(&elastic.series, &at_image, len);
    defect.add(&y.clone().negated());
    let defect = scales.defect(&defect)
        + elastic.norm * (composing(total) + slope * w_error)
        + elastic.error * total * Magnitude::exact(2.0)
        + y_error * (elastic.norm + Magnitude::ONE);

    // Of the true compression: what it misses counts with the largest weight.
    let last = q_size + p_size * exact(len as f64);
    let second = (moment(&|k| (q_size + p_size * k) * (q_size + p_size * k)) + y_error * small * last * last)
        * elastic.norm
        * Magnitude::exact(2.0);
    let by_image = moment(&|k| k * (q_size + p_size * k));
    let m = derivative(shop, &elastic.series, &at_image, &compose(shop, &slopes, &w, len), exponents, len);
    let inverse = reciprocal(shop, &m);
    let mut gap = shop.product(&m, &inverse, len);
    gap.add(&one_padded(shop, len).negated());
    let inverse_norm = scales.norm(&inverse);
    // The product is rounded, and so are both parts of its second factor.
    let m_error = exact(PRODUCT * len as f64)
        + elastic.norm
            * (exact(2.0 * len as f64)
                + composing(total) * q_size
                + composing(slope) * p_size
                + by_image * w_error
                + y_error * last)
        + elastic.error * (q_size * total + p_size * slope) * Magnitude::exact(2.0);
    let gap = (scales.defect(&gap) + inverse_norm * m_error) * small;
    let inverse_norm = inverse_norm * over_one_minus(gap)?;
    let logarithm = inverse_norm * defect * Magnitude::exact(2.0);
    let contraction = second * inverse_norm * logarithm * small * Magnitude::exact(2.0);
    let relative = logarithm * small * exact(len as f64 + 8.0);
    let stretched = logarithm * small * last;
    if !within(contraction, CONTRACTION)
        || !within(relative, FIRST_ORDER)
        || !within(stretched, LARGEST_STRETCH)
    {
        return None;
    }
    let result = scales.exponential(l, (1, 1))?;
    let error = result.error + result.norm * logarithm * Magnitude::exact(1.0 + 1e-5);
    Some(Restitution { series: result.series, error, weight })
}

#[cfg(test)]
mod tests;
