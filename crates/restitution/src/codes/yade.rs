use super::{Input, plane_strain};
use crate::bodies::error::{finite, positive};
use crate::{Contact, End, MaterialError, ViscoelasticContact, fifth_root};
use core::fmt;

/// Numerator and denominator of the [3/6] Padé approximant of \[MP2011\] in `v = sqrt(u)`, zero-force end, with the six
/// digits that are printed and that YADE carries. Six digits on purpose: YADE inverts this formula, not epsilon.
const NUMERATOR: [f64; 4] = [1.0, 1.07232, 0.574198, 0.141552];
const DENOMINATOR: [f64; 7] = [1.0, 1.07232, 1.72765, 1.37842, 1.19449, 0.467273, 0.235585];

/// YADE 2025 and later, `Ip2_FrictMat_FrictMat_MindlinPhys(en, vn)`.
///
/// YADE takes the coefficient `en` at impact velocity `vn`, solves its six-digit [3/6] formula for `v` and damps with
///
/// ```text
/// u = v^2 (g/vn)^(1/5)
/// ```
///
/// whatever the stiffness; zero force ends the contact. The rebound at `vn` is therefore not quite `en`: the
/// formula is off by what [`formula_error`](Self::formula_error) says. [`new`](Self::new) gives the `en`
/// that makes YADE use the wanted `u`.
///
/// # Examples
///
/// ```
/// use restitution::codes::Yade;
/// use restitution::{End, MaterialError};
///
/// let input = Yade::measured(0.5, 0.1, 1e9)?; // epsilon = 0.5 at 0.1 m/s, effective modulus 1 GPa
/// assert!((input.epsilon(0.1)? - 0.5).abs() < 1e-14);
/// assert!((input.en - 0.5).abs() < 1e-4); // the formula's own error
///
/// assert_eq!(Yade::measured(1.2, 0.1, 1e9), Err(MaterialError::Epsilon { value: 1.2 }));
/// # Ok::<(), MaterialError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Yade {
    /// The coefficient of restitution `en` that YADE aims at.
    pub en: f64,
    /// The impact velocity `vn`, in m/s.
    pub vn: f64,
    /// The effective modulus `E`, in Pa, of which YADE's `young` and `poisson` make `kno = (4/3) E sqrt(R_eff)`.
    pub effective_modulus: f64,
}

impl Yade {
    /// Returns the input that stands for `pair`, with `vn` as the reference velocity.
    ///
    /// # Errors
    ///
    /// [`MaterialError::NotPositive`] for a velocity that is not positive, [`MaterialError::Epsilon`] without damping.
    pub fn new(pair: &ViscoelasticContact, vn: f64) -> Result<Self, MaterialError> {
        let en = formula(pair.u(positive("velocity vn", vn)?)?.sqrt());
        Self { en, vn, effective_modulus: pair.contact().effective_modulus() }.checked()
    }

    /// Returns the input with which YADE's spheres rebound with `epsilon` at velocity `vn`.
    ///
    /// # Errors
    ///
    /// [`MaterialError::Epsilon`] unless `0 < epsilon < 1`; [`MaterialError::NotPositive`].
    pub fn measured(epsilon: f64, vn: f64, effective_modulus: f64) -> Result<Self, MaterialError> {
        if !(epsilon > 0.0 && epsilon < 1.0) {
            return Err(MaterialError::Epsilon { value: epsilon });
        }
        Self { en: formula(crate::u_of_epsilon(epsilon, End::ZeroForce).sqrt()), vn, effective_modulus }
            .checked()
    }

    /// Returns the input of spheres with `young` (Pa) and `poisson` as YADE takes them.
    ///
    /// # Errors
    ///
    /// [`MaterialError::PoissonRatio`], [`MaterialError::NotPositive`], [`MaterialError::Epsilon`].
    pub fn of_material(en: f64, vn: f64, young: f64, poisson: f64) -> Result<Self, MaterialError> {
        Self { en, vn, effective_modulus: 0.5 * young / plane_strain(poisson)? }.checked()
    }

