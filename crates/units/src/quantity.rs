//! Quantities with units: `0.32cm/s`, `5 mm`, `9.1 GPa`; a bare number is SI.

use crate::{Dimension, dimension_of, size};
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};
use restitution_law::exact::{Exact, NumberError};
use std::cmp::Ordering;
use std::fmt;

/// Why a text is not the quantity that was asked for.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum UnitError {
    /// The number in front of the unit cannot be read.
    #[error(transparent)]
    Number(#[from] NumberError),
    /// The unit belongs to no quantity known here.
    #[error("'{unit}' is not a unit of {wanted}: give one of {known}, or a bare number in {si}", known = wanted.examples().join(", "), si = wanted.si())]
    UnknownUnit {
        /// The unit that was given.
        unit: String,
        /// What the value should be.
        wanted: Dimension,
    },
    /// The unit belongs to another quantity.
    #[error("'{text}' is {article} {given}, not {wanted_article} {wanted}: give one of {known}, or a bare number in {si}", article = article(*given), wanted_article = article(*wanted), known = wanted.examples().join(", "), si = wanted.si())]
    WrongDimension {
        /// The text that was given.
        text: String,
        /// What it is.
        given: Dimension,
        /// What the value should be.
        wanted: Dimension,
    },
    /// Some values of a list carry a unit and some do not.
    #[error("'{with}' has a unit and '{without}' has none: give the unit with every value or with none")]
    MixedUnits {
        /// A value with a unit.
        with: String,
        /// A value without.
        without: String,
    },
}

/// A physical quantity as it was typed, with its exact value in SI units.
///
/// # Examples
///
/// ```
/// use restitution_units::{Dimension, Quantity, UnitError};
///
/// let g = Quantity::parse("0.32cm/s", Dimension::Velocity)?;
/// assert_eq!(g.si().to_string(), "2/625");
/// assert_eq!(g.to_string(), "0.32cm/s");
/// assert!(g.sign().is_gt());
/// assert_eq!((g.to_f64(), g.unit_size(), g.unit()), (0.0032, 0.01, Some("cm/s")));
///
/// assert_eq!(Dimension::Velocity.examples()[0], Dimension::Velocity.si());
/// let wrong = Quantity::parse("5mm", Dimension::Velocity);
/// assert!(matches!(wrong, Err(UnitError::WrongDimension { .. })));
/// # Ok::<(), UnitError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quantity {
    text: String,
    unit: Option<String>,
    size: BigRational,
    si: BigRational,
}

impl Quantity {
    /// Reads a number and its unit; a bare number is in SI units.
    ///
    /// # Errors
    ///
    /// [`UnitError::Number`], [`UnitError::UnknownUnit`] or [`UnitError::WrongDimension`].
    pub fn parse(text: &str, wanted: Dimension) -> Result<Self, UnitError> {
        let text = text.trim();
        let (number, symbol) = split(text);
        let unit_size = match symbol {
            "" => BigRational::one(),
            _ => size(symbol, wanted).ok_or_else(|| not_a_unit(text, symbol, wanted))?,
        };
        let number: Exact = number.parse().map_err(|error| match error {
            NumberError::NotANumber { .. } => NumberError::NotANumber { text: text.to_owned() },
            other => other,
        })?;
        let unit = (!symbol.is_empty()).then(|| symbol.to_owned());
        Ok(Self { text: text.to_owned(), unit, si: number.value() * &unit_size, size: unit_size })
    }

    /// The value in SI units.
    pub fn si(&self) -> &BigRational {
        &self.si
    }

    /// How the value compares with 0, however small it is.
    pub fn sign(&self) -> Ordering {
        self.si.cmp(&BigRational::zero())
    }

    /// The f64 nearest to the value in SI units.
    pub fn to_f64(&self) -> f64 {
        self.si.to_f64().unwrap_or(f64::NAN)
    }

    /// The size in SI units of the unit as it was typed; 1 for a bare number.
    pub fn unit_size(&self) -> f64 {
        self.size.to_f64().unwrap_or(f64::NAN)
    }

