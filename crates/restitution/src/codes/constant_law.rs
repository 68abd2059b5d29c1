use crate::bodies::error::{at_least_zero, finite};
use crate::{End, MaterialError};
use core::f64::consts::PI;

/// The damping `xi^(1/4)` that makes the coefficient of restitution independent of velocity.
///
/// What LIGGGHTS `model hertz`, LAMMPS `damping tsuji` and `coeff_restitution` and YADE's `betan` use. With the scaled
/// equation `x'' + c x^(1/4) x' + x^(3/2) = 0` (eq. 12 of \[RPBS1999\] for `a = 3/2`) and `zeta = c/sqrt(5)`:
///
/// ```text
/// zero compression:  epsilon = exp(-pi zeta/sqrt(1-zeta^2))
/// zero force:        epsilon = exp(-2 zeta/sqrt(1-zeta^2) acos(zeta))
///                            = exp(-2 zeta/sqrt(zeta^2-1) ln(zeta + sqrt(zeta^2-1)))   for zeta > 1
/// ```
///
/// The variable `x^(5/4)` turns the equation into a linear spring and dashpot, zero force into its zero force. Not
/// the damping of a viscoelastic body.
///
/// # Examples
///
/// ```
/// use restitution::codes::ConstantRestitution;
/// use restitution::{End, MaterialError};
///
/// let nominal = ConstantRestitution::of_epsilon(0.7)?; // at zero compression, as the codes define it
/// assert!((nominal.epsilon(End::ZeroForce) - 0.71820).abs() < 1e-5);
///
/// assert_eq!(ConstantRestitution::of_epsilon(0.0), Err(MaterialError::Epsilon { value: 0.0 }));
/// # Ok::<(), MaterialError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstantRestitution {
    pub(super) zeta: f64,
}

impl ConstantRestitution {
    /// Returns the law that rebounds with `epsilon` at zero compression.
    ///
    /// # Errors
    ///
    /// [`MaterialError::Epsilon`] unless `0 < epsilon < 1`.
    pub fn of_epsilon(epsilon: f64) -> Result<Self, MaterialError> {
        if !(epsilon > 0.0 && epsilon < 1.0) {
            return Err(MaterialError::Epsilon { value: epsilon });
        }
        let logarithm = epsilon.ln();
        Ok(Self { zeta: -logarithm / logarithm.hypot(PI) })
    }

    /// Returns the law of YADE's damping ratio `betan`: `c = 2 sqrt(3/2) betan`.
    ///
    /// # Errors
    ///
    /// [`MaterialError::Negative`] below zero, [`MaterialError::OutOfRange`] if `zeta` is beyond f64.
    pub fn of_betan(betan: f64) -> Result<Self, MaterialError> {
        let zeta = 2.0 * 0.3_f64.sqrt() * at_least_zero("damping ratio betan", betan)?;
        Ok(Self { zeta: finite("damping ratio zeta", zeta)? })
    }

    /// Returns the law that rebounds with `epsilon` at the given end: what a code has to be told as its nominal value is
    /// [`epsilon`](Self::epsilon) of it at zero compression.
    ///
    /// # Errors
    ///
    /// [`MaterialError::Epsilon`] unless `0 < epsilon < 1`.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution::codes::ConstantRestitution;
    /// use restitution::{End, MaterialError};
    ///
    /// let law = ConstantRestitution::that_gives(0.7, End::ZeroForce)?;
    /// assert!((law.epsilon(End::ZeroForce) - 0.7).abs() < 1e-14);
    /// assert!(law.epsilon(End::ZeroCompression) < 0.7); // the nominal value
    ///
    /// assert_eq!(ConstantRestitution::that_gives(1.0, End::ZeroForce), Err(MaterialError::Epsilon { value: 1.0 }));
    /// # Ok::<(), MaterialError>(())
    /// ```
    pub fn that_gives(epsilon: f64, end: End) -> Result<Self, MaterialError> {
        let nominal = Self::of_epsilon(epsilon)?;
        if end == End::ZeroCompression {
            return Ok(nominal);
        }
        // the coefficient falls with zeta, and ending earlier raises it
        let (mut low, mut high) = (nominal.zeta, 2.0 * nominal.zeta);
        while (Self { zeta: high }).epsilon(end) > epsilon {
            high *= 2.0;
        }
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                return Ok(Self { zeta: middle });
            }
            if (Self { zeta: middle }).epsilon(end) > epsilon { low = middle } else { high = middle }
        }
    }

    /// Returns the law of `damping tsuji` of LAMMPS 22Jul2025, told `nominal`.
    ///
    /// Its polynomial for the damping lacks a factor of the square root of 2, which later sources have: told 0.7, it rebounds with 0.7777.
    ///
    /// # Errors
    ///
    /// [`MaterialError::Epsilon`] unless `0 < nominal < 1`.
    pub fn of_lammps_tsuji(nominal: f64) -> Result<Self, MaterialError> {
        const ALPHA: [f64; 7] = [1.2728, -4.2783, 11.087, -22.348, 27.467, -18.022, 4.8218];
        if !(nominal > 0.0 && nominal < 1.0) {
            return Err(MaterialError::Epsilon { value: nominal });
        }
        let alpha = ALPHA.iter().rev().fold(0.0, |sum, c| sum * nominal + c);
        Ok(Self { zeta: alpha.max(0.0) / 5.0_f64.sqrt() })
    }

    /// YADE's damping ratio.
    pub fn betan(&self) -> f64 {
        self.zeta / (2.0 * 0.3_f64.sqrt())
    }

    /// The damping ratio `zeta` of the equivalent linear spring and dashpot.
    pub fn zeta(&self) -> f64 {
        self.zeta
    }

    /// The coefficient of restitution; 0 at zero compression from critical damping, `zeta = 1`, on.
    pub fn epsilon(&self, end: End) -> f64 {
        let zeta = self.zeta;
        match end {
            End::ZeroCompression if zeta >= 1.0 => 0.0,
            End::ZeroCompression => (-PI * zeta / ((1.0 - zeta) * (1.0 + zeta)).sqrt()).exp(),
            End::ZeroForce if zeta < 1.0 => {
                let root = ((1.0 - zeta) * (1.0 + zeta)).sqrt();
                (-2.0 * root.atan2(zeta) * (zeta / root)).exp()
            }
            End::ZeroForce if zeta == 1.0 => (-2.0_f64).exp(),
            End::ZeroForce => {
                let share = ((1.0 - 1.0 / zeta) * (1.0 + 1.0 / zeta)).sqrt(); // sqrt(zeta^2 - 1)/zeta, of any zeta
                (-2.0 * (zeta.ln() + share.ln_1p()) / share).exp()
            }
        }
    }
}