    fn checked(self) -> Result<Self, MaterialError> {
        positive("velocity vn", self.vn)?;
        positive("effective modulus", self.effective_modulus)?;
        if self.en > 0.0 && self.en < 1.0 { Ok(self) } else { Err(MaterialError::Epsilon { value: self.en }) }
    }

    /// The damping parameter `u` at impact velocity `velocity` (m/s) that YADE uses with this input.
    ///
    /// # Errors
    ///
    /// [`MaterialError::Epsilon`] unless `0 < en < 1`, [`MaterialError::NotPositive`], [`MaterialError::OutOfRange`].
    pub fn u(&self, velocity: f64) -> Result<f64, MaterialError> {
        let ratio = positive("velocity", velocity)? / self.checked()?.vn;
        finite("damping parameter u", inverse_formula(self.en).powi(2) * fifth_root(ratio))
    }

    /// The coefficient of restitution at impact velocity `velocity` (m/s) that the input means.
    ///
    /// # Errors
    ///
    /// As [`u`](Self::u).
    pub fn epsilon(&self, velocity: f64) -> Result<f64, MaterialError> {
        Ok(crate::epsilon(self.u(velocity)?, End::ZeroForce))
    }

    /// By how much the rebound at `vn` exceeds `en`.
    ///
    /// # Errors
    ///
    /// As [`u`](Self::u).
    pub fn formula_error(&self) -> Result<f64, MaterialError> {
        Ok(self.epsilon(self.vn)? - self.en)
    }

    /// Returns what the input means for particles of the given effective radius (m) and mass (kg).
    ///
    /// # Errors
    ///
    /// As [`u`](Self::u), and [`MaterialError::OutOfRange`].
    pub fn contact(&self, radius: f64, mass: f64) -> Result<ViscoelasticContact, MaterialError> {
        let contact = Contact::new(radius, mass, self.checked()?.effective_modulus)?;
        let a = self.u(self.vn)? / (1.5 * contact.rate() * fifth_root(self.vn));
        ViscoelasticContact::new(contact, finite("dissipative constant A", a)?)
    }
}

impl fmt::Display for Yade {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (en, vn) = (Input(self.en), Input(self.vn));
        writeln!(f, "# FrictMat: young/(2*(1 - poisson**2)) = {}", Input(self.effective_modulus))?;
        write!(f, "Ip2_FrictMat_FrictMat_MindlinPhys(en={en}, vn={vn})")
    }
}

/// The six-digit [3/6] formula at `v = sqrt(u)`, falling from 1 at 0 to 0.
fn formula(v: f64) -> f64 {
    let horner = |c: &[f64], v: f64| c.iter().rev().fold(0.0, |sum, c| sum * v + c);
    if v <= 1.0 {
        return horner(&NUMERATOR, v) / horner(&DENOMINATOR, v);
    }
    // in powers of 1/v, so that nothing overflows
    let reversed = |c: &[f64]| c.iter().fold(0.0, |sum, c| sum / v + c);
    reversed(&NUMERATOR) / reversed(&DENOMINATOR) / v / v / v
}

/// Solves `formula(v) = en` for `0 < en < 1`.
///
/// Bisection in the logarithm of `v`, to the last bit: the formula falls, so this is YADE's root.
fn inverse_formula(en: f64) -> f64 {
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    while formula(high) > en {
        low = high;
        high *= 2.0;
    }
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return high;
        }
        if formula(middle) > en { low = middle } else { high = middle }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_formula_falls_and_is_inverted() {
        let mut last = 1.0;
        for k in 1..2000 {
            let v = f64::from(k) * 0.01;
            let en = formula(v);
            assert!(en < last, "v = {v}");
            assert!((inverse_formula(en) / v - 1.0).abs() < 1e-12, "v = {v}");
            last = en;
        }
        assert!(inverse_formula(1e-300).is_finite());
    }
}
