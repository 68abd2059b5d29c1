use super::{Field, OrderedField, ZeroTest};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::cmp::Ordering;

/// The field of rational numbers: exact, and every question has an answer.
///
/// # Examples
///
/// ```
/// use restitution_real::{Field, Rationals};
///
/// let four_ninths = Rationals.ratio(4, 9);
/// assert_eq!(Rationals.power(&four_ninths, &Rationals.ratio(-1, 2)), Some(Rationals.ratio(3, 2)));
/// assert_eq!(Rationals.power(&Rationals.ratio(2, 1), &Rationals.ratio(1, 2)), None); // not rational
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rationals;

impl Field for Rationals {
    type Number = BigRational;

    fn zero(&self) -> BigRational {
        Zero::zero()
    }

    fn one(&self) -> BigRational {
        One::one()
    }

    fn rational(&self, value: &BigRational) -> BigRational {
        value.clone()
    }

    fn add(&self, x: &BigRational, y: &BigRational) -> BigRational {
        x + y
    }

    fn sub(&self, x: &BigRational, y: &BigRational) -> BigRational {
        x - y
    }

    fn mul(&self, x: &BigRational, y: &BigRational) -> BigRational {
        x * y
    }

    fn div(&self, x: &BigRational, y: &BigRational) -> BigRational {
        x / y
    }

    fn neg(&self, x: &BigRational) -> BigRational {
        -x
    }

    /// The exact power, if it is rational: `(p/q)^(m/n)` needs n-th roots of `p` and `q`.
    fn power(&self, x: &BigRational, exponent: &BigRational) -> Option<BigRational> {
        if x.is_one() {
            return Some(x.clone());
        }
        if x.is_zero() {
            return (!exponent.is_negative())
                .then(|| if exponent.is_zero() { One::one() } else { Zero::zero() });
        }
        let degree = exponent.denom().to_u32()?;
        let times = exponent.numer().to_i32()?;
        let root = |n: &BigInt| {
            let root =
                if n.is_negative() && degree.is_multiple_of(2) { return None } else { n.nth_root(degree) };
            (root.pow(degree) == *n).then_some(root)
        };
        Some(BigRational::new(root(x.numer())?, root(x.denom())?).pow(times))
    }

    fn zero_test(&self, x: &BigRational) -> ZeroTest {
        if x.is_zero() { ZeroTest::Zero } else { ZeroTest::NonZero }
    }
}

impl OrderedField for Rationals {
    fn sign(&self, x: &BigRational) -> Option<Ordering> {
        Some(x.cmp(&Zero::zero()))
    }

    fn pivot_rank(&self, x: &BigRational) -> i64 {
        let bits = x.numer().bits() + x.denom().bits();
        i64::try_from(bits).map_or(i64::MIN, |bits| -bits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_exact_or_absent() {
        let ratio = |n, d| Rationals.ratio(n, d);
        let power = |x, exponent| Rationals.power(&x, &exponent);
        assert_eq!(power(ratio(8, 27), ratio(-2, 3)), Some(ratio(9, 4)));
        assert_eq!(power(ratio(-8, 1), ratio(1, 3)), Some(ratio(-2, 1)));
        assert_eq!(power(ratio(2, 1), ratio(1, 2)), None);
        assert_eq!(power(ratio(1, 2), ratio(1, 2)), None);
        assert_eq!(power(ratio(-4, 1), ratio(1, 2)), None);
        assert_eq!(power(ratio(1, 1), ratio(1, 7_000_000_000)), Some(ratio(1, 1)));
        assert_eq!(power(ratio(0, 1), ratio(2, 3)), Some(ratio(0, 1)));
        assert_eq!(power(ratio(0, 1), ratio(0, 1)), Some(ratio(1, 1)));
        assert_eq!(power(ratio(0, 1), ratio(-1, 1)), None);
    }

    #[test]
    fn few_digits_make_the_better_divisor() {
        let rank = |n, d| Rationals.pivot_rank(&Rationals.ratio(n, d));
        assert!(rank(15, 13) > rank(1000, 1));
        assert!(rank(1, 1) > rank(3, 1) && rank(3, 1) > rank(3, 2) && rank(-3, 2) > rank(5, 2));
    }
}
