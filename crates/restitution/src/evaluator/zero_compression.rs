//! The contact that ends at zero compression.

use super::curve::{Curve, ROWS};
use super::pieces::{Piece, Rows};
use super::rounding::{Number, Rooted};
use super::tables::zero_compression::{GRID, INNER, NEAR, NEAR_END, OUTER_GRID, PIECES};

/// The pieces, for batches: those in `u`, then those of the power law in the significand of `u`.
static TABLE: Rows<ROWS> = Rows::of(&PIECES);
/// From here on an argument is rounded beyond the pieces in `u`.
const TABLE_END: f64 = GRID.end(INNER);
/// Below, the power law needs no more than one power of two.
const LARGE: f64 = f64::from_bits((1023 + 200) << 52);

/// The end at zero compression.
pub(crate) struct ZeroCompression;

impl Curve for ZeroCompression {
    const TABLE: &'static Rows<ROWS> = &TABLE;
    const NEAR_END: f64 = NEAR_END;
    const END: f64 = LARGE;
    const HAS_POWER: bool = true;

    #[inline(always)]
    fn is_other(u: f64) -> bool {
        u >= TABLE_END
    }

    #[inline(always)]
    fn place(u: f64) -> (u64, f64) {
        let (index, centre) = GRID.locate(u);
        (index as u64, centre)
    }

    /// In the significand of `u`, with the power of two that is missing.
    ///
    /// ```text
    /// epsilon = R^5/u^5 (1 + O(1e-18)) = 2^(-5k) R^5/m^5,   u = 2^k m,  1 <= m < 2,  k <= 200
    /// ```
    #[inline(always)]
    fn place_other(u: f64, low: f64) -> (u64, f64, f64) {
        const SIGNIFICAND: u64 = (1 << 52) - 1;
        let bits = u.to_bits();
        let exponent = bits >> 52;
        let m = f64::from_bits((bits & SIGNIFICAND) | 1.0_f64.to_bits());
        let shrunk = f64::from_bits((2046_u64.wrapping_sub(exponent) & 0x7ff) << 52); // 2^-k
        let (index, centre) = OUTER_GRID.locate(m);
        let power = f64::from_bits((6 * 1023_u64).wrapping_sub(5 * exponent) << 52);
        ((index + INNER) as u64, (m - centre) + low * shrunk, power)
    }

    #[inline(always)]
    fn piece(u: f64, distance: impl Fn(f64) -> f64) -> Option<(&'static Piece, f64)> {
        let (index, centre) = GRID.locate(u);
        match PIECES.get(index) {
            Some(piece) if index < INNER && u >= Self::NOTHING_LOST => Some((piece, distance(centre))),
            _ => None,
        }
    }

    fn beyond(u: f64, low: f64) -> f64 {
        const SCALE: f64 = f64::from_bits((1023 - 100) << 52);
        const SCALE_TO_5: f64 = f64::from_bits((1023 - 500) << 52);
        const ALL_STOPPED: f64 = f64::from_bits((1023 + 216) << 52);
        if u < NEAR_END {
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
    fn near<T: Rooted>(u: T) -> T {
        near(u)
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

#[inline(always)]
fn power_law(u: f64, low: f64) -> f64 {
    let (index, t, power) = ZeroCompression::place_other(u, low);
    PIECES[(index as usize).min(PIECES.len() - 1)].value(t) * power
}
