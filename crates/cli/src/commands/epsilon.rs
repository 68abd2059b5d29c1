//! `restitution epsilon`: the coefficient of restitution by certified direct integration.

mod damping;
mod lookup;
mod refusals;

use crate::args::{EndArgs, LawArgs, count};
use crate::exact::Exact;
use crate::list::{self, List};
use crate::progress::Progress;
use crate::units::{self, Quantity};
use crate::{Cell, CliError, OutputArgs, Table};
pub(super) use damping::DampingArgs;
use lookup::in_si;
use rayon::prelude::*;
use refusals::Refusals;
use restitution_direct::{
    Collision, Damping, DirectError, End, VelocityScale, saturation_radius, saturation_speed,
};
use restitution_table::Format;

/// The largest number of digits that is accepted: 1000 take minutes.
const LARGEST_DIGITS: usize = 10_000;

/// Arguments of `restitution epsilon`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  restitution epsilon --u 0.1,1,8 --digits 30\n  \
    restitution epsilon --velocity 1cm/s,10cm/s --g-star 0.32cm/s --end zero-force\n  \
    restitution epsilon --u 1e-12 --quantity loss\n  restitution epsilon --saturation --digits 50")]
pub struct EpsilonArgs {
    /// Dampings u of x'' + u x^GAMMA x' + x^A = 0 with x'(0) = 1, separated by commas, or a grid such as 0.1:2:20
    #[arg(long, value_name = "U", num_args = 1.., value_parser = list::at_least_zero)]
    u: Vec<List<Exact>>,
    /// Impact velocities such as 0.5cm/s,1cm/s or the grid 1cm/s:10m/s:50log, with --g-star or a material
    #[arg(long, value_name = "G", num_args = 1.., value_parser = list::velocities, conflicts_with = "u")]
    velocity: Vec<List<Quantity>>,
    /// Print R = lim u epsilon^p and R^(1/p), the exit speed at unlimited velocity; p = 1/5 for spheres
    #[arg(long, conflicts_with_all = ["u", "velocity", "end"])]
    saturation: bool,
    /// What is printed
    #[arg(
        long,
        value_enum,
        default_value_t,
        hide_default_value = true,
        value_name = "QUANTITY",
        conflicts_with = "saturation"
    )]
    quantity: Printed,
    /// Significant digits, all proved
    #[arg(long, value_name = "D", default_value_t = 20, value_parser = digits)]
    digits: usize,
    #[command(flatten)]
    damping: DampingArgs,
    #[command(flatten)]
    law: LawArgs,
    #[command(flatten)]
    end: EndArgs,
    #[command(flatten)]
    output: OutputArgs,
}

/// What is printed of a collision.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
enum Printed {
    /// The coefficient of restitution.
    #[default]
    Epsilon,
    /// What is lost of the velocity, 1 - epsilon, to as many digits however small it is.
    Loss,
}

fn digits(text: &str) -> Result<usize, String> {
    count(text, "a number of digits", 1, LARGEST_DIGITS)
}

impl EpsilonArgs {
    /// Integrates the collisions and prints the table.
    ///
    /// Of a list, what can be answered is printed and the rest left empty, with one line on stderr. That
    /// bodies do not separate is an answer as long as others of the list do; digits that could not be
    /// proved are a failure, after the others are printed.
    ///
    /// # Errors
    ///
    /// Usage where the law and the end of contact do not go together or the damping is incomplete,
    /// failure where no coefficient of the list exists or the digits of one cannot be proved.
    pub fn run(&self) -> Result<(), CliError> {
        self.check()?;
        self.output.check()?;
        if self.saturation { self.output.print(&self.saturated()?) } else { self.integrated() }
    }

    /// Refuses what does not go together.
    fn check(&self) -> Result<(), CliError> {
        match (self.velocity.is_empty(), self.damping.given()) {
            (false, false) => Err(CliError::usage(
                "a velocity alone says nothing of the bodies: give --g-star, or --dissipative-constant, --young, --poisson, --density and --radius",
            )),
            (true, true) => Err(CliError::usage(
                "bodies and g* go with impact velocities, for which they give u: give --velocity, or leave them out",
            )),
            (true, false) if self.u.is_empty() && !self.saturation => Err(CliError::usage(
                "nothing says which collision: give --u <U>, --velocity <G> or --saturation",
            )),
            _ => Ok(()),
        }
    }

