use crate::collision::Collision;
use crate::error::DirectError;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use restitution_law::ForceLaw;
use restitution_real::Ball;

/// Bits by which intermediate results are finer.
const GUARD_BITS: u32 = 32;

/// The damping parameter `u` of one collision, to any precision.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_direct::{Collision, Damping, DirectError, End};
/// use restitution_law::ForceLaw;
///
/// let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
/// let spheres = ForceLaw::viscoelastic_spheres();
/// let at_g_star = Damping::of_velocity(&ratio(1, 100), &ratio(1, 100), &spheres)?;
/// assert_eq!(at_g_star.at(100).to_digits(20).as_deref(), Some("0.86696518270547191339")); // 1/|C_1|
///
/// let collision = Collision::new(&spheres, End::ZeroCompression)?;
/// assert_eq!(collision.epsilon_at(&at_g_star, 10)?.to_digits(10).as_deref(), Some("0.3841091979"));
/// let tenth = Damping::exact(&ratio(1, 10));
/// assert_eq!(collision.one_minus_epsilon_at(&tenth, 10)?.to_digits(10).as_deref(), Some("0.1078524127"));
///
/// let backwards = Damping::of_velocity(&ratio(-1, 100), &ratio(1, 100), &spheres);
/// assert_eq!(backwards.unwrap_err(), DirectError::NegativeVelocity);
/// # Ok::<(), DirectError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Damping(Source);

#[derive(Clone, Debug)]
enum Source {
    Exact(BigRational),
    /// `(g/g*)^p/|C_1|`.
    Scaled {
        ratio: BigRational,
        law: ForceLaw,
    },
    /// `u^5 pi^2`.
    EqualSpheres {
        power: BigRational,
    },
}

/// Two equal viscoelastic spheres, in SI units.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_direct::{Damping, DirectError, EqualSpheres};
///
/// let number = |n: i64| BigRational::from_integer(n.into());
/// let ice = EqualSpheres {
///     dissipative_constant: BigRational::new(1.into(), 10_000.into()), // s
///     young: number(9_400_000_000),                                    // Pa
///     poisson: BigRational::new(33.into(), 100.into()),
///     density: number(917),                                            // kg/m^3
///     radius: BigRational::new(11.into(), 400.into()),                 // m
/// };
/// let u = Damping::of_equal_spheres(&ice, &BigRational::new(1.into(), 100.into()))?; // at 1 cm/s
/// assert_eq!(u.at(64).to_digits(6).as_deref(), Some("0.798041"));
///
/// let stiff = EqualSpheres { young: number(0), ..ice };
/// assert_eq!(
///     Damping::of_equal_spheres(&stiff, &number(1)).unwrap_err(),
///     DirectError::NotPositive { what: "Young's modulus" }
/// );
/// # Ok::<(), DirectError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EqualSpheres {
    /// The dissipative constant `A`.
    pub dissipative_constant: BigRational,
    /// Young's modulus.
    pub young: BigRational,
    /// Poisson's ratio.
    pub poisson: BigRational,
    /// The mass density.
    pub density: BigRational,
    /// The radius of each.
    pub radius: BigRational,
}

/// What sets the damping of each impact velocity.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_direct::{DirectError, VelocityScale};
/// use restitution_law::ForceLaw;
///
/// let whole = |n: i64| BigRational::from_integer(n.into());
/// let law = ForceLaw::viscoelastic_spheres();
/// let scale = VelocityScale::Characteristic { g_star: whole(2), law: law.clone() };
/// assert_eq!(scale.damping(&whole(2))?.at(64).to_digits(6).as_deref(), Some("0.866965")); // 1/|C_1|
///
/// let nothing = VelocityScale::Characteristic { g_star: whole(0), law };
/// assert!(matches!(nothing.damping(&whole(2)), Err(DirectError::NotPositive { .. })));
/// # Ok::<(), DirectError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum VelocityScale {
    /// The characteristic velocity `g*` of a law, in the unit of the velocities.
    Characteristic {
        /// `g*`.
        g_star: BigRational,
        /// The force law.
        law: ForceLaw,
    },
    /// The material and the size of two equal spheres; velocities in m/s.
    EqualSpheres(EqualSpheres),
}

impl VelocityScale {
    /// Returns the damping at an impact velocity.
    ///
    /// # Errors
    ///
    /// Those of [`Damping::of_velocity`] and [`Damping::of_equal_spheres`].
    pub fn damping(&self, g: &BigRational) -> Result<Damping, DirectError> {
        match self {
            Self::Characteristic { g_star, law } => Damping::of_velocity(g, g_star, law),
            Self::EqualSpheres(spheres) => Damping::of_equal_spheres(spheres, g),
        }
    }
}

impl Damping {
    /// Returns a damping that is a rational number.
    pub fn exact(u: &BigRational) -> Self {
        Self(Source::Exact(u.clone()))
    }

