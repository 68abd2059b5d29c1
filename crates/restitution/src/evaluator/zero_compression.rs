//! The contact that ends at zero compression.

use super::curve::Curve;
use super::fifth_root::fifth_root;
use super::index::Index;
use super::pieces::{Grid, ROWS, Rows, WORDS};
use super::rounding::{Number, Rooted};
use super::tables::zero_compression::{COUNT, GRID, NEAR, NEAR_END, R5, TABLE};

/// The end at zero compression.
pub(crate) struct ZeroCompression;

static INDEX: Index = Index::of(&TABLE, COUNT);

impl Curve for ZeroCompression {
    const TABLE: &'static Rows<ROWS> = &TABLE;
    const INDEX: &'static Index = &INDEX;
    const GRID: Grid = GRID;
    const COUNT: usize = COUNT;
    const NEAR_END: f64 = NEAR_END;

    /// By the pieces for `2^8 <= u < 2^9`, where the exit speed has long been saturated.
    ///
    /// ```text
    /// epsilon = R^5/u^5 (1 + O(1e-18)),   epsilon(2^k u) = 2^(-5k) epsilon(u)
    /// ```
    fn beyond(u: f64, low: f64) -> f64 {
        const ALL_STOPPED: f64 = f64::from_bits((1023 + 216) << 52);
        const LARGE: f64 = f64::from_bits((1023 + 200) << 52); // below, the power is normal
        const SCALE: f64 = f64::from_bits((1023 - 100) << 52);
        const SCALE_TO_5: f64 = f64::from_bits((1023 - 500) << 52);
        if u >= ALL_STOPPED {
            return 0.0;
        }
        if u < LARGE { power_law(u, low) } else { power_law(u * SCALE, low * SCALE) * SCALE_TO_5 }
    }

    #[inline(always)]
    fn near<T: Rooted>(u: T) -> T {
        near(u)
    }

    const NEAR: [f64; 2] = [NEAR[0], NEAR[1]];

    #[inline(always)]
    fn near_slope(u: f64) -> f64 {
        NEAR[0] + u * (2.0 * NEAR[1] + u * (3.0 * NEAR[2] + u * (4.0 * NEAR[3])))
    }

    /// `u = (R^5/epsilon)^(1/5)`, then by the ratio that is still missing; all of it `2^-40` times as large, where every power is normal.
    fn inverse_beyond(kept: f64) -> f64 {
        const TWO_TO_200: f64 = f64::from_bits((1023 + 200) << 52);
        const TWO_TO_40: f64 = f64::from_bits((1023 + 40) << 52);
        let kept = kept * TWO_TO_200;
        let u = fifth_root(R5[0] / kept);
        (u + u * (0.2 * (power_law(u, 0.0) / kept - 1.0))) * TWO_TO_40
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

/// `epsilon(2^k m) = 2^(-5k) epsilon(m)`, `2^8 <= m < 2^9`.
fn power_law(u: f64, low: f64) -> f64 {
    const EXPONENT: u64 = 1023 + 8;
    const SIGNIFICAND: u64 = (1 << 52) - 1;
    let k = (u.to_bits() >> 52).wrapping_sub(EXPONENT);
    let m = f64::from_bits((u.to_bits() & SIGNIFICAND) | (EXPONENT << 52));
    let power = |exponent: u64| f64::from_bits(1023_u64.wrapping_sub(exponent) << 52);
    let (index, centre) = GRID.locate(m);
    TABLE.row(index as u64 * WORDS).value((m - centre) + low * power(k)) * power(k.wrapping_mul(5))
}
