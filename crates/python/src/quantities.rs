//! Quantities with units, as the command reads them.

use crate::errors::value;
use pyo3::prelude::*;
use restitution_units::{Dimension, Quantity};

/// The number of SI units in a text such as `0.32cm/s`.
#[pyfunction]
pub fn quantity(text: &str, dimension: &str) -> PyResult<f64> {
    let wanted = Dimension::ALL.into_iter().find(|known| known.to_string() == dimension);
    let wanted = wanted.ok_or_else(|| value(format!("'{dimension}' is no dimension known here")))?;
    Ok(Quantity::parse(text, wanted).map_err(value)?.to_f64())
}
