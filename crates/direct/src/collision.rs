use crate::compression::compress;
use crate::dashpot::Dashpot;
use crate::equation::{Equation, shown};
use crate::error::DirectError;
use crate::exit::{to_zero_compression, to_zero_force};
use crate::overdamping::never_leaves;
use crate::precision::{first_precision, proved};
use crate::saturation::Saturation;
use crate::stepper::Stepper;
use crate::time::impact_to_way_out;
use crate::turning::rebound;
use num_rational::BigRational;
use num_traits::{One, Zero};
use restitution::End;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use std::sync::Mutex;

/// Collisions under one force law with one end of contact, integrated directly.
///
/// ```text
/// x'' + u x^gamma x' + x^a = 0,    x(0) = 0,  x'(0) = 1,    epsilon(u) = -x'(t_c)
/// ```
///
/// The phase plane is followed in Taylor steps with proved remainders: in `z = x^(1/q)` at both ends of
/// the contact, in the velocity around the turning point. No formula of the appendix of \[RPBS1999\]
/// has a part in it. Method and proofs: docs/direct-integration.md.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_direct::{Collision, DirectError, End};
/// use restitution_law::ForceLaw;
///
/// let spheres = Collision::new(&ForceLaw::viscoelastic_spheres(), End::ZeroCompression)?;
/// let epsilon = spheres.epsilon(&BigRational::new(1.into(), 10.into()), 30)?;
/// assert_eq!(epsilon.to_digits(30).as_deref(), Some("0.892147587290229345269672993933"));
///
/// assert_eq!((spheres.law(), spheres.end()), (&ForceLaw::viscoelastic_spheres(), End::ZeroCompression));
///
/// let minus_one = BigRational::from_integer((-1).into());
/// assert!(matches!(spheres.epsilon(&minus_one, 30), Err(DirectError::Damping { .. })));
/// # Ok::<(), DirectError>(())
/// ```
#[derive(Debug)]
pub struct Collision {
    law: ForceLaw,
    end: End,
    /// Saturated exit speeds by working precision; `None` where there is none.
    saturations: Mutex<Vec<(u32, Option<Saturation>)>>,
}

impl Collision {
    /// Returns the collisions of a law.
    ///
    /// # Errors
    ///
    /// [`DirectError::NoZeroForce`] if contact shall end at zero force and `a <= gamma`.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_direct::{Collision, DirectError, End};
    ///
    /// let law = "1,2".parse().expect("a force law");
    /// assert!(Collision::new(&law, End::ZeroCompression).is_ok());
    /// assert!(matches!(Collision::new(&law, End::ZeroForce), Err(DirectError::NoZeroForce { .. })));
    /// ```
    pub fn new(law: &ForceLaw, end: End) -> Result<Self, DirectError> {
        if end == End::ZeroForce && law.a() <= law.gamma() {
            return Err(DirectError::NoZeroForce { law: Box::new(law.clone()) });
        }
        Ok(Self { law: law.clone(), end, saturations: Mutex::default() })
    }

    /// The force law.
    pub fn law(&self) -> &ForceLaw {
        &self.law
    }

    /// Where the contact ends.
    pub fn end(&self) -> End {
        self.end
    }

    /// Returns the coefficient of restitution `epsilon(u)` with at least `digits` proved digits.
    ///
    /// The working precision is raised until they are proved. Cost: a few milliseconds at 30 digits.
    ///
    /// # Errors
    ///
    /// [`DirectError::Damping`] if `u < 0`, [`DirectError::Overdamped`] if the bodies do not separate,
    /// [`DirectError::Faint`] if their speed cannot be told from rest, [`DirectError::StepVanished`], [`DirectError::Stiff`]
    /// or [`DirectError::Real`] if the digits cannot be proved.
    pub fn epsilon(&self, u: &BigRational, digits: usize) -> Result<Ball, DirectError> {
        if let Some(dashpot) = self.slow_dashpot(u) {
            return proved(digits, first_precision(digits), |prec| dashpot.epsilon(prec));
        }
        self.epsilon_of(|prec| Ball::from_rational(u, prec), digits)
    }

    /// As [`Collision::epsilon`], for a damping that is known to any precision: `u` gets the bits.
    ///
    /// # Errors
    ///
    /// As [`Collision::epsilon`].
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_direct::{Collision, DirectError, End};
    /// use restitution_law::ForceLaw;
    /// use restitution_real::Ball;
    ///
    /// let spheres = Collision::new(&ForceLaw::viscoelastic_spheres(), End::ZeroForce)?;
    /// let at_root_two = spheres.epsilon_of(|bits| Ball::from_integer(2, bits).sqrt(), 10)?;
    /// assert_eq!(at_root_two.to_digits(10).as_deref(), Some("0.2966084829"));
    /// assert!(matches!(spheres.epsilon_of(|bits| -Ball::pi(bits), 10), Err(DirectError::Damping { .. })));
    /// # Ok::<(), DirectError>(())
    /// ```
    pub fn epsilon_of(&self, u: impl Fn(u32) -> Ball, digits: usize) -> Result<Ball, DirectError> {
        proved(digits, first_precision(digits), |prec| self.enclose(&u(prec), prec))
    }

