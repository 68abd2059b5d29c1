//! How the bodies dissipate: one of four ways to say it.

use super::bodies::BodyArgs;
use super::measured::{Measured, MeasuredArgs};
use crate::CliError;
use crate::units::{self, Quantity};
use restitution::{
    DissipationFormula, End, ViscoelasticContact, combined_dissipative_constant, dissipative_constant,
};

/// Which formula makes the dissipative constant of the viscosities.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Formula {
    /// Eq. (4) of the paper: diverges as NU goes to 0, vanishes at NU = 1/2.
    #[value(name = "eq4")]
    Equation4,
    /// The corrected formula of 2015.
    #[value(name = "goldobin2015")]
    Goldobin2015,
}

/// Arguments that say how the bodies dissipate.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Dissipation")]
#[group(id = "damping", multiple = true)]
pub(in crate::commands) struct DampingArgs {
    /// Dissipative constant A, such as 1e-6s
    #[arg(long, value_name = "A", value_parser = units::time, allow_hyphen_values = true, conflicts_with_all = ["eta1", "eta2", "measurement", "g_star"])]
    dissipative_constant: Option<Quantity>,
    /// Dissipative constant of the second material
    #[arg(long, value_name = "A", value_parser = units::time, allow_hyphen_values = true, requires = "dissipative_constant")]
    dissipative_constant2: Option<Quantity>,
    /// Viscosity of shear, such as 1e4Pa*s
    #[arg(long, value_name = "ETA", value_parser = units::viscosity, allow_hyphen_values = true, requires = "eta2", conflicts_with_all = ["measurement", "g_star"])]
    eta1: Option<Quantity>,
    /// Viscosity of volume
    #[arg(long, value_name = "ETA", value_parser = units::viscosity, allow_hyphen_values = true, requires = "eta1")]
    eta2: Option<Quantity>,
    /// The formula for A from the viscosities
    #[arg(long, value_enum, value_name = "FORMULA", requires = "eta1")]
    formula: Option<Formula>,
    #[command(flatten)]
    measured: MeasuredArgs,
    /// Characteristic velocity, such as 0.32cm/s
    #[arg(long, value_name = "G", value_parser = units::velocity, allow_hyphen_values = true, conflicts_with = "measurement")]
    g_star: Option<Quantity>,
}

impl DampingArgs {
    /// The measured collision, if one was given.
    pub(super) fn measured(&self) -> Result<Option<Measured>, CliError> {
        self.measured.get()
    }

    /// The characteristic velocity, if it was given.
    pub(super) fn g_star(&self) -> Option<&Quantity> {
        self.g_star.as_ref()
    }

    /// Whether anything was given.
    pub(super) fn is_given(&self) -> Result<bool, CliError> {
        let given = self.dissipative_constant.is_some() || self.eta1.is_some() || self.g_star.is_some();
        Ok(given || self.measured()?.is_some())
    }

    /// The dissipative constants of two materials, if they were given.
    pub(super) fn constants(&self) -> Option<(f64, f64)> {
        let [one, other] = [&self.dissipative_constant, &self.dissipative_constant2];
        Some((one.as_ref()?.to_f64(), other.as_ref()?.to_f64()))
    }

    /// Whether any quantity was given with a unit.
    pub(super) fn has_units(&self) -> bool {
        let all =
            [&self.dissipative_constant, &self.dissipative_constant2, &self.eta1, &self.eta2, &self.g_star];
        self.measured.has_units() || all.into_iter().flatten().any(|quantity| quantity.unit().is_some())
    }

    /// The viscoelastic contact, if anything says how it dissipates.
    pub(super) fn pair(&self, bodies: &BodyArgs, end: End) -> Result<Option<ViscoelasticContact>, CliError> {
        let measured = self.measured()?;
        if let (Some(measured), Some(duration)) = (&measured, &self.measured.duration) {
            let (radius, mass) = bodies.radius_and_mass()?;
            let (velocity, lost) = (measured.loss.velocity(), measured.loss.lost());
            let pair =
                ViscoelasticContact::from_duration(radius, mass, velocity, lost, duration.to_f64(), end);
            return pair.map(Some).map_err(CliError::usage);
        }
        let contact = bodies.contact()?;
        let pair = if let Some(measured) = measured {
            ViscoelasticContact::from_loss(contact, measured.loss.velocity(), measured.loss.lost(), end)
        } else if let Some(g_star) = &self.g_star {
            ViscoelasticContact::from_characteristic_velocity(contact, g_star.to_f64())
        } else if let Some(a) = self.constant(bodies)? {
            ViscoelasticContact::new(contact, a)
        } else {
            return Ok(None);
        };
        pair.map(Some).map_err(CliError::usage)
    }

    fn constant(&self, bodies: &BodyArgs) -> Result<Option<f64>, CliError> {
        if let (Some(eta_1), Some(eta_2)) = (&self.eta1, &self.eta2) {
            return self.of_viscosities(bodies, eta_1.to_f64(), eta_2.to_f64()).map(Some);
        }
        let Some(a) = self.dissipative_constant.as_ref().map(Quantity::to_f64) else { return Ok(None) };
        match (&self.dissipative_constant2, bodies.has_two_materials()) {
            (None, false) => Ok(Some(a)),
            (Some(_), false) => Err(CliError::usage(
                "a second dissipative constant belongs to a second material: give --young2 or --poisson2",
            )),
            (None, true) => Err(CliError::usage(
                "two materials dissipate in two ways: give --dissipative-constant2 for the second",
            )),
            (Some(a_2), true) => {
                let second = bodies.second_material()?.map_or_else(|| bodies.material(), Ok)?;
                let combined =
                    combined_dissipative_constant((&bodies.material()?, a), (&second, a_2.to_f64()));
                combined.map(Some).map_err(CliError::usage)
            }
        }
    }

    fn of_viscosities(&self, bodies: &BodyArgs, eta_1: f64, eta_2: f64) -> Result<f64, CliError> {
        if bodies.has_two_materials() {
            return Err(CliError::usage(
                "one pair of viscosities is not enough for two materials: find A of each alone, then give --dissipative-constant and --dissipative-constant2",
            ));
        }
        let formula = match self.formula {
            Some(Formula::Equation4) => DissipationFormula::Equation4,
            Some(Formula::Goldobin2015) => DissipationFormula::Goldobin2015,
            None => {
                return Err(CliError::usage(
                    "two formulas lead from viscosities to A and differ: give --formula goldobin2015, or eq4 to follow the paper",
                ));
            }
        };
        dissipative_constant(&bodies.material()?, eta_1, eta_2, formula).map_err(CliError::usage)
    }
}
