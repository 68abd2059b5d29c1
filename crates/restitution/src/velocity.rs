use crate::fifth_root::{Root, fifth_root, is_ordinary};
use crate::tables::zero_compression::NEAR;
use crate::{End, epsilon, one_minus_epsilon, zero_compression, zero_force};

/// The coefficient of restitution of two given bodies as a function of their impact velocity.
///
/// ```text
/// u = (f g)^(1/5),   f = u_1^5 = 1/(g* |C_1|^5),   u_1 = (3/2) A (rho/m_eff)^(2/5)
/// ```
///
/// (\[RPBS1999\], eqs. 6, 30, 31.) `u_1` is the value of `u` at unit velocity and `g*` the velocity at
/// which `|C_1| u = 1`, in the unit of velocity that is then used throughout. A scale that is not
/// positive and finite makes every coefficient NaN.
///
/// # Error bound
///
/// That of [`epsilon`] plus 1 ulp: `u` enters with more than the bits of an f64, the product `f g` is
/// rounded, and `|d ln epsilon/d ln g| <= 1`. `f` itself is within 4 ulp of the value that `g*` or
/// `u_1` stands for, which changes the coefficient at most as much as a change of the velocity in the
/// same proportion.
///
/// # Examples
///
/// ```
/// use restitution::{End, Restitution};
///
/// let ice = Restitution::from_g_star(0.32e-2, End::ZeroCompression);
/// let slow = ice.epsilon(1e-4);
/// assert!(0.6 < slow && slow < 0.7);
/// assert!(ice.epsilon(-1.0).is_nan());
/// assert!(Restitution::from_g_star(0.0, End::ZeroForce).epsilon(1.0).is_nan());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Restitution {
    factor: f64,
    end: End,
}

impl Restitution {
    /// From the velocity `g*` at which `|C_1| u = 1` (eq. 31).
    #[must_use]
    pub fn from_g_star(g_star: f64, end: End) -> Self {
        let c1 = NEAR[0]; // -C_1, rounded
        Self::from_factor(1.0 / (c1 * c1 * c1 * c1 * c1 * g_star), end)
    }

    /// From `u` at unit velocity, `(3/2) A (rho/m_eff)^(2/5)`.
    #[must_use]
    pub fn from_u_at_unit_velocity(u_1: f64, end: End) -> Self {
        Self::from_factor(u_1 * u_1 * u_1 * u_1 * u_1, end)
    }

    fn from_factor(factor: f64, end: End) -> Self {
        Self { factor: if is_ordinary(factor) { factor } else { f64::NAN }, end }
    }

    /// Where the contact ends.
    #[inline]
    #[must_use]
    pub fn end(&self) -> End {
        self.end
    }

    /// Returns `u` of an impact velocity.
    #[inline]
    #[must_use]
    pub fn u(&self, velocity: f64) -> f64 {
        fifth_root(self.factor * velocity)
    }

    /// Returns the impact velocity that belongs to `u`, in six roundings; infinite where it overflows.
    #[inline]
    #[must_use]
    pub fn velocity(&self, u: f64) -> f64 {
        let u2 = u * u;
        u2 * u2 * u / self.factor
    }

    /// Returns the coefficient of restitution at an impact velocity; NaN below zero.
    #[inline]
    #[must_use]
    pub fn epsilon(&self, velocity: f64) -> f64 {
        let x = self.factor * velocity;
        if !is_ordinary(x) {
            return epsilon(fifth_root(x), self.end);
        }
        match self.end {
            End::ZeroCompression => zero_compression::epsilon_of_root(Root::of(x)),
            End::ZeroForce => zero_force::epsilon_of_root(Root::of(x)),
        }
    }

    /// Returns one less the coefficient of restitution, accurate where that is close to one.
    #[inline]
    #[must_use]
    pub fn one_minus_epsilon(&self, velocity: f64) -> f64 {
        one_minus_epsilon(self.u(velocity), self.end)
    }

    /// Writes the coefficients at `velocities` to `out`, as far as the shorter of the two reaches.
    #[inline]
    pub fn epsilon_batch(&self, velocities: &[f64], out: &mut [f64]) {
        for (velocity, out) in velocities.iter().zip(out) {
            *out = self.epsilon(*velocity);
        }
    }
}
