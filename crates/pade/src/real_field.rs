use num_rational::BigRational;
use num_traits::{Signed, Zero};
use restitution_real::Ball;
use restitution_series::{Field, ZeroTest};
use std::cmp::Ordering;

/// A field whose numbers have a sign, as far as their type can tell.
pub trait RealField: Field {
    /// Compares the number with zero; `None` if its enclosure leaves that open.
    fn sign(&self) -> Option<Ordering>;

    /// How good a divisor the (nonzero) number is: larger is better.
    ///
    /// Balls prefer large magnitude, which keeps radii small; rationals prefer few digits.
    fn pivot_rank(&self) -> i64;
}

impl RealField for BigRational {
    fn sign(&self) -> Option<Ordering> {
        Some(self.cmp(&Self::zero()))
    }

    fn pivot_rank(&self) -> i64 {
        let bits = self.numer().abs().bits() + self.denom().bits();
        i64::try_from(bits).map_or(i64::MIN, |bits| -bits)
    }
}

impl RealField for Ball {
    fn sign(&self) -> Option<Ordering> {
        match self.zero_test() {
            ZeroTest::Zero => Some(Ordering::Equal),
            ZeroTest::NonZero if self.is_positive() => Some(Ordering::Greater),
            ZeroTest::NonZero => Some(Ordering::Less),
            ZeroTest::Undecided => None,
        }
    }

    fn pivot_rank(&self) -> i64 {
        self.abs_down().get_exp().map_or(i64::MIN, i64::from)
    }
}
