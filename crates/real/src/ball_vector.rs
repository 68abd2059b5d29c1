use crate::Ball;
use crate::ball::RADIUS_BITS;
use crate::kronecker;
use num_traits::Zero;
use rug::float::Round;
use rug::{Float, Integer};
use std::borrow::Cow;

/// Largest decay, in bits per index, that a vector is scaled by.
const MAX_SLOPE: i64 = 256;

/// The coefficients of a power series of balls, as fixed-point integers ready to be multiplied.
///
/// ```text
/// a_i = n_i 2^(exponent - slope i) + e_i,   |e_i| <= r_i
/// ```
///
/// The slope follows the slowest decay of the coefficients; the integers of a product come from one
/// product of long integers (Kronecker substitution), its radii from a convolution of magnitudes.
///
/// # Error bound
///
/// Coefficient `m` of `a b` is off by at most `sum_(i+k=m) (|a_i| r_k + r_i |b_k| + r_i r_k)`, where
/// `r_i` is the ball's radius and, if bits were cut off, one unit `2^(exponent - slope i)`.
#[derive(Clone, Debug)]
pub struct BallVector {
    balls: Vec<Ball>,
    /// How many coefficients at the beginning are exactly zero.
    zeros: usize,
    image: Option<Image>,
}

/// The integers of a vector at one slope and precision, with bounds of their sizes and errors.
#[derive(Clone, Debug)]
struct Image {
    packed: Integer,
    slope: i64,
    bits: u32,
    exponent: i64,
    sizes: Magnitudes,
    errors: Magnitudes,
}

impl BallVector {
    /// Prepares the first `len` of the given coefficients for products.
    pub fn new(balls: &[Ball], len: usize) -> Self {
        let balls = balls[..balls.len().min(len)].to_vec();
        let image = Image::new(&balls, decay(balls.iter().map(|b| &b.mid)), precision(&balls));
        let zeros = balls.iter().position(|b| !b.is_zero()).unwrap_or(usize::MAX / 2);
        Self { balls, zeros, image }
    }

    /// Returns the first `len` coefficients of `sum_t weight_t a_t b_t` over the given terms.
    pub fn sum_of_products(terms: &[(i64, &Self, &Self)], len: usize) -> Vec<Ball> {
        let known = |(_, a, b): &&(i64, &Self, &Self)| a.zeros + b.zeros < len;
        let terms: Vec<_> = terms.iter().filter(known).collect();
        let zeros = terms.iter().map(|(_, a, b)| a.zeros + b.zeros).min().unwrap_or(len);
        let vectors = || terms.iter().flat_map(|(_, a, b)| [a, b]);
        let bits = vectors().map(|v| precision(&v.balls)).max().unwrap_or(64);
        let slopes = vectors().map(|v| v.image.as_ref().map(|image| image.slope));
        let Some(slope) = slopes.reduce(|x, y| Some(flatter(x?, y?))).unwrap_or(Some(0)) else {
            return vec![Ball::whole_line(bits); len];
        };
        let spreads = vectors().filter_map(|v| v.image.as_ref().map(|image| image.sizes.slope));
        let spread = spreads.reduce(flatter).unwrap_or(0);
        let product = |(weight, a, b): &&(i64, &Self, &Self)| {
            Some(Image::product(*weight, &*a.image_at(slope, bits)?, &*b.image_at(slope, bits)?, spread, len))
        };
        let sum = match terms.iter().map(product).collect::<Option<Vec<Product>>>() {
            Some(products) => Product::sum(products, spread, slope, bits, len),
            None => return vec![Ball::whole_line(bits); len],
        };
        let exact = |(m, c)| if m < zeros { Ball::zero() } else { c };
        sum.into_balls(slope, bits).enumerate().map(exact).collect()
    }

    /// Returns the first `len` coefficients of the product of two vectors.
    pub fn product(a: &Self, b: &Self, len: usize) -> Vec<Ball> {
        Self::sum_of_products(&[(1, a, b)], len)
    }

    fn image_at(&self, slope: i64, bits: u32) -> Option<Cow<'_, Image>> {
        match &self.image {
            Some(image) if image.slope == slope && image.bits == bits => Some(Cow::Borrowed(image)),
            _ => Image::new(&self.balls, slope, bits).map(Cow::Owned),
        }
    }
}

