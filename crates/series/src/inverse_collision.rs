//! The coefficient of restitution from the maximal compression, by the inverse collision (A28)-(A32).

use crate::turning_point::{power, reciprocal};
use crate::{Field, FractionalSeries, SeriesError};
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use restitution_law::ForceLaw;
use restitution_real::Ball;

/// Returns `eps(u) = 1 + C_1 u + C_2 u^2 + ...` from the compression `Y(u)`, to the same order.
///
/// Time reversed, the second half of the collision is the first half of one with impact velocity `eps`
/// and damping `w = -u eps^p`, and both reach the same compression (A28):
///
/// ```text
/// eps^(2/(a+1)) Y(w) = Y(u),    w = -u eps^p,    p = (2 gamma - a + 1)/(a + 1)
/// ```
///
/// Eliminating `eps` leaves one odd equation, `K(w) = -K(u)` with `K(u) = u (Y(u)/Y(0))^((2 gamma-a+1)/2)`
/// (the damping in the units of the turning point, MATH section 5), hence
///
/// ```text
/// w = K^(-1)(-K(u)),    eps = (Y(u)/Y(w))^((a+1)/2)
/// ```
///
/// Formal: no truncation error enters. `y_k` of even order `k = N` cancels from `C_N`. Where `p = -1/m`, the
/// coefficient `C_2m` is exactly zero: no enclosure could tell.
///
/// # Errors
///
/// [`SeriesError::ZeroConstantTerm`] if `Y(0)` may be zero.
pub(crate) fn restitution<T: Field>(law: &ForceLaw, compression: &[T]) -> Result<Vec<T>, SeriesError> {
    let half = |x: BigRational| x / BigRational::from_integer(2.into());
    let elastic = law.elastic_step();
    let len = compression.len();
    let y = scaled_to_one(compression)?;
    let exponent = half(law.velocity_exponent() * &elastic);
    let image = if exponent.is_zero() { negated_identity(len) } else { image_damping(&y, &exponent)? };
    let y = FractionalSeries::new(1, y);
    let y_at_image = y.compose(&image)?;
    let ratio = T::product(y.coefficients(), &reciprocal(y_at_image.coefficients())?, len);
    let mut restitution = power(&ratio, &half(elastic))?;
    if let Some(vanishing) = vanishing_order(law).and_then(|k| restitution.get_mut(k)) {
        *vanishing = T::zero();
    }
    Ok(restitution)
}

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

/// `w = K^(-1)(-K(u))` with `K = u y^exponent`.
fn image_damping<T: Field>(y: &[T], exponent: &BigRational) -> Result<FractionalSeries<T>, SeriesError> {
    let mut k = vec![T::zero()];
    k.extend(power(y, exponent)?);
    k.truncate(y.len());
    let k = FractionalSeries::new(1, k);
    k.reverse()?.compose(&k.scaled(-1, 1))
}

fn negated_identity<T: Field>(len: usize) -> FractionalSeries<T> {
    let mut coefficients = vec![T::zero(); len];
    if let Some(linear) = coefficients.get_mut(1) {
        *linear = -T::one();
    }
    FractionalSeries::new(1, coefficients)
}

/// `Y/Y(0)`, which begins with exactly 1.
fn scaled_to_one<T: Field>(compression: &[T]) -> Result<Vec<T>, SeriesError> {
    let inverse = reciprocal(&compression[..1])?;
    let rest = compression[1..].iter().map(|c| inverse[0].times(c));
    Ok(std::iter::once(inverse[0].ratio(1, 1)).chain(rest).collect())
}
