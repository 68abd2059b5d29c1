use crate::{Field, ZeroTest};
use num_rational::BigRational;
use num_traits::Zero;
use restitution_real::{Ball, BallVector};

impl Field for Ball {
    type Factor = BallVector;

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

    fn power(&self, exponent: &BigRational) -> Option<Self> {
        let power = self.pow(exponent);
        power.is_finite().then_some(power)
    }

    /// Every coefficient is scaled at the largest precision among them, constants included.
    fn scale_each(series: &[Self], weights: &dyn Fn(usize) -> (i64, i64)) -> Vec<Self> {
        let prec = series.iter().map(Self::prec).max().unwrap_or(64);
        let scale = |(j, x): (usize, &Self)| {
            let (numerator, denominator) = weights(j);
            x * Self::from_integer(numerator, prec) / Self::from_integer(denominator, 64)
        };
        series.iter().enumerate().map(scale).collect()
    }

    fn factor(series: &[Self], len: usize) -> Self::Factor {
        BallVector::new(series, len)
    }

    fn sum_of_products(terms: &[(i64, &Self::Factor, &Self::Factor)], len: usize) -> Vec<Self> {
        BallVector::sum_of_products(terms, len)
    }
}
