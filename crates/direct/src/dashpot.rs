//! Laws of constant restitution near critical damping, where the exit speed is too small to be integrated.

use crate::equation::shown;
use crate::error::DirectError;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use restitution_law::ForceLaw;
use restitution_real::Ball;

/// A collision with `gamma = (a-1)/2`, the linear dashpot in another coordinate.
///
/// With `X = x^((a+1)/2)` and `dT = sqrt((a+1)/2) x^((a-1)/2) dt` the equation of motion is
///
/// ```text
/// X'' + 2 zeta X' + X = 0,    zeta^2 = u^2/(2 (a+1))
/// ```
///
/// so that zero compression is reached with `epsilon = exp(-pi zeta/sqrt(1 - zeta^2))` if `zeta < 1` and
/// never if `zeta >= 1`. Exact decision, for a rational `u`.
pub(crate) struct Dashpot {
    law: ForceLaw,
    u: BigRational,
    zeta_squared: BigRational,
}

impl Dashpot {
    /// The dashpot that a law and a damping `u >= 0` amount to; `None` for laws with `p != 0`.
    pub(crate) fn of(law: &ForceLaw, u: &BigRational) -> Option<Self> {
        if !law.velocity_exponent().is_zero() || u.is_negative() {
            return None;
        }
        let zeta_squared = u * u / (law.elastic_step() * BigRational::from_integer(2.into()));
        Some(Self { law: law.clone(), u: u.clone(), zeta_squared })
    }

    /// Whether so little speed is left, `epsilon < exp(-12)`, that the integration would lose it.
    pub(crate) fn is_nearly_critical(&self) -> bool {
        self.zeta_squared > BigRational::new(15.into(), 16.into())
    }

    /// The coefficient of restitution at zero compression.
    pub(crate) fn epsilon(&self, prec: u32) -> Result<Ball, DirectError> {
        let epsilon = self.left_over(prec)?;
        if epsilon.is_positive() {
            return Ok(epsilon);
        }
        Err(DirectError::Vanishing { law: Box::new(self.law.clone()), u: self.shown() })
    }

    /// What is lost of the velocity; 1 to any digits where the coefficient is too small to be held.
    pub(crate) fn one_minus_epsilon(&self, prec: u32) -> Result<Ball, DirectError> {
        Ok(Ball::one() - self.left_over(prec)?)
    }

    /// `exp(-pi zeta/sqrt(1 - zeta^2))`, which may be a ball around 0.
    fn left_over(&self, prec: u32) -> Result<Ball, DirectError> {
        let left = BigRational::one() - &self.zeta_squared;
        if !left.is_positive() {
            return Err(DirectError::Overdamped { law: Box::new(self.law.clone()), u: self.shown() });
        }
        // A few bits more carry the size of the exponent.
        let tangent = Ball::from_rational(&(&self.zeta_squared / left), prec + 64).sqrt();
        Ok((-(Ball::pi(prec + 64) * tangent)).exp().with_prec(prec))
    }

    fn shown(&self) -> String {
        shown(&Ball::from_rational(&self.u, 64))
    }
}
