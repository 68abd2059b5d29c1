use super::curve::Curve;
use super::end::End;
use super::epsilon::{epsilon, one_minus_epsilon};
use super::fifth_root::{Root, fifth_root, is_ordinary};
use super::tables::constants::SLOPE;
use super::zero_compression::ZeroCompression;
use super::zero_force::ZeroForce;

/// The coefficient of restitution of two given bodies as a function of their impact velocity.
///
/// ```text
/// u = (f g)^(1/5),   f = u_1^5 = 1/(g* |C_1|^5),   u_1 = (3/2) A (rho/m_eff)^(2/5)
/// ```
///
/// (\[RPBS1999\], eqs. 6, 30, 31.) `u_1` is the value of `u` at unit velocity and `g*` the velocity at
/// which `|C_1| u = 1`, in the unit of velocity that is then used throughout. A scale whose `f` is no normal
/// positive f64 (`g*` outside 3e-309 to 2e307, `u_1` outside 2e-62 to 4e61) makes every coefficient NaN.
///
/// # Error bound
///
/// [`bounds::EPSILON_OF_VELOCITY`](crate::bounds::EPSILON_OF_VELOCITY): at most 3 ulp (proved). `u` enters with more than the bits of an f64, the product `f g` is
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
        Self::from_factor(1.0 / (SLOPE * SLOPE * SLOPE * SLOPE * SLOPE * g_star), end)
    }

    /// From `u` at unit velocity, `(3/2) A (rho/m_eff)^(2/5)`.
    #[must_use]
    pub fn from_u_at_unit_velocity(u_1: f64, end: End) -> Self {
        Self::from_factor(u_1 * u_1 * u_1 * u_1 * u_1, end)
    }

    /// From `f = u_1^5`, the factor of the velocity in `u^5`.
    #[must_use]
    pub fn from_factor(factor: f64, end: End) -> Self {
        Self { factor: if is_ordinary(factor) { factor } else { f64::NAN }, end }
    }

    /// The factor `f` of the velocity in `u^5 = f g`; NaN where the scale was not positive and finite.
    #[inline(always)]
    #[must_use]
    pub fn factor(&self) -> f64 {
        self.factor
    }

    /// The velocity `g*` at which `|C_1| u = 1` (eq. 31), within 8 ulp of the one that `f` stands for.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution::{End, Restitution};
    ///
    /// let g_star = Restitution::from_u_at_unit_velocity(2.0, End::ZeroForce).g_star();
    /// assert!((g_star - 1.0 / (2.0_f64 * 1.1534488580952889).powi(5)).abs() < 1e-17);
    /// assert!(Restitution::from_factor(-1.0, End::ZeroForce).g_star().is_nan());
    /// ```
    #[must_use]
    pub fn g_star(&self) -> f64 {
        1.0 / (SLOPE * SLOPE * SLOPE * SLOPE * SLOPE * self.factor)
    }

    /// Where the contact ends.
    #[inline]
    #[must_use]
    pub fn end(&self) -> End {
        self.end
    }

    /// Returns `u` of an impact velocity, within 2 ulp where `f g` is beyond the range of f64, too; NaN below zero.
    #[inline]
    #[must_use]
    pub fn u(&self, velocity: f64) -> f64 {
        let x = self.factor * velocity;
        if is_ordinary(x) { fifth_root(x) } else { self.unusual_u(velocity) }
    }

    /// `u` where the product with the factor is not an ordinary number.
    #[cold]
    fn unusual_u(&self, velocity: f64) -> f64 {
        if self.factor.is_nan() || velocity.is_nan() || velocity < 0.0 {
            return f64::NAN;
        }
        if velocity == 0.0 || velocity.is_infinite() {
            return velocity;
        }
        // The factor is normal, so neither of the two leaves the range, and their product is normal.
        let exponent = if self.factor * velocity < 1.0 { 550 } else { -550 };
        let scale = power_of_two(exponent);
        fifth_root((self.factor * scale) * (velocity * scale)) * power_of_two(-exponent * 2 / 5)
    }

    /// Returns the impact velocity that belongs to `u`, in six roundings; infinite where it overflows, NaN below zero.
    #[must_use]
    pub fn velocity(&self, u: f64) -> f64 {
        if !(u > 0.0 && u.is_finite() && self.factor.is_finite()) {
            return if u >= 0.0 && self.factor.is_finite() { u } else { f64::NAN };
        }
        let (u, u_exponent) = normalized(u);
        let (factor, factor_exponent) = normalized(self.factor);
        let u2 = u * u;
        let exponent = (5 * u_exponent - factor_exponent).clamp(-1200, 1200);
        let half = exponent / 2;
        u2 * u2 * u / factor * power_of_two(half) * power_of_two(exponent - half)
    }

    /// Returns the coefficient of restitution at an impact velocity; NaN below zero.
    #[inline]
    #[must_use]
    pub fn epsilon(&self, velocity: f64) -> f64 {
        let x = self.factor * velocity;
        if !is_ordinary(x) {
            return epsilon(self.u(velocity), self.end);
        }
        match self.end {
            End::ZeroCompression => ZeroCompression::epsilon_of_root(Root::of(x)),
            End::ZeroForce => ZeroForce::epsilon_of_root(Root::of(x)),
        }
    }

    /// Returns one less the coefficient of restitution, accurate where that is close to one.
    #[inline]
    #[must_use]
    pub fn one_minus_epsilon(&self, velocity: f64) -> f64 {
        one_minus_epsilon(self.u(velocity), self.end)
    }
}

