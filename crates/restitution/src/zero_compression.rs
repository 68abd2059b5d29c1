//! The contact that ends at zero compression.

use crate::fifth_root::Root;
use crate::rounding::{Number, two_product};
use crate::tables::zero_compression::{NEAR, PIECES, R5};

pub(crate) use crate::tables::zero_compression::{GRID, NEAR_END};

/// The pieces, for batches.
pub(crate) static TABLE: &[crate::pieces::Piece; ROWS] = &PIECES;
pub(crate) const ROWS: usize = PIECES.len();

/// What the rounded `R^5` lacks, relative to it.
const R5_RESIDUAL: f64 = R5[1] / R5[0];

/// Below, `epsilon` is 1; the table gives that but for its rounding.
pub(crate) const NOTHING_LOST: f64 = f64::EPSILON / 16.0;
/// From here on an argument is rounded beyond the table.
pub(crate) const TABLE_END: f64 = GRID.end(ROWS);
/// Below, no power of `u` overflows and no `u^(-5)` is subnormal.
pub(crate) const LARGE: f64 = f64::from_bits((1023 + 150) << 52);

#[inline(always)]
pub(crate) fn epsilon(u: f64) -> f64 {
    let (index, centre) = GRID.locate(u);
    match PIECES.get(index) {
        Some(piece) if u >= NOTHING_LOST => piece.value(u - centre),
        _ => beyond(u, 0.0),
    }
}

#[inline(always)]
pub(crate) fn epsilon_of_root(root: Root) -> f64 {
    let (index, centre) = GRID.locate(root.estimate());
    match PIECES.get(index) {
        Some(piece) => piece.value(root.distance(centre)),
        None => far_root(root),
    }
}

#[inline(always)]
pub(crate) fn one_minus_epsilon(u: f64) -> f64 {
    if u < NEAR_END {
        return if u >= 0.0 { near(u) } else { f64::NAN };
    }
    let (index, centre) = GRID.locate(u);
    match PIECES.get(index) {
        Some(piece) => piece.one_minus(u - centre),
        None => 1.0 - beyond(u, 0.0),
    }
}

/// `1 - epsilon` on `[0, NEAR_END)`.
#[inline(always)]
pub(crate) fn near<T: Number>(u: T) -> T {
    let c = |k: usize| u.of(NEAR[k]);
    let pair = |k: usize| u.clone().multiply_add(c(k + 1), c(k));
    let u2 = u.clone() * u.clone();
    let low = u2.clone().multiply_add(pair(3), pair(1));
    let high = u2.clone().multiply_add(c(7), pair(5));
    let u4 = u2.clone() * u2;
    u.clone() * u.clone().multiply_add(u4.multiply_add(high, low), c(0))
}

#[cold]
fn far_root(root: Root) -> f64 {
    let u = root.distance(0.0);
    beyond(u, root.distance(u))
}

/// `epsilon(u + low)` for `u >= TABLE_END`, for next to no `u`, and for what is not a velocity.
///
/// ```text
/// epsilon = R^5/u^5 (1 + O(1e-18))
/// ```
///
/// The roundings of the powers are carried along; those of their sum and of the division remain.
#[cold]
fn beyond(u: f64, low: f64) -> f64 {
    const SCALE: f64 = f64::from_bits((1023 - 100) << 52);
    const SCALE_TO_5: f64 = f64::from_bits((1023 - 500) << 52);
    const ALL_STOPPED: f64 = f64::from_bits((1023 + 216) << 52);
    if u < NOTHING_LOST {
        return if u >= 0.0 { 1.0 } else { f64::NAN };
    }
    if u < LARGE {
        return inverse_fifth_power(u, low);
    }
    if u >= ALL_STOPPED {
        return 0.0;
    }
    inverse_fifth_power(u * SCALE, low * SCALE) * SCALE_TO_5 // NaN comes through here
}

/// `R^5/(u + low)^5`.
#[inline(always)]
pub(crate) fn inverse_fifth_power(u: f64, low: f64) -> f64 {
    let (u2, error2) = two_product(u, u);
    let (u4, error4) = two_product(u2, u2);
    let (u5, error5) = two_product(u4, u);
    let error4 = error4 + 2.0 * u2 * error2 + 5.0 * (u4 / u) * low;
    R5[0] / (u5 + (error5 + u * error4 - u5 * R5_RESIDUAL))
}
