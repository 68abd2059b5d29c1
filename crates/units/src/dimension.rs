use core::fmt;

/// What kind of quantity a number is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// A velocity, in m/s.
    Velocity,
    /// A length, in m.
    Length,
    /// A time, in s.
    Time,
    /// A mass, in kg.
    Mass,
    /// A mass density, in kg/m^3.
    Density,
    /// An elastic modulus or pressure, in Pa.
    Modulus,
    /// A viscosity, in Pa s.
    Viscosity,
    /// An acceleration, in m/s^2.
    Acceleration,
}

impl Dimension {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Velocity,
        Self::Length,
        Self::Time,
        Self::Mass,
        Self::Density,
        Self::Modulus,
        Self::Viscosity,
        Self::Acceleration,
    ];

    /// The powers of metre, kilogram and second.
    pub(crate) fn powers(self) -> [i32; 3] {
        match self {
            Self::Velocity => [1, 0, -1],
            Self::Length => [1, 0, 0],
            Self::Time => [0, 0, 1],
            Self::Mass => [0, 1, 0],
            Self::Density => [-3, 1, 0],
            Self::Modulus => [-1, 1, -2],
            Self::Viscosity => [-1, 1, -1],
            Self::Acceleration => [1, 0, -2],
        }
    }

    /// Units to choose from, the SI unit first, as messages show them.
    pub fn examples(self) -> &'static [&'static str] {
        match self {
            Self::Velocity => &["m/s", "km/s", "cm/s", "mm/s", "um/s", "km/h", "ft/s"],
            Self::Length => &["m", "km", "cm", "mm", "um", "nm", "in", "ft"],
            Self::Time => &["s", "ms", "us", "ns", "min", "h"],
            Self::Mass => &["kg", "g", "mg", "ug", "t", "lb"],
            Self::Density => &["kg/m^3", "g/cm^3", "lb/ft^3"],
            Self::Modulus => &["Pa", "kPa", "MPa", "GPa", "bar", "psi"],
            Self::Viscosity => &["Pa s", "mPa s", "kPa s", "MPa s", "GPa s", "P"],
            Self::Acceleration => &["m/s^2", "cm/s^2", "mm/s^2"],
        }
    }

    /// The SI unit.
    pub fn si(self) -> &'static str {
        self.examples()[0]
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Velocity => "velocity",
            Self::Length => "length",
            Self::Time => "time",
            Self::Mass => "mass",
            Self::Density => "density",
            Self::Modulus => "modulus",
            Self::Viscosity => "viscosity",
            Self::Acceleration => "acceleration",
        })
    }
}
