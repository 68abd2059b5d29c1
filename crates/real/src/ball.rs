use crate::convert::rug_rational;
use num_rational::BigRational;
use rug::float::Round;
use rug::ops::{AddAssignRound, AssignRound};
use rug::{Assign, Float, Integer, Rational};
use std::cmp::Ordering;
use std::fmt;

/// Bits of a radius: it is only ever an upper bound, so few are enough.
pub(crate) const RADIUS_BITS: u32 = 32;
/// Bits of an exact constant that has not met a working precision yet.
const CONSTANT_BITS: u32 = 64;

/// A real number known to lie within `radius` of `midpoint`.
///
/// ```text
/// ball = { x : |x - midpoint| <= radius }
/// ```
///
/// Operations return a ball that contains every result of exact operands from the given balls, at
/// the larger of the operands' precisions: an exact constant such as `Ball::one()` takes the
/// precision of what it meets. Where no finite ball can be given (division by a ball that contains
/// zero, a logarithm that reaches zero) the result is the whole line, which [`Ball::is_finite`]
/// tells; nothing panics.
///
/// # Examples
///
/// ```
/// use restitution_real::Ball;
///
/// let third = Ball::from_ratio(1, 3, 100);
/// let one = &third + &third + &third;
/// assert!(one.contains(&Ball::from_integer(1, 100)));
///
/// let zero = &third - &third;
/// assert!(!(one / zero).is_finite());
/// ```
///
/// What a ball says of its number:
///
/// ```
/// use num_rational::BigRational;
/// use restitution_real::Ball;
/// use rug::{Float, Integer};
///
/// let third = Ball::from_rational(&BigRational::new(1.into(), 3.into()), 100);
/// assert!(third.lower() < *third.mid() && *third.mid() < third.upper() && *third.rad() < 1e-30);
/// assert!(third.is_positive() && (-&third).is_negative() && !third.is_exact());
/// assert_eq!((third.relative_bits(), Ball::from_f64(0.5, 53).relative_bits()), (Some(99), None));
/// assert_eq!((third.to_f64(), third.with_prec(20).prec()), (1.0 / 3.0, 20));
///
/// let around = third.clone().widened(&Float::with_val(32, 0.5)); // -1/6 to 5/6
/// assert!(around.contains(&third) && around.contains_zero() && around.abs_down() == 0 && around.abs_up() > 0.8);
/// let two = Ball::from_big_integer(&Integer::from(2), 64);
/// assert!(!around.overlaps(&two) && around.union(&two).contains(&Ball::exact(Float::with_val(53, 1.5))));
/// let mut between = Ball::between(&third.upper(), &third.lower(), 100); // in either order
/// between.widen(&Float::with_val(32, 1));
/// assert!(between.contains_rational(&BigRational::new(4.into(), 3.into())));
/// assert!(!Ball::from_f64(f64::NAN, 53).is_finite());
/// ```
#[derive(Clone)]
pub struct Ball {
    pub(crate) mid: Float,
    pub(crate) rad: Float,
}

impl Ball {
    /// Returns the ball with the given midpoint and radius.
    ///
    /// The precision of the ball is that of `mid`. The radius is rounded up; a negative or NaN
    /// radius gives the whole line.
    pub fn new(mid: Float, rad: &Float) -> Self {
        let rad = Float::with_val_round(RADIUS_BITS, rad, Round::Up).0;
        if !mid.is_finite() || rad.is_nan() || rad < 0 {
            return Self::whole_line(mid.prec());
        }
        Self { mid, rad }
    }

    /// Returns the whole real line, what is known when nothing is.
    pub fn whole_line(prec: u32) -> Self {
        Self { mid: Float::new(prec), rad: Float::with_val(RADIUS_BITS, rug::float::Special::Infinity) }
    }

    /// Returns the midpoint as an exact ball of its own.
    pub fn exact(mid: Float) -> Self {
        Self::new(mid, &Float::new(RADIUS_BITS))
    }

    /// Returns the integer `n`, rounded to `prec` bits.
    pub fn from_integer(n: i64, prec: u32) -> Self {
        Self::rounded(prec, n)
    }

    /// Returns the fraction `numerator/denominator`, rounded to `prec` bits; the whole line if the
    /// denominator is 0.
    pub fn from_ratio(numerator: i64, denominator: i64, prec: u32) -> Self {
        if denominator == 0 {
            return Self::whole_line(prec);
        }
        Self::rounded(prec, &Rational::from((numerator, denominator)))
    }

