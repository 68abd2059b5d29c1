//! Exact conversions between the numbers of num-bigint and those of GMP, and to decimals.

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
    // Whole words are copied; halves would be shifted out one byte at a time.
    let words = value.to_digits::<u64>(rug::integer::Order::Lsf);
    let digits: Vec<u32> = words.into_iter().flat_map(|word| [word as u32, (word >> 32) as u32]).collect();
    let sign = if value.is_negative() { Sign::Minus } else { Sign::Plus };
    BigInt::from_slice(sign, &digits)
}

/// Converts GMP's fraction, which is reduced, to num-rational's.
pub fn big_rational(value: &Rational) -> BigRational {
    BigRational::new_raw(big_integer(value.numer()), big_integer(value.denom()))
}

/// Returns the fraction as num-rational prints it, `p/q` or `p`, in time that grows little faster than its length.
///
/// num-bigint takes time that grows with the square.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_real::convert::fraction;
///
/// let value = BigRational::new((-6).into(), 4.into());
/// assert_eq!(fraction(&value), "-3/2");
/// assert_eq!(fraction(&BigRational::from_integer(7.into())), "7");
/// ```
pub fn fraction(value: &BigRational) -> String {
    let numerator = rug_integer(value.numer()).to_string();
    if value.is_integer() { numerator } else { format!("{numerator}/{}", rug_integer(value.denom())) }
}
