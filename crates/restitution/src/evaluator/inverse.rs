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

/// Finds the piece that a coefficient belongs to, and what is missing at its centre.
///
/// The index knows the last centre above it, or the one before. Of the two centres around it the nearer one is taken, in half widths
/// of their pieces: `epsilon` bends so little between them that no distance exceeds 1.04 of a half width (`no_distance_leaves_its_piece`).
#[inline(always)]
pub(crate) fn place<C: Curve>(kept: f64, lost: f64) -> (usize, f64) {
    let constant = |index: usize| C::TABLE.row(index as u64 * WORDS).constant();
    let before = C::INDEX.before(kept, lost);
    let above = before + usize::from(constant(before + 1) > kept);
    let below = above + 1; // beyond the pieces the table has zeros, which are farther
    let end = C::GRID.start(below);
    let half_widths = [end - C::GRID.centre(above), C::GRID.centre(below) - end];
    let nearer = (constant(above) - kept) * half_widths[1] < (kept - constant(below)) * half_widths[0];
    let index = if nearer { above } else { below };
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

    /// What the distance is off by after the steps at most, relative to it: bounds of the start's error by the terms that are left out, of
    /// each step's by the terms that the tangent lacks and by the curvature. No rounding is counted.
    fn unsettled<C: Curve>() -> f64 {
        let mut largest = 0.0_f64;
        for index in 0..C::COUNT {
            let c = C::TABLE.row(index as u64 * WORDS).all();
            let t = 1.04 * (C::GRID.centre(index) - C::GRID.start(index));
            let r = |k: usize| (c[k] / c[1]).abs() * t.powi(k as i32 - 1);
            let sum = |from: usize, weight: &dyn Fn(f64) -> f64| {
                (from..8).map(|k| weight(k as f64) * r(k)).sum::<f64>()
            };
            let least_slope = 1.0 - sum(2, &|k| k);
            // |x/t| is 1 + q at most; F(x (1 + b x + (2 b^2 + d) x^2)) without its terms to the third order, all of them positive
            let x = 1.0 + sum(2, &|_| 1.0);
            let (b, d) = (r(2), r(3));
            let start = x * (1.0 + b * x + (2.0 * b * b + d) * x * x);
            let whole = start + (2..8).map(|k| r(k) * start.powi(k as i32)).sum::<f64>();
            let kept = x + 2.0 * b * x.powi(2) + (2.0 * b * b + 2.0 * d + 2.0 * b * b) * x.powi(3);
            let mut off = (whole - kept) / least_slope;
            for _ in 0..2 {
                let (missing, bend) = (sum(5, &|k| k), sum(2, &|k| k * (k - 1.0)));
                off *= (missing + bend * off) / (least_slope * (1.0 - off));
            }
            largest = largest.max(off);
        }
        largest
    }

    #[test]
    fn every_distance_has_settled() {
        for off in [unsettled::<ZeroCompression>(), unsettled::<ZeroForce>()] {
            assert!(off > 0.0 && off < f64::EPSILON / 64.0, "{off:e}");
        }
    }

    /// At the centres, the ends and near the ends of all pieces.
    fn largest_distance<C: Curve>() -> f64 {
        let mut largest = 0.0_f64;
        for index in 0..C::COUNT - 1 {
            let (start, end) = (C::GRID.start(index), C::GRID.start(index + 1));
            for part in [0.0, 1e-9, 0.01, 0.02, 0.05, 0.5, 0.95, 0.98, 0.99, 1.0 - 1e-9] {
                let u = start + part * (end - start);
                let (kept, lost) = (C::epsilon(u), C::one_minus_epsilon(u));
                if is_in_table::<C>(kept, lost) {
                    let (place, change) = place::<C>(kept, lost);
                    let distance = C::TABLE.row(place as u64 * WORDS).distance(change);
                    let half_width = C::GRID.centre(place) - C::GRID.start(place);
                    largest = largest.max(distance.abs() / half_width);
                }
            }
        }
        largest
    }

    #[test]
    fn no_distance_leaves_its_piece() {
        let largest = largest_distance::<ZeroCompression>().max(largest_distance::<ZeroForce>());
        assert!(largest > 0.999 && largest <= 1.04, "{largest}");
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
