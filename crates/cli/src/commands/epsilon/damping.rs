//! Arguments that say how strongly bodies dissipate.

use crate::CliError;
use crate::commands::material::bodies::incomplete;
use crate::exact::{Exact, at_least_zero};
use crate::units::{self, Quantity};
use restitution_direct::{EqualSpheres, VelocityScale};
use restitution_law::ForceLaw;
use std::fmt;

/// Arguments that say how strongly the bodies dissipate.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Damping, for velocities")]
#[group(id = "damping", multiple = true)]
pub(in crate::commands) struct DampingArgs {
    /// Characteristic velocity g*, with epsilon = 1 - s + ..., s = (g/g*)^p
    #[arg(long, value_name = "G", value_parser = units::velocity)]
    g_star: Option<Quantity>,
    /// Dissipative constant A of two equal spheres, such as 1e-6s
    #[arg(long, value_name = "A", value_parser = units::time, conflicts_with = "g_star")]
    dissipative_constant: Option<Quantity>,
    /// Young's modulus, such as 9.4GPa
    #[arg(long, value_name = "Y", value_parser = units::modulus, requires = "dissipative_constant")]
    young: Option<Quantity>,
    /// Poisson's ratio
    #[arg(long, value_name = "NU", value_parser = at_least_zero, requires = "dissipative_constant")]
    poisson: Option<Exact>,
    /// Mass density, such as 917kg/m3
    #[arg(long, value_name = "DENSITY", value_parser = units::density, requires = "dissipative_constant")]
    density: Option<Quantity>,
    /// Radius of both spheres, such as 2.75cm
    #[arg(long, value_name = "R", value_parser = units::length, requires = "dissipative_constant")]
    radius: Option<Quantity>,
}

impl fmt::Display for DampingArgs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(g_star) = &self.g_star {
            return write!(f, "given as {g_star}");
        }
        let parts = [
            self.dissipative_constant.as_ref().map(|a| format!("A = {a}")),
            self.young.as_ref().map(|young| format!("Y = {young}")),
            self.poisson.as_ref().map(|poisson| format!("nu = {poisson}")),
            self.density.as_ref().map(|density| format!("density {density}")),
            self.radius.as_ref().map(|radius| format!("radius {radius}")),
        ];
        write!(f, "two equal spheres, {}", parts.into_iter().flatten().collect::<Vec<_>>().join(", "))
    }
}

impl DampingArgs {
    /// Whether any of them is there.
    pub(in crate::commands) fn given(&self) -> bool {
        self.g_star.is_some() || self.dissipative_constant.is_some()
    }

    /// What sets the damping of a velocity in m/s.
    ///
    /// # Errors
    ///
    /// Usage for what is missing or cannot be.
    pub(in crate::commands) fn scale(&self, law: &ForceLaw) -> Result<VelocityScale, CliError> {
        if let Some(g_star) = &self.g_star {
            let g_star = positive(g_star, "--g-star")?.si().clone();
            return Ok(VelocityScale::Characteristic { g_star, law: law.clone() });
        }
        if *law != ForceLaw::viscoelastic_spheres() {
            return Err(CliError::usage(
                "a material is that of viscoelastic spheres: give --g-star with another --law",
            ));
        }
        Ok(VelocityScale::EqualSpheres(self.spheres()?))
    }

    fn spheres(&self) -> Result<EqualSpheres, CliError> {
        let (Some(a), Some(young), Some(poisson), Some(density), Some(radius)) =
            (&self.dissipative_constant, &self.young, &self.poisson, &self.density, &self.radius)
        else {
            let missing = [
                ("--dissipative-constant", self.dissipative_constant.is_none()),
                ("--young", self.young.is_none()),
                ("--poisson", self.poisson.is_none()),
                ("--density", self.density.is_none()),
                ("--radius", self.radius.is_none()),
            ];
            let missing = missing.iter().filter(|(_, missing)| *missing).map(|(name, _)| *name);
            return Err(incomplete(&missing.collect::<Vec<_>>()));
        };
        if *poisson >= 1 {
            return Err(CliError::usage(format!(
                "Poisson's ratio is {poisson}: give a number of at least 0 and below 1"
            )));
        }
        Ok(EqualSpheres {
            dissipative_constant: positive(a, "--dissipative-constant")?.si().clone(),
            young: positive(young, "--young")?.si().clone(),
            density: positive(density, "--density")?.si().clone(),
            radius: positive(radius, "--radius")?.si().clone(),
            poisson: poisson.value().clone(),
        })
    }
}

fn positive<'a>(quantity: &'a Quantity, name: &str) -> Result<&'a Quantity, CliError> {
    if quantity.sign().is_gt() {
        return Ok(quantity);
    }
    Err(CliError::usage(format!("{name} is {quantity}: give {name} with a positive value")))
}
