//! Coefficients that vanish exactly, which no enclosure could tell.

use num_traits::{One, Signed, ToPrimitive, Zero};
use restitution_law::ForceLaw;
use restitution_real::Ball;

/// Sets the coefficient that vanishes exactly, where there is one.
pub(crate) fn vanish(law: &ForceLaw, restitution: &mut [Ball]) {
    if let Some(vanishing) = vanishing_order(law).and_then(|k| restitution.get_mut(k)) {
        *vanishing = Ball::zero();
    }
}

/// The order `k = 2m > 0` with `C_k = 0` exactly, which there is for `p = -1/m`.
///
/// `w(u) = -u eps^p` is its own inverse, and `eps = (-u/w)^m`. Lagrange's formula `N [u^N] w^K = K [u^(-K)] w^(-N)`
/// (for the inverse function, here `w` itself) with `K = -m`, `N = m` says that `[u^m] w^(-m)`, up to a sign
/// `[u^2m] eps`, equals minus itself.
fn vanishing_order(law: &ForceLaw) -> Option<usize> {
    let p = law.velocity_exponent();
    let is_reciprocal = p.is_negative() && p.numer().abs().is_one();
    is_reciprocal.then(|| p.denom().to_usize()).flatten().map(|m| 2 * m)
}