/// The coefficients of a product: `integers[m] 2^(exponent - slope m)` up to `errors`.
struct Product {
    integers: Vec<Integer>,
    exponent: i64,
    errors: Magnitudes,
}

impl Product {
    /// Adds products up, on the finest exponent that does not exceed the precision twice over.
    fn sum(products: Vec<Self>, spread: i64, slope: i64, bits: u32, len: usize) -> Self {
        let exponents = || products.iter().map(|p| p.exponent);
        let (finest, coarsest) = (exponents().min().unwrap_or(0), exponents().max().unwrap_or(0));
        let exponent = finest.max(coarsest - 2 * i64::from(bits) - 64);
        let mut sum =
            Self { integers: vec![Integer::new(); len], exponent, errors: Magnitudes::zero(len, spread) };
        for product in products {
            let shift = product.exponent - exponent;
            for (total, integer) in sum.integers.iter_mut().zip(product.integers) {
                *total += integer << i32::try_from(shift).unwrap_or(i32::MIN);
            }
            sum.errors.add(&product.errors);
            if shift < 0 {
                let units: Vec<Float> =
                    (0..len).map(|m| power_of_two(exponent - slope * as_i64(m))).collect();
                sum.errors.add(&Magnitudes::new(&units, spread));
            }
        }
        sum
    }

    fn into_balls(self, slope: i64, bits: u32) -> impl Iterator<Item = Ball> {
        let Self { integers, exponent, errors } = self;
        integers.into_iter().enumerate().map(move |(m, integer)| {
            let mut ball = Ball::rounded(bits, &integer);
            ball.shift(exponent - slope * as_i64(m));
            ball.widened(&errors.get(m))
        })
    }
}

impl Image {
    /// Rounds the scaled coefficients to integers; `None` if one is unbounded.
    fn new(balls: &[Ball], slope: i64, bits: u32) -> Option<Self> {
        if !balls.iter().all(Ball::is_finite) {
            return None;
        }
        let scaled_exponent =
            |(i, b): (usize, &Ball)| b.mid.get_exp().map(|e| i64::from(e) + slope * as_i64(i));
        let top = balls.iter().enumerate().filter_map(scaled_exponent).max().unwrap_or(0);
        let exponent = top - i64::from(bits);
        let mut integers = Vec::with_capacity(balls.len());
        let mut errors = Vec::with_capacity(balls.len());
        for (i, ball) in balls.iter().enumerate() {
            let unit = exponent - slope * as_i64(i);
            let (integer, exact) = fixed_point(&ball.mid, -unit);
            errors.push(if exact { ball.rad.clone() } else { sum_up(&ball.rad, &power_of_two(unit)) });
            integers.push(integer);
        }
        let packed = kronecker::pack(integers.iter(), slot(bits));
        let sizes: Vec<Float> = balls.iter().map(Ball::abs_up).collect();
        let spread = match errors.iter().all(Float::is_zero) {
            true => decay(sizes.iter()),
            false => flatter(decay(sizes.iter()), decay(errors.iter())),
        };
        let (sizes, errors) = (Magnitudes::new(&sizes, spread), Magnitudes::new(&errors, spread));
        Some(Self { packed, slope, bits, exponent, sizes, errors })
    }

    /// Multiplies two images of the same slope and precision.
    fn product(weight: i64, a: &Self, b: &Self, spread: i64, len: usize) -> Product {
        let mut integers = kronecker::unpack(&Integer::from(&a.packed * &b.packed), slot(a.bits), len);
        if weight != 1 {
            integers.iter_mut().for_each(|c| *c *= weight);
        }
        // |A B - a b| <= |A| r_b + r_a |b|, with |A| <= sizes.
        let at = |part| Magnitudes::at_slope(part, spread);
        let mut errors = at(&a.sizes).convolution(&at(&b.errors), len);
        errors.add(&at(&a.errors).convolution(&at(&b.sizes), len));
        errors.scale(weight.unsigned_abs());
        Product { integers, exponent: a.exponent + b.exponent, errors }
    }
}