    /// Returns `1 - epsilon(u)` with at least `digits` proved significant digits, however small `u` is.
    ///
    /// # Errors
    ///
    /// As [`Collision::epsilon`].
    ///
    /// # Examples
    ///
    /// ```
    /// use num_rational::BigRational;
    /// use restitution_direct::{Collision, End};
    /// use restitution_law::ForceLaw;
    ///
    /// let spheres = Collision::new(&ForceLaw::viscoelastic_spheres(), End::ZeroCompression)?;
    /// let tiny = BigRational::new(1.into(), 1_000_000_000_000_i64.into());
    /// let lost = spheres.one_minus_epsilon(&tiny, 12)?;
    /// assert_eq!(lost.to_digits(12).as_deref(), Some("1.15344885809e-12"));
    /// assert!(spheres.one_minus_epsilon(&-tiny, 12).is_err());
    /// # Ok::<(), restitution_direct::DirectError>(())
    /// ```
    pub fn one_minus_epsilon(&self, u: &BigRational, digits: usize) -> Result<Ball, DirectError> {
        if let Some(dashpot) = self.slow_dashpot(u) {
            return proved(digits, first_precision(digits), |prec| dashpot.one_minus_epsilon(prec));
        }
        self.one_minus_epsilon_of(|prec| Ball::from_rational(u, prec), digits)
    }

    /// As [`Collision::one_minus_epsilon`], for a damping that is known to any precision.
    ///
    /// # Errors
    ///
    /// As [`Collision::epsilon`].
    pub(crate) fn one_minus_epsilon_of(
        &self,
        u: impl Fn(u32) -> Ball,
        digits: usize,
    ) -> Result<Ball, DirectError> {
        let small = u(64).mid().get_exp().map_or(0, |e| (-e).max(0).unsigned_abs());
        let first = first_precision(digits).saturating_add(small);
        proved(digits, first, |prec| Ok(Ball::one() - self.enclose(&u(prec), prec)?))
    }

    /// Returns an enclosure of `epsilon(u)` for every `u` of the ball, in one run at `prec` bits.
    ///
    /// About 25 bits of the working precision are lost, and what the ball of `u` is wide.
    ///
    /// # Errors
    ///
    /// As [`Collision::epsilon`], but never [`DirectError::Real`].
    pub fn enclose(&self, u: &Ball, prec: u32) -> Result<Ball, DirectError> {
        if u.is_zero() {
            return Ok(Ball::one().with_prec(prec));
        }
        if !u.is_positive() || !u.is_finite() {
            return Err(DirectError::Damping { u: shown(u) });
        }
        let prec = prec.max(LEAST_PRECISION);
        if self.end == End::ZeroCompression
            && let Some(epsilon) = self.saturated(u, prec)
        {
            return Ok(epsilon);
        }
        self.integrate(u, prec)
    }

    /// The collision as that of a dashpot near or beyond critical damping, if it is one.
    fn slow_dashpot(&self, u: &BigRational) -> Option<Dashpot> {
        let zero_compression = self.end == End::ZeroCompression;
        zero_compression.then(|| Dashpot::of(&self.law, u)).flatten().filter(Dashpot::is_nearly_critical)
    }

    /// Whether contact is proved never to end: by zero compression alone, and before any motion is followed.
    pub(crate) fn is_without_rebound(&self, equation: &Equation) -> bool {
        self.end == End::ZeroCompression && never_leaves(equation)
    }

    /// Follows the whole motion.
    fn integrate(&self, u: &Ball, prec: u32) -> Result<Ball, DirectError> {
        let equation = Equation::new(&self.law, u, prec);
        if self.is_without_rebound(&equation) {
            return Err(equation.overdamped());
        }
        let mut stepper = Stepper::new(equation.prec, equation.order);
        let rebounding = match impact_to_way_out(&equation, self.end) {
            Some(point) => {
                stepper.start_with(0.15 * point.z.to_f64());
                point
            }
            None => {
                let compressed = compress(&equation, &mut stepper)?;
                rebound(&equation, &mut stepper, &compressed)?
            }
        };
        match self.end {
            End::ZeroCompression => to_zero_compression(&equation, &mut stepper, rebounding),
            End::ZeroForce => to_zero_force(&equation, &mut stepper, rebounding),
        }
    }

