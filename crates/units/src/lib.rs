//! Quantities with units as people spell them, exactly in SI units: `0.32cm/s`, `5 mm`, `9.1 GPa`.
//!
//! `m/s`, `m s-1`, `m·s⁻¹` and `m s^-1` are one unit, `ft/min` and `in/s` are made of their parts; what is not a unit,
//! or one of another kind, is refused.

mod dimension;
mod quantity;
mod spelling;
mod symbols;

pub use dimension::Dimension;
pub use quantity::{
    Quantity, UnitError, acceleration, all_or_none, density, length, mass, modulus, time, velocity, viscosity,
};

use num_rational::BigRational;

/// A unit: its size in SI units, exactly, and the powers of metre, kilogram and second in it.
struct Unit {
    size: BigRational,
    powers: [i32; 3],
}

/// Returns the size of a unit of the wanted dimension, in SI units; `None` for anything else.
///
/// # Examples
///
/// ```
/// use restitution_units::{Dimension, size};
///
/// for spelling in ["cm/s", "cm s-1", "cm s^-1", "cm·s⁻¹", "cm / sec", "cm per second"] {
///     assert_eq!(size(spelling, Dimension::Velocity).unwrap().to_string(), "1/100", "{spelling}");
/// }
/// assert_eq!(size("ft/min", Dimension::Velocity).unwrap().to_string(), "127/25000");
///
/// assert_eq!(size("cm", Dimension::Velocity), None);
/// assert_eq!(size("ms-1", Dimension::Velocity), None); // one over a millisecond
/// ```
pub fn size(symbol: &str, wanted: Dimension) -> Option<BigRational> {
    spelling::read(symbol).filter(|unit| unit.powers == wanted.powers()).map(|unit| unit.size)
}

/// Returns the dimension of a unit; `None` for what is no unit or one of no dimension known here.
///
/// # Examples
///
/// ```
/// use restitution_units::{Dimension, dimension_of};
///
/// assert_eq!(dimension_of("g cm-3"), Some(Dimension::Density));
/// assert_eq!(dimension_of("furlong"), None);
/// ```
pub fn dimension_of(symbol: &str) -> Option<Dimension> {
    let unit = spelling::read(symbol)?;
    Dimension::ALL.into_iter().find(|dimension| dimension.powers() == unit.powers)
}

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
