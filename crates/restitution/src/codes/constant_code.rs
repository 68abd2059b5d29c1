use super::ConstantRestitution;
use crate::bodies::error::at_least_zero;
use crate::{End, MaterialError};
use core::f64::consts::PI;

/// What Lethe's source has for the square of pi, for 2/3 and for `2 sqrt(5/6)`.
const LETHE: [f64; 3] = [9.8696, 0.66665, 1.8257];
/// The polynomial for `ln((1 - 1/(1 + gamma^2))/(1 + e)^2)` over `e` of Thornton, Cummins and Cleary (2013), as Kratos has it.
const KRATOS: [f64; 10] = [
    -6.918798, -16.41105, 146.8049, -796.4559, 2928.711, -7206.864, 11494.29, -11342.18, 6276.757, -1489.915,
];
/// The coefficients between which Kratos evaluates it.
const KRATOS_RANGE: (f64, f64) = (0.001, 0.999);

/// The codes that take a coefficient of restitution, or a damping ratio, for Hertz's force with the damping `xi^(1/4)`.
///
/// What each of them damps with when it is told `e`, in the variables of [`ConstantRestitution`], with
/// `beta(e) = -ln(e)/sqrt(ln(e)^2 + pi^2)`:
///
/// ```text
/// LAMMPS (coeff_restitution), LIGGGHTS, Chrono, DEM-Engine    zeta = beta(e)
/// Lethe            zeta = 1.8257/sqrt(5 * 0.66665) beta(e), with pi^2 = 9.8696 in beta
/// MFiX             zeta = 2/sqrt(5) beta(e): that of a linear spring, so that e comes out too large
/// Kratos           zeta = 2 sqrt(3/10) gamma(e), gamma the fit of Thornton, Cummins and Cleary (2013) for the end at zero force
/// YADE             zeta = 2 sqrt(3/10) betan
/// TrixiParticles   zeta = -2/sqrt(5) damping_coefficient: its dashpot pushes along the relative velocity
/// ```
///
/// LAMMPS, LIGGGHTS, YADE and Kratos were run; the others were read in their sources (docs/codes.md).
///
/// # Examples
///
/// ```
/// use restitution::codes::{ConstantCode, ConstantRestitution};
/// use restitution::{End, MaterialError};
///
/// let told = ConstantCode::Mfix.law(0.7)?;
/// assert!((told.epsilon(End::ZeroCompression) - 0.7272).abs() < 1e-4);
///
/// let wanted = ConstantRestitution::of_epsilon(0.7)?;
/// assert!((ConstantCode::Mfix.input(&wanted)? - 0.6707).abs() < 1e-4); // what MFiX has to be told
/// let too_small = ConstantRestitution::of_epsilon(1e-3)?;
/// assert!(matches!(ConstantCode::Mfix.input(&too_small), Err(MaterialError::EpsilonNotOffered { .. })));
/// # Ok::<(), MaterialError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ConstantCode {
    /// LAMMPS, `pair_style granular`, `damping coeff_restitution`.
    Lammps,
    /// LIGGGHTS, `model hertz`.
    Liggghts,
    /// Project Chrono, smooth contacts with material properties, `ContactForceModel::Hertz`.
    Chrono,
    /// Chrono's DEM-Engine, the built-in Hertzian models.
    DemEngine,
    /// Lethe, `hertz_mindlin_limit_overlap`, `hertz_mindlin_limit_force` and `hertz`.
    Lethe,
    /// MFiX, `DES_COLL_MODEL = 'HERTZIAN'`.
    Mfix,
    /// Kratos, `DEM_D_Hertz_viscous_Coulomb`.
    Kratos,
    /// YADE, `Ip2_FrictMat_FrictMat_MindlinPhys`, whose input `betan` is a damping ratio.
    Yade,
    /// TrixiParticles, `HertzContactModel`, whose input is no coefficient but a damping ratio.
    TrixiParticles,
}

