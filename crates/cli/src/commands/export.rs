//! `restitution export`: the evaluator as source code.

use crate::CliError;
use crate::args::EndArgs;
use crate::commands::epsilon::DampingArgs;
use crate::output::TargetArgs;
use crate::progress;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use restitution::End;
use restitution_export::{
    Beyond, CharacteristicVelocity, ExportError, InterpolatedCurve, LANGUAGES, Language, Listing, Request,
};
use restitution_export::{constants, tier_tables, zero_compression_tables, zero_force_tables};
use restitution_law::ForceLaw;

/// Arguments of `restitution export`.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  restitution export --lang c --tolerance 1e-9 --range 0,20 -o restitution.h\n  \
    restitution export --lang f90 --end zero-force --beyond law --name ice --g-star 0.32cm/s -o ice.f90"
)]
pub struct ExportArgs {
    /// The language
    #[arg(long, value_name = "LANGUAGE", value_parser = languages(), ignore_case = true)]
    lang: Target,
    /// The largest relative error, from 1e-15 to 0.1
    #[arg(long, value_name = "T", default_value = "1e-9", value_parser = tolerance, allow_hyphen_values = true)]
    tolerance: f64,
    /// The range of u, 0 <= LO < HI <= 1e6
    #[arg(long, value_name = "LO,HI", default_value = "0,8", value_parser = range, allow_hyphen_values = true)]
    range: (f64, f64),
    /// What follows beyond the range: NaN, or values within the tolerance for every u
    #[arg(long, value_enum, default_value_t, value_name = "WHAT")]
    beyond: BeyondRange,
    /// What every name in the source starts with, so that several fit into one program
    #[arg(long, value_name = "NAME", default_value = "restitution", allow_hyphen_values = true)]
    name: String,
    #[command(flatten)]
    damping: DampingArgs,
    #[command(flatten)]
    end: EndArgs,
    #[command(flatten)]
    target: TargetArgs,
}

/// What follows beyond the range.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
enum BeyondRange {
    /// No value.
    #[default]
    Nan,
    /// A longer table where the tolerance needs it, then the law at infinity.
    Law,
}

/// What can be written.
#[derive(Clone, Copy, Debug)]
enum Target {
    Source(&'static Language),
    /// The tables of the crate `restitution`, for `make tables`.
    EvaluatorConstants,
    EvaluatorTables,
    EvaluatorTiers,
}

/// Reads a [`Target`] by any of its names; those of the project's own tables are not listed.
fn languages() -> impl TypedValueParser<Value = Target> {
    let listed = LANGUAGES.iter().map(|language| {
        PossibleValue::new(language.name).aliases(language.aliases.iter().copied()).help(language.title)
    });
    let internal = ["evaluator-constants", "evaluator-tables", "evaluator-tiers"]
        .map(|name| PossibleValue::new(name).hide(true));
    PossibleValuesParser::new(listed.chain(internal).collect::<Vec<_>>()).try_map(|name| {
        match name.to_lowercase().as_str() {
            "evaluator-constants" => Ok(Target::EvaluatorConstants),
            "evaluator-tables" => Ok(Target::EvaluatorTables),
            "evaluator-tiers" => Ok(Target::EvaluatorTiers),
            name => Language::of(name).map(Target::Source),
        }
    })
}

impl ExportArgs {
    /// Writes the source.
    ///
    /// # Errors
    ///
    /// Usage for what no source can have, failure if no table keeps the tolerance on the range, and those of the output.
    pub fn run(&self) -> Result<(), CliError> {
        self.target.check()?;
        let source = match self.lang {
            Target::Source(language) => {
                language.check(&self.name)?;
                self.request().check()?;
                let velocity = self.velocity()?;
                progress::during("certified values", || self.source(language, velocity))?
            }
            Target::EvaluatorConstants => constants(),
            Target::EvaluatorTables => progress::during("certified values", || self.tables())?,
            Target::EvaluatorTiers => progress::during("certified values", || self.tiers())?,
        };
        self.target.write(&source)
    }

    fn request(&self) -> Request {
        let beyond = match self.beyond {
            BeyondRange::Nan => Beyond::NotANumber,
            BeyondRange::Law => Beyond::Law,
        };
        Request { tolerance: self.tolerance, range: self.range, beyond }
    }

    /// The characteristic velocity of the bodies that were given, if any were.
    fn velocity(&self) -> Result<Option<CharacteristicVelocity>, CliError> {
        if !self.damping.given() {
            return Ok(None);
        }
        let scale = self.damping.scale(&ForceLaw::viscoelastic_spheres())?;
        Ok(Some(CharacteristicVelocity::of_scale(&scale, self.damping.to_string())?))
    }

    fn source(
        &self,
        language: &Language,
        velocity: Option<CharacteristicVelocity>,
    ) -> Result<String, CliError> {
        let request = self.request();
        let listing = Listing::new(&self.reference(request.reach())?, request)?;
        let listing = match velocity {
            Some(velocity) => listing.with_velocity(velocity),
            None => listing,
        };
        Ok(language.write(&listing, &self.name)?)
    }

    fn tables(&self) -> Result<String, CliError> {
        let reference = self.reference(f64::INFINITY)?;
        Ok(match reference.end() {
            End::ZeroCompression => zero_compression_tables(&reference),
            End::ZeroForce => zero_force_tables(&reference),
        })
    }

    fn tiers(&self) -> Result<String, CliError> {
        let [compression, force] = [End::ZeroCompression, End::ZeroForce].map(InterpolatedCurve::new);
        let references = [&compression.map_err(CliError::failure)?, &force.map_err(CliError::failure)?];
        Ok(tier_tables(references)?)
    }

    fn reference(&self, last: f64) -> Result<InterpolatedCurve, CliError> {
        let end = End::from(self.end.end);
        InterpolatedCurve::up_to(end, last).map_err(CliError::failure)
    }
}

impl From<ExportError> for CliError {
    fn from(error: ExportError) -> Self {
        match error {
            ExportError::Tolerance { .. } | ExportError::Law { .. } | ExportError::Direct(_) => {
                Self::failure(error)
            }
            _ => Self::usage(error),
        }
    }
}

fn tolerance(text: &str) -> Result<f64, ExportError> {
    text.trim().parse().map_err(|_| ExportError::WrongTolerance)
}

fn range(text: &str) -> Result<(f64, f64), ExportError> {
    let parse = |part: &str| part.trim().parse::<f64>().ok();
    let ends = text.split_once(',').and_then(|(low, high)| Some((parse(low)?, parse(high)?)));
    ends.ok_or(ExportError::WrongRange)
}