    /// Returns an exact rational number, rounded to `prec` bits.
    pub fn from_rational(value: &BigRational, prec: u32) -> Self {
        Self::rounded(prec, &rug_rational(value))
    }

    /// Returns a big integer, rounded to `prec` bits.
    pub fn from_big_integer(value: &Integer, prec: u32) -> Self {
        Self::rounded(prec, value)
    }

    /// Returns the double `value`, exactly; the whole line if it is NaN or infinite.
    pub fn from_f64(value: f64, prec: u32) -> Self {
        if value.is_finite() { Self::rounded(prec.max(53), value) } else { Self::whole_line(prec) }
    }

    /// Returns a ball around the interval with these ends, given in either order: its midpoint is the
    /// middle rounded to `prec` bits, its radius reaches the farther end.
    pub fn between(lower: &Float, upper: &Float, prec: u32) -> Self {
        let (lower, upper) = if lower <= upper { (lower, upper) } else { (upper, lower) };
        let (mid, _) = Float::with_val_round(prec, lower + upper, Round::Nearest);
        let mid = mid / 2u32;
        let below = Float::with_val_round(RADIUS_BITS, &mid - lower, Round::Up).0;
        let above = Float::with_val_round(RADIUS_BITS, upper - &mid, Round::Up).0;
        Self::new(mid, &below.max(&above))
    }

    /// Rounds anything MPFR can take to `prec` bits, with the rounding error as radius.
    pub(crate) fn rounded<T>(prec: u32, value: T) -> Self
    where
        Float: AssignRound<T, Round = Round, Ordering = Ordering>,
    {
        let (mid, direction) = Float::with_val_round(prec, value, Round::Nearest);
        let rad = rounding_error(&mid, direction);
        Self::new(mid, &rad)
    }

    /// The working precision in bits.
    pub fn prec(&self) -> u32 {
        self.mid.prec()
    }

    /// Returns the same ball with its midpoint rounded to `prec` bits.
    pub fn with_prec(&self, prec: u32) -> Self {
        let mut out = Self::rounded(prec, &self.mid);
        out.widen(&self.rad);
        out
    }

    /// The midpoint.
    pub fn mid(&self) -> &Float {
        &self.mid
    }

    /// The radius.
    pub fn rad(&self) -> &Float {
        &self.rad
    }

    /// A lower bound, rounded down.
    pub fn lower(&self) -> Float {
        Float::with_val_round(self.prec(), &self.mid - &self.rad, Round::Down).0
    }

    /// An upper bound, rounded up.
    pub fn upper(&self) -> Float {
        Float::with_val_round(self.prec(), &self.mid + &self.rad, Round::Up).0
    }

    /// An upper bound of `|x|` over the ball, with the bits of a radius.
    pub fn abs_up(&self) -> Float {
        let mid = magnitude_up(&self.mid);
        Float::with_val_round(RADIUS_BITS, &mid + &self.rad, Round::Up).0
    }

    /// A lower bound of `|x|` over the ball, with the bits of a radius; 0 if the ball contains 0.
    pub fn abs_down(&self) -> Float {
        let mut least = if self.mid.is_sign_negative() {
            -Float::with_val_round(RADIUS_BITS, &self.mid + &self.rad, Round::Up).0
        } else {
            Float::with_val_round(RADIUS_BITS, &self.mid - &self.rad, Round::Down).0
        };
        if !least.is_finite() || least.is_sign_negative() {
            least.assign(0);
        }
        least
    }

    /// Whether the ball is bounded.
    pub fn is_finite(&self) -> bool {
        self.mid.is_finite() && self.rad.is_finite()
    }

    /// Whether the ball is a single point.
    pub fn is_exact(&self) -> bool {
        self.rad.is_zero()
    }

    /// Whether 0 lies in the ball.
    pub fn contains_zero(&self) -> bool {
        self.mid.cmp_abs(&self.rad) != Some(Ordering::Greater)
    }

    /// Whether every point of the ball is greater than 0.
    pub fn is_positive(&self) -> bool {
        !self.contains_zero() && self.mid.is_sign_positive()
    }

    /// Whether every point of the ball is less than 0.
    pub fn is_negative(&self) -> bool {
        !self.contains_zero() && self.mid.is_sign_negative()
    }