/// Upper bounds `values[i] 2^(exponent - slope i)` of nonnegative numbers.
///
/// The slope is the flattest at hand, so that a value raised to the least one is small beside another.
#[derive(Clone, Debug)]
struct Magnitudes {
    values: Vec<f64>,
    exponent: i64,
    slope: i64,
}

impl Magnitudes {
    /// The smallest value that is told from zero; products of two still are normal numbers.
    const LEAST: f64 = f64::from_bits((1023 - 500) << 52);

    fn new(bounds: &[Float], slope: i64) -> Self {
        let scaled: Vec<Float> =
            bounds.iter().enumerate().map(|(i, x)| shifted(x, slope * as_i64(i))).collect();
        let exponent = scaled.iter().filter_map(Float::get_exp).max().map_or(0, i64::from);
        let value = |x: &Float| {
            if x.is_zero() { 0.0 } else { shifted(x, -exponent).to_f64_round(Round::Up).max(Self::LEAST) }
        };
        Self { values: scaled.iter().map(value).collect(), exponent, slope }
    }

    fn zero(len: usize, slope: i64) -> Self {
        Self { values: vec![0.0; len], exponent: 0, slope }
    }

    /// The same bounds at another slope.
    fn at_slope(&self, slope: i64) -> Cow<'_, Self> {
        if slope == self.slope {
            return Cow::Borrowed(self);
        }
        let bounds: Vec<Float> = (0..self.values.len()).map(|i| self.get(i)).collect();
        Cow::Owned(Self::new(&bounds, slope))
    }

    /// Adds other bounds; what is too small for the larger exponent counts as the least value.
    fn add(&mut self, other: &Self) {
        if other.values.iter().all(|&y| y == 0.0) {
            return;
        }
        if self.values.iter().all(|&x| x == 0.0) {
            self.exponent = other.exponent;
        }
        let exponent = self.exponent.max(other.exponent);
        let factor =
            |from: i64| if exponent - from > 1000 { 0.0 } else { 2f64.powi((from - exponent) as i32) };
        let (own, its) = (factor(self.exponent), factor(other.exponent));
        let scaled = |x: f64, factor: f64| if x > 0.0 { (x * factor).max(Self::LEAST) } else { 0.0 };
        for (x, &y) in self.values.iter_mut().zip(&other.values) {
            *x = (scaled(*x, own) + scaled(y, its)) * (1.0 + 1e-12);
        }
        self.exponent = exponent;
    }

    fn scale(&mut self, factor: u64) {
        if factor != 1 {
            self.values.iter_mut().for_each(|x| *x *= factor as f64 * (1.0 + 1e-12));
        }
    }

    /// Upper bounds of `sum_(i+k=m) a_i b_k`, `m < len`.
    ///
    /// All terms are nonnegative, so `len` roundings to nearest lose less than `len 2^-52` of the sum.
    fn convolution(&self, other: &Self, len: usize) -> Self {
        let mut values = vec![0.0; len];
        if other.values.iter().any(|&x| x > 0.0) {
            for (i, &x) in self.values.iter().enumerate().take(len).filter(|(_, x)| **x > 0.0) {
                for (sum, &y) in values[i..].iter_mut().zip(&other.values) {
                    *sum += x * y;
                }
            }
        }
        values.iter_mut().for_each(|v| *v *= 1.0 + 1e-6);
        Self { values, exponent: self.exponent + other.exponent, slope: self.slope }
    }

    fn get(&self, index: usize) -> Float {
        let value = self.values.get(index).copied().unwrap_or(0.0);
        shifted(
            &Float::with_val_round(RADIUS_BITS, value, Round::Up).0,
            self.exponent - self.slope * as_i64(index),
        )
    }
}

/// The integer part of `x 2^shift`, and whether nothing was cut off.
fn fixed_point(x: &Float, shift: i64) -> (Integer, bool) {
    let Some((mut integer, exponent)) = x.to_integer_exp() else {
        return (Integer::new(), true);
    };
    let total = i64::from(exponent) + shift;
    if total >= 0 {
        integer <<= u32::try_from(total).unwrap_or(u32::MAX);
        return (integer, true);
    }
    let cut = u32::try_from(-total).unwrap_or(u32::MAX);
    let exact = integer.find_one(0).is_none_or(|lowest| lowest >= cut);
    integer >>= cut;
    (integer, exact)
}

