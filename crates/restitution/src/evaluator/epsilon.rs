use super::curve::Curve;
use super::end::End;
use super::zero_compression::ZeroCompression;
use super::zero_force::ZeroForce;

/// Returns the coefficient of restitution `epsilon(u)` of viscoelastic spheres.
///
/// ```text
/// x'' + u sqrt(x) x' + x^(3/2) = 0,   x(0) = 0,  x'(0) = 1,   epsilon(u) = -x'(end of contact)
/// u = (3/2) A (rho/m_eff)^(2/5) g^(1/5)
/// ```
///
/// (\[RPBS1999\], eqs. 5 and 6.) Defined for every f64: 1 at `u = 0` and -0, 0 at infinity (subnormal, then 0,
/// on the way), NaN for NaN and below zero.
///
/// Cost: a look-up of one cache line and a polynomial of degree 7, no division; at zero force a power of `u` takes over from
/// `u = 1023.99` on, with its rounding carried along.
///
/// # Error bound
///
/// [`bounds::EPSILON`](crate::bounds::EPSILON): at most 2 ulp (proved) where the result is normal; at zero
/// force from `u = 1023.99` on the same is measured. The proof is in `docs/evaluator.md`. Rounding makes `epsilon` rise between neighbouring arguments here and
/// there, by [`bounds::STEP_UP`](crate::bounds::STEP_UP).
///
/// # Examples
///
/// ```
/// use restitution::{End, epsilon};
///
/// assert!((epsilon(1.0, End::ZeroCompression) - 0.331_164_810_466_640_94).abs() < 1e-16);
/// assert!((epsilon(1.0, End::ZeroForce) - 0.393_930_603_229_873_2).abs() < 1e-16);
/// assert_eq!(epsilon(0.0, End::ZeroForce), 1.0);
/// assert!(epsilon(-1.0, End::ZeroCompression).is_nan());
/// ```
#[inline]
#[must_use]
pub fn epsilon(u: f64, end: End) -> f64 {
    match end {
        End::ZeroCompression => ZeroCompression::epsilon(u),
        End::ZeroForce => ZeroForce::epsilon(u),
    }
}

/// Returns `1 - epsilon(u)`, with all its digits where `epsilon` is close to 1.
///
/// ```text
/// 1 - epsilon(u) = -C_1 u - C_2 u^2 - …,   C_1 = -1.1534488580952888
/// ```
///
/// (\[RPBS1999\], eq. A30.) 0 at `u = 0`, 1 at infinity, NaN for NaN and below zero.
///
/// # Error bound
///
/// [`bounds::ONE_MINUS_EPSILON`](crate::bounds::ONE_MINUS_EPSILON): at most 3 ulp (proved) where the result is
/// normal, else one unit of the smallest subnormal more; `docs/evaluator.md` has the parts.
///
/// # Examples
///
/// ```
/// use restitution::{End, epsilon, one_minus_epsilon};
///
/// let lost = one_minus_epsilon(1e-20, End::ZeroCompression);
/// assert!((lost / 1.153_448_858_095_288_8e-20 - 1.0).abs() < 1e-15);
/// assert_eq!(1.0 - epsilon(1e-20, End::ZeroCompression), 0.0);
/// assert!(one_minus_epsilon(-1e-300, End::ZeroForce).is_nan());
/// ```
#[inline]
#[must_use]
pub fn one_minus_epsilon(u: f64, end: End) -> f64 {
    match end {
        End::ZeroCompression => ZeroCompression::one_minus_epsilon(u),
        End::ZeroForce => ZeroForce::one_minus_epsilon(u),
    }
}
