use super::curve::Curve;
use super::end::End;
use super::pieces::WORDS;
use super::zero_compression::ZeroCompression;
use super::zero_force::ZeroForce;

/// Returns the `u` at which the coefficient of restitution is `epsilon`: the inverse of [`crate::epsilon`].
///
/// 0 for 1, infinite for 0, NaN outside `[0, 1]`.
///
/// A table is searched for the piece, of which the polynomial is inverted; near 0 and at large `u` the forms that hold there
/// are. [`u_of_epsilon_batch`](crate::u_of_epsilon_batch) does the same for many.
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
    at(epsilon, Given::Kept, end)
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
    at(lost, Given::Lost, end)
}

/// What is given of a coefficient.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Given {
    /// `epsilon`.
    Kept,
    /// `1 - epsilon`.
    Lost,
}

impl Given {
    /// `epsilon` and `1 - epsilon`.
    #[inline(always)]
    pub(crate) fn both(self, value: f64) -> [f64; 2] {
        match self {
            Self::Kept => [value, 1.0 - value],
            Self::Lost => [1.0 - value, value],
        }
    }
}

fn at(value: f64, given: Given, end: End) -> f64 {
    match end {
        End::ZeroCompression => inverse::<ZeroCompression>(value, given),
        End::ZeroForce => inverse::<ZeroForce>(value, given),
    }
}

/// The `u` of a coefficient.
pub(crate) fn inverse<C: Curve>(value: f64, given: Given) -> f64 {
    let [kept, lost] = given.both(value);
    if is_near::<C>(lost) {
        near_zero::<C>(lost)
    } else if is_in_table::<C>(kept, lost) {
        let (index, change) = place::<C>(kept, lost);
        C::GRID.centre(index) + C::TABLE.row(index as u64 * WORDS).distance(change)
    } else if kept == 0.0 {
        f64::INFINITY
    } else if kept > 0.0 && kept < 1.0 {
        C::inverse_beyond(kept)
    } else {
        f64::NAN
    }
}

/// Whether the form near 0 serves: there `1 - epsilon` is larger than `u`.
#[inline(always)]
pub(crate) fn is_near<C: Curve>(lost: f64) -> bool {
    (0.0 <= lost) & (lost < C::NEAR_END)
}

/// Whether a piece of the table serves.
#[inline(always)]
pub(crate) fn is_in_table<C: Curve>(kept: f64, lost: f64) -> bool {
    (C::NEAR_END <= lost) & (C::TABLE.row((C::COUNT - 1) as u64 * WORDS).constant() <= kept)
}

/// Solves `1 - epsilon(u) = lost` from two terms of the inverse series, by three steps of Newton's iteration.
///
/// The start is off by 3e-3 of `u`, the steps leave 1e-6, 1e-11 and 1e-16 of it.
#[inline(always)]
pub(crate) fn near_zero<C: Curve>(lost: f64) -> f64 {
    let x = lost / C::NEAR[0];
    let mut u = x - C::NEAR[1] / C::NEAR[0] * (x * x);
    for _ in 0..3 {
        u += (lost - C::near(u)) / C::near_slope(u);
    }
    u
}

/// Finds the piece whose centre is nearest in `epsilon`, which falls, and what is missing there.
///
/// The index knows the last centre above it, or the one before.
#[inline(always)]
pub(crate) fn place<C: Curve>(kept: f64, lost: f64) -> (usize, f64) {
    let constant = |index: usize| C::TABLE.row(index as u64 * WORDS).constant();
    let before = C::INDEX.before(kept, lost);
    let above = before + usize::from(constant(before + 1) > kept);
    let below = above + 1; // beyond the pieces the table has zeros, which are farther
    let index = if constant(above) - kept < kept - constant(below) { above } else { below };
    let piece = C::TABLE.row(index as u64 * WORDS);
    (index, if kept > 0.5 { piece.complement() - lost } else { kept - piece.constant() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::epsilon;

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
