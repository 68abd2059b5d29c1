//! The conventions of the discrete-element codes, there and back.
//!
//! Every code's input becomes a [`ViscoelasticContact`] for given effective radius
//! and mass, and back; `Display` prints the lines to paste. All inputs are in SI units.

mod chrono;
mod constant_code;
mod constant_law;
mod constant_lines;
mod esys;
mod lammps;
mod liggghts;
mod mercury;
mod unit_system;
mod yade;

pub use chrono::Chrono;
pub use constant_code::ConstantCode;
pub use constant_law::ConstantRestitution;
pub use constant_lines::{ConstantBodies, Elastic};
pub use esys::EsysParticle;
pub use lammps::{LammpsGranular, LammpsHertzHistory};
pub use liggghts::Liggghts;
pub use mercury::MercuryDpm;
pub use unit_system::UnitSystem;
pub use yade::Yade;

use crate::bodies::error::{at_least_zero, finite, in_range, positive};
use crate::{Contact, MaterialError, ViscoelasticContact};
use core::fmt;

/// A number as input files take it: the shortest text that reads back as the same f64.
struct Input(f64);

impl fmt::Display for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 == 0.0 || (1e-3..1e6).contains(&self.0.abs()) {
            self.0.fmt(f)
        } else {
            write!(f, "{:e}", self.0)
        }
    }
}

/// Stiffness `k_n` and damping `eta` of the LAMMPS family for one pair of particles.
///
/// ```text
/// F = sqrt(R_eff xi) (k_n xi - eta m_eff xi'),   rho = k_n sqrt(R_eff),   (3/2) A = eta m_eff/k_n
/// ```
fn stiffness_and_damping(pair: &ViscoelasticContact) -> Result<(f64, f64), MaterialError> {
    let k_n = in_range("stiffness k_n", 4.0 / 3.0 * pair.contact().effective_modulus())?;
    let damping = 1.5 * pair.dissipative_constant() * (k_n / pair.contact().effective_mass());
    Ok((k_n, at_least_zero("damping eta_n0", damping)?))
}

/// The way back of [`stiffness_and_damping`].
fn from_stiffness_and_damping(
    (k_n, damping): (f64, f64),
    radius: f64,
    mass: f64,
) -> Result<ViscoelasticContact, MaterialError> {
    let contact = Contact::new(radius, mass, 0.75 * positive("stiffness k_n", k_n)?)?;
    let a = at_least_zero("damping eta_n0", damping)? * (mass / k_n) / 1.5;
    ViscoelasticContact::new(contact, finite("dissipative constant A", a)?)
}

/// `1 - nu^2`.
fn plane_strain(poisson: f64) -> Result<f64, MaterialError> {
    if !(poisson > -1.0 && poisson <= 0.5) {
        return Err(MaterialError::PoissonRatio { value: poisson });
    }
    Ok((1.0 - poisson) * (1.0 + poisson))
}
