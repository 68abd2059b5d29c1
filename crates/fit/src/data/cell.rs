//! The value of one cell, in the unit of its column.

use super::role::Role;
use super::{DataError, DataOptions};
use crate::sheet::{Column, Decimal, is_missing, parse, split};
use num_traits::ToPrimitive;
use restitution_units::{dimension_of, size};

/// A column in use: what it holds, where it is and in which unit.
pub(super) struct Source {
    pub(super) role: Role,
    pub(super) place: usize,
    /// The unit as it was spelled.
    pub(super) unit: String,
    /// Its size in SI units; of a percentage 1/100.
    pub(super) size: f64,
    /// Whether somebody said so.
    pub(super) stated: bool,
}

impl Source {
    /// The unit is the one beside the name, the one that was asked for, or that of the first cell with one.
    pub(super) fn of(
        role: Role,
        place: usize,
        head: &Column,
        first_cell_unit: Option<&str>,
        options: &DataOptions,
    ) -> Result<Self, String> {
        let asked = options
            .velocity_unit
            .as_deref()
            .filter(|_| role.dimension() == Some(restitution_units::Dimension::Velocity));
        let head_unit = head.unit.as_deref().filter(|unit| !unit.is_empty());
        let unit = match (head_unit, asked) {
            (Some(header), Some(asked)) if !same(header, asked) => {
                return Err(format!(
                    "the header says {header} and --velocity-unit says {asked}: give one of them"
                ));
            }
            (Some(unit), _) | (None, Some(unit)) => Some(unit),
            (None, None) => first_cell_unit,
        };
        let si = role.dimension().map_or("", |dimension| dimension.si());
        let text = unit.unwrap_or(si);
        let scale = scale(role, text)?;
        Ok(Self { role, place, unit: text.to_owned(), size: scale, stated: unit.is_some() })
    }

    /// The value of a cell, in the unit of the column; `None` if it is missing.
    pub(super) fn value(&self, cell: &str, decimal: Decimal, line: usize) -> Result<Option<f64>, DataError> {
        if is_missing(cell) {
            return Ok(None);
        }
        let (number, unit) = split(cell);
        let value = parse(number, decimal);
        let noun = self.role.noun();
        let fault = |reason: String| Err(DataError::Row { line, reason });
        match value {
            Some(value) if unit.is_empty() || same(unit, &self.unit) => Ok(Some(value)),
            Some(value) if unit == "%" && self.role.dimension().is_none() && self.size == 1.0 => {
                Ok(Some(value / 100.0))
            }
            Some(_) if unit.starts_with(['±', '(']) || unit.starts_with("+/-") || unit.starts_with("+-") => {
                fault(format!(
                    "the {noun} '{cell}' has its uncertainty beside it: give that a column of its own, such as sigma"
                ))
            }
            Some(_) if self.role.dimension().is_none() => {
                fault(format!("the {noun} '{cell}' has a unit: give a plain number"))
            }
            Some(_) if dimension_of(unit).is_some() => fault(format!(
                "the {noun} '{cell}' is in another unit than its column ({}): give all in one unit",
                self.unit
            )),
            _ => fault(format!("the {noun} '{cell}' is not a number: write it as 0.1 or 1e-3")),
        }
    }
}

/// The size of a unit of what a column holds.
fn scale(role: Role, unit: &str) -> Result<f64, String> {
    let Some(dimension) = role.dimension() else {
        return match unit {
            "" | "1" | "-" => Ok(1.0),
            "%" => Ok(0.01),
            _ => Err(format!("the {} are in '{unit}': give them as plain numbers or in %", plural(role))),
        };
    };
    let examples = dimension.examples().join(", ");
    match (size(unit, dimension), dimension_of(unit)) {
        (Some(size), _) => Ok(size.to_f64().unwrap_or(f64::NAN)),
        (None, Some(other)) => {
            Err(format!("'{unit}' is a unit of {other}, not of {dimension}: give one of {examples}"))
        }
        (None, None) => Err(format!("'{unit}' is not a unit of {dimension}: give one of {examples}")),
    }
}

fn plural(role: Role) -> &'static str {
    if role == Role::Sigma { "standard deviations" } else { "coefficients" }
}

fn same(one: &str, other: &str) -> bool {
    let sizes = |text| dimension_of(text).and_then(|dimension| Some((dimension, size(text, dimension)?)));
    one == other || sizes(one).is_some_and(|one| Some(one) == sizes(other))
}
