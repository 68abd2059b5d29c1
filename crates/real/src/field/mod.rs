//! Number fields as values: what makes numbers, and what is known about them.

mod balls;
mod rationals;

pub use balls::Balls;
pub use rationals::Rationals;

use num_rational::BigRational;
use std::cmp::Ordering;
use std::fmt::Debug;

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

/// A field of numbers, as a value that carries what its numbers need: a precision, a prime, nothing.
///
/// Code that is generic over fields takes the field beside the numbers and asks it for every
/// constant and every operation, so no number has to guess a precision from its neighbours:
///
/// ```
/// use restitution_real::{Ball, Balls, Field, Rationals, ZeroTest};
///
/// fn sum_of_squares<F: Field>(field: &F, numbers: &[F::Number]) -> F::Number {
///     numbers.iter().fold(field.zero(), |sum, x| field.add(&sum, &field.mul(x, x)))
/// }
///
/// let exact = [Rationals.ratio(1, 3), Rationals.ratio(2, 3)];
/// assert_eq!(sum_of_squares(&Rationals, &exact).to_string(), "5/9");
///
/// let field = Balls::new(100);
/// let enclosed = sum_of_squares(&field, &[field.ratio(1, 3), field.ratio(2, 3)]);
/// assert!(enclosed.contains_rational(&Rationals.ratio(5, 9)) && enclosed.prec() == 100);
///
/// // The sum minus 5/9 is zero; a ball can only say that it may be.
/// let rest = field.sub(&enclosed, &field.ratio(5, 9));
/// assert_eq!(field.zero_test(&rest), ZeroTest::Undecided);
/// ```
///
/// # Panics
///
/// A field that has no number for a quotient by zero panics in [`Field::div`]: ask
/// [`Field::zero_test`] first. Enclosures do not: they answer with the whole line.
pub trait Field: Clone + Debug {
    /// The numbers of the field.
    type Number: Clone + Debug;

    /// The number 0, exactly.
    fn zero(&self) -> Self::Number;

    /// The number 1, exactly.
    fn one(&self) -> Self::Number;

    /// Returns a rational number.
    fn rational(&self, value: &BigRational) -> Self::Number;

    /// Returns the fraction `numerator/denominator` (`denominator != 0`).
    fn ratio(&self, numerator: i64, denominator: i64) -> Self::Number {
        self.rational(&BigRational::new(numerator.into(), denominator.into()))
    }

    /// Returns `x + y`.
    fn add(&self, x: &Self::Number, y: &Self::Number) -> Self::Number;

    /// Returns `x - y`.
    fn sub(&self, x: &Self::Number, y: &Self::Number) -> Self::Number;

    /// Returns `x y`.
    fn mul(&self, x: &Self::Number, y: &Self::Number) -> Self::Number;

    /// Returns `x/y` for `y` that is not zero.
    fn div(&self, x: &Self::Number, y: &Self::Number) -> Self::Number;

    /// Returns `-x`.
    fn neg(&self, x: &Self::Number) -> Self::Number;

    /// Returns `x^exponent`, or `None` where the field has no such number.
    fn power(&self, x: &Self::Number, exponent: &BigRational) -> Option<Self::Number>;

    /// Tells whether the number is zero.
    fn zero_test(&self, x: &Self::Number) -> ZeroTest;
}

/// A field whose numbers have a sign, as far as their type can tell.
pub trait OrderedField: Field {
    /// Compares the number with zero; `None` if its enclosure leaves that open.
    fn sign(&self, x: &Self::Number) -> Option<Ordering>;

    /// How good a divisor the (nonzero) number is: larger is better.
    ///
    /// Balls prefer large magnitude, which keeps radii small; rationals prefer few digits.
    fn pivot_rank(&self, x: &Self::Number) -> i64;
}
