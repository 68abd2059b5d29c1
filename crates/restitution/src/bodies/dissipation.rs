//! The dissipative constant A of a material from its viscosities.

use crate::bodies::error::{at_least_zero, finite};
use crate::{Material, MaterialError};

/// Which formula turns viscosities into the dissipative constant `A`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DissipationFormula {
    /// Eq. (4) of \[RPBS1999\], after \[BSHP1996\].
    ///
    /// ```text
    /// A = (1/3) (3 eta_2 - eta_1)^2 / (3 eta_2 + 2 eta_1) * (1 - nu^2) (1 - 2 nu) / (Y nu^2)
    /// ```
    ///
    /// What most of the literature quotes. It diverges as `nu -> 0` and vanishes at `nu = 1/2`, where nothing
    /// physical happens to the material: keep it to reproduce published values.
    Equation4,
    /// The corrected formula of \[BPG2015\].
    ///
    /// ```text
    /// A = (1/Y) (1 + nu)/(1 - nu) [ (2/3) eta_1 (1 - nu + nu^2) + eta_2 (1 - 2 nu)^2 ]
    /// ```
    ///
    /// Finite for every `nu` in (-1, 1/2); the one to use.
    Goldobin2015,
}

/// Returns the dissipative constant `A`, in s, of a material with viscosities `eta_1` and `eta_2` (Pa s).
///
/// The convention of \[BSHP1996\]: the dissipative stress is
///
/// ```text
/// sigma_ij = eta_1 (e'_ij - delta_ij e'_ll / 3) + eta_2 e'_ll delta_ij
/// ```
///
/// Both formulas give `A = tau` when `eta_1 = tau Y/(1+nu)` and `eta_2 = tau Y/(3(1-2 nu))`, that is when every
/// component of the stress relaxes with one time `tau`; elsewhere they differ. Rounding: a few ulp.
///
/// # Errors
///
/// [`MaterialError::Negative`] for a viscosity below zero, [`MaterialError::FormulaDiverges`] for eq. (4) at
/// `nu = 0`, [`MaterialError::NothingDeforms`] for eq. (4) without any viscosity.
///
/// # Examples
///
/// ```
/// use restitution::{DissipationFormula, Material, MaterialError, dissipative_constant};
///
/// let rubber = Material::new(1e7, 0.25, 1100.0)?;
/// let (eta_1, eta_2) = (1e-4 * 1e7 / 1.25, 1e-4 * 1e7 / 1.5); // one relaxation time of 0.1 ms
/// for formula in [DissipationFormula::Equation4, DissipationFormula::Goldobin2015] {
///     let a = dissipative_constant(&rubber, eta_1, eta_2, formula)?;
///     assert!((a / 1e-4 - 1.0).abs() < 1e-12);
/// }
///
/// let cork = Material::new(3e7, 0.0, 240.0)?;
/// let a = dissipative_constant(&cork, 10.0, 10.0, DissipationFormula::Equation4);
/// assert_eq!(a, Err(MaterialError::FormulaDiverges));
/// # Ok::<(), MaterialError>(())
/// ```
pub fn dissipative_constant(
    material: &Material,
    eta_1: f64,
    eta_2: f64,
    formula: DissipationFormula,
) -> Result<f64, MaterialError> {
    let (eta_1, eta_2) = (at_least_zero("viscosity eta_1", eta_1)?, at_least_zero("viscosity eta_2", eta_2)?);
    let (young, nu) = (material.young(), material.poisson());
    let a = match formula {
        DissipationFormula::Equation4 if nu == 0.0 => return Err(MaterialError::FormulaDiverges),
        DissipationFormula::Equation4 if eta_1 == 0.0 && eta_2 == 0.0 => {
            return Err(MaterialError::NothingDeforms { quantity: "sum 3 eta_2 + 2 eta_1" });
        }
        DissipationFormula::Equation4 => {
            let larger = eta_1.max(eta_2); // the rest are ratios, which neither overflow nor vanish together
            let (shear, bulk) = (eta_1 / larger, eta_2 / larger);
            let viscosity = (3.0 * bulk - shear).powi(2) / (3.0 * bulk + 2.0 * shear) / 3.0;
            viscosity * ((1.0 - nu) * (1.0 + nu) * (1.0 - 2.0 * nu) / nu / nu) * (larger / young)
        }
        DissipationFormula::Goldobin2015 => {
            let shear = 2.0 / 3.0 * eta_1 * (1.0 - nu + nu * nu);
            (1.0 + nu) / (1.0 - nu) * (shear / young + eta_2 / young * (1.0 - 2.0 * nu).powi(2))
        }
    };
    finite("dissipative constant", a)
}

/// Returns the dissipative constant of a contact between two materials, in s.
///
/// Each body takes its share of the compression in proportion to its compliance `D = (1-nu^2)/Y`, and dissipates
/// in proportion to the square of that share:
///
/// ```text
/// A = (A_1 D_1 + A_2 D_2)/(D_1 + D_2)
/// ```
///
/// To first order in the viscosities, as the force law itself (docs/materials.md, "Two materials"). Exact
/// for equal materials; a rigid partner counts with `D = 0`, that is not at all.
///
/// # Errors
///
/// [`MaterialError::Negative`] for a constant below zero.
///
/// # Examples
///
/// ```
/// use restitution::{Material, MaterialError, combined_dissipative_constant};
///
/// let (steel, rubber) = (Material::new(210e9, 0.3, 7800.0)?, Material::new(1e7, 0.49, 1100.0)?);
/// let a = combined_dissipative_constant((&steel, 1e-9), (&rubber, 1e-4))?;
/// assert!((a / 1e-4 - 1.0).abs() < 1e-4); // the rubber does it all
///
/// assert!(matches!(
///     combined_dissipative_constant((&steel, -1e-9), (&rubber, 1e-4)),
///     Err(MaterialError::Negative { .. })
/// ));
/// # Ok::<(), MaterialError>(())
/// ```
pub fn combined_dissipative_constant(
    one: (&Material, f64),
    other: (&Material, f64),
) -> Result<f64, MaterialError> {
    let (d_1, d_2) = (one.0.compliance(), other.0.compliance());
    let a_1 = at_least_zero("dissipative constant", one.1)?;
    let a_2 = at_least_zero("dissipative constant", other.1)?;
    let share = 1.0 / (1.0 + d_2 / d_1);
    Ok(a_2 + share * (a_1 - a_2))
}
