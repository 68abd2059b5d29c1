use super::{Input, UnitSystem, from_stiffness_and_damping, plane_strain, stiffness_and_damping};
use crate::bodies::error::{at_least_zero, in_range, positive};
use crate::{End, MaterialError, ViscoelasticContact};
use core::fmt;

/// LAMMPS, `pair_style granular` with `hertz k_n eta_n0` and `damping viscoelastic`.
///
/// ```text
/// rho = k_n sqrt(R_eff),   (3/2) A = eta_n0 m_eff/k_n
/// ```
///
/// `hertz/material E eta_n0 nu` is the same with `k_n = (2/3) E/(1-nu^2)`. Zero compression ends the contact;
/// with `limit_damping` zero force does. `eta_n0` multiplies the effective mass: one value is right for one
/// `m_eff`, and in a mixture of sizes `A` grows in proportion to `m_eff`.
///
/// # Examples
///
/// ```
/// use restitution::codes::LammpsGranular;
/// use restitution::{End, MaterialError};
///
/// let input = LammpsGranular { k_n: 1e7, eta_n0: 2e7, end: End::ZeroForce };
/// let pair = input.contact(0.005, 1e-3)?; // effective radius and mass
/// assert_eq!(pair.dissipative_constant(), 2e7 * 1e-3 / 1e7 / 1.5);
/// assert_eq!(LammpsGranular::new(&pair, input.end)?, input);
/// assert!(input.to_string().ends_with("damping viscoelastic limit_damping"));
///
/// let wrong = LammpsGranular { k_n: -1e7, ..input };
/// assert!(matches!(wrong.contact(0.005, 1e-3), Err(MaterialError::NotPositive { .. })));
/// # Ok::<(), MaterialError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LammpsGranular {
    /// The stiffness `k_n`, in Pa.
    pub k_n: f64,
    /// The damping `eta_n0`, in 1/(m s).
    pub eta_n0: f64,
    /// Zero force stands for `limit_damping`.
    pub end: End,
}

impl LammpsGranular {
    /// Returns the input that stands for `pair`.
    ///
    /// # Errors
    ///
    /// [`MaterialError::OutOfRange`], [`MaterialError::Negative`] beyond f64.
    pub fn new(pair: &ViscoelasticContact, end: End) -> Result<Self, MaterialError> {
        let (k_n, eta_n0) = stiffness_and_damping(pair)?;
        Ok(Self { k_n, eta_n0, end })
    }

    /// Returns the line for a wall, here the plane z = 0: `pair_coeff` says nothing about walls.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution::End;
    /// use restitution::codes::LammpsGranular;
    ///
    /// let input = LammpsGranular { k_n: 1e7, eta_n0: 2e7, end: End::ZeroCompression };
    /// assert!(input.wall_line().starts_with("fix wall all wall/gran granular hertz 1e7 2e7"));
    /// ```
    pub fn wall_line(&self) -> std::string::String {
        std::format!("fix wall all wall/gran granular {} zplane 0.0 NULL", self.model())
    }

    /// Returns the `pair_coeff` of two types, such as `1 2` or `* *`.
    pub fn pair_line(&self, types: &str) -> std::string::String {
        std::format!("pair_coeff {types} {}", self.model())
    }

    fn model(&self) -> std::string::String {
        let (k_n, eta_n0) = (Input(self.k_n), Input(self.eta_n0));
        let limit = if self.end == End::ZeroForce { " limit_damping" } else { "" };
        std::format!("hertz {k_n} {eta_n0} tangential linear_nohistory 0 0 damping viscoelastic{limit}")
    }

    /// Returns the same input with its numbers in another system of units.
    #[must_use]
    pub fn in_units(self, units: UnitSystem) -> Self {
        let (k_n, eta_n0) = (self.k_n / units.pressure(), self.eta_n0 / units.damping());
        Self { k_n, eta_n0, ..self }
    }

