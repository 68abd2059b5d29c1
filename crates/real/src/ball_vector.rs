use crate::Ball;
use crate::ball::RADIUS_BITS;
use crate::kronecker;
use rug::float::Round;
use rug::ops::{AddAssignRound, DivRounding, MulAssignRound};
use rug::{Assign, Float, Integer};

/// Largest decay, in bits per index, that a vector is scaled by.
const MAX_SLOPE: i64 = 256;

/// The coefficients of a power series of balls, as fixed-point integers ready to be multiplied.
///
/// ```text
/// a_i = 2^(-slope i) (n_i 2^exponent + e_i),   |n_i| <= 2^bits,   |e_i| <= error
/// ```
///
/// The slope follows the decay of the coefficients, so that all of them keep their relative
/// precision; then one error bound serves all, and a product costs one product of long integers.
///
/// # Error bound
///
/// With `||a||` the sum of all `|n_i| 2^exponent`, coefficient `m` of `a b` is off by at most
/// `2^(-slope m) (||a|| error_b + ||b|| error_a + len error_a error_b)`.
#[derive(Clone, Debug)]
pub struct BallVector {
    balls: Vec<Ball>,
    image: Option<Image>,
}

/// The integers of a vector at one slope and precision.
#[derive(Clone, Debug)]
struct Image {
    packed: Integer,
    slope: i64,
    bits: u32,
    exponent: i64,
    norm: Float,
    error: Float,
}

impl BallVector {
    /// Prepares the first `len` of the given coefficients for products.
    pub fn new(balls: &[Ball], len: usize) -> Self {
        let balls = balls[..balls.len().min(len)].to_vec();
        let image = Image::new(&balls, decay(&balls), precision(&balls));
        Self { balls, image }
    }

    /// Returns the first `len` coefficients of `sum_t weight_t a_t b_t` over the given terms.
    pub fn sum_of_products(terms: &[(i64, &Self, &Self)], len: usize) -> Vec<Ball> {
        let mut total: Option<Vec<Ball>> = None;
        for (weight, a, b) in terms {
            let product = Self::product(a, b, len);
            let weighted = product
                .into_iter()
                .map(|c| if *weight == 1 { c } else { c * Ball::from_integer(*weight, 64) });
            total = Some(match total {
                None => weighted.collect(),
                Some(sum) => sum.into_iter().zip(weighted).map(|(x, y)| x + y).collect(),
            });
        }
        total.unwrap_or_else(|| vec![num_traits::Zero::zero(); len])
    }

    /// Returns the first `len` coefficients of the product of two vectors.
    pub fn product(a: &Self, b: &Self, len: usize) -> Vec<Ball> {
        if a.balls.iter().all(num_traits::Zero::is_zero) || b.balls.iter().all(num_traits::Zero::is_zero) {
            return vec![num_traits::Zero::zero(); len];
        }
        let (Some(image_a), Some(image_b)) = (&a.image, &b.image) else {
            return vec![Ball::whole_line(precision(&a.balls).max(precision(&b.balls))); len];
        };
        if image_a.slope == image_b.slope && image_a.bits == image_b.bits {
            return Image::product(image_a, image_b, a.balls.len().min(b.balls.len()), len);
        }
        let slope = image_a.slope.min(image_b.slope);
        let bits = image_a.bits.max(image_b.bits);
        match (Image::new(&a.balls, slope, bits), Image::new(&b.balls, slope, bits)) {
            (Some(x), Some(y)) => Image::product(&x, &y, a.balls.len().min(b.balls.len()), len),
            _ => vec![Ball::whole_line(bits); len],
        }
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
        let mut norm = Float::new(RADIUS_BITS);
        let mut error = Float::new(RADIUS_BITS);
        let mut integers = Vec::with_capacity(balls.len());
        for (i, ball) in balls.iter().enumerate() {
            let shift = slope * as_i64(i);
            let (integer, exact) = fixed_point(&ball.mid, shift - exponent);
            let mut own = scaled_up(&ball.rad, shift);
            if !exact {
                own.add_assign_round(&power_of_two(exponent), Round::Up);
            }
            error = error.max(&own);
            norm.add_assign_round(
                &Float::with_val_round(RADIUS_BITS, &*integer.as_abs(), Round::Up).0,
                Round::Up,
            );
            integers.push(integer);
        }
        norm.mul_assign_round(&power_of_two(exponent), Round::Up);
        let packed = kronecker::pack(integers.iter(), slot(bits));
        Some(Self { packed, slope, bits, exponent, norm, error })
    }

    /// Multiplies two images of the same slope and precision.
    fn product(a: &Self, b: &Self, terms: usize, len: usize) -> Vec<Ball> {
        let integers = kronecker::unpack(&Integer::from(&a.packed * &b.packed), slot(a.bits), len);
        let mut error = up(&a.norm, &b.error);
        error.add_assign_round(&up(&b.norm, &a.error), Round::Up);
        let mut both = up(&a.error, &b.error);
        both.mul_assign_round(terms as u64, Round::Up);
        error.add_assign_round(&both, Round::Up);
        let exponent = a.exponent + b.exponent;
        let ball = |(m, integer): (usize, Integer)| {
            let shift = a.slope * as_i64(m);
            let mut ball = Ball::rounded(a.bits, &integer);
            ball = ball.shifted(as_i32(exponent - shift));
            ball.widened(&scaled_up(&error, -shift))
        };
        integers.into_iter().enumerate().map(ball).collect()
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
    let exact = integer.is_zero() || integer.find_one(0).is_some_and(|lowest| lowest >= cut);
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

/// Bits per index by which the coefficients fall, rounded down.
fn decay(balls: &[Ball]) -> i64 {
    let size = |b: &Ball| b.mid.get_exp().map(i64::from);
    let mut sizes = balls.iter().enumerate().filter_map(|(i, b)| size(b).map(|e| (as_i64(i), e)));
    let (Some((first, high)), Some((last, low))) = (sizes.next(), sizes.next_back()) else {
        return 0;
    };
    DivRounding::div_floor(high - low, last - first).clamp(-MAX_SLOPE, MAX_SLOPE)
}

fn up(x: &Float, y: &Float) -> Float {
    Float::with_val_round(RADIUS_BITS, x * y, Round::Up).0
}

fn scaled_up(x: &Float, shift: i64) -> Float {
    let mut out = x.clone();
    out <<= as_i32(shift);
    out
}

fn power_of_two(exponent: i64) -> Float {
    let mut out = Float::new(RADIUS_BITS);
    out.assign(1);
    out <<= as_i32(exponent);
    out
}

fn as_i64(index: usize) -> i64 {
    i64::try_from(index).unwrap_or(i64::MAX)
}

/// Exponents stay far inside MPFR's range; one that does not saturates to an infinite radius or zero.
fn as_i32(shift: i64) -> i32 {
    i32::try_from(shift).unwrap_or(if shift < 0 { i32::MIN } else { i32::MAX })
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