impl ConstantCode {
    /// The name of the code.
    pub fn name(self) -> &'static str {
        match self {
            Self::Lammps => "LAMMPS",
            Self::Liggghts => "LIGGGHTS",
            Self::Chrono => "Chrono",
            Self::DemEngine => "DEM-Engine",
            Self::Lethe => "Lethe",
            Self::Mfix => "MFiX",
            Self::Kratos => "Kratos",
            Self::Yade => "YADE",
            Self::TrixiParticles => "TrixiParticles",
        }
    }

    /// Where the code ends a contact, its default first.
    pub fn ends(self) -> &'static [End] {
        match self {
            Self::Lammps | Self::Liggghts => &[End::ZeroCompression, End::ZeroForce],
            Self::Chrono | Self::Kratos | Self::Yade => &[End::ZeroForce],
            Self::DemEngine | Self::Lethe | Self::Mfix | Self::TrixiParticles => &[End::ZeroCompression],
        }
    }

    /// Returns what the code does when it is told `input`.
    ///
    /// # Errors
    ///
    /// [`MaterialError::Epsilon`] unless `0 < input < 1`; [`MaterialError::Negative`] for a damping ratio of YADE below 0, and for one of
    /// TrixiParticles above 0, with which its spheres part faster than they met.
    pub fn law(self, input: f64) -> Result<ConstantRestitution, MaterialError> {
        if self == Self::TrixiParticles {
            return Ok(ConstantRestitution {
                zeta: 2.0 / 5.0_f64.sqrt()
                    * at_least_zero("damping_coefficient with its sign changed", -input)?,
            });
        }
        if self == Self::Yade {
            return ConstantRestitution::of_betan(input);
        }
        let exact = ConstantRestitution::of_epsilon(input)?;
        Ok(match self {
            Self::Lethe => {
                let [pi_squared, stiffness, damping] = LETHE;
                let logarithm = -input.ln();
                let beta = logarithm / (logarithm * logarithm + pi_squared).sqrt();
                ConstantRestitution { zeta: damping / (5.0 * stiffness).sqrt() * beta }
            }
            Self::Mfix => ConstantRestitution { zeta: 2.0 / 5.0_f64.sqrt() * exact.zeta },
            Self::Kratos => ConstantRestitution { zeta: 2.0 * 0.3_f64.sqrt() * kratos_gamma(input) },
            _ => exact,
        })
    }

    /// Returns what the code has to be told to do as `law` does.
    ///
    /// # Errors
    ///
    /// [`MaterialError::EpsilonNotOffered`] for a coefficient that no input makes.
    pub fn input(self, law: &ConstantRestitution) -> Result<f64, MaterialError> {
        let zeta = law.zeta;
        let input = match self {
            Self::Yade => return Ok(law.betan()),
            Self::TrixiParticles => return Ok(-0.5 * 5.0_f64.sqrt() * zeta),
            Self::Lethe => {
                let [pi_squared, stiffness, damping] = LETHE;
                of_beta(zeta * (5.0 * stiffness).sqrt() / damping, pi_squared.sqrt())
            }
            Self::Mfix => of_beta(0.5 * 5.0_f64.sqrt() * zeta, PI),
            Self::Kratos => kratos_input(law.betan()),
            _ => of_beta(zeta, PI),
        };
        let end = if zeta < 1.0 { self.ends()[0] } else { End::ZeroForce };
        input
            .filter(|input| (1e-9..1.0).contains(input))
            .ok_or(MaterialError::EpsilonNotOffered { code: self.name(), value: law.epsilon(end) })
    }
}

/// `e` of `beta(e) = -ln(e)/sqrt(ln(e)^2 + pi^2)`.
fn of_beta(beta: f64, pi: f64) -> Option<f64> {
    (beta < 1.0).then(|| (-pi * beta / ((1.0 - beta) * (1.0 + beta)).sqrt()).exp())
}

/// Kratos' damping ratio of a coefficient.
fn kratos_gamma(e: f64) -> f64 {
    let (low, high) = KRATOS_RANGE;
    if e > high {
        return 0.0;
    }
    let e = e.max(low);
    let alpha = e * KRATOS.iter().rev().fold(0.0, |sum, c| sum * e + c);
    (1.0 / (1.0 - (1.0 + e) * (1.0 + e) * alpha.exp()) - 1.0).sqrt()
}

/// The coefficient to which Kratos gives the damping ratio `gamma`, which falls with it.
fn kratos_input(gamma: f64) -> Option<f64> {
    let (mut low, mut high) = KRATOS_RANGE;
    if !(kratos_gamma(high)..=kratos_gamma(low)).contains(&gamma) {
        return None;
    }
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return Some(middle);
        }
        if kratos_gamma(middle) > gamma { low = middle } else { high = middle }
    }
}
