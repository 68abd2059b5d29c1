use super::{Input, UnitSystem, from_stiffness_and_damping, stiffness_and_damping};
use crate::{End, MaterialError, ViscoelasticContact};
use core::fmt;

/// What stands in the lines for pairs and walls alike.
const MODEL: &str = "model hertz/stiffness tangential no_history";

/// LIGGGHTS, `pair_style gran model hertz/stiffness` with the properties `kn` and `gamman`.
///
/// The same force as [`LammpsGranular`](super::LammpsGranular) with `gamman = eta_n0`; `limitForce off`, the
/// default, ends the contact at zero compression, `limitForce on` at zero force. (`model hertz` takes a
/// coefficient of restitution instead and makes it independent of velocity: [`ConstantRestitution`](super::ConstantRestitution).)
///
/// # Examples
///
/// ```
/// use restitution::codes::Liggghts;
/// use restitution::{End, MaterialError};
///
/// let input = Liggghts { kn: 1e7, gamman: 2e7, end: End::ZeroCompression };
/// assert_eq!(Liggghts::new(&input.contact(0.005, 1e-3)?, input.end)?, input);
///
/// assert!(matches!(input.contact(0.005, 0.0), Err(MaterialError::NotPositive { .. })));
/// # Ok::<(), MaterialError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Liggghts {
    /// The stiffness `kn`, in Pa.
    pub kn: f64,
    /// The damping `gamman`, in 1/(m s).
    pub gamman: f64,
    /// Zero force stands for `limitForce on`.
    pub end: End,
}

impl Liggghts {
    /// Returns the input that stands for `pair`.
    ///
    /// # Errors
    ///
    /// As [`LammpsGranular::new`](super::LammpsGranular::new).
    pub fn new(pair: &ViscoelasticContact, end: End) -> Result<Self, MaterialError> {
        let (kn, gamman) = stiffness_and_damping(pair)?;
        Ok(Self { kn, gamman, end })
    }

    /// Returns what the input means for particles of the given effective radius (m) and mass (kg).
    ///
    /// # Errors
    ///
    /// As [`LammpsGranular::contact`](super::LammpsGranular::contact).
    pub fn contact(&self, radius: f64, mass: f64) -> Result<ViscoelasticContact, MaterialError> {
        from_stiffness_and_damping((self.kn, self.gamman), radius, mass)
    }
}

impl Liggghts {
    /// Returns the line for a wall, here the plane z = 0, of the material of the particles.
    pub fn wall_line(&self) -> std::string::String {
        let limit = self.limit();
        std::format!("fix wall all wall/gran {MODEL} primitive type 1 zplane 0.0 limitForce {limit}")
    }

    fn limit(&self) -> &'static str {
        if self.end == End::ZeroForce { "on" } else { "off" }
    }

    /// Returns the same input with its numbers in another system of units.
    #[must_use]
    pub fn in_units(self, units: UnitSystem) -> Self {
        let (kn, gamman) = (self.kn / units.pressure(), self.gamman / units.damping());
        Self { kn, gamman, ..self }
    }
}

impl fmt::Display for Liggghts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "pair_style gran {MODEL} limitForce {}", self.limit())?;
        writeln!(f, "pair_coeff * *")?;
        let property = |name: &str, value: f64| {
            format!("fix {name} all property/global {name} peratomtypepair 1 {}", Input(value))
        };
        writeln!(f, "{}", property("kn", self.kn))?;
        writeln!(f, "{}", property("kt", 0.0))?;
        writeln!(f, "{}", property("gamman", self.gamman))?;
        writeln!(f, "{}", property("gammat", 0.0))?;
        write!(f, "{}", property("coefficientFriction", 0.0))
    }
}
