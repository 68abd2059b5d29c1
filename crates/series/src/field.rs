use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use restitution_real::Ball;
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Whether a number is zero, as far as its type can tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ZeroTest {
    /// It is exactly zero.
    Zero,
    /// It is certainly not zero.
    NonZero,
    /// Its enclosure contains zero and other numbers: more precision may decide.
    Undecided,
}

/// The numbers a series can have as coefficients: a field that contains the rationals.
///
/// One pipeline serves exact and certified numbers: [`BigRational`] is exact, [`Ball`] encloses.
/// The constants `zero()` and `one()` know no precision; they take it from what they meet, and
/// [`Field::ratio`] makes every other constant with the precision of a number at hand.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use num_traits::One;
/// use restitution_series::{Field, ZeroTest};
///
/// let one = BigRational::one();
/// assert_eq!(one.ratio(-6, 4).to_string(), "-3/2");
/// assert_eq!((one.clone() - &one).zero_test(), ZeroTest::Zero);
/// ```
pub trait Field:
    Clone
    + Debug
    + Zero
    + One
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + for<'r> Add<&'r Self, Output = Self>
    + for<'r> Sub<&'r Self, Output = Self>
    + for<'r> Mul<&'r Self, Output = Self>
    + for<'r> Div<&'r Self, Output = Self>
{
    /// Returns the rational number `value` with the precision of `self`.
    fn rational(&self, value: &BigRational) -> Self;

    /// Returns the fraction `numerator/denominator` (`denominator != 0`) with the precision of `self`.
    fn ratio(&self, numerator: i64, denominator: i64) -> Self {
        self.rational(&BigRational::new(numerator.into(), denominator.into()))
    }

    /// Returns `self * numerator/denominator` for `denominator != 0`.
    fn scaled(&self, numerator: i64, denominator: i64) -> Self {
        self.ratio(numerator, denominator) * self
    }

    /// Tells whether the number is zero.
    fn zero_test(&self) -> ZeroTest;

    /// Returns `self * other` without taking either.
    fn times(&self, other: &Self) -> Self {
        self.clone() * other
    }

    /// Returns the first `len` coefficients of the product of two power series.
    ///
    /// ```text
    /// c_k = sum_(i+j=k) a_i b_j,   k < len
    /// ```
    ///
    /// This is where nearly all time goes, hence the one operation each number type may do its own
    /// way; the default takes `len^2/2` multiplications.
    fn product(a: &[Self], b: &[Self], len: usize) -> Vec<Self> {
        Self::sum_of_products(&[(a, b)], len)
    }

    /// Returns the first `len` coefficients of a sum of products of power series.
    fn sum_of_products(terms: &[(&[Self], &[Self])], len: usize) -> Vec<Self> {
        let mut out = vec![Self::zero(); len];
        for (a, b) in terms {
            for (i, x) in a.iter().enumerate().take(len) {
                for (y, c) in b.iter().zip(&mut out[i..]) {
                    *c = std::mem::replace(c, Self::zero()) + x.times(y);
                }
            }
        }
        out
    }

    /// Multiplies coefficient `j` by the fraction `weights(j) = (numerator, denominator)`.
    fn scale_each(series: &[Self], weights: &dyn Fn(usize) -> (i64, i64)) -> Vec<Self> {
        let scale = |(j, x): (usize, &Self)| {
            let (numerator, denominator) = weights(j);
            x.scaled(numerator, denominator)
        };
        series.iter().enumerate().map(scale).collect()
    }
}

impl Field for BigRational {
    fn rational(&self, value: &BigRational) -> Self {
        value.clone()
    }

    fn scaled(&self, numerator: i64, denominator: i64) -> Self {
        self * Self::new(BigInt::from(numerator), BigInt::from(denominator))
    }

    fn zero_test(&self) -> ZeroTest {
        if self.is_zero() { ZeroTest::Zero } else { ZeroTest::NonZero }
    }

    fn times(&self, other: &Self) -> Self {
        self * other
    }
}

impl Field for Ball {
    fn rational(&self, value: &BigRational) -> Self {
        Self::from_rational(value, self.prec())
    }

    fn ratio(&self, numerator: i64, denominator: i64) -> Self {
        Self::from_ratio(numerator, denominator, self.prec())
    }

    fn scaled(&self, numerator: i64, denominator: i64) -> Self {
        self * Self::from_integer(numerator, 64) / Self::from_integer(denominator, 64)
    }

    fn zero_test(&self) -> ZeroTest {
        match (self.is_zero(), self.contains_zero()) {
            (true, _) => ZeroTest::Zero,
            (false, true) => ZeroTest::Undecided,
            (false, false) => ZeroTest::NonZero,
        }
    }

    fn times(&self, other: &Self) -> Self {
        self * other
    }
}
