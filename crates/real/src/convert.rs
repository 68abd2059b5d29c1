//! Exact conversions between the numbers of num-bigint and those of GMP.

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use rug::{Integer, Rational};

/// Converts num-rational's number to GMP's.
pub fn rug_rational(value: &BigRational) -> Rational {
    Rational::from((rug_integer(value.numer()), rug_integer(value.denom())))
}

/// Converts num-bigint's number to GMP's.
pub fn rug_integer(value: &BigInt) -> Integer {
    let (sign, digits) = value.to_u64_digits();
    let magnitude = Integer::from_digits(&digits, rug::integer::Order::Lsf);
    if sign == Sign::Minus { -magnitude } else { magnitude }
}

/// Converts GMP's number to num-bigint's.
pub fn big_integer(value: &Integer) -> BigInt {
    let digits = value.to_digits::<u32>(rug::integer::Order::Lsf);
    let sign = if value.is_negative() { Sign::Minus } else { Sign::Plus };
    BigInt::from_slice(sign, &digits)
}

/// Converts GMP's fraction, which is reduced, to num-rational's.
pub fn big_rational(value: &Rational) -> BigRational {
    BigRational::new_raw(big_integer(value.numer()), big_integer(value.denom()))
}
