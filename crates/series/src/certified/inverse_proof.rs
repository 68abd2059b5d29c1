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

/// Sums over the sizes of the coefficients `y_k`, with what `eps^(q + p k)` makes of them: by `|q| + |p| k` for each derivative.
#[derive(Clone, Copy, Debug)]
struct Sums {
    /// Of `y_k` and of `k y_k`.
    total: Magnitude,
    slope: Magnitude,
    /// By `k (|q| + |p| k)` and by `(|q| + |p| k)^2`.
    by_image: Magnitude,
    by_square: Magnitude,
}

impl Sums {
    fn of(coefficients: &[Magnitude], q: Magnitude, p: Magnitude) -> Self {
        let sum = |of: &dyn Fn(Magnitude) -> Magnitude| -> Magnitude {
            coefficients.iter().enumerate().map(|(k, &c)| c * of(exact(k as f64))).sum()
        };
        let stretch = |k: Magnitude| q + p * k;
        Self {
            total: sum(&|_| Magnitude::ONE),
            slope: sum(&|k| k),
            by_image: sum(&|k| k * stretch(k)),
            by_square: sum(&|k| stretch(k) * stretch(k)),
        }
    }

    /// Of the true compression: what it misses counts with the largest weight.
    fn second_derivative(self, missed: Magnitude, last: Magnitude, norm: Magnitude) -> Magnitude {
        (self.by_square + missed * last * last) * norm * Magnitude::exact(2.0)
    }
}

/// What composing a series of so many terms and this sum of coefficients costs: every power of `w` up to the step, every block
/// and every product with the giant step is rounded.
fn composing(len: usize, sum: Magnitude) -> Magnitude {
    let len = len as f64;
    exact((PRODUCT + 1.0) * len) * exact(len + 3.0 * len.sqrt() + 4.0) * (Magnitude::ONE + sum)
}

/// The error of the derivative: its product is rounded, and so are both parts of its second factor, which are off by as much.
fn derivative_error(len: usize, norm: Magnitude, parts: Magnitude, of_power: Magnitude) -> Magnitude {
    let len = len as f64;
    exact(PRODUCT * len) + norm * (exact(2.0 * len) + parts) + of_power * Magnitude::exact(2.0)
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
    let sums = Sums::of(&coefficients, q_size, p_size);
    let composing = |sum: Magnitude| composing(len, sum);

    let integers: Vec<Integer> = (0..len).map(|k| y.integer(k)).collect();
    let slopes: Vec<Integer> =
        integers.iter().enumerate().map(|(k, c)| Integer::from(c * k as u64)).collect();
    let at_image = compose(shop, &integers, &w, len);
    let mut defect = shop.product(&elastic.series, &at_image, len);
    defect.add(&y.clone().negated());
    let defect = scales.defect(&defect)
        + elastic.norm * (composing(sums.total) + sums.slope * w_error)
        + elastic.error * sums.total * Magnitude::exact(2.0)
        + y_error * (elastic.norm + Magnitude::ONE);

    let last = q_size + p_size * exact(len as f64);
    let second = sums.second_derivative(y_error * small, last, elastic.norm);
    let m = derivative(shop, &elastic.series, &at_image, &compose(shop, &slopes, &w, len), exponents, len);
    let inverse = reciprocal(shop, &m);
    let mut gap = shop.product(&m, &inverse, len);
    gap.add(&one_padded(shop, len).negated());
    let inverse_norm = scales.norm(&inverse);
    // The parts of the second factor.
    let parts = composing(sums.total) * q_size + composing(sums.slope) * p_size;
    let given = sums.by_image * w_error + y_error * last;
    let of_power = elastic.error * (q_size * sums.total + p_size * sums.slope);
    let m_error = derivative_error(len, elastic.norm, parts + given, of_power);
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
