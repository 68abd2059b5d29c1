use super::Input;
use crate::{Contact, MaterialError, ViscoelasticContact};
use core::fmt;

/// MercuryDPM, the species `HertzianBSHPViscoelastic`.
///
/// The paper's `A` and the effective modulus as they are; zero force ends the contact.
///
/// # Examples
///
/// ```
/// use restitution::codes::MercuryDpm;
/// use restitution::MaterialError;
///
/// let input = MercuryDpm { effective_elastic_modulus: 5e9, dissipation: 1e-6 };
/// assert_eq!(MercuryDpm::new(&input.contact(0.005, 1e-3)?), input);
///
/// let wrong = MercuryDpm { dissipation: -1e-6, ..input };
/// assert!(matches!(wrong.contact(0.005, 1e-3), Err(MaterialError::Negative { .. })));
/// # Ok::<(), MaterialError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MercuryDpm {
    /// The argument of `setEffectiveElasticModulus`, in Pa.
    pub effective_elastic_modulus: f64,
    /// The argument of `setDissipation`, in s.
    pub dissipation: f64,
}

impl MercuryDpm {
    /// Returns the input that stands for `pair`.
    pub fn new(pair: &ViscoelasticContact) -> Self {
        Self {
            effective_elastic_modulus: pair.contact().effective_modulus(),
            dissipation: pair.dissipative_constant(),
        }
    }

    /// Returns what the input means for particles of the given effective radius (m) and mass (kg).
    ///
    /// # Errors
    ///
    /// [`MaterialError::NotPositive`] or [`MaterialError::Negative`] for values that mean nothing.
    pub fn contact(&self, radius: f64, mass: f64) -> Result<ViscoelasticContact, MaterialError> {
        ViscoelasticContact::new(
            Contact::new(radius, mass, self.effective_elastic_modulus)?,
            self.dissipation,
        )
    }
}

impl fmt::Display for MercuryDpm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "species->setEffectiveElasticModulus({});", Input(self.effective_elastic_modulus))?;
        write!(f, "species->setDissipation({});", Input(self.dissipation))
    }
}
