use super::curve::Curve;
use super::end::End;
use super::epsilon::epsilon;
use super::fifth_root::fifth_root;
use super::pieces::WORDS;
use super::tables::zero_compression::{NEAR, R5};
use super::tables::zero_force::LIMIT;
use super::zero_compression::ZeroCompression;
use super::zero_force::ZeroForce;

/// Steps after which an iteration has long been where it ends.
const STEPS: usize = 40;

/// Returns the `u` at which the coefficient of restitution is `epsilon`: the inverse of [`crate::epsilon`].
///
/// 0 for 1, infinite for 0, NaN outside `[0, 1]`.
///
/// A table is searched for the piece, then Newton's iteration runs in it; near 0 and at large `u` the
/// iteration runs on the forms that hold there.
///
/// # Error bound
///
/// [`bounds::INVERSE`](crate::bounds::INVERSE): the exact coefficient at the result differs from the one asked for by
/// at most 1e-15 relative (measured); above 1/2 that holds for `1 - epsilon`. The rounding of the result counts up to
/// five times, as `|d ln epsilon/d ln u| <= 5`. Below 1e-290 the coefficient asked for has few bits itself.
///
/// # Examples
///
/// ```
/// use restitution::{End, epsilon, u_of_epsilon};
///
/// let u = u_of_epsilon(0.5, End::ZeroForce);
/// assert!((epsilon(u, End::ZeroForce) - 0.5).abs() < 3e-16);
/// assert_eq!(u_of_epsilon(1.0, End::ZeroForce), 0.0);
/// assert!(u_of_epsilon(1.1, End::ZeroForce).is_nan());
/// ```
#[must_use]
pub fn u_of_epsilon(epsilon: f64, end: End) -> f64 {
    if (0.0..=1.0).contains(&epsilon) { solve(epsilon, 1.0 - epsilon, end) } else { f64::NAN }
}

/// Returns the `u` at which a collision loses `lost = 1 - epsilon`: the inverse of [`crate::one_minus_epsilon`].
///
/// Of a coefficient near 1, `1 - epsilon` has digits that `epsilon` in double precision lacks. 0 for 0, infinite for 1, NaN outside `[0, 1]`.
///
/// # Error bound
///
/// That of [`u_of_epsilon`], for `1 - epsilon` down to the smallest.
///
/// # Examples
///
/// ```
/// use restitution::{End, one_minus_epsilon, u_of_one_minus_epsilon};
///
/// let u = u_of_one_minus_epsilon(1e-12, End::ZeroCompression); // of epsilon = 0.999999999999
/// assert!((one_minus_epsilon(u, End::ZeroCompression) / 1e-12 - 1.0).abs() < 1e-15);
/// assert!(u_of_one_minus_epsilon(-1e-12, End::ZeroForce).is_nan());
/// ```
#[must_use]
pub fn u_of_one_minus_epsilon(lost: f64, end: End) -> f64 {
    if (0.0..=1.0).contains(&lost) { solve(1.0 - lost, lost, end) } else { f64::NAN }
}

fn solve(epsilon: f64, lost: f64, end: End) -> f64 {
    if epsilon == 0.0 {
        return f64::INFINITY;
    }
    match end {
        End::ZeroCompression => on::<ZeroCompression>(epsilon, lost).unwrap_or_else(|| saturated(epsilon)),
        End::ZeroForce => on::<ZeroForce>(epsilon, lost).unwrap_or_else(|| overdamped(epsilon)),
    }
}

/// Where the form near 0 or the table of a curve serves.
fn on<C: Curve>(epsilon: f64, lost: f64) -> Option<f64> {
    if lost < C::near(C::NEAR_END) {
        Some(near_zero::<C>(lost))
    } else {
        (epsilon >= C::epsilon(C::END.next_down())).then(|| in_table::<C>(epsilon, lost))
    }
}

/// Solves `1 - epsilon(u) = lost` by Newton's iteration with the slope at 0.
fn near_zero<C: Curve>(lost: f64) -> f64 {
    let mut u = lost / NEAR[0];
    for _ in 0..STEPS {
        let step = (lost - C::near(u)) / NEAR[0];
        u += step;
        if step.abs() <= u * f64::EPSILON / 4.0 {
            break;
        }
    }
    u
}