/// `2^exponent` of a normal number.
fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(u64::from((1023 + exponent).unsigned_abs()) << 52)
}

/// Splits a positive finite number into one of `[1, 2)` and its exponent; of a subnormal number the first is smaller.
fn normalized(x: f64) -> (f64, i32) {
    let exponent = (x.to_bits() >> 52) as i32 - 1023;
    (x * power_of_two(-exponent / 2) * power_of_two(-exponent + exponent / 2), exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    const ENDS: [End; 2] = [End::ZeroCompression, End::ZeroForce];

    #[test]
    fn a_velocity_below_zero_has_no_coefficient_however_small() {
        for end in ENDS {
            for factor in [1e-300, 1.0, 1e300] {
                let law = Restitution::from_factor(factor, end);
                for velocity in [-5e-324, -1e-310, -1.0, -f64::MAX, f64::NEG_INFINITY, f64::NAN, -f64::NAN] {
                    assert!(law.epsilon(velocity).is_nan(), "{velocity:e}");
                    assert!(law.one_minus_epsilon(velocity).is_nan() && law.u(velocity).is_nan());
                    assert!(law.velocity(velocity).is_nan());
                }
                assert_eq!((law.epsilon(-0.0), law.one_minus_epsilon(-0.0)), (1.0, 0.0));
                assert_eq!((law.epsilon(f64::INFINITY), law.velocity(f64::INFINITY)), (0.0, f64::INFINITY));
            }
        }
    }

    #[test]
    fn products_beyond_the_range_have_their_root() {
        for (factor, velocity, u) in [
            (1e300, 1e300, 1e120),
            (1e-300, 1e-300, 1e-120),
            (1e300, 1e-300, 1.0),
            (f64::MAX, f64::MAX, 2.003_946_966_571_920_8e123), // MAX^(2/5)
            (f64::MIN_POSITIVE, 5e-324, 6.430_219_789_291_553_4e-127),
        ] {
            let law = Restitution::from_factor(factor, End::ZeroForce);
            assert!((law.u(velocity) / u - 1.0).abs() <= 1e-14, "{:e}", law.u(velocity));
            let back = law.velocity(u) / velocity;
            assert!(velocity < f64::MIN_POSITIVE || (back - 1.0).abs() <= 1e-13, "{back}");
        }
        let fast = Restitution::from_factor(1e300, End::ZeroForce);
        assert!((fast.epsilon(1e300) / 1.310_370_697_104_448_2e-200 - 1.0).abs() < 1e-15);
        let slow = Restitution::from_factor(1e-300, End::ZeroCompression);
        assert!((slow.one_minus_epsilon(1e-300) / 1.153_448_858_095_288_8e-120 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn a_scale_of_velocities_gives_the_damping() {
        let slope: f64 = 1.153_448_858_095_288_8; // -C_1
        for end in ENDS {
            for g_star in [0.0032, 1.0, 7.5] {
                let law = Restitution::from_g_star(g_star, end);
                assert!((law.factor() * g_star * slope.powi(5) - 1.0).abs() < 4e-15, "{g_star}");
                assert!(
                    (law.g_star() / g_star - 1.0).abs() < 4e-15
                        && (law.u(g_star) * slope - 1.0).abs() < 2e-15
                );
            }
            for u_1 in [0.3, 1.0, 2.5] {
                let law = Restitution::from_u_at_unit_velocity(u_1, end);
                assert!(
                    (law.factor() / f64::powi(u_1, 5) - 1.0).abs() < 2e-15
                        && (law.u(1.0) / u_1 - 1.0).abs() < 1e-15
                );
                // g = (u/u_1)^5, from subnormal to large ones
                for u in [1e-63, 1e-62, 1e-20, 0.125, 40.0, 1e60] {
                    let g = law.velocity(u);
                    assert!(
                        (law.u(g) / u - 1.0).abs() < if g < 1e-307 { 1e-6 } else { 2e-15 },
                        "{u:e} {g:e}"
                    );
                }
            }
            for none in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-310] {
                let law = Restitution::from_factor(none, end);
                assert!(law.factor().is_nan() && law.u(1.0).is_nan() && law.velocity(1.0).is_nan());
                assert!(law.u(0.0).is_nan() && law.u(f64::INFINITY).is_nan() && law.epsilon(0.0).is_nan());
            }
        }
    }
}
