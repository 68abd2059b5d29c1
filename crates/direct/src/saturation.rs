//! The exit speed of a collision at unlimited velocity.

use crate::compression::ratio;
use crate::equation::Equation;
use crate::error::DirectError;
use crate::exit::to_zero_compression;
use crate::fixed::{BOUND_BITS, upper_bound};
use crate::phase_arc::PhasePoint;
use crate::precision::{first_precision, proved};
use crate::stepper::Stepper;
use num_rational::BigRational;
use num_traits::{One, Signed};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use rug::Float;

/// The exit speed that no collision exceeds, in the units in which the damping is 1.
///
/// With lengths and times such that `u = 1` every collision runs in one and the same phase plane,
///
/// ```text
/// V dV/dX = -X^gamma V - X^a,    V(0) = u^(1/p),    exit speed = epsilon u^(1/p) -> R^(1/p)
/// ```
///
/// with `p = (2 gamma - a + 1)/(a + 1)`, 1/5 for spheres. Trajectories cannot cross, so the exit speed
/// grows with the impact speed; the curve of zero force and a multiple of it hold all of them between
/// them on the way out. The enclosure starts with that whole width at a large `X` and shrinks with the
/// motion's own contraction (docs/direct-integration.md, Prop. 6).
#[derive(Clone, Debug)]
pub(crate) struct Saturation {
    /// Encloses the exit speed for unlimited velocity and for every `u` with `impact_speed >= needed`.
    pub(crate) exit_speed: Ball,
    /// Impact speeds from this on end in `exit_speed`.
    needed: Ball,
    /// `1/p`.
    power: BigRational,
}

impl Saturation {
    /// Whether the exit speed of this law saturates: `a > gamma` and `p > 0`.
    pub(crate) fn exists(law: &ForceLaw) -> bool {
        law.a() > law.gamma() && law.velocity_exponent().is_positive()
    }

    /// Follows the slow manifold from both sides to zero compression at `prec` bits.
    pub(crate) fn enclose(law: &ForceLaw, prec: u32) -> Result<Self, DirectError> {
        if !Self::exists(law) {
            return Err(DirectError::NoSaturation { law: Box::new(law.clone()) });
        }
        let equation = Equation::new(law, &Ball::from_integer(1, prec), prec);
        let start = far_coordinate(&equation);
        if start.get_exp().is_none_or(|e| e > LARGEST_START) {
            return Err(DirectError::SlowSaturation {
                law: Box::new(law.clone()),
                exponent: Box::new(law.velocity_exponent()),
            });
        }
        let point = funnel(&equation, &start)?;
        let mut stepper = Stepper::new(equation.prec, equation.order);
        stepper.start_with(0.25);
        let exit_speed = to_zero_compression(&equation, &mut stepper, point)?;
        Ok(Self {
            exit_speed,
            needed: needed_speed(&equation, &start),
            power: BigRational::one() / law.velocity_exponent(),
        })
    }

    /// The restitution coefficient `exit speed/u^(1/p)`, if `u` is proved large enough for it.
    pub(crate) fn epsilon(&self, u: &Ball) -> Option<Ball> {
        let impact_speed = u.pow(&self.power);
        let proved = (&impact_speed - &self.needed).is_positive();
        proved.then(|| &self.exit_speed / impact_speed)
    }

    /// The radius `R = (exit speed)^p`.
    pub(crate) fn radius(&self) -> Ball {
        self.exit_speed.pow(&(BigRational::one() / &self.power))
    }
}

/// Binary exponent of the largest coordinate from which the slow manifold is followed.
const LARGEST_START: i32 = 32;

/// A coordinate from which the contraction to zero exceeds the working precision.
///
/// The contraction is about `exp(-q z^(2B-A)/(2B-A))` times a power; a wrong guess costs digits only.
fn far_coordinate(equation: &Equation) -> Float {
    let c = &equation.coordinate;
    let bend = ratio(&(&c.damping + &c.damping - &c.elastic));
    let prec = f64::from(equation.prec);
    let wanted = 1.12 * std::f64::consts::LN_2 * prec + 4.0 * prec.ln();
    let least = (16.0 * ratio(&c.force_power()) / ratio(&c.q)).powf(1.0 / bend);
    Float::with_val(equation.prec, (wanted * bend / ratio(&c.q)).powf(1.0 / bend).max(least).ceil())
}