    /// Returns the damping at an impact velocity, `u = (g/g*)^p/|C_1|`: eq. (31) of \[RPBS1999\] for any law.
    ///
    /// # Errors
    ///
    /// [`DirectError::NegativeVelocity`] if `g < 0`, [`DirectError::NotPositive`] unless `g* > 0`,
    /// [`DirectError::InfiniteDamping`] for `g = 0` if `p < 0`.
    pub fn of_velocity(g: &BigRational, g_star: &BigRational, law: &ForceLaw) -> Result<Self, DirectError> {
        if g.is_negative() {
            return Err(DirectError::NegativeVelocity);
        }
        let g_star = positive("the characteristic velocity", g_star)?;
        if law.velocity_exponent().is_negative() && g.is_zero() {
            return Err(DirectError::InfiniteDamping);
        }
        Ok(Self(Source::Scaled { ratio: g / g_star, law: law.clone() }))
    }

    /// Returns the damping of two equal spheres at an impact velocity, eqs. (2) and (14) of \[RPBS1999\].
    ///
    /// ```text
    /// rho = 2 Y sqrt(R/2)/(3 (1 - nu^2)),   m_eff = (2/3) pi R^3 density,   u = (3/2) A (rho/m_eff)^(2/5) g^(1/5)
    /// u^5 = (3/2)^5 A^5 g Y^2/(2 pi^2 R^5 (1 - nu^2)^2 density^2)
    /// ```
    ///
    /// # Errors
    ///
    /// [`DirectError::NegativeVelocity`] if `g < 0`, [`DirectError::NotPositive`] for a constant that is not positive, and for
    /// `1 - nu^2`.
    pub fn of_equal_spheres(spheres: &EqualSpheres, g: &BigRational) -> Result<Self, DirectError> {
        if g.is_negative() {
            return Err(DirectError::NegativeVelocity);
        }
        let a = positive("the dissipative constant", &spheres.dissipative_constant)?;
        let young = positive("Young's modulus", &spheres.young)?;
        let density = positive("the density", &spheres.density)?;
        let radius = positive("the radius", &spheres.radius)?;
        let strain = BigRational::one() - &spheres.poisson * &spheres.poisson;
        let stiffness = young / (positive("1 - nu^2", &strain)? * density);
        let front = num_traits::pow(BigRational::new(3.into(), 2.into()) * a / radius, 5);
        let power = front * g * &stiffness * &stiffness / BigRational::from_integer(2.into());
        Ok(Self(Source::EqualSpheres { power }))
    }

    /// Encloses `u`, computed with `prec` bits and some more.
    pub fn at(&self, prec: u32) -> Ball {
        let wide = prec + GUARD_BITS;
        match &self.0 {
            Source::Exact(u) => Ball::from_rational(u, prec),
            Source::Scaled { ratio, law } if ratio.is_zero() && !law.velocity_exponent().is_zero() => {
                Ball::zero().with_prec(prec)
            }
            Source::Scaled { ratio, law } => {
                Ball::from_rational(ratio, wide).pow(&law.velocity_exponent()) / first_order_loss(law, wide)
            }
            Source::EqualSpheres { power } if power.is_zero() => Ball::zero().with_prec(prec),
            Source::EqualSpheres { power } => {
                (Ball::from_rational(power, wide) / Ball::pi(wide).powi(2)).fifth_root()
            }
        }
    }
}

impl Collision {
    /// As [`Collision::epsilon`], for a damping that need not be rational.
    ///
    /// # Errors
    ///
    /// As [`Collision::epsilon`].
    pub fn epsilon_at(&self, damping: &Damping, digits: usize) -> Result<Ball, DirectError> {
        match &damping.0 {
            Source::Exact(u) => self.epsilon(u, digits),
            _ => self.epsilon_of(|prec| damping.at(prec), digits),
        }
    }

    /// As [`Collision::one_minus_epsilon`], for a damping that need not be rational.
    ///
    /// # Errors
    ///
    /// As [`Collision::epsilon`].
    pub fn one_minus_epsilon_at(&self, damping: &Damping, digits: usize) -> Result<Ball, DirectError> {
        match &damping.0 {
            Source::Exact(u) => self.one_minus_epsilon(u, digits),
            _ => self.one_minus_epsilon_of(|prec| damping.at(prec), digits),
        }
    }
}

/// `-C_1 = 2 ((a+1)/2)^r B(r, 3/2)/(a+1)`, `r = (gamma+1)/(a+1)`: the work of the dashpot on the undamped motion. It defines `g*`.
fn first_order_loss(law: &ForceLaw, prec: u32) -> Ball {
    let step = law.elastic_step();
    let two = BigRational::from_integer(2.into());
    let exponent = law.damping_step() / &step;
    let beta = Ball::beta(&exponent, &BigRational::new(3.into(), 2.into()), prec);
    Ball::from_rational(&(&step / &two), prec).pow(&exponent)
        * beta
        * Ball::from_rational(&(two / step), prec)
}

