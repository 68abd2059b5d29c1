//! `restitution fit`: the characteristic velocity from a table of measurements.

mod data;

use super::material::ten_digits;
use crate::args::{EndArgs, EndOfContact};
use crate::units::{Dimension, Quantity};
use crate::{Cell, CliError, OutputArgs, Table};
use data::Data;
use restitution::{End, Fit, Loss, fit};
use std::path::PathBuf;

/// Arguments of `restitution fit`.
#[derive(Debug, clap::Args)]
pub struct FitArgs {
    /// A CSV file with a header line and columns g and epsilon, such as g[cm/s],epsilon; - is stdin
    #[arg(value_name = "DATA")]
    data: PathBuf,
    /// Unit of the velocities, if the header names none [default: m/s]
    #[arg(long, value_name = "UNIT", value_parser = velocity_unit)]
    velocity_unit: Option<String>,
    /// How residuals count
    #[arg(long, value_enum, default_value_t, value_name = "LOSS")]
    loss: LossArg,
    /// What to print
    #[arg(long, value_enum, default_value_t, value_name = "TABLE")]
    table: Show,
    #[command(flatten)]
    end: EndArgs,
    #[command(flatten)]
    output: OutputArgs,
}

/// How residuals count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
enum LossArg {
    /// Least squares.
    #[default]
    Squares,
    /// Huber's loss, robust against outliers.
    Huber,
}

/// What is printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
enum Show {
    /// The characteristic velocity and its error.
    #[default]
    Fit,
    /// Every row with its fitted value.
    Residuals,
}

impl FitArgs {
    /// Fits and prints.
    ///
    /// # Errors
    ///
    /// Usage for a file that cannot be read as measurements, with the number of the line; failure for measurements
    /// that do not determine `g*`.
    pub fn run(&self) -> Result<(), CliError> {
        self.output.check()?;
        let data = Data::read(&self.data, self.velocity_unit.as_deref())?;
        let end = match self.end.end {
            EndOfContact::ZeroCompression => End::ZeroCompression,
            EndOfContact::ZeroForce => End::ZeroForce,
        };
        let loss = match self.loss {
            LossArg::Squares => Loss::Squares,
            LossArg::Huber => Loss::Huber,
        };
        let result = fit(&data.rows, end, loss).map_err(CliError::failure)?;
        self.output.print(&match self.table {
            Show::Fit => summary(&data, &result),
            Show::Residuals => residuals(&data, &result, end),
        })
    }
}

fn summary(data: &Data, fit: &Fit) -> Table {
    let mut table = Table::new(&["quantity", "symbol", "value", "unit"]);
    let mut add = |quantity: &str, symbol: &str, value: Cell, unit: &str| {
        table.push(vec![quantity.into(), symbol.into(), value, unit.into()]);
    };
    let (low, high) = fit.interval();
    let significant = |value| statistic(value, fit.log_error);
    add("characteristic velocity", "g*", significant(fit.characteristic_velocity), &data.unit);
    add("lower end, one standard error", "g*/f", significant(low), &data.unit);
    add("upper end, one standard error", "g* f", significant(high), &data.unit);
    add("standard error of ln g*", "ln f", rounded(fit.log_error, 3), "");
    add("scatter of epsilon", "s", rounded(fit.scatter, 3), "");
    add("largest residual of epsilon", "r", rounded(fit.largest_residual, 3), "");
    add("line of the largest residual", "", data.lines[fit.largest_residual_row].into(), "");
    add("rows", "n", fit.rows.into(), "");
    add("rows that count less", "", fit.outliers.into(), "");
    add("changes of sign of the residuals", "", fit.sign_changes.into(), "");
    if fit.is_systematic() {
        table.note(
            "The residuals run together: the data do not follow the curve of a viscoelastic collision, and g* is less certain than its standard error.",
        );
    }
    let above = data.rows.iter().zip(&data.lines).filter(|(row, _)| row.epsilon() > 1.0);
    let above = above.map(|(_, line)| line.to_string()).collect::<Vec<_>>();
    if !above.is_empty() {
        table.note(format!("Coefficients above 1, kept as noise: line {}.", above.join(", ")));
    }
    table
}

fn residuals(data: &Data, fit: &Fit, end: End) -> Table {
    let mut table = Table::new(&["line", "velocity", "epsilon", "fitted", "residual"]);
    for (row, line) in data.rows.iter().zip(&data.lines) {
        let fitted = fit.epsilon(row.velocity(), end);
        let cells = [row.velocity(), row.epsilon(), fitted, row.epsilon() - fitted];
        table.push([Cell::from(*line)].into_iter().chain(cells.map(ten_digits)).collect());
    }
    table.note(format!("Velocities in {}.", data.unit));
    table
}

/// A fitted value to the digits its error leaves, and one more; ten at most.
fn statistic(value: f64, relative_error: f64) -> Cell {
    let digits = if relative_error > 0.0 { (1.5 - relative_error.log10()).ceil() } else { 10.0 };
    rounded(value, digits.clamp(2.0, 10.0) as usize)
}

/// A number rounded to some significant digits.
fn rounded(value: f64, digits: usize) -> Cell {
    Cell::Float(format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value))
}

fn velocity_unit(text: &str) -> Result<String, String> {
    let unit = text.trim();
    Quantity::parse(&format!("1{unit}"), Dimension::Velocity).map_err(|error| error.to_string())?;
    Ok(unit.to_owned())
}
