//! `restitution export`: the evaluator as source code.

use crate::CliError;
use crate::args::{EndArgs, EndOfContact};
use crate::output::TargetArgs;
use crate::progress;
use clap::ValueEnum;
use restitution::End;
use restitution_export::{ExportError, Language, Listing, Reference, constants, design};
use restitution_export::{tier_tables, zero_compression_tables, zero_force_tables};

/// The least and the largest relative error that can be asked for.
const TOLERANCES: (f64, f64) = (1e-15, 0.1);
/// The largest `u` that can be asked for.
const LARGEST_U: f64 = 1e6;

/// Arguments of `restitution export`.
#[derive(Debug, clap::Args)]
pub struct ExportArgs {
    /// The language; evaluator-tables writes the tables of this project's own evaluator
    #[arg(long, value_name = "LANGUAGE", value_enum)]
    lang: Target,
    /// The largest relative error, from 1e-15 to 0.1
    #[arg(long, value_name = "T", default_value = "1e-9", value_parser = tolerance, allow_hyphen_values = true)]
    tolerance: f64,
    /// The range of u, 0 <= LO < HI <= 1e6
    #[arg(long, value_name = "LO,HI", default_value = "0,8", value_parser = range, allow_hyphen_values = true)]
    range: (f64, f64),
    #[command(flatten)]
    end: EndArgs,
    #[command(flatten)]
    target: TargetArgs,
}

/// What can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Target {
    Rust,
    C,
    Fortran,
    Python,
    EvaluatorConstants,
    EvaluatorTables,
    EvaluatorTiers,
}

impl ExportArgs {
    /// Writes the source.
    ///
    /// # Errors
    ///
    /// [`CliError::Failure`] if no table keeps the tolerance on the range, and those of the output.
    pub fn run(&self) -> Result<(), CliError> {
        self.target.check()?;
        let source = progress::during("certified values", || self.source())?;
        self.target.write(&source)
    }

    fn source(&self) -> Result<String, CliError> {
        let language = match self.lang {
            Target::EvaluatorConstants => return Ok(constants()),
            Target::EvaluatorTables => return self.tables(),
            Target::EvaluatorTiers => {
                let (compression, force) =
                    (Reference::new(End::ZeroCompression), Reference::new(End::ZeroForce));
                let references =
                    [&compression.map_err(CliError::failure)?, &force.map_err(CliError::failure)?];
                return Ok(tier_tables(references)?);
            }
            Target::Rust => Language::Rust,
            Target::C => Language::C,
            Target::Fortran => Language::Fortran,
            Target::Python => Language::Python,
        };
        // The last piece reaches beyond the range, at most to twice sqrt(HI) + 8 in the variable.
        let reference = self.reference(4.0 * (self.range.1.sqrt() + 8.0).powi(2))?;
        let pieces = design(&reference, self.tolerance, self.range)?;
        let listing = Listing::new(&reference, pieces, self.tolerance, self.range);
        Ok(language.write(&listing))
    }

    fn tables(&self) -> Result<String, CliError> {
        let reference = self.reference(f64::INFINITY)?;
        Ok(match reference.end() {
            End::ZeroCompression => zero_compression_tables(&reference)?,
            End::ZeroForce => zero_force_tables(&reference)?,
        })
    }

    fn reference(&self, last: f64) -> Result<Reference, CliError> {
        let end = match self.end.end {
            EndOfContact::ZeroCompression => End::ZeroCompression,
            EndOfContact::ZeroForce => End::ZeroForce,
        };
        Reference::up_to(end, last).map_err(CliError::failure)
    }
}

impl From<ExportError> for CliError {
    fn from(error: ExportError) -> Self {
        Self::failure(error)
    }
}

fn tolerance(text: &str) -> Result<f64, String> {
    let (least, largest) = TOLERANCES;
    let value = text.trim().parse::<f64>().ok().filter(|t| (least..=largest).contains(t));
    value.ok_or_else(|| format!("a tolerance is a relative error: give one from {least:e} to {largest}"))
}

fn range(text: &str) -> Result<(f64, f64), String> {
    let parse = |part: &str| part.trim().parse::<f64>().ok();
    let ends = text.split_once(',').and_then(|(low, high)| Some((parse(low)?, parse(high)?)));
    let sound = |(low, high): &(f64, f64)| 0.0 <= *low && low < high && *high <= LARGEST_U;
    ends.filter(sound).ok_or_else(|| format!("a range of u is LO,HI: give 0 <= LO < HI <= {LARGEST_U:e}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_and_ranges_have_limits() {
        assert_eq!(tolerance("1e-6"), Ok(1e-6));
        assert_eq!(range("0, 2.5"), Ok((0.0, 2.5)));
        for text in ["", "0", "-1e-3", "1e-16", "0.5", "NaN", "inf", "x"] {
            assert!(tolerance(text).is_err(), "{text}");
        }
        for text in ["", "1", "2,1", "1,1", "-1,2", "0,inf", "NaN,1", "0,2e6", "0;1"] {
            assert!(range(text).is_err(), "{text}");
        }
    }
}