/// Returns the point whose energy covers all speeds between `z^(A-B)` and `(1 + 2 k) z^(A-B)`.
///
/// Every trajectory stays below the upper curve where `k = (A-B) z^(A-2B)/q <= 1/8`.
fn funnel(equation: &Equation, z: &Float) -> Result<PhasePoint, DirectError> {
    let c = &equation.coordinate;
    let z_ball = Ball::exact(z.clone()).with_prec(equation.prec);
    let force = z_ball.pow(&c.force_power());
    let bend = equation.rational(&(c.force_power() / &c.q)) * z_ball.pow(&(c.force_power() - &c.damping));
    if !(bend.shifted(3) - Ball::one()).is_negative() && !bend.shifted(3).contains(&Ball::one()) {
        return Err(DirectError::NoSaturation { law: Box::new(equation.law.clone()) });
    }
    let speed = &force * (Ball::one() + &bend);
    let widest = &force * (Ball::one() + bend.shifted(1));
    let v = -Float::with_val(equation.prec, speed.mid());
    let square = Ball::exact(v.clone()).powi(2);
    let energy = upper_bound(&((&widest * &widest - &square).abs() + (square - &force * &force).abs()));
    Ok(PhasePoint { z: z.clone(), v, energy })
}

/// The impact speed from which on the trajectory has met the curve of zero force before `start`.
///
/// ```text
/// z_1 = (9/8) start,   1 - exp(-k s) = (8/9)^(A-B),   k = q z_1^(2B-A-1),   z_2 = z_1 + s
/// needed = 2 q z_2^B/B + z_2^(A-B)
/// ```
fn needed_speed(equation: &Equation, start: &Float) -> Ball {
    let c = &equation.coordinate;
    let eighths = Ball::from_ratio(9, 8, equation.prec);
    let first = Ball::exact(start.clone()).with_prec(equation.prec) * &eighths;
    let rate =
        equation.rational(&c.q) * first.pow(&(&c.damping + &c.damping - &c.elastic - BigRational::one()));
    let missing = Ball::one() - eighths.pow(&-c.force_power());
    let turn = &first - missing.ln() / rate;
    let speed =
        equation.rational(&(&c.q / &c.damping)) * turn.pow(&c.damping) * Ball::from_integer(2, BOUND_BITS)
            + turn.pow(&c.force_power());
    upper_bound(&speed)
}

/// Returns `R = lim u epsilon^p` to `digits` digits, each proved; for spheres `epsilon -> (R/u)^5`.
///
/// ```text
/// R = 1.38836192561582941006822465...
/// ```
///
/// `u = -R` is also the singularity of `epsilon(u)` that limits the convergence of its power series
/// (docs/direct-integration.md). The slow manifold of the way out is approached from both sides and the
/// precision is raised until the digits are proved.
///
/// # Errors
///
/// [`DirectError::NoSaturation`] if the exit speed of the law is not bounded,
/// [`DirectError::Real`] if the digits are not reached.
///
/// # Examples
///
/// ```
/// use restitution_direct::{DirectError, saturation_radius};
/// use restitution_law::ForceLaw;
///
/// let radius = saturation_radius(&ForceLaw::viscoelastic_spheres(), 20)?;
/// assert_eq!(radius.to_digits(20).as_deref(), Some("1.3883619256158294101"));
///
/// let dashpot = "1,0".parse::<ForceLaw>().unwrap();
/// assert!(matches!(saturation_radius(&dashpot, 20), Err(DirectError::NoSaturation { .. })));
/// # Ok::<(), DirectError>(())
/// ```
pub fn saturation_radius(law: &ForceLaw, digits: usize) -> Result<Ball, DirectError> {
    proved(digits, first_precision(digits), |prec| Ok(Saturation::enclose(law, prec)?.radius()))
}