fn positive<'a>(what: &'static str, value: &'a BigRational) -> Result<&'a BigRational, DirectError> {
    if value.is_positive() { Ok(value) } else { Err(DirectError::NotPositive { what }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(n: i64, d: i64) -> BigRational {
        BigRational::new(n.into(), d.into())
    }

    fn near(found: &Ball, wanted: f64) {
        assert!((found.to_f64() / wanted - 1.0).abs() < 1e-12, "{found:?} {wanted}");
    }

    /// `u = (g/g*)^p/|C_1|` with `-C_1 = 2 ((a+1)/2)^r B(r, 3/2)/(a+1)`: `pi/2` for the dashpot, 1.1534… for spheres.
    #[test]
    fn a_velocity_has_its_damping() {
        let at = |law: &str, g: (i64, i64)| {
            let law = law.parse::<ForceLaw>().unwrap();
            Damping::of_velocity(&ratio(g.0, g.1), &ratio(1, 4), &law).map(|u| u.at(80))
        };
        near(&at("3/2,1/2", (8, 1)).unwrap(), 2.0 / 1.153_448_858_095_288_8);
        near(&at("1,0", (7, 3)).unwrap(), std::f64::consts::FRAC_2_PI);
        // a = 3, gamma = 1: r = 1/2, B = pi/2, p = 0; gamma = 3: r = 1, B = 2/3, p = 1.
        near(&at("3,1", (5, 1)).unwrap(), 2.0 * 2.0_f64.sqrt() / std::f64::consts::PI);
        near(&at("3,3", (1, 2)).unwrap(), 2.0 / (2.0 * 2.0 * (2.0 / 3.0) / 4.0));
        assert_eq!(at("3/2,1/2", (0, 1)).unwrap().to_f64(), 0.0);
        // p = 0: the same at every velocity.
        near(&at("1,0", (0, 1)).unwrap(), std::f64::consts::FRAC_2_PI);
        assert_eq!(at("3/2,1/2", (-1, 9)).unwrap_err(), DirectError::NegativeVelocity);
        assert_eq!(at("3,1/2", (0, 1)).unwrap_err(), DirectError::InfiniteDamping);
        assert!(at("3,1/2", (1, 9)).is_ok());
        let law = ForceLaw::viscoelastic_spheres();
        for g_star in [0, -1] {
            let none = Damping::of_velocity(&ratio(1, 1), &ratio(g_star, 1), &law);
            assert!(matches!(none, Err(DirectError::NotPositive { .. })));
        }
    }

    /// Eqs. (2) and (14): `u = (3/2) A (rho/m_eff)^(2/5) g^(1/5)`.
    #[test]
    fn two_equal_spheres_have_their_damping() {
        let spheres = EqualSpheres {
            dissipative_constant: ratio(1, 10_000),
            young: ratio(7_000_000, 1),
            poisson: ratio(3, 10),
            density: ratio(1100, 1),
            radius: ratio(1, 50),
        };
        let rho = 2.0 * 7e6 * 0.01_f64.sqrt() / (3.0 * (1.0 - 0.09));
        let mass = 2.0 / 3.0 * std::f64::consts::PI * 0.02_f64.powi(3) * 1100.0;
        let wanted = 1.5e-4 * (rho / mass).powf(0.4) * 0.3_f64.powf(0.2);
        near(&Damping::of_equal_spheres(&spheres, &ratio(3, 10)).unwrap().at(80), wanted);
        assert_eq!(Damping::of_equal_spheres(&spheres, &ratio(0, 1)).unwrap().at(80).to_f64(), 0.0);
        assert!(Damping::of_equal_spheres(&spheres, &ratio(-1, 10)).is_err());
        let scale = VelocityScale::EqualSpheres(spheres.clone());
        near(&scale.damping(&ratio(3, 10)).unwrap().at(80), wanted);
        for poisson in [1, -1, 2] {
            let wrong = EqualSpheres { poisson: ratio(poisson, 1), ..spheres.clone() };
            assert!(Damping::of_equal_spheres(&wrong, &ratio(1, 1)).is_err(), "{poisson}");
        }
    }

    #[test]
    fn precision_is_that_asked_for() {
        for u in [
            Damping::exact(&ratio(1, 3)),
            Damping::of_velocity(&ratio(1, 3), &ratio(1, 1), &ForceLaw::viscoelastic_spheres()).unwrap(),
        ] {
            for prec in [64, 200] {
                assert!(
                    u.at(prec).relative_bits().is_some_and(|bits| bits >= i64::from(prec) - 2),
                    "{u:?} {prec}"
                );
            }
        }
    }
}