    /// The unit as it was typed; `None` for a bare number.
    pub fn unit(&self) -> Option<&str> {
        self.unit.as_deref()
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Checks that the values of a list all carry a unit, or none does.
///
/// # Errors
///
/// [`UnitError::MixedUnits`] with one of each.
///
/// # Examples
///
/// ```
/// use restitution_units::{UnitError, all_or_none, velocity};
///
/// assert!(all_or_none(&[velocity("1cm/s")?, velocity("2m/s")?]).is_ok());
/// assert!(matches!(all_or_none(&[velocity("1cm/s")?, velocity("2")?]), Err(UnitError::MixedUnits { .. })));
/// # Ok::<(), UnitError>(())
/// ```
pub fn all_or_none(values: &[Quantity]) -> Result<(), UnitError> {
    let with = values.iter().find(|value| value.unit.is_some());
    let without = values.iter().find(|value| value.unit.is_none());
    match (with, without) {
        (Some(with), Some(without)) => {
            Err(UnitError::MixedUnits { with: with.to_string(), without: without.to_string() })
        }
        _ => Ok(()),
    }
}

/// Defines clap value parsers, one for each dimension.
macro_rules! value_parsers {
    ($($name:ident $dimension:ident),*) => {$(
        #[doc = concat!("Reads a quantity of this kind, ", stringify!($name), "; for clap's `value_parser`.")]
        ///
        /// # Errors
        ///
        /// As [`Quantity::parse`].
        pub fn $name(text: &str) -> Result<Quantity, UnitError> {
            Quantity::parse(text, Dimension::$dimension)
        }
    )*};
}

value_parsers!(velocity Velocity, length Length, time Time, mass Mass, density Density, modulus Modulus, viscosity Viscosity, acceleration Acceleration);

fn article(dimension: Dimension) -> &'static str {
    if dimension == Dimension::Acceleration { "an" } else { "a" }
}

/// Splits a text behind its leading number, which may be a decimal, a fraction or in powers of ten.
fn split(text: &str) -> (&str, &str) {
    let bytes = text.as_bytes();
    let digit = |i: usize| bytes.get(i).is_some_and(u8::is_ascii_digit);
    let sign = |i: usize| matches!(bytes.get(i), Some(b'+' | b'-'));
    let mut end = usize::from(sign(0));
    while let Some(byte) = bytes.get(end) {
        match byte {
            b'0'..=b'9' | b'.' => end += 1,
            b'e' | b'E' if digit(end + 1) || (sign(end + 1) && digit(end + 2)) => end += 2,
            b'/' if digit(end + 1) => end += 1,
            _ => break,
        }
    }
    (text[..end].trim_end(), text[end..].trim_start())
}

fn not_a_unit(text: &str, symbol: &str, wanted: Dimension) -> UnitError {
    match dimension_of(symbol) {
        Some(given) => UnitError::WrongDimension { text: text.to_owned(), given, wanted },
        None if text == symbol => NumberError::NotANumber { text: text.to_owned() }.into(),
        None => UnitError::UnknownUnit { unit: symbol.to_owned(), wanted },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_exact_in_si_units() {
        let read = |text, dimension| Quantity::parse(text, dimension).unwrap().si.to_string();
        assert_eq!(read("0.01m/s", Dimension::Velocity), "1/100");
        assert_eq!(read("1e-3 cm/s", Dimension::Velocity), "1/100000");
        assert_eq!(read("0.5", Dimension::Velocity), "1/2");
        assert_eq!(read("1/3mm", Dimension::Length), "1/3000");
        assert_eq!(read("9.1 GPa", Dimension::Modulus), "9100000000");
        assert_eq!(read("0.9g/cm3", Dimension::Density), "900");
        assert_eq!(read("2Pa s", Dimension::Viscosity), "2");
        assert_eq!(read("18km/h", Dimension::Velocity), "5");
    }

    #[test]
    fn messages_name_the_remedy() {
        let message = |text, dimension| Quantity::parse(text, dimension).unwrap_err().to_string();
        assert_eq!(
            message("5mm", Dimension::Velocity),
            "'5mm' is a length, not a velocity: give one of m/s, km/s, cm/s, mm/s, um/s, km/h, ft/s, or a bare number in m/s"
        );
        assert_eq!(
            message("5 furlong", Dimension::Time),
            "'furlong' is not a unit of time: give one of s, ms, us, ns, min, h, or a bare number in s"
        );
        assert_eq!(
            message("fast", Dimension::Velocity),
            "'fast' is not a number: write it as 0.1, 1e-12 or 1/3"
        );
        assert_eq!(
            message("m/s", Dimension::Velocity),
            "'m/s' is not a number: write it as 0.1, 1e-12 or 1/3"
        );
        let mixed = [velocity("1").unwrap(), velocity("1cm/s").unwrap()];
        assert!(matches!(all_or_none(&mixed), Err(UnitError::MixedUnits { .. })));
        assert_eq!(all_or_none(&mixed[..1]), Ok(()));
    }

    proptest::proptest! {
        #[test]
        fn any_text_is_read_or_refused(text in "[-+]?[0-9.eE/]{0,8}.{0,6}") {
            for dimension in Dimension::ALL {
                let _ = Quantity::parse(&text, dimension);
            }
        }
    }
}
