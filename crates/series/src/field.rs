use num_rational::BigRational;
use num_traits::{One, Zero};
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
/// One pipeline serves exact and certified numbers: `BigRational` is exact, `Ball` encloses.
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
    /// A series prepared for products: transformed, packed, or just copied.
    type Factor: Clone;

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

    /// Returns `self^exponent`, or `None` where the field has no such number.
    fn power(&self, exponent: &BigRational) -> Option<Self>;

    /// Prepares the first `len` coefficients of a series for products.
    fn factor(series: &[Self], len: usize) -> Self::Factor;

    /// Returns the first `len` coefficients of a weighted sum of products of power series.
    ///
    /// ```text
    /// c_k = sum_t weight_t sum_(i+j=k) a_(t,i) b_(t,j),   k < len
    /// ```
    ///
    /// This is where nearly all time goes, hence the one operation that each number type does its own
    /// way, all of them quasi-linear in `len`. The weights are small integers.
    fn sum_of_products(terms: &[(i64, &Self::Factor, &Self::Factor)], len: usize) -> Vec<Self>;

    /// Returns the first `len` coefficients of the product of two power series.
    fn product(a: &[Self], b: &[Self], len: usize) -> Vec<Self> {
        Self::sum_of_products(&[(1, &Self::factor(a, len), &Self::factor(b, len))], len)
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
