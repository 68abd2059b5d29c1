//! Where the measurements come from and how they are to be read.

use crate::units::{self, Dimension, Quantity};
use crate::{CliError, input};
use restitution_fit::sheet::{Decimal, Dialect, Separator};
use restitution_fit::{Data, DataOptions, Method, STANDARD_GRAVITY};
use std::path::PathBuf;

/// The largest file that is read: ten million rows of two columns.
const LARGEST_FILE: u64 = 256_000_000;
/// The law of Bridges, Hatzes and Lin for ice, with which the paper compares.
const ICE: &str = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/data/ice_bridges.csv"));

/// Arguments that say where the measurements are and how to read them.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Reading")]
pub(super) struct SourceArgs {
    /// A table of measurements in any usual form; - is stdin
    #[arg(value_name = "DATA", required_unless_present = "example")]
    data: Option<PathBuf>,
    /// Use a table that comes with the program
    #[arg(long, value_enum, value_name = "NAME", conflicts_with = "data")]
    example: Option<Example>,
    /// Which columns hold what, by name or number, in order or as KEY=COLUMN, such as 2,4 or velocity=2,epsilon=4,sigma=5
    #[arg(long, value_name = "COLUMN,...")]
    columns: Option<String>,
    /// What was measured [default: by the names of the columns, or coefficients]
    #[arg(long, value_enum, value_name = "METHOD")]
    measured_as: Option<MeasuredAs>,
    /// Unit of the velocities, if the header names none [default: m/s]
    #[arg(long, value_name = "UNIT", value_parser = velocity_unit)]
    velocity_unit: Option<String>,
    /// Acceleration of gravity, for heights and times [default: 9.80665m/s^2]
    #[arg(long, value_name = "A", value_parser = units::acceleration)]
    gravity: Option<Quantity>,
    /// What separates the columns [default: as the file has it]
    #[arg(long, value_enum, value_name = "SIGN")]
    separator: Option<SeparatorArg>,
    /// The decimal sign [default: as the file has it]
    #[arg(long, value_enum, value_name = "SIGN")]
    decimal: Option<DecimalArg>,
    /// Leave rows without a value out instead of refusing them
    #[arg(long)]
    skip_missing: bool,
}

/// A table that comes with the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Example {
    /// Ice: the law of Bridges, Hatzes and Lin at 28 velocities, as in Fig. 1 of the paper.
    Ice,
}

/// What was measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum MeasuredAs {
    /// Impact velocity and coefficient.
    Coefficients,
    /// Speeds before and after.
    Speeds,
    /// Heights of drop and rebound.
    Heights,
    /// Times of successive impacts of a bouncing ball.
    Bounces,
}

/// What separates columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum SeparatorArg {
    /// Commas.
    Comma,
    /// Semicolons.
    Semicolon,
    /// Tabs.
    Tab,
    /// Blanks.
    Blank,
    /// Vertical bars.
    Bar,
}

/// The sign between whole and fraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum DecimalArg {
    /// 0.5
    Point,
    /// 0,5
    Comma,
}

impl SourceArgs {
    /// Reads the measurements.
    pub(super) fn read(&self) -> Result<Data, CliError> {
        let (name, bytes) = match &self.data {
            Some(path) => {
                (path.display().to_string(), input::read(path, LARGEST_FILE, "give a table of measurements")?)
            }
            None => ("ice".to_owned(), ICE.as_bytes().to_vec()),
        };
        Data::read(bytes, &self.options()?).map_err(|error| CliError::usage(format!("'{name}' {error}")))
    }

    fn options(&self) -> Result<DataOptions, CliError> {
        let gravity = self.gravity.as_ref().map_or(STANDARD_GRAVITY, Quantity::to_f64);
        if !(gravity > 0.0 && gravity.is_finite()) {
            return Err(CliError::usage(
                "the acceleration of gravity must be positive: give one such as 9.81m/s^2",
            ));
        }
        Ok(DataOptions {
            dialect: Dialect {
                separator: self.separator.map(|separator| match separator {
                    SeparatorArg::Comma => Separator::Comma,
                    SeparatorArg::Semicolon => Separator::Semicolon,
                    SeparatorArg::Tab => Separator::Tab,
                    SeparatorArg::Blank => Separator::Blanks,
                    SeparatorArg::Bar => Separator::Bar,
                }),
                decimal: self.decimal.map(|decimal| match decimal {
                    DecimalArg::Point => Decimal::Point,
                    DecimalArg::Comma => Decimal::Comma,
                }),
            },
            method: self.measured_as.map(|method| match method {
                MeasuredAs::Coefficients => Method::Coefficients,
                MeasuredAs::Speeds => Method::Speeds,
                MeasuredAs::Heights => Method::Heights,
                MeasuredAs::Bounces => Method::Bounces,
            }),
            columns: self.columns.clone(),
            velocity_unit: self.velocity_unit.clone(),
            gravity,
            skip_missing: self.skip_missing,
        })
    }
}

fn velocity_unit(text: &str) -> Result<String, String> {
    let unit = text.trim();
    if unit.is_empty() {
        return Err("a unit has a name: give one such as cm/s".to_owned());
    }
    Quantity::parse(&format!("1 {unit}"), Dimension::Velocity).map_err(|error| error.to_string())?;
    Ok(unit.to_owned())
}
