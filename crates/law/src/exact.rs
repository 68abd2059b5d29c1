//! Numbers as they were typed: exact rationals.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};
use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

/// The longest number that is read, in characters.
const LONGEST: usize = 10_000;
/// The largest power of ten that is written out.
const LARGEST_EXPONENT: u64 = 10_000;

/// Why a text is not an exact number.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NumberError {
    /// The text is not a decimal number or a fraction.
    #[error("'{text}' is not a number: write it as 0.1, 1e-12 or 1/3")]
    NotANumber {
        /// The text that was given.
        text: String,
    },
    /// The number has more digits or a larger exponent than anyone needs.
    #[error("a number has more than {LONGEST} digits: give it with fewer")]
    TooLong,
    /// A number that must not be negative is.
    #[error("'{text}' is negative: give a number of at least 0")]
    Negative {
        /// The text that was given.
        text: String,
    },
}

/// A number as it was typed, exact: `0.1` is one tenth.
///
/// # Examples
///
/// ```
/// use restitution_law::exact::{Exact, NumberError};
///
/// let tenth: Exact = "0.1".parse()?;
/// assert_eq!(tenth.value().to_string(), "1/10");
/// assert_eq!(tenth.to_string(), "0.1");
/// assert_eq!("-2.5e-3".parse::<Exact>()?.value().to_string(), "-1/400");
/// assert!(tenth > 0 && tenth < 1);
///
/// assert!(matches!("0,1".parse::<Exact>(), Err(NumberError::NotANumber { .. })));
/// # Ok::<(), NumberError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exact {
    text: String,
    value: BigRational,
}

impl Exact {
    /// The number.
    pub fn value(&self) -> &BigRational {
        &self.value
    }

    /// The f64 nearest to it.
    pub fn to_f64(&self) -> f64 {
        self.value.to_f64().unwrap_or(f64::NAN)
    }
}

impl PartialEq<i64> for Exact {
    fn eq(&self, whole: &i64) -> bool {
        self.partial_cmp(whole) == Some(Ordering::Equal)
    }
}

impl PartialOrd<i64> for Exact {
    fn partial_cmp(&self, whole: &i64) -> Option<Ordering> {
        self.value.partial_cmp(&BigRational::from_integer((*whole).into()))
    }
}

impl fmt::Display for Exact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl FromStr for Exact {
    type Err = NumberError;

    fn from_str(text: &str) -> Result<Self, NumberError> {
        let text = text.trim();
        if text.len() > LONGEST {
            return Err(NumberError::TooLong);
        }
        let value = match text.split_once('/') {
            Some((numerator, denominator)) => {
                let denominator = decimal(denominator)?;
                decimal(numerator)?.zip(denominator.filter(|d| !d.is_zero())).map(|(n, d)| n / d)
            }
            None => decimal(text)?,
        };
        let value = value.ok_or_else(|| NumberError::NotANumber { text: text.to_owned() })?;
        Ok(Self { text: text.to_owned(), value })
    }
}

/// Reads a number that is at least 0; for clap's `value_parser`.
///
/// # Errors
///
/// A [`NumberError`] for what is not a number or negative.
pub fn at_least_zero(text: &str) -> Result<Exact, NumberError> {
    let number: Exact = text.parse()?;
    if number.value.is_negative() {
        return Err(NumberError::Negative { text: number.text });
    }
    Ok(number)
}

/// Reads `-12.5e-3` exactly; `None` if the text is not such a decimal.
fn decimal(text: &str) -> Result<Option<BigRational>, NumberError> {
    let text = text.trim();
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = |s: &str| s.bytes().all(|b| b.is_ascii_digit());
    let unsigned = whole.strip_prefix(['+', '-']).unwrap_or(whole);
    let number_of_digits = unsigned.len() + fraction.len();
    let exponent_digits = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
    if number_of_digits == 0 || !digits(unsigned) || !digits(fraction) {
        return Ok(None);
    }
    if exponent_digits.is_empty() || !digits(exponent_digits) {
        return Ok(None);
    }
    let exponent = exponent.parse::<i64>().ok().filter(|e| e.unsigned_abs() <= LARGEST_EXPONENT);
    let exponent = exponent.ok_or(NumberError::TooLong)? - i64::try_from(fraction.len()).unwrap_or(i64::MAX);
    let Ok(mantissa) = format!("{whole}{fraction}").parse::<BigInt>() else { return Ok(None) };
    let power =
        BigInt::from(10).pow(u32::try_from(exponent.unsigned_abs()).map_err(|_| NumberError::TooLong)?);
    Ok(Some(if exponent < 0 { BigRational::new(mantissa, power) } else { (mantissa * power).into() }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_and_fractions_are_exact() {
        let read = |text: &str| text.parse::<Exact>().map(|x| x.value.to_string());
        for (text, value) in [
            ("0.32", "8/25"),
            ("-.5", "-1/2"),
            ("5.", "5"),
            ("1e3", "1000"),
            ("1E-2", "1/100"),
            ("+2/6", "1/3"),
            ("0.1/0.3", "1/3"),
        ] {
            assert_eq!(read(text).as_deref(), Ok(value), "{text}");
        }
    }

    #[test]
    fn nonsense_is_refused() {
        for text in [
            "", ".", "-", "e5", "1e", "1e+", "1/0", "1/", "/2", "1/2/3", "0x10", "nan", "inf", "1 2", "٣",
            "--1", "+-1", "1_000",
        ] {
            assert!(matches!(text.parse::<Exact>(), Err(NumberError::NotANumber { .. })), "{text}");
        }
        assert_eq!("1e999999999999".parse::<Exact>(), Err(NumberError::TooLong));
        assert_eq!("9".repeat(20_000).parse::<Exact>(), Err(NumberError::TooLong));
        assert!(matches!(at_least_zero("-1"), Err(NumberError::Negative { .. })));
    }
}
