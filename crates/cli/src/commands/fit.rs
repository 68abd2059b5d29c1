//! `restitution fit`: the characteristic velocity from a table of measurements.

mod report;
mod source;

use crate::args::{EndArgs, EndOfContact};
use crate::units::{Dimension, Quantity};
use crate::{CliError, OutputArgs, progress};
use restitution::End;
use restitution_fit::{Data, Law, Loss, adequacy, compare, fit};
use source::SourceArgs;

/// Arguments of `restitution fit`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  restitution fit data.csv\n  \
    restitution fit data.txt --columns 2,4 --velocity-unit cm/s --between 1cm/s,50cm/s\n  \
    restitution fit drops.csv --measured-as heights --table laws\n  \
    restitution fit --example ice --between 0.3cm/s,5cm/s --table laws --printed-formula")]
pub struct FitArgs {
    #[command(flatten)]
    source: SourceArgs,
    /// Use the rows with velocities from LOW to HIGH only, such as 0.3cm/s,5cm/s
    #[arg(long, value_name = "LOW,HIGH", value_parser = between)]
    between: Option<(Quantity, Quantity)>,
    /// How residuals count
    #[arg(long, value_enum, default_value_t, value_name = "LOSS")]
    loss: LossArg,
    /// What to print
    #[arg(long, value_enum, default_value_t, value_name = "TABLE")]
    table: Show,
    /// Compare formula (35) as the paper prints it, too
    #[arg(long)]
    printed_formula: bool,
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
    /// The characteristic velocity, its interval, and whether the law fits at all.
    #[default]
    Fit,
    /// Every row with its fitted value.
    Residuals,
    /// Several laws fitted to the same rows, best first.
    Laws,
    /// The tests of whether the law fits.
    Tests,
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
        let mut data = progress::during("reading", || self.source.read())?;
        self.restrict(&mut data)?;
        let table = progress::during("fitting", || self.make(&data))?;
        self.output.print(&table)
    }

    /// Leaves out what `--between` leaves out, and says so.
    fn restrict(&self, data: &mut Data) -> Result<(), CliError> {
        let Some((low, high)) = &self.between else { return Ok(()) };
        let dropped = data.keep_between(low.to_f64(), high.to_f64());
        if data.rows.is_empty() {
            let rows = if dropped == 1 { "row lies" } else { "rows lie" };
            return Err(CliError::usage(format!(
                "the {dropped} {rows} outside {low} to {high}: give wider limits"
            )));
        }
        data.remarks
            .push(format!("{} rows from {low} to {high}, {dropped} outside left out.", data.rows.len()));
        Ok(())
    }

    fn make(&self, data: &Data) -> Result<crate::Table, CliError> {
        let end = self.end();
        if self.table == Show::Laws {
            let printed = self.printed_formula.then_some(Law::Printed35);
            let laws = Law::USUAL.into_iter().chain(printed).collect::<Vec<_>>();
            return Ok(report::laws(data, &compare(&data.rows, &laws).map_err(CliError::failure)?));
        }
        let loss = match self.loss {
            LossArg::Squares => Loss::Squares,
            LossArg::Huber => Loss::Huber,
        };
        let result = fit(&data.rows, end, loss).map_err(CliError::failure)?;
        let verdict = || adequacy(&data.rows, &result).map_err(CliError::failure);
        Ok(match self.table {
            Show::Residuals => report::residuals(data, &result),
            Show::Tests => report::tests(&verdict()?, &result),
            _ => {
                let laws = compare(&data.rows, &Law::USUAL).map_err(CliError::failure)?;
                report::summary(data, &result, &verdict()?, &laws)
            }
        })
    }

    fn end(&self) -> End {
        match self.end.end {
            EndOfContact::ZeroCompression => End::ZeroCompression,
            EndOfContact::ZeroForce => End::ZeroForce,
        }
    }
}

fn between(text: &str) -> Result<(Quantity, Quantity), String> {
    let Some((low, high)) = text.split_once(',') else {
        return Err(format!("'{text}' is not a pair of limits: write it as LOW,HIGH, such as 0.3cm/s,5cm/s"));
    };
    let read = |text| Quantity::parse(text, Dimension::Velocity).map_err(|error| error.to_string());
    let (low, high) = (read(low)?, read(high)?);
    crate::units::all_or_none(&[low.clone(), high.clone()]).map_err(|error| error.to_string())?;
    if low.si() >= high.si() {
        return Err(format!(
            "the limits {low} and {high} leave nothing between them: give the lower one first"
        ));
    }
    Ok((low, high))
}