    /// The value at a velocity so high that the exit speed has saturated.
    fn saturated(&self, u: &Ball, prec: u32) -> Option<Ball> {
        if u.mid() < &4 || !Saturation::exists(&self.law) {
            return None;
        }
        let mut known = self.saturations.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some((_, saturation)) = known.iter().find(|(bits, _)| *bits == prec) {
            return saturation.as_ref()?.epsilon(u);
        }
        let saturation = Saturation::enclose(&self.law, prec).ok();
        let epsilon = saturation.as_ref().and_then(|s| s.epsilon(u));
        known.push((prec, saturation));
        epsilon
    }
}

/// Bits below which a step can hardly be proved.
const LEAST_PRECISION: u32 = 64;

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(n: i64, d: i64) -> BigRational {
        BigRational::new(n.into(), d.into())
    }

    #[test]
    fn no_damping_loses_nothing() {
        let spheres = Collision::new(&ForceLaw::viscoelastic_spheres(), End::ZeroCompression).unwrap();
        assert_eq!(
            spheres.epsilon(&ratio(0, 1), 50).unwrap().to_digits(50).unwrap(),
            "1.0000000000000000000000000000000000000000000000000"
        );
    }

    #[test]
    fn an_overdamped_dashpot_never_separates() {
        let dashpot = Collision::new(&"1,0".parse().unwrap(), End::ZeroCompression).unwrap();
        assert!(matches!(dashpot.epsilon(&ratio(5, 2), 10), Err(DirectError::Overdamped { .. })));
        assert!(dashpot.epsilon(&ratio(3, 2), 10).is_ok());
    }

    /// Friction that grows against the force only at 10^-1284 of the size: between rest and a speed of that order.
    #[test]
    fn a_motion_near_rest_has_no_wrong_speed() {
        let creeping = Collision::new(&"1001/1000,1/1000".parse().unwrap(), End::ZeroCompression).unwrap();
        // At 2.1 epsilon is 1.33e-53, and it falls with u.
        let most = 1.34e-53;
        for (u, prec) in [
            (ratio(87_696, 10_000), 64),
            (ratio(87_696, 10_000), 84),
            (ratio(5, 1), 100),
            (ratio(21, 10), 200),
        ] {
            if let Ok(epsilon) = creeping.enclose(&Ball::from_rational(&u, prec), prec) {
                assert!(
                    !epsilon.is_finite() || epsilon.abs_down() <= most,
                    "{u} at {prec} bits: {epsilon:?}"
                );
            }
        }
    }

    #[test]
    fn zero_force_needs_a_zero() {
        let law = "1,2".parse().unwrap();
        assert!(matches!(Collision::new(&law, End::ZeroForce), Err(DirectError::NoZeroForce { .. })));
    }

    #[test]
    fn a_small_loss_has_its_digits() {
        let spheres = Collision::new(&ForceLaw::viscoelastic_spheres(), End::ZeroCompression).unwrap();
        let tiny = BigRational::new(
            1.into(),
            num_traits::pow(BigRational::from_integer(10.into()), 40).to_integer(),
        );
        let lost = spheres.one_minus_epsilon(&tiny, 12).unwrap();
        assert_eq!(lost.to_digits(12).as_deref(), Some("1.15344885810e-40"));
        for none in [
            Ball::from_integer(-1, 80),
            Ball::zero().widened(&rug::Float::with_val(64, 0.5)),
            Ball::whole_line(80),
        ] {
            assert!(matches!(spheres.enclose(&none, 80), Err(DirectError::Damping { .. })), "{none:?}");
        }
    }

    /// Where the speed has saturated it is kept for each precision, and is the integrated one.
    #[test]
    fn saturated_speeds_are_those_of_the_motion() {
        let spheres = Collision::new(&ForceLaw::viscoelastic_spheres(), End::ZeroCompression).unwrap();
        for bits in [80, 120, 80] {
            let u = Ball::from_integer(60, bits);
            let (kept, followed) = (spheres.enclose(&u, bits).unwrap(), spheres.integrate(&u, bits).unwrap());
            assert!(kept.overlaps(&followed) && kept.rad() < followed.rad(), "{kept:?} {followed:?}");
        }
        let known = spheres.saturations.lock().unwrap().iter().map(|(bits, _)| *bits).collect::<Vec<_>>();
        assert_eq!(known, [80, 120]);
    }

    #[test]
    fn a_nearly_critical_dashpot_is_not_integrated() {
        for (end, u, slow) in [
            (End::ZeroCompression, (199, 100), true),
            (End::ZeroCompression, (3, 2), false),
            (End::ZeroForce, (199, 100), false),
        ] {
            let dashpot = Collision::new(&"1,0".parse().unwrap(), end).unwrap();
            assert_eq!(dashpot.slow_dashpot(&ratio(u.0, u.1)).is_some(), slow);
        }
    }
}
