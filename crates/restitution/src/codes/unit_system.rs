/// The `units` of LAMMPS and LIGGGHTS in which granular particles are simulated.
///
/// # Examples
///
/// ```
/// use restitution::codes::UnitSystem;
///
/// assert_eq!(1e7 / UnitSystem::Cgs.pressure(), 1e8); // Pa in dyn/cm^2
/// assert_eq!(UnitSystem::Reduced.damping(), 1.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum UnitSystem {
    /// `units si`: metre, kilogram, second.
    #[default]
    Si,
    /// `units cgs`: centimetre, gram, second.
    Cgs,
    /// `units micro`: micrometre, picogram, microsecond.
    Micro,
    /// `units lj`: numbers without units, taken as they are.
    Reduced,
}

impl UnitSystem {
    /// The size of the unit of pressure, in Pa.
    pub fn pressure(self) -> f64 {
        match self {
            Self::Si | Self::Reduced => 1.0,
            Self::Cgs => 0.1,
            Self::Micro => 1e3,
        }
    }

    /// The size of the unit of the damping `eta_n0`, one over length and time, in 1/(m s).
    pub fn damping(self) -> f64 {
        match self {
            Self::Si | Self::Reduced => 1.0,
            Self::Cgs => 1e2,
            Self::Micro => 1e12,
        }
    }

    /// What the codes call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Si => "si",
            Self::Cgs => "cgs",
            Self::Micro => "micro",
            Self::Reduced => "lj",
        }
    }
}