    fn integrated(&self) -> Result<(), CliError> {
        units::all_or_none(&list::flat(&self.velocity)).map_err(CliError::usage)?;
        let end = End::from(self.end.end);
        let collision = Collision::new(&self.law.law, end).map_err(usage)?;
        let scale = if self.velocity.is_empty() { None } else { Some(self.damping.scale(&self.law.law)?) };
        let points = self.points(scale.as_ref())?;
        let progress = Progress::steps("collisions", points.len() as u64);
        let values: Vec<Result<Option<String>, DirectError>> = points
            .par_iter()
            .map(|(_, damping)| {
                let value = self.value(&collision, damping);
                progress.advance(1);
                value
            })
            .collect();
        drop(progress);
        let lookup = self.output.format == Format::Lookup && !self.velocity.is_empty();
        let first = match (self.velocity.is_empty(), lookup) {
            (true, _) => "u",
            (false, false) => "velocity",
            (false, true) => "velocity_in_m_per_s",
        };
        let second = if self.quantity == Printed::Epsilon { "epsilon" } else { "one_minus_epsilon" };
        let mut table = Table::new(&[first, second]).titled(format!("Force law {}", self.law.law));
        let mut refusals = Refusals::default();
        for ((name, _), value) in points.into_iter().zip(values) {
            let shown = name.clone();
            let name = if lookup { in_si(&name)? } else { name };
            let cell = match value {
                Ok(shown) => Cell::Digits(self.proved(shown)?),
                Err(error) => {
                    refusals.add(&shown, error);
                    Cell::Empty
                }
            };
            table.push(vec![Cell::Digits(name), cell]);
        }
        table.note("every digit is proved: direct integration with bounded remainders");
        if let (true, Some(scale)) = (lookup, &scale) {
            table.note(self.interpolation(&collision, scale)?);
        }
        self.answer(&table, &refusals, first)
    }

    /// Prints what can be answered and says what cannot.
    fn answer(&self, table: &Table, refusals: &Refusals, name: &str) -> Result<(), CliError> {
        let Some(error) = refusals.error(name, table.rows().len()) else { return self.output.print(table) };
        if refusals.count() < table.rows().len() {
            self.output.print(table)?;
        }
        if !refusals.all_are_facts() || refusals.count() == table.rows().len() {
            return Err(error);
        }
        error.report();
        Ok(())
    }

    /// What was asked for, as typed and as a damping to any precision.
    fn points(&self, scale: Option<&VelocityScale>) -> Result<Vec<(String, Damping)>, CliError> {
        let Some(scale) = scale else {
            let exact = |u: &Exact| (u.to_string(), Damping::exact(u.value()));
            return Ok(list::flat(&self.u).iter().map(exact).collect());
        };
        let from = |g: &Quantity| {
            if g.sign().is_lt() {
                return Err(CliError::usage(format!("the impact velocity {g} is negative: give its size")));
            }
            Ok((g.to_string(), scale.damping(g.si()).map_err(CliError::usage)?))
        };
        list::flat(&self.velocity).iter().map(from).collect()
    }

    /// The proved digits; `None` if they are fewer than was asked for.
    fn value(&self, collision: &Collision, damping: &Damping) -> Result<Option<String>, DirectError> {
        let value = match self.quantity {
            Printed::Epsilon => collision.epsilon_at(damping, self.digits),
            Printed::Loss => collision.one_minus_epsilon_at(damping, self.digits),
        };
        Ok(value?.to_digits(self.digits))
    }

    fn saturated(&self) -> Result<Table, CliError> {
        let _progress = Progress::unknown("slow manifold");
        let law = &self.law.law;
        let mut table = Table::new(&["quantity", "value"]).titled(format!("Force law {law}"));
        let radius = saturation_radius(law, self.digits).map_err(usage)?;
        let speed = saturation_speed(law, self.digits).map_err(usage)?;
        table.push(vec![Cell::text("R"), Cell::Digits(self.proved(radius.to_digits(self.digits))?)]);
        let power = law.velocity_exponent().recip();
        let name = if power.is_integer() { format!("R^{power}") } else { format!("R^({power})") };
        table.push(vec![Cell::text(name), Cell::Digits(self.proved(speed.to_digits(self.digits))?)]);
        table.note(format!("epsilon u^{power} -> R^{power} at unlimited velocity"));
        Ok(table)
    }

    fn proved(&self, digits: Option<String>) -> Result<String, CliError> {
        let unproved =
            || CliError::failure(format!("{} digits could not be proved: ask for fewer", self.digits));
        digits.ok_or_else(unproved)
    }
}

/// A request that no collision can meet is at fault itself; everything else is a failure.
fn usage(error: DirectError) -> CliError {
    match error {
        DirectError::NoZeroForce { .. }
        | DirectError::NoSaturation { .. }
        | DirectError::SlowSaturation { .. } => CliError::usage(error),
        _ => CliError::failure(error),
    }
}