    /// Returns the input of `hertz/material E eta_n0 nu`, where Young's modulus and Poisson's ratio give `k_n`.
    ///
    /// # Errors
    ///
    /// [`MaterialError::PoissonRatio`] outside (-1, 1/2), [`MaterialError::NotPositive`] or
    /// [`MaterialError::Negative`] for a modulus or a damping that means nothing, [`MaterialError::OutOfRange`].
    pub fn of_material(young: f64, poisson: f64, eta_n0: f64, end: End) -> Result<Self, MaterialError> {
        let k_n = 2.0 / 3.0 * positive("Young modulus", young)? / plane_strain(poisson)?;
        Ok(Self {
            k_n: in_range("stiffness k_n", k_n)?,
            eta_n0: at_least_zero("damping eta_n0", eta_n0)?,
            end,
        })
    }

    /// Returns what the input means for particles of the given effective radius (m) and mass (kg).
    ///
    /// # Errors
    ///
    /// [`MaterialError::NotPositive`] or [`MaterialError::Negative`] for values that mean nothing.
    pub fn contact(&self, radius: f64, mass: f64) -> Result<ViscoelasticContact, MaterialError> {
        from_stiffness_and_damping((self.k_n, self.eta_n0), radius, mass)
    }
}

impl fmt::Display for LammpsGranular {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "pair_style granular")?;
        f.write_str(&self.pair_line("* *"))
    }
}

/// LAMMPS, the classic `pair_style gran/hertz/history Kn Kt gamma_n gamma_t xmu dampflag`.
///
/// The same force as [`LammpsGranular`] with `gamma_n = eta_n0`; zero compression ends the contact.
///
/// # Examples
///
/// ```
/// use restitution::codes::LammpsHertzHistory;
/// use restitution::MaterialError;
///
/// let input = LammpsHertzHistory { kn: 1e7, gamma_n: 2e7 };
/// assert_eq!(LammpsHertzHistory::new(&input.contact(0.005, 1e-3)?)?, input);
///
/// let wrong = LammpsHertzHistory { gamma_n: f64::NAN, ..input };
/// assert!(matches!(wrong.contact(0.005, 1e-3), Err(MaterialError::Negative { .. })));
/// # Ok::<(), MaterialError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LammpsHertzHistory {
    /// The stiffness `Kn`, in Pa.
    pub kn: f64,
    /// The damping `gamma_n`, in 1/(m s).
    pub gamma_n: f64,
}

impl LammpsHertzHistory {
    /// Returns the input that stands for `pair`.
    ///
    /// # Errors
    ///
    /// As [`LammpsGranular::new`].
    pub fn new(pair: &ViscoelasticContact) -> Result<Self, MaterialError> {
        let (kn, gamma_n) = stiffness_and_damping(pair)?;
        Ok(Self { kn, gamma_n })
    }

    /// Returns what the input means for particles of the given effective radius (m) and mass (kg).
    ///
    /// # Errors
    ///
    /// As [`LammpsGranular::contact`].
    pub fn contact(&self, radius: f64, mass: f64) -> Result<ViscoelasticContact, MaterialError> {
        from_stiffness_and_damping((self.kn, self.gamma_n), radius, mass)
    }
}

impl LammpsHertzHistory {
    /// Returns the line for a wall, here the plane z = 0: `pair_style` says nothing about walls.
    pub fn wall_line(&self) -> std::string::String {
        let (kn, gamma_n) = (Input(self.kn), Input(self.gamma_n));
        std::format!("fix wall all wall/gran hertz/history {kn} NULL {gamma_n} NULL 0 0 zplane 0.0 NULL")
    }

    /// Returns the same input with its numbers in another system of units.
    #[must_use]
    pub fn in_units(self, units: UnitSystem) -> Self {
        Self { kn: self.kn / units.pressure(), gamma_n: self.gamma_n / units.damping() }
    }
}

impl fmt::Display for LammpsHertzHistory {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "pair_style gran/hertz/history {} NULL {} NULL 0 0",
            Input(self.kn),
            Input(self.gamma_n)
        )?;
        write!(f, "pair_coeff * *")
    }
}
