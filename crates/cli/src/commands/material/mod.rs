//! `restitution material`: what a material, a measurement or a code's input means.

pub(in crate::commands) mod bodies;
pub(in crate::commands) mod code;
pub(in crate::commands) mod damping;
mod measured;
mod report;

use crate::args::EndOfContact;
use crate::exact::{Exact, at_least_zero};
use crate::list::{self, List};
use crate::units::{self, Quantity};
use crate::{CliError, OutputArgs};
use bodies::BodyArgs;
use code::{Code, CodeInput, Dissipation, Request};
use damping::DampingArgs;
use restitution::codes::UnitSystem;
use restitution::{End, ViscoelasticContact};

/// Arguments of `restitution material`.
#[derive(Debug, clap::Args)]
pub struct MaterialArgs {
    /// Impact velocities, such as 1cm/s,2cm/s or the grid 1cm/s:10m/s:50log
    #[arg(long, value_name = "G", num_args = 1.., value_parser = list::velocities)]
    velocity: Vec<List<Quantity>>,
    /// Where the contact ends [default: zero-compression, or where the code ends it]
    #[arg(long, value_enum, value_name = "END")]
    end: Option<EndOfContact>,
    /// Print the input lines of a discrete-element code
    #[arg(long, value_enum, value_name = "CODE", conflicts_with = "from_code")]
    code: Option<Code>,
    /// Say what the input of a discrete-element code means
    #[arg(long, value_enum, value_name = "CODE", requires = "input", conflicts_with_all = ["young", "poisson", "young2", "poisson2", "effective_modulus", "damping"])]
    from_code: Option<Code>,
    /// The input of the code, such as k_n=1e7,eta_n0=2e7,limit_damping
    #[arg(long, value_name = "KEY=VALUE,...", requires = "from_code")]
    input: Option<String>,
    /// The unit system of the code's input
    #[arg(long, value_enum, value_name = "SYSTEM", requires = "code")]
    units: Option<UnitArg>,
    /// Also give the time step that keeps the error of epsilon below this
    #[arg(long, value_name = "ERROR", value_parser = at_least_zero, conflicts_with = "code")]
    error: Option<Exact>,
    /// Also give the error of epsilon that this time step causes, such as 1us
    #[arg(long, value_name = "DT", value_parser = units::time, conflicts_with_all = ["code", "error"])]
    time_step: Option<Quantity>,
    #[command(flatten)]
    output: OutputArgs,
    #[command(flatten)]
    bodies: BodyArgs,
    #[command(flatten)]
    damping: DampingArgs,
}

/// A unit system.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(in crate::commands) enum UnitArg {
    /// Metre, kilogram, second.
    Si,
    /// Centimetre, gram, second.
    Cgs,
    /// Micrometre, picogram, microsecond.
    Micro,
    /// Bare numbers, taken as they are.
    Lj,
}

impl UnitArg {
    /// The unit system that was asked for.
    pub(in crate::commands) fn system(asked: Option<Self>) -> UnitSystem {
        match asked {
            None | Some(Self::Si) => UnitSystem::Si,
            Some(Self::Cgs) => UnitSystem::Cgs,
            Some(Self::Micro) => UnitSystem::Micro,
            Some(Self::Lj) => UnitSystem::Reduced,
        }
    }
}

impl MaterialArgs {
    /// Prints the table of quantities, or the lines of a code.
    ///
    /// # Errors
    ///
    /// Usage for values that mean nothing, those of the output.
    pub fn run(&self) -> Result<(), CliError> {
        self.output.check()?;
        units::all_or_none(&self.velocities()).map_err(CliError::usage)?;
        self.bodies.check()?;
        match (self.code, self.from_code) {
            (Some(code), _) => self.output.print_lines(&self.request().lines(code)?),
            (None, Some(code)) => self.print_meaning(code),
            (None, None) => {
                let pair = self.damping.pair(&self.bodies, self.end())?;
                let contact = pair.map_or_else(|| self.bodies.contact(), |pair| Ok(*pair.contact()))?;
                self.print_report(contact, pair, self.end())
            }
        }
    }

    fn request(&self) -> Request<'_> {
        Request {
            bodies: &self.bodies,
            dissipation: Dissipation::Given(&self.damping),
            velocities: self.velocities(),
            units: UnitArg::system(self.units),
            end: self.end,
        }
    }

    fn print_meaning(&self, code: Code) -> Result<(), CliError> {
        let input = CodeInput::parse(code, self.input.as_deref().unwrap_or_default())?;
        if let Some((law, ends)) = input.constant_law()? {
            return self.output.print(&report::constant_law(&law, ends));
        }
        let (radius, mass) = self.bodies.radius_and_mass()?;
        let pair = input.pair(radius, mass)?;
        let end = input.end(self.end)?;
        self.print_report(*pair.contact(), Some(pair), end)
    }

    fn print_report(
        &self,
        contact: restitution::Contact,
        pair: Option<ViscoelasticContact>,
        end: End,
    ) -> Result<(), CliError> {
        let step = self.error.is_some() || self.time_step.is_some();
        if pair.is_none() && (!self.velocity.is_empty() || step) {
            return Err(CliError::usage(
                "nothing says how the material dissipates: give --dissipative-constant, --eta1 and --eta2, --measured, --heights, --speeds, --bounce-times or --g-star",
            ));
        }
        if step && self.velocity.is_empty() {
            return Err(CliError::usage("a time step belongs to an impact velocity: give --velocity"));
        }
        let material = self.bodies.softer_material()?;
        let report = report::Report {
            contact,
            pair,
            material,
            rayleigh: self.bodies.rayleigh_time()?,
            end,
            error: self.error.as_ref().map(Exact::to_f64),
            time_step: self.time_step.as_ref().map(Quantity::to_f64),
        };
        let velocities = self.velocities().iter().map(|g| (g.to_string(), g.to_f64())).collect::<Vec<_>>();
        self.output.print(&report.table(&velocities)?)
    }

    /// The velocities that were asked for.
    fn velocities(&self) -> Vec<Quantity> {
        list::flat(&self.velocity)
    }

    /// The end of contact that was asked for.
    fn end(&self) -> End {
        end_of(self.end.unwrap_or_default())
    }
}

fn end_of(end: EndOfContact) -> End {
    end.into()
}
