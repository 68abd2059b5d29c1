use super::{Field, OrderedField, ZeroTest};
use crate::{Ball, arithmetic};
use num_rational::BigRational;
use num_traits::Zero;
use std::cmp::Ordering;

/// The field of real numbers enclosed in balls of a given precision.
///
/// Every result contains the exact one and is rounded to the precision of the field, whatever the
/// operands had.
///
/// # Examples
///
/// ```
/// use restitution_real::{Balls, Field, OrderedField};
/// use std::cmp::Ordering;
///
/// let field = Balls::new(80);
/// let third = field.ratio(1, 3);
/// assert_eq!(field.sign(&third), Some(Ordering::Greater));
/// assert_eq!(field.sign(&field.sub(&third, &third)), None); // an enclosure of 0 has no sign
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Balls {
    prec: u32,
}

impl Balls {
    /// Returns the field with `prec` bits of working precision, at least 2.
    pub const fn new(prec: u32) -> Self {
        Self { prec: if prec < 2 { 2 } else { prec } }
    }

    /// The working precision in bits.
    pub fn prec(self) -> u32 {
        self.prec
    }
}

impl Field for Balls {
    type Number = Ball;

    fn zero(&self) -> Ball {
        Ball::from_integer(0, self.prec)
    }

    fn one(&self) -> Ball {
        Ball::from_integer(1, self.prec)
    }

    fn rational(&self, value: &BigRational) -> Ball {
        Ball::from_rational(value, self.prec)
    }

    fn ratio(&self, numerator: i64, denominator: i64) -> Ball {
        Ball::from_ratio(numerator, denominator, self.prec)
    }

    fn add(&self, x: &Ball, y: &Ball) -> Ball {
        arithmetic::add(x, y, self.prec)
    }

    fn sub(&self, x: &Ball, y: &Ball) -> Ball {
        arithmetic::sub(x, y, self.prec)
    }

    fn mul(&self, x: &Ball, y: &Ball) -> Ball {
        arithmetic::mul(x, y, self.prec)
    }

    fn div(&self, x: &Ball, y: &Ball) -> Ball {
        arithmetic::div(x, y, self.prec)
    }

    fn neg(&self, x: &Ball) -> Ball {
        -x.with_prec(self.prec)
    }

    fn power(&self, x: &Ball, exponent: &BigRational) -> Option<Ball> {
        let power = x.with_prec(self.prec).pow(exponent);
        power.is_finite().then_some(power)
    }

    fn zero_test(&self, x: &Ball) -> ZeroTest {
        match (x.is_zero(), x.contains_zero()) {
            (true, _) => ZeroTest::Zero,
            (false, true) => ZeroTest::Undecided,
            (false, false) => ZeroTest::NonZero,
        }
    }
}

impl OrderedField for Balls {
    fn sign(&self, x: &Ball) -> Option<Ordering> {
        match self.zero_test(x) {
            ZeroTest::Zero => Some(Ordering::Equal),
            ZeroTest::NonZero if x.is_positive() => Some(Ordering::Greater),
            ZeroTest::NonZero => Some(Ordering::Less),
            ZeroTest::Undecided => None,
        }
    }

    fn pivot_rank(&self, x: &Ball) -> i64 {
        x.abs_down().get_exp().map_or(i64::MIN, i64::from)
    }
}
