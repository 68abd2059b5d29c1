//! Section II of \[RPBS1999\]: what dimensional analysis alone says about a collision.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use restitution_law::{ForceLaw, LawError};
use restitution_real::Ball;

/// Elastic and dissipative forces that are powers of the compression and of its rate (eq. 7).
///
/// ```text
/// xi'' + D_1 xi^alpha + D_2 xi^gamma xi'^beta = 0,    xi(0) = 0,  xi'(0) = g
/// ```
///
/// In units of the largest elastic compression and of the impact velocity only one parameter is
/// left, `delta(g)` (eq. 10), and all dependence on the velocity is through it. Exact: exponents are
/// rational numbers; only [`PowerForces::damping_number`] and [`PowerForces::elastic_compression`]
/// round, in balls.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_audit::PowerForces;
/// use restitution_law::{ForceLaw, LawError};
///
/// let spheres = PowerForces::from(ForceLaw::viscoelastic_spheres());
/// assert_eq!(spheres.velocity_exponent().to_string(), "1/5"); // delta ~ g^(1/5), eq. (14)
/// assert!(spheres.is_viscoelastic() && !spheres.is_velocity_independent());
///
/// let half = BigRational::new(1.into(), 2.into());
/// let static_friction = PowerForces::new(half.clone(), BigRational::from_integer(0.into()), half);
/// assert!(matches!(static_friction, Err(LawError::RateExponent { .. })));
/// # Ok::<(), LawError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PowerForces {
    alpha: BigRational,
    beta: BigRational,
    gamma: BigRational,
}

impl PowerForces {
    /// Returns the forces `D_1 xi^alpha` and `D_2 xi^gamma xi'^beta`.
    ///
    /// # Errors
    ///
    /// [`LawError::ElasticExponent`] unless `alpha > 0`, [`LawError::RateExponent`] unless `beta > 0`,
    /// [`LawError::DampingExponent`] unless `gamma > -1`.
    pub fn new(alpha: BigRational, beta: BigRational, gamma: BigRational) -> Result<Self, LawError> {
        if !alpha.is_positive() {
            return Err(LawError::ElasticExponent { a: alpha });
        }
        if !beta.is_positive() {
            return Err(LawError::RateExponent { beta });
        }
        if gamma <= -BigRational::one() {
            return Err(LawError::DampingExponent { gamma });
        }
        Ok(Self { alpha, beta, gamma })
    }

    /// The exponents `alpha`, `beta`, `gamma`.
    pub fn exponents(&self) -> (&BigRational, &BigRational, &BigRational) {
        (&self.alpha, &self.beta, &self.gamma)
    }

    /// The exponent `2/(1 + alpha)` with which the largest elastic compression grows with `g` (eq. 8).
    pub fn length_exponent(&self) -> BigRational {
        two() / self.elastic_step()
    }

    /// The exponent with which `delta` grows with the impact velocity (eq. 11).
    ///
    /// ```text
    /// 2 (gamma - alpha)/(1 + alpha) + beta
    /// ```
    pub fn velocity_exponent(&self) -> BigRational {
        two() * (&self.gamma - &self.alpha) / self.elastic_step() + &self.beta
    }

    /// Whether the restitution coefficient does not depend on the velocity (eq. 12).
    ///
    /// ```text
    /// 2 (gamma - alpha) + beta (1 + alpha) = 0
    /// ```
    pub fn is_velocity_independent(&self) -> bool {
        (two() * (&self.gamma - &self.alpha) + &self.beta * self.elastic_step()).is_zero()
    }

    /// The damping exponent that eq. (12) demands of given `alpha` and `beta`.
    ///
    /// ```text
    /// gamma = alpha - beta (1 + alpha)/2
    /// ```
    ///
    /// 0 for the linear spring and 1/4 for spheres if `beta = 1`.
    pub fn velocity_independent_gamma(alpha: &BigRational, beta: &BigRational) -> BigRational {
        alpha - beta * (alpha + BigRational::one()) / two()
    }

    /// Whether the dissipative force is the rate of the elastic one, `beta = 1`, `gamma = alpha - 1`.
    ///
    /// ```text
    /// F_diss = A xi' dF_el/dxi                                (eq. 13)
    /// ```
    ///
    /// Forces between viscoelastic bodies in quasi-static motion are so; `delta` then grows as
    /// `g^((alpha-1)/(alpha+1))`, and only `alpha = 1` gives a constant restitution coefficient.
    pub fn is_viscoelastic(&self) -> bool {
        self.beta.is_one() && &self.gamma + BigRational::one() == self.alpha
    }

    /// Returns the largest compression of the elastic collision (eq. 8).
    ///
    /// ```text
    /// xi_0 = ((1 + alpha)/(2 D_1))^(1/(1+alpha)) g^(2/(1+alpha))
    /// ```
    ///
    /// `stiffness` is `D_1`, force over effective mass; any consistent units. Encloses the exact value
    /// for positive operands; the whole line otherwise.
    pub fn elastic_compression(&self, stiffness: &Ball, velocity: &Ball) -> Ball {
        self.length_scale(stiffness).pow(&self.elastic_step().recip()) * velocity.pow(&self.length_exponent())
    }

    /// Returns `delta(g)`, the one parameter of the scaled collision (eq. 11).
    ///
    /// ```text
    /// delta = D_2 ((1 + alpha)/(2 D_1))^((1+gamma)/(1+alpha)) g^(2(gamma-alpha)/(1+alpha) + beta)
    /// ```
    ///
    /// `stiffness` and `damping` are `D_1` and `D_2`, forces over effective mass; any consistent
    /// units. Encloses the exact value for positive operands; the whole line otherwise.
    pub fn damping_number(&self, stiffness: &Ball, damping: &Ball, velocity: &Ball) -> Ball {
        let ratio = (&self.gamma + BigRational::one()) / self.elastic_step();
        damping * self.length_scale(stiffness).pow(&ratio) * velocity.pow(&self.velocity_exponent())
    }

    /// `(1 + alpha)/(2 D_1)`: the power `1 + alpha` of the length at unit velocity.
    fn length_scale(&self, stiffness: &Ball) -> Ball {
        Ball::from_rational(&(self.elastic_step() / two()), stiffness.prec()) / stiffness
    }

    fn elastic_step(&self) -> BigRational {
        &self.alpha + BigRational::one()
    }
}

impl From<ForceLaw> for PowerForces {
    /// The forces of a law: `alpha = a`, `beta = 1`.
    fn from(law: ForceLaw) -> Self {
        Self { alpha: law.a().clone(), beta: BigRational::one(), gamma: law.gamma().clone() }
    }
}

fn two() -> BigRational {
    BigRational::from_integer(2.into())
}
