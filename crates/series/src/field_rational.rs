use crate::{Field, ZeroTest};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use restitution_real::convert::{big_integer, rug_integer};
use restitution_real::kronecker;
use rug::Integer;

/// Rational coefficients over one common denominator.
#[derive(Clone, Debug)]
pub struct CommonDenominator {
    numerators: Vec<Integer>,
    denominator: Integer,
}

impl CommonDenominator {
    fn new(series: &[BigRational]) -> Self {
        let denominators = || series.iter().map(|c| rug_integer(c.denom()));
        let denominator = denominators().fold(Integer::from(1), |common, d| common.lcm(&d));
        let numerator = |c: &BigRational| {
            rug_integer(c.numer()) * Integer::from(denominator.div_exact_ref(&rug_integer(c.denom())))
        };
        Self { numerators: series.iter().map(numerator).collect(), denominator }
    }

    /// The coefficients `weight * c_k`, in lowest terms.
    fn product(weight: i64, a: &Self, b: &Self, len: usize) -> Vec<BigRational> {
        let denominator = Integer::from(&a.denominator * &b.denominator);
        let reduce = |mut numerator: Integer| {
            numerator *= weight;
            let common = Integer::from(numerator.gcd_ref(&denominator));
            let denominator = Integer::from(denominator.div_exact_ref(&common));
            BigRational::new_raw(big_integer(&numerator.div_exact(&common)), big_integer(&denominator))
        };
        kronecker::product(&a.numerators, &b.numerators, len).into_iter().map(reduce).collect()
    }
}

impl Field for BigRational {
    type Factor = CommonDenominator;

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

    /// The exact power, if it is rational: `(p/q)^(m/n)` needs n-th roots of `p^m` and `q^m`.
    fn power(&self, exponent: &BigRational) -> Option<Self> {
        if self.is_one() {
            return Some(self.clone());
        }
        if self.is_zero() {
            return (exponent.is_positive()).then(Self::zero);
        }
        let degree = exponent.denom().to_u32()?;
        let times = exponent.numer().to_i32()?;
        let root = |n: &BigInt| {
            let root = if n.is_negative() && degree % 2 == 0 { return None } else { n.nth_root(degree) };
            (root.pow(degree) == *n).then_some(root)
        };
        Some(Self::new(root(self.numer())?, root(self.denom())?).pow(times))
    }

    fn factor(series: &[Self], len: usize) -> Self::Factor {
        CommonDenominator::new(&series[..series.len().min(len)])
    }

    fn sum_of_products(terms: &[(i64, &Self::Factor, &Self::Factor)], len: usize) -> Vec<Self> {
        let mut products = terms.iter().map(|(weight, a, b)| CommonDenominator::product(*weight, a, b, len));
        let first = products.next().unwrap_or_else(|| vec![Self::zero(); len]);
        let add = |sum: Vec<Self>, next: Vec<Self>| sum.into_iter().zip(next).map(|(x, y)| x + y).collect();
        products.fold(first, add)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_exact_or_absent() {
        let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
        assert_eq!(ratio(8, 27).power(&ratio(-2, 3)), Some(ratio(9, 4)));
        assert_eq!(ratio(2, 1).power(&ratio(1, 2)), None);
        assert_eq!(ratio(-8, 1).power(&ratio(1, 3)), Some(ratio(-2, 1)));
        assert_eq!(ratio(-4, 1).power(&ratio(1, 2)), None);
    }
}
