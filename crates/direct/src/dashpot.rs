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

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(n: i64, d: i64) -> BigRational {
        BigRational::new(n.into(), d.into())
    }

    fn dashpot(law: &str, u: BigRational) -> Option<Dashpot> {
        Dashpot::of(&law.parse().unwrap(), &u)
    }

    /// `exp(-pi zeta/sqrt(1 - zeta^2))` with `zeta^2 = u^2/(2 (a+1))`: 0.36 and 0.98 of laws with `p = 0`.
    #[test]
    fn a_dashpot_in_another_coordinate_has_its_coefficient() {
        for (law, u, zeta_squared) in
            [("1,0", ratio(6, 5), 0.36), ("3,1", ratio(14, 5), 0.98), ("1,0", ratio(39, 20), 0.950_625)]
        {
            let dashpot = dashpot(law, u).unwrap();
            let wanted = (-std::f64::consts::PI * f64::sqrt(zeta_squared / (1.0 - zeta_squared))).exp();
            let found = dashpot.epsilon(100).unwrap();
            assert!(
                (found.to_f64() / wanted - 1.0).abs() < 1e-12 && found.relative_bits() >= Some(90),
                "{law}"
            );
            assert!((dashpot.one_minus_epsilon(100).unwrap().to_f64() - (1.0 - wanted)).abs() < 1e-15);
            assert_eq!(dashpot.is_nearly_critical(), zeta_squared > 0.9375, "{law}");
        }
    }

    #[test]
    fn at_critical_damping_nothing_is_left() {
        for u in [ratio(2, 1), ratio(9, 4)] {
            let critical = dashpot("1,0", u).unwrap();
            let known = |error: &DirectError| matches!(error, DirectError::Overdamped { u, .. } if u.starts_with('2'));
            assert!(critical.epsilon(100).is_err_and(|error| known(&error)));
            assert!(matches!(critical.one_minus_epsilon(100), Err(DirectError::Overdamped { .. })));
        }
        // So little is left that no number holds it.
        let next = ratio(2, 1) - ratio(1, 1 << 60) * ratio(1, 1 << 60);
        let nothing = dashpot("1,0", next).unwrap();
        assert!(matches!(nothing.epsilon(100), Err(DirectError::Vanishing { .. })));
        assert_eq!(nothing.one_minus_epsilon(100).unwrap().to_digits(20).unwrap(), "1.0000000000000000000");
        for (law, u) in [("3/2,1/2", ratio(1, 1)), ("1,0", ratio(-1, 1))] {
            assert!(dashpot(law, u).is_none(), "{law}");
        }
    }

    #[test]
    fn nearly_critical_is_beyond_fifteen_sixteenths() {
        let with = |zeta_squared| Dashpot { zeta_squared, ..dashpot("1,0", ratio(1, 1)).unwrap() };
        assert!(!with(ratio(15, 16)).is_nearly_critical() && with(ratio(1501, 1600)).is_nearly_critical());
    }
}
