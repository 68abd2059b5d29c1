//! The subcommands.
//!
//! To add one:
//!
//! 1. A file `commands/NAME.rs` with `#[derive(clap::Args)] pub struct NameArgs` and
//!    `impl NameArgs { pub fn run(&self) -> Result<(), CliError> }`. Flatten
//!    [`OutputArgs`](crate::OutputArgs) for `--format` and `-o`; take orders, digits, laws, ends of
//!    contact, exact numbers and units from [`args`](crate::args), [`exact`](crate::exact) and
//!    [`units`](crate::units).
//! 2. In `run`: `self.output.check()?` first, then [`memory::require`](crate::memory::require) with
//!    an estimate, then the work inside [`progress::during`](crate::progress::during), then
//!    `self.output.print(&table)`.
//! 3. A variant of [`Command`] below and its arm.
//! 4. Tests in `crates/cli/tests/it/`, with one wrong input of each kind, and a line in the README.

pub mod audit;
pub mod closed_form;
pub mod completions;
pub mod epsilon;
pub mod export;
pub mod fit;
pub mod material;
pub mod pade;
pub mod page;
pub mod report;
pub mod table;
pub mod trajectory;

use crate::CliError;
use clap::error::ErrorKind;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use std::ffi::OsString;

/// The coefficient of restitution of colliding viscoelastic bodies, with every printed digit proved
#[derive(Debug, Parser)]
#[command(name = "restitution", version, arg_required_else_help = true)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
}

/// What can be asked for.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Print the coefficients of the expansions in u, with proved digits
    Table(table::TableArgs),
    /// Print a coefficient as a closed form in Beta values and iterated Beta integrals
    ClosedForm(closed_form::ClosedFormArgs),
    /// Print the trajectory as exact power series in time
    Trajectory(trajectory::TrajectoryArgs),
    /// Print coefficients of restitution by certified direct integration
    Epsilon(Box<epsilon::EpsilonArgs>),
    /// Write an evaluator of epsilon(u) as source code, in C, Fortran, Python and other languages
    Export(Box<export::ExportArgs>),
    /// Judge the statements of the papers, one by one
    Audit(audit::AuditArgs),
    /// Write one HTML file to play with epsilon(g), measurements and lines for codes
    Page(page::PageArgs),
    /// Measure speed against error on this machine and write it as a page with figures and data
    Report(report::ReportArgs),
    /// Write the completions of a shell, or the manual page
    Completions(completions::CompletionsArgs),
    /// Fit the characteristic velocity g* to measured coefficients of restitution
    Fit(Box<fit::FitArgs>),
    /// What follows from a material, a measurement or the input of a discrete-element code
    Material(Box<material::MaterialArgs>),
    /// Padé approximants: constants, verdicts, maps, recommended and published ones
    Pade(Box<pade::PadeArgs>),
}

/// Reads the arguments, the program's name first, and carries out what they ask for.
///
/// # Errors
///
/// A [`CliError`]: usage for what cannot be understood or done at any time, failure otherwise.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> Result<(), CliError> {
    let arguments = arguments.into_iter().collect::<Vec<_>>();
    match parse(&arguments) {
        Ok(cli) => cli.command.run(),
        Err(error) if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) => {
            error.print().map_err(|_| CliError::ClosedPipe)
        }
        // the command alone: its help is the answer, so that it goes where answers go
        Err(error) if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            crate::output::TargetArgs::default().write(&error.render().to_string())
        }
        Err(error) => Err(CliError::of_arguments(&error, &arguments)),
    }
}

impl Command {
    fn run(&self) -> Result<(), CliError> {
        match self {
            Self::Table(args) => args.run(),
            Self::ClosedForm(args) => args.run(),
            Self::Trajectory(args) => args.run(),
            Self::Epsilon(args) => args.run(),
            Self::Export(args) => args.run(),
            Self::Audit(args) => args.run(),
            Self::Page(args) => args.run(),
            Self::Report(args) => args.run(),
            Self::Completions(args) => args.run(),
            Self::Fit(args) => args.run(),
            Self::Material(args) => args.run(),
            Self::Pade(args) => args.run(),
        }
    }
}

fn parse(arguments: &[OsString]) -> Result<Cli, clap::Error> {
    Cli::from_arg_matches(&command().try_get_matches_from(arguments)?)
}

/// Returns the whole command line; a negative number is a value, so that its parser can say why not.
pub fn command() -> clap::Command {
    let takes_numbers = |arg: clap::Arg| {
        let takes_value = arg.get_action().takes_values();
        if takes_value && !arg.is_allow_hyphen_values_set() { arg.allow_negative_numbers(true) } else { arg }
    };
    Cli::command().mut_subcommands(|sub| sub.mut_args(takes_numbers))
}