/// Limbs of a product's coefficient, the same for all vectors of one precision.
fn slot(bits: u32) -> usize {
    kronecker::slot_limbs(bits + 1, bits + 1, u32::MAX as usize)
}

/// The working precision of a vector.
fn precision(balls: &[Ball]) -> u32 {
    balls.iter().map(Ball::prec).max().unwrap_or(64)
}

/// The slope at which no number, once scaled, exceeds the largest: the whole number of bits per index
/// by which all fall off from it to the right; or, negative, to the left if there are more on that side.
fn decay<'a>(numbers: impl Iterator<Item = &'a Float>) -> i64 {
    let size = |(i, x): (usize, &Float)| x.get_exp().map(|e| (as_i64(i), i64::from(e)));
    let sizes: Vec<_> = numbers.enumerate().filter_map(size).collect();
    let Some(&(top, high)) = sizes.iter().max_by_key(|(i, e)| (*e, -i)) else { return 0 };
    let right = sizes.iter().filter(|(i, _)| *i > top).map(|(i, e)| (high - e) / (i - top));
    let left = sizes.iter().filter(|(i, _)| *i < top).map(|(i, e)| (high - e) / (top - i));
    let falls_right = right.clone().count() >= left.clone().count();
    let slope = if falls_right { right.min() } else { left.min().map(|slope| -slope) };
    slope.unwrap_or(0).clamp(-MAX_SLOPE, MAX_SLOPE)
}

/// The slope nearer to zero, zero if they have different signs.
fn flatter(x: i64, y: i64) -> i64 {
    match (x >= 0, y >= 0) {
        (true, true) => x.min(y),
        (false, false) => x.max(y),
        _ => 0,
    }
}

fn sum_up(x: &Float, y: &Float) -> Float {
    Float::with_val_round(RADIUS_BITS, x + y, Round::Up).0
}

fn shifted(x: &Float, shift: i64) -> Float {
    let mut out = x.clone();
    out <<= i32::try_from(shift).unwrap_or(if shift < 0 { i32::MIN } else { i32::MAX });
    out
}

fn power_of_two(exponent: i64) -> Float {
    shifted(&Float::with_val(RADIUS_BITS, 1), exponent)
}

fn as_i64(index: usize) -> i64 {
    i64::try_from(index).unwrap_or(i64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `sum_(i+j=k) a_i b_j` term by term.
    fn schoolbook(a: &[Ball], b: &[Ball], len: usize) -> Vec<Ball> {
        let mut out = vec![Ball::from_integer(0, 64); len];
        for (i, x) in a.iter().enumerate() {
            for (j, y) in b.iter().enumerate().take(len.saturating_sub(i)) {
                out[i + j] = &out[i + j] + x * y;
            }
        }
        out
    }

    #[test]
    fn products_enclose_those_of_higher_precision() {
        let vector = |prec: u32, ratio: i64| -> Vec<Ball> {
            (0..20)
                .map(|i| Ball::from_ratio(7 - i, 3, prec) / Ball::from_integer(ratio, prec).powi(i))
                .collect()
        };
        for (ratio_a, ratio_b) in [(1, 1), (17, 17), (5, 40), (1, 90)] {
            let (a, b) = (vector(80, ratio_a), vector(80, ratio_b));
            let fast = BallVector::product(&BallVector::new(&a, 20), &BallVector::new(&b, 20), 20);
            let fine = schoolbook(&vector(300, ratio_a), &vector(300, ratio_b), 20);
            for (enclosure, value) in fast.iter().zip(&fine) {
                assert!(enclosure.contains(value), "{enclosure:?} {value:?}");
            }
            assert!(fast[0].relative_bits().is_none_or(|bits| bits > 70));
        }
    }

    #[test]
    fn an_unbounded_coefficient_bounds_nothing() {
        let a = [Ball::from_integer(1, 64), Ball::whole_line(64)];
        let v = BallVector::new(&a, 2);
        assert!(!BallVector::product(&v, &v, 2)[0].is_finite());
    }
}