/// Returns `lim epsilon u^(1/p)`, the exit speed at unlimited velocity: `R^5` for spheres.
///
/// ```text
/// R^5 = 5.15838170426768521641430592...
/// ```
///
/// # Errors
///
/// As [`saturation_radius`].
///
/// # Examples
///
/// ```
/// use restitution_direct::saturation_speed;
/// use restitution_law::ForceLaw;
///
/// let speed = saturation_speed(&ForceLaw::viscoelastic_spheres(), 20)?;
/// assert_eq!(speed.to_digits(20).as_deref(), Some("5.1583817042676852164"));
/// # Ok::<(), restitution_direct::DirectError>(())
/// ```
pub fn saturation_speed(law: &ForceLaw, digits: usize) -> Result<Ball, DirectError> {
    proved(digits, first_precision(digits), |prec| Ok(Saturation::enclose(law, prec)?.exit_speed))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law(text: &str) -> ForceLaw {
        text.parse().unwrap()
    }

    #[test]
    fn speeds_saturate_where_damping_is_the_weaker_for_small_and_the_stronger_for_fast_bodies() {
        for (text, exists) in [
            ("3/2,1/2", true),
            ("2,1", true),
            ("1,0", false),
            ("3,1/2", false),
            ("1,1", false),
            ("1,2", false),
        ] {
            assert_eq!(Saturation::exists(&law(text)), exists, "{text}");
        }
    }

    /// Prop. 6 for spheres: `k = 1/z`, and all speeds lie between `z^2` and `(1 + 2 k) z^2`.
    #[test]
    fn the_funnel_holds_every_speed_where_it_is_narrow() {
        let equation = Equation::new(&law("3/2,1/2"), &Ball::from_integer(1, 80), 80);
        let of = |z: f64| funnel(&equation, &Float::with_val(80, z));
        let point = of(16.0).unwrap();
        assert_eq!(point.v, -256.0 * (1.0 + 1.0 / 16.0));
        let energy = 65_536.0 * (81.0 / 64.0 - 1.0);
        assert!((point.energy.to_f64() / energy - 1.0).abs() < 1e-12 && point.energy.upper() >= energy);
        assert!(of(8.001).is_ok());
        for narrow in [7.999, 4.0, 1.0] {
            assert!(of(narrow).is_err(), "{narrow}");
        }
    }

    #[test]
    fn the_slow_manifold_is_followed_from_where_the_contraction_exceeds_the_precision() {
        // Spheres: 2B - A = 1, q = 2; k = 1/z up to 1/16 at few bits, 1.12 ln 2 prec + 4 ln prec over 2 at many.
        let far =
            |prec: u32| far_coordinate(&Equation::new(&law("3/2,1/2"), &Ball::from_integer(1, prec), prec));
        assert_eq!(far(4), 16);
        let many: f64 = (1.12 * std::f64::consts::LN_2 * 300.0 + 4.0 * 300_f64.ln()) / 2.0;
        assert_eq!(far(300).to_f64(), many.ceil());
    }

    /// The impact speed of Prop. 6: the curve of zero force is met from `z_2` on, friction alone takes what is more.
    #[test]
    fn faster_bodies_have_met_the_curve() {
        for (text, q, a, b) in [
            ("3/2,1/2", 2.0, 5.0, 3.0),
            ("2,1", 1.0, 3.0, 2.0),
            ("7/3,5/6", 6.0 / 11.0, 20.0 / 11.0, 1.0),
            ("3/2,1", 2.0, 5.0, 4.0),
        ] {
            let equation = Equation::new(&law(text), &Ball::from_integer(1, 80), 80);
            let c = &equation.coordinate;
            assert_eq!([&c.q, &c.elastic, &c.damping].map(ratio), [q, a, b], "{text}");
            let first = 9.0 / 8.0 * 12.0_f64;
            let rate = q * first.powf(2.0 * b - a - 1.0);
            let second = first - (1.0 - (8.0_f64 / 9.0).powf(a - b)).ln() / rate;
            let wanted = 2.0 * q * second.powf(b) / b + second.powf(a - b);
            let found = needed_speed(&equation, &Float::with_val(80, 12)).to_f64();
            assert!((found / wanted - 1.0).abs() < 1e-12, "{text}: {found} {wanted}");
        }
        let speed = |u: f64, needed: f64| {
            let (exit_speed, power) = (Ball::from_integer(5, 80), BigRational::from_integer(5.into()));
            Saturation { exit_speed, needed: Ball::from_f64(needed, 80), power }
                .epsilon(&Ball::from_f64(u, 80))
        };
        assert!((speed(2.0, 31.9).unwrap().to_f64() - 5.0 / 32.0).abs() < 1e-15);
        for needed in [32.0, 32.1, 1000.0] {
            assert!(speed(2.0, needed).is_none());
        }
    }
}