/// Finds the piece by halving, as `epsilon` falls, then solves `c_0 + t slope(t) = epsilon`.
fn in_table<C: Curve>(epsilon: f64, lost: f64) -> f64 {
    let piece = |index: usize| C::TABLE.row(index as u64 * WORDS);
    let (mut above, mut below) = (0, C::COUNT - 1);
    while below - above > 1 {
        let middle = usize::midpoint(above, below);
        if piece(middle).constant() > epsilon { above = middle } else { below = middle }
    }
    let nearer_above = piece(above).constant() - epsilon < epsilon - piece(below).constant();
    let index = if nearer_above { above } else { below };
    let piece = piece(index);
    let wanted = if epsilon > 0.5 { piece.complement() - lost } else { epsilon - piece.constant() };
    let mut t = wanted / piece.slope(0.0);
    for _ in 0..STEPS {
        let next = wanted / piece.slope(t);
        let change = (next - t).abs();
        t = next;
        if change <= t.abs() * f64::EPSILON {
            break;
        }
    }
    C::GRID.centre(index) + t
}

/// `u = (R^5/epsilon)^(1/5)`, and by the ratio that is still missing.
fn saturated(wanted: f64) -> f64 {
    const TWO_TO_200: f64 = f64::from_bits((1023 + 200) << 52);
    const TWO_TO_40: f64 = f64::from_bits((1023 + 40) << 52);
    let u = fifth_root(R5[0] / (wanted * TWO_TO_200)) * TWO_TO_40;
    if wanted < f64::MIN_POSITIVE {
        return u;
    }
    u + u * (0.2 * (epsilon(u, End::ZeroCompression) / wanted - 1.0))
}

/// From `u = ((3/2)^(2/3)/epsilon)^(3/5)`, by the ratio that is still missing.
fn overdamped(wanted: f64) -> f64 {
    const TWO_TO_500: f64 = f64::from_bits((1023 + 500) << 52);
    const TWO_TO_300: f64 = f64::from_bits((1023 + 300) << 52);
    let root = fifth_root(LIMIT[0] / (wanted * TWO_TO_500));
    let mut u = root * root * root * TWO_TO_300;
    if wanted < 1e-250 {
        return u;
    }
    for _ in 0..STEPS {
        let ratio = epsilon(u, End::ZeroForce) / wanted - 1.0;
        u += u * (0.6 * ratio);
        if ratio.abs() <= 2.0 * f64::EPSILON {
            break;
        }
    }
    u
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_of_the_interval() {
        for end in [End::ZeroCompression, End::ZeroForce] {
            assert_eq!(u_of_epsilon(1.0, end), 0.0);
            assert_eq!(u_of_epsilon(0.0, end), f64::INFINITY);
            for wrong in [-1e-300, 1.0 + f64::EPSILON, f64::NAN, f64::INFINITY] {
                assert!(u_of_epsilon(wrong, end).is_nan());
            }
            assert!(u_of_epsilon(5e-324, end).is_finite());
        }
    }

    #[test]
    fn the_way_there_and_back() {
        for i in 1..2000 {
            for wanted in [f64::from(i) / 2000.0, 0.99_f64.powi(i), 1.0 - 0.985_f64.powi(i)] {
                for end in [End::ZeroCompression, End::ZeroForce] {
                    let back = epsilon(u_of_epsilon(wanted, end), end);
                    let loss = crate::one_minus_epsilon(u_of_one_minus_epsilon(wanted, end), end);
                    assert!((loss / wanted - 1.0).abs() <= 1e-15 || wanted > 0.5, "{wanted}: {loss}");
                    let lost = crate::one_minus_epsilon(u_of_epsilon(wanted, end), end);
                    assert!(wanted < 0.5 || (lost / (1.0 - wanted) - 1.0).abs() <= 1e-15, "{wanted}: {lost}");
                    assert!((back / wanted - 1.0).abs() <= 1e-15, "{wanted}: {back}");
                }
            }
        }
    }
}
