//! The contact that ends at zero compression.

use super::fifth_root::Root;
use super::pieces::Rows;
use super::rounding::Number;
use super::tables::zero_compression::{INNER, NEAR, OUTER_GRID, PIECES};

pub(crate) use super::tables::zero_compression::{GRID, NEAR_END};

/// The pieces, for batches: those in `u`, then those of the power law in the significand of `u`.
pub(crate) static TABLE: Rows<ROWS> = Rows::of(&PIECES);
pub(crate) const ROWS: usize = PIECES.len().next_power_of_two();

/// Below, `epsilon` is 1; the table gives that but for its rounding.
pub(crate) const NOTHING_LOST: f64 = f64::EPSILON / 16.0;
/// From here on an argument is rounded beyond the table.
pub(crate) const TABLE_END: f64 = GRID.end(INNER);
/// Below, the power law needs no more than one power of two.
pub(crate) const LARGE: f64 = f64::from_bits((1023 + 200) << 52);

#[inline(always)]
pub(crate) fn epsilon(u: f64) -> f64 {
    let (index, centre) = GRID.locate(u);
    match PIECES.get(index) {
        Some(piece) if index < INNER && u >= NOTHING_LOST => piece.value(u - centre),
        _ => beyond(u, 0.0),
    }
}

#[inline(always)]
pub(crate) fn epsilon_of_root(root: Root) -> f64 {
    let (index, centre) = GRID.locate(root.estimate());
    match PIECES.get(index) {
        Some(piece) if index < INNER => piece.value(root.distance(centre)),
        _ => far_root(root),
    }
}

#[inline(always)]
pub(crate) fn one_minus_epsilon(u: f64) -> f64 {
    if u < NEAR_END {
        return if u >= 0.0 { near(u) } else { f64::NAN };
    }
    let (index, centre) = GRID.locate(u);
    match PIECES.get(index) {
        Some(piece) if index < INNER => piece.one_minus(u - centre),
        _ => 1.0 - beyond(u, 0.0),
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

fn far_root(root: Root) -> f64 {
    let u = root.distance(0.0);
    beyond(u, root.distance(u))
}

/// `epsilon(u + low)` for `u >= TABLE_END`, for next to no `u`, and for what is not a velocity.
fn beyond(u: f64, low: f64) -> f64 {
    const SCALE: f64 = f64::from_bits((1023 - 100) << 52);
    const SCALE_TO_5: f64 = f64::from_bits((1023 - 500) << 52);
    const ALL_STOPPED: f64 = f64::from_bits((1023 + 216) << 52);
    if u < NOTHING_LOST {
        return if u >= 0.0 { 1.0 } else { f64::NAN };
    }
    if u < LARGE {
        return power_law(u, low);
    }
    if u >= ALL_STOPPED {
        return 0.0;
    }
    if u.is_nan() { u } else { power_law(u * SCALE, low * SCALE) * SCALE_TO_5 }
}

#[inline(always)]
fn power_law(u: f64, low: f64) -> f64 {
    let (index, t, power) = place_beyond(u, low);
    PIECES[(index as usize).min(PIECES.len() - 1)].value(t) * power
}

/// The row for `u + low` beyond the table, the distance from its centre and the power of two that is missing.
///
/// ```text
/// epsilon = R^5/u^5 (1 + O(1e-18)) = 2^(-5k) R^5/m^5,   u = 2^k m,  1 <= m < 2,  k <= 200
/// ```
#[inline(always)]
pub(crate) fn place_beyond(u: f64, low: f64) -> (u64, f64, f64) {
    const SIGNIFICAND: u64 = (1 << 52) - 1;
    let bits = u.to_bits();
    let exponent = bits >> 52;
    let m = f64::from_bits((bits & SIGNIFICAND) | 1.0_f64.to_bits());
    let shrunk = f64::from_bits((2046_u64.wrapping_sub(exponent) & 0x7ff) << 52); // 2^-k
    let (index, centre) = OUTER_GRID.locate(m);
    let power = f64::from_bits((6 * 1023_u64).wrapping_sub(5 * exponent) << 52);
    ((index + INNER) as u64, (m - centre) + low * shrunk, power)
}
