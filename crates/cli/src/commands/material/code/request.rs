//! What the lines of a code are made of.

use crate::CliError;
use crate::args::EndOfContact;
use crate::commands::material::bodies::BodyArgs;
use crate::commands::material::damping::DampingArgs;
use crate::units::Quantity;
use restitution::codes::UnitSystem;
use restitution::{End, ViscoelasticContact};
use restitution_fit::Stiffness;

/// Everything that decides what the lines are.
pub(in crate::commands) struct Request<'a> {
    pub(in crate::commands) bodies: &'a BodyArgs,
    pub(in crate::commands) dissipation: Dissipation<'a>,
    pub(in crate::commands) velocities: Vec<Quantity>,
    pub(in crate::commands) units: UnitSystem,
    pub(in crate::commands) end: Option<EndOfContact>,
}

/// How it is known how the bodies dissipate.
pub(in crate::commands) enum Dissipation<'a> {
    /// By arguments.
    Given(&'a DampingArgs),
    /// By a fit.
    Fitted {
        /// The characteristic velocity, in m/s.
        g_star: f64,
        /// What durations say, if they were measured.
        stiffness: Option<Stiffness>,
        /// What is said about it.
        says: String,
    },
}

impl Dissipation<'_> {
    /// The dissipative constants of both materials, if they were given.
    pub(super) fn constants(&self) -> Option<(f64, f64)> {
        match self {
            Self::Given(args) => args.constants(),
            Self::Fitted { .. } => None,
        }
    }

    pub(super) fn has_units(&self) -> bool {
        matches!(self, Self::Given(args) if args.has_units())
    }
}

impl Request<'_> {
    /// The contact of the bodies.
    pub(super) fn pair(&self, end: End) -> Result<ViscoelasticContact, CliError> {
        match &self.dissipation {
            Dissipation::Given(args) => args.pair(self.bodies, end)?.ok_or_else(nothing_dissipates),
            Dissipation::Fitted { g_star, stiffness, .. } => {
                let contact = match stiffness {
                    Some(found) if !self.bodies.is_elastic() => {
                        let (radius, mass) = self.bodies.radius_and_mass()?;
                        found.contact(radius, mass).map_err(CliError::usage)?
                    }
                    _ => self.bodies.contact()?,
                };
                ViscoelasticContact::from_characteristic_velocity(contact, *g_star).map_err(CliError::usage)
            }
        }
    }
}

pub(super) fn nothing_dissipates() -> CliError {
    CliError::usage(
        "nothing says how the material dissipates: give --dissipative-constant, --eta1 and --eta2, --measured, --heights, --speeds, --bounce-times or --g-star",
    )
}
