use super::Input;
use crate::bodies::error::{at_least_zero, finite, in_range, positive};
use crate::{Contact, MaterialError, ViscoelasticContact};
use core::fmt;

/// Project Chrono, smooth contacts, `ContactForceModel::Hertz` without material properties: `SetKn`, `SetGn`.
///
/// ```text
/// F = R_eff sqrt(xi) (kn xi - gn m_eff xi'),   rho = kn R_eff,   (3/2) A = gn m_eff/kn
/// ```
///
/// Zero force ends the contact. `kn` is right for one effective radius, `gn` for one effective mass. (With material properties Chrono takes a
/// coefficient of restitution and makes it independent of velocity: [`ConstantCode::Chrono`](super::ConstantCode::Chrono).) Read in its source, not run.
///
/// # Examples
///
/// ```
/// use restitution::codes::Chrono;
/// use restitution::MaterialError;
///
/// let input = Chrono { kn: 1e9, gn: 2e7 };
/// let pair = input.contact(0.005, 1e-3)?;
/// assert!((pair.contact().force_prefactor() / (1e9 * 0.005) - 1.0).abs() < 1e-15);
///
/// assert!(matches!(Chrono { kn: 0.0, ..input }.contact(0.005, 1e-3), Err(MaterialError::NotPositive { .. })));
/// # Ok::<(), MaterialError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chrono {
    /// The argument of `SetKn`, in N/m^(5/2).
    pub kn: f64,
    /// The argument of `SetGn`, in 1/(m^(3/2) s).
    pub gn: f64,
}

impl Chrono {
    /// Returns the input that stands for `pair`.
    ///
    /// # Errors
    ///
    /// [`MaterialError::OutOfRange`], [`MaterialError::Negative`] beyond f64.
    pub fn new(pair: &ViscoelasticContact) -> Result<Self, MaterialError> {
        let contact = pair.contact();
        let kn = in_range("stiffness kn", contact.force_prefactor() / contact.effective_radius())?;
        let gn = 1.5 * pair.dissipative_constant() * (kn / contact.effective_mass());
        Ok(Self { kn, gn: at_least_zero("damping gn", gn)? })
    }

    /// Returns what the input means for particles of the given effective radius (m) and mass (kg).
    ///
    /// # Errors
    ///
    /// [`MaterialError::NotPositive`] or [`MaterialError::Negative`] for values that mean nothing.
    pub fn contact(&self, radius: f64, mass: f64) -> Result<ViscoelasticContact, MaterialError> {
        let rho = positive("stiffness kn", self.kn)? * positive("effective radius", radius)?;
        let a = at_least_zero("damping gn", self.gn)? * (mass / self.kn) / 1.5;
        ViscoelasticContact::new(
            Contact::with_prefactor(radius, mass, rho)?,
            finite("dissipative constant A", a)?,
        )
    }
}

impl fmt::Display for Chrono {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "system.UseMaterialProperties(false);")?;
        writeln!(f, "system.SetContactForceModel(ChSystemSMC::Hertz);")?;
        writeln!(f, "material->SetKn({});", Input(self.kn))?;
        write!(f, "material->SetGn({});", Input(self.gn))
    }
}
