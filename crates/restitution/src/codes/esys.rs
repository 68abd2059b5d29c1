use super::{Input, plane_strain};
use crate::bodies::error::{at_least_zero, finite, in_range};
use crate::{Contact, MaterialError, ViscoelasticContact};
use core::fmt;

/// ESyS-Particle, `HertzianViscoElasticPrms(name, A, E, nu)`.
///
/// ```text
/// F = 2 E sqrt(R_eff)/(3 (1-nu^2)) (xi^(3/2) + A_ESyS sqrt(xi) xi')
/// ```
///
/// without the paper's 3/2: `A_ESyS = (3/2) A`. Zero force ends the contact.
///
/// # Examples
///
/// ```
/// use restitution::codes::EsysParticle;
/// use restitution::MaterialError;
///
/// let input = EsysParticle { a: 1.5e-6, young: 9e9, poisson: 0.3 };
/// assert!((input.contact(0.005, 1e-3)?.dissipative_constant() / 1e-6 - 1.0).abs() < 1e-15);
///
/// let wrong = EsysParticle { poisson: 0.6, ..input };
/// assert_eq!(wrong.contact(0.005, 1e-3), Err(MaterialError::PoissonRatio { value: 0.6 }));
/// # Ok::<(), MaterialError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EsysParticle {
    /// The damping constant `A` of the code, in s.
    pub a: f64,
    /// Young's modulus, in Pa.
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
}

impl EsysParticle {
    /// Returns the input that stands for `pair` with a Poisson's ratio of choice; only `E/(1-nu^2)` matters.
    ///
    /// # Errors
    ///
    /// [`MaterialError::PoissonRatio`] outside (-1, 1/2), [`MaterialError::OutOfRange`].
    pub fn new(pair: &ViscoelasticContact, poisson: f64) -> Result<Self, MaterialError> {
        let young = 2.0 * pair.contact().effective_modulus() * plane_strain(poisson)?;
        let a = finite("damping constant A", 1.5 * pair.dissipative_constant())?;
        Ok(Self { a, young: in_range("Young modulus", young)?, poisson })
    }

    /// Returns what the input means for particles of the given effective radius (m) and mass (kg).
    ///
    /// # Errors
    ///
    /// [`MaterialError::PoissonRatio`], [`MaterialError::NotPositive`] or [`MaterialError::Negative`].
    pub fn contact(&self, radius: f64, mass: f64) -> Result<ViscoelasticContact, MaterialError> {
        let modulus = self.young / (2.0 * plane_strain(self.poisson)?);
        let a = at_least_zero("damping constant A", self.a)? / 1.5;
        ViscoelasticContact::new(Contact::new(radius, mass, modulus)?, a)
    }
}

impl fmt::Display for EsysParticle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (a, young, nu) = (Input(self.a), Input(self.young), Input(self.poisson));
        write!(f, "HertzianViscoElasticPrms(name=\"contact\", A={a}, E={young}, nu={nu})")
    }
}
