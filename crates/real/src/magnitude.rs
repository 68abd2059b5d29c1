use crate::Ball;
use rug::Float;
use rug::float::Round;
use std::ops::{Add, Mul};

/// An upper bound of a nonnegative number, cheap enough to be used by the million.
///
/// Sums and products of upper bounds are upper bounds again: each is rounded to nearest in double
/// precision and then moved to the next double above, which is at least the exact result. Infinity
/// means that no bound is known; a bound of zero is exact, and zero times anything is zero.
///
/// # Examples
///
/// ```
/// use restitution_real::{Ball, Magnitude};
///
/// let third = Magnitude::of(&Ball::from_ratio(-1, 3, 64));
/// assert!(third.to_float() > 0.3333333333333333 && third.to_float() < 0.333333334);
///
/// let powers = Magnitude::exact(0.5).powers(3);
/// assert!(powers[0].to_f64() == 1.0 && powers[2].to_f64() >= 0.25);
///
/// let unknown = Magnitude::of(&Ball::whole_line(64));
/// assert!(!(third + unknown).is_finite());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Magnitude(f64);

impl Magnitude {
    /// The exact bound of the number 0.
    pub const ZERO: Self = Self(0.0);
    /// The exact bound of the number 1.
    pub const ONE: Self = Self(1.0);

    /// Returns an upper bound of `|x|` over the ball.
    pub fn of(ball: &Ball) -> Self {
        Self(ball.abs_up().to_f64_round(Round::Up))
    }

    /// Returns the double as an exact bound of itself; no bound if it is negative or NaN.
    pub fn exact(value: f64) -> Self {
        if value >= 0.0 { Self(value) } else { Self(f64::INFINITY) }
    }

    /// Whether a bound is known.
    pub fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    /// The bound as a double.
    pub fn to_f64(self) -> f64 {
        self.0
    }

    /// The bound as an MPFR number.
    pub fn to_float(self) -> Float {
        Float::with_val(53, self.0)
    }

    /// Returns bounds of `x^0, x^1, ..., x^(len-1)`.
    pub fn powers(self, len: usize) -> Vec<Self> {
        std::iter::successors(Some(Self::ONE), |power| Some(*power * self)).take(len).collect()
    }
}

impl Add for Magnitude {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self.0 == 0.0 {
            return other;
        }
        if other.0 == 0.0 { self } else { Self((self.0 + other.0).next_up()) }
    }
}

impl Mul for Magnitude {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if self.0 == 0.0 || other.0 == 0.0 { Self::ZERO } else { Self((self.0 * other.0).next_up()) }
    }
}

impl std::iter::Sum for Magnitude {
    fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
        iter.fold(Self::ZERO, Add::add)
    }
}
