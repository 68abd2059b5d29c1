//! `restitution fit`: the characteristic velocity from a table of measurements.

mod report;
mod source;

use super::material::UnitArg;
use super::material::bodies::BodyArgs;
use super::material::code::{Code, Dissipation, Request};
use crate::args::EndOfContact;
use crate::units::{Dimension, Quantity};
use crate::{CliError, OutputArgs, progress};
use restitution::End;
use restitution_fit::{Data, Fit, Law, Loss, Stiffness, adequacy, compare, fit, stiffness};
use source::SourceArgs;

/// Arguments of `restitution fit`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  restitution fit data.csv\n  \
    restitution fit data.txt --columns 2,4 --velocity-unit cm/s --between 1cm/s,50cm/s\n  \
    restitution fit drops.csv --measured-as heights --table laws\n  \
    restitution fit --example ice --between 0.3cm/s,5cm/s --table laws --printed-formula\n  \
    restitution fit data.csv --code lammps --young 1GPa --poisson 0.3 --density 2500kg/m3 --radius 5mm")]
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
    /// Where the contact ends [default: zero-compression, or where the code ends it]
    #[arg(long, value_enum, value_name = "END")]
    end: Option<EndOfContact>,
    /// Print the input lines of a discrete-element code for bodies of this g*
    #[arg(long, value_enum, value_name = "CODE", conflicts_with_all = ["table", "printed_formula"])]
    code: Option<Code>,
    /// The unit system of the code's input
    #[arg(long, value_enum, value_name = "SYSTEM", requires = "code")]
    units: Option<UnitArg>,
    #[command(flatten)]
    output: OutputArgs,
    #[command(flatten)]
    bodies: BodyArgs,
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
        if let Some(code) = self.code {
            let lines = progress::during("fitting", || self.lines(code, &data))?;
            return self.output.print_lines(&lines);
        }
        if self.bodies.is_given() && (data.durations.is_empty() || self.table != Show::Fit) {
            return Err(CliError::usage(
                "bodies serve --code, and durations of contacts in the table: give --code, or leave the bodies out",
            ));
        }
        let table = progress::during("fitting", || self.make(&data))?;
        self.output.print(&table)
    }

    /// The lines of a code, with what was fitted above them.
    fn lines(&self, code: Code, data: &Data) -> Result<String, CliError> {
        let end = code.end(self.end)?;
        let result = fit(&data.rows, end, self.loss()).map_err(CliError::failure)?;
        let verdict = adequacy(&data.rows, &result).map_err(CliError::failure)?;
        let request = Request {
            bodies: &self.bodies,
            dissipation: Dissipation::Fitted {
                g_star: data.in_si(result.characteristic_velocity),
                stiffness: lasting(data, &result)?,
                says: report::in_a_line(data, &result, &verdict),
            },
            velocities: Vec::new(),
            units: UnitArg::system(self.units),
            end: self.end,
        };
        request.lines(code)
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
        let result = fit(&data.rows, end, self.loss()).map_err(CliError::failure)?;
        let verdict = || adequacy(&data.rows, &result).map_err(CliError::failure);
        Ok(match self.table {
            Show::Residuals => report::residuals(data, &result),
            Show::Tests => report::tests(&verdict()?, &result),
            _ => {
                let laws = compare(&data.rows, &Law::USUAL).map_err(CliError::failure)?;
                let mut table = report::summary(data, &result, &verdict()?, &laws);
                if let Some(found) = lasting(data, &result)? {
                    report::add_stiffness(&mut table, &found);
                    if self.bodies.is_given() {
                        report::add_bodies(&mut table, &found, self.bodies.radius_and_mass()?)?;
                    }
                }
                table
            }
        })
    }

    fn loss(&self) -> Loss {
        match self.loss {
            LossArg::Squares => Loss::Squares,
            LossArg::Huber => Loss::Huber,
        }
    }

    fn end(&self) -> End {
        self.end.unwrap_or_default().into()
    }
}

/// Stiffness and damping, if the table has durations.
fn lasting(data: &Data, result: &Fit) -> Result<Option<Stiffness>, CliError> {
    if data.durations.is_empty() {
        return Ok(None);
    }
    stiffness(&data.rows, &data.durations, data.unit_size, result).map(Some).map_err(CliError::failure)
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