    /// Whether every point of `other` lies in this ball.
    pub fn contains(&self, other: &Self) -> bool {
        if self.rad.is_infinite() {
            return true;
        }
        let ([low, high], [other_low, other_high]) = (self.exact_ends(), other.exact_ends());
        other.is_finite() && low <= other_low && other_high <= high
    }

    /// Whether the exact rational lies in this ball.
    pub fn contains_rational(&self, value: &BigRational) -> bool {
        if self.rad.is_infinite() {
            return true;
        }
        let value = rug_rational(value);
        let [low, high] = self.exact_ends();
        low <= value && value <= high
    }

    /// Whether the two balls have a point in common.
    pub fn overlaps(&self, other: &Self) -> bool {
        if !self.is_finite() || !other.is_finite() {
            return true;
        }
        let ([low, high], [other_low, other_high]) = (self.exact_ends(), other.exact_ends());
        low <= other_high && other_low <= high
    }

    /// Returns a ball around both, as [`Ball::between`] does.
    pub fn union(&self, other: &Self) -> Self {
        // Not with Float::min and max, which round what they take from the other. Infinite ends have no middle: the whole line.
        let [low, high] = [[self.lower(), other.lower()], [self.upper(), other.upper()]];
        let low = if low[0] <= low[1] { &low[0] } else { &low[1] };
        let high = if high[0] >= high[1] { &high[0] } else { &high[1] };
        Self::between(low, high, self.prec().max(other.prec()))
    }

    /// Adds `error >= 0` to the radius, rounding up; a negative or NaN error gives the whole line.
    pub fn widen(&mut self, error: &Float) {
        if error.is_nan() || *error < 0 {
            *self = Self::whole_line(self.prec());
        } else {
            self.rad.add_assign_round(error, Round::Up);
        }
    }

    /// Returns the ball widened by `error >= 0`, as [`Ball::widen`] does.
    #[must_use]
    pub fn widened(mut self, error: &Float) -> Self {
        self.widen(error);
        self
    }

    /// Bits to which the value is known relative to its size: `-log2(radius/|midpoint|)`, rounded
    /// down; `None` if the ball is exact, negative if nothing is known.
    pub fn relative_bits(&self) -> Option<i64> {
        if self.is_exact() {
            return None;
        }
        match (self.mid.get_exp(), self.rad.get_exp()) {
            (Some(mid), Some(rad)) => Some(i64::from(mid) - i64::from(rad) - 1),
            _ => Some(i64::MIN),
        }
    }

    /// The nearest double to the midpoint.
    pub fn to_f64(&self) -> f64 {
        self.mid.to_f64()
    }

    /// Both ends of a bounded ball as exact rational numbers.
    fn exact_ends(&self) -> [Rational; 2] {
        let exact = |x: &Float| x.to_rational().unwrap_or_default();
        let (mid, rad) = (exact(&self.mid), exact(&self.rad));
        [Rational::from(&mid - &rad), mid + rad]
    }

    pub(crate) fn constant(n: u32) -> Self {
        Self::exact(Float::with_val(CONSTANT_BITS, n))
    }
}

impl fmt::Debug for Ball {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rad = self.rad.to_string_radix_round(10, Some(3), Round::Up);
        write!(f, "{} +/- {rad}", self.mid.to_string_radix(10, Some(20)))
    }
}

/// Half a unit in the last place, which bounds the error of rounding to nearest; 0 if it was exact.
pub(crate) fn rounding_error(mid: &Float, direction: Ordering) -> Float {
    let mut error = Float::new(RADIUS_BITS);
    if direction == Ordering::Equal {
        return error;
    }
    match mid.get_exp() {
        Some(exponent) => {
            let shift = i64::from(exponent) - i64::from(mid.prec()) - 1;
            error.assign(1);
            error <<= i32::try_from(shift).unwrap_or(i32::MIN);
            if error.is_zero() {
                error = smallest_error();
            }
        }
        None => error = smallest_error(),
    }
    error
}

/// A bound of what is lost where MPFR's exponents end, at about `2^(-2^30)`, far below this.
pub(crate) fn smallest_error() -> Float {
    Float::with_val(RADIUS_BITS, f64::MIN_POSITIVE)
}

/// `|x|` with the bits of a radius, rounded up.
pub(crate) fn magnitude_up(x: &Float) -> Float {
    let mut out =
        Float::with_val_round(RADIUS_BITS, x, if x.is_sign_negative() { Round::Down } else { Round::Up }).0;
    out.abs_mut();
    out
}
