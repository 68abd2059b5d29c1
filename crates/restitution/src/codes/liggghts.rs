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

    /// Returns the lines of two types of particles, with the inputs of the pairs 1 1, 1 2 and 2 2.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution::End;
    /// use restitution::codes::Liggghts;
    ///
    /// let input = |gamman| Liggghts { kn: 1e7, gamman, end: End::ZeroForce };
    /// let lines = Liggghts::lines_of_two_types([input(1e7), input(2e7), input(3e7)]);
    /// assert!(lines.contains("gamman peratomtypepair 2 1e7 2e7 2e7 3e7"));
    /// assert!(lines.contains("limitForce on"));
    /// ```
    pub fn lines_of_two_types(pairs: [Self; 3]) -> std::string::String {
        let of = |value: fn(&Self) -> f64| {
            let [one, met, other] = pairs.each_ref().map(|pair| Input(value(pair)));
            std::format!("2 {one} {met} {met} {other}")
        };
        pairs[1].lines(&[
            ("kn", of(|pair| pair.kn)),
            ("kt", of(|_| 0.0)),
            ("gamman", of(|pair| pair.gamman)),
            ("gammat", of(|_| 0.0)),
            ("coefficientFriction", of(|_| 0.0)),
        ])
    }

    fn lines(&self, properties: &[(&str, std::string::String)]) -> std::string::String {
        let head = std::format!("pair_style gran {MODEL} limitForce {}\npair_coeff * *", self.limit());
        let lines = properties.iter().map(|(name, values)| {
            std::format!("\nfix {name} all property/global {name} peratomtypepair {values}")
        });
        head + &lines.collect::<std::string::String>()
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
        let one = |value| std::format!("1 {}", Input(value));
        f.write_str(&self.lines(&[
            ("kn", one(self.kn)),
            ("kt", one(0.0)),
            ("gamman", one(self.gamman)),
            ("gammat", one(0.0)),
            ("coefficientFriction", one(0.0)),
        ]))
    }
}
