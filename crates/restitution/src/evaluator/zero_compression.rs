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
    ///
    /// `2^-100` of `u`, where every power is normal.
    fn beyond(u: f64, low: f64) -> f64 {
        const ALL_STOPPED: f64 = f64::from_bits((1023 + 216) << 52);
        const SCALE: f64 = f64::from_bits((1023 - 100) << 52);
        const SCALE_TO_5: f64 = f64::from_bits((1023 - 500) << 52);
        if u >= ALL_STOPPED {
            return 0.0;
        }
        power_law(u * SCALE, low * SCALE) * SCALE_TO_5
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

#[cfg(all(test, feature = "std"))]
mod tests {
    use crate::{End, Restitution, epsilon, one_minus_epsilon, u_of_epsilon};

    const END: End = End::ZeroCompression;
    const R5: f64 = 5.158_381_704_267_685;

    #[test]
    fn certified_values_are_given() {
        for (u, kept) in [
            (0.01, 0.988_544_818_656_846_1),
            (1.0, 0.331_164_810_466_640_9),
            (30.0, 2.122_790_824_801_516_6e-7),
            (500.0, 1.650_682_145_365_659_3e-13),
            (2000.0, 1.611_994_282_583_651_6e-16),
            (1e6, 5.158_381_704_267_685e-30),
        ] {
            assert!((epsilon(u, END) / kept - 1.0).abs() <= 2.0 * f64::EPSILON, "{u}");
            assert!((one_minus_epsilon(u, END) / (1.0 - kept) - 1.0).abs() <= 1e-14, "{u}");
        }
    }

    /// `epsilon(2^k u) = 2^(-5k) epsilon(u)` to the bit from the table's last pieces on, then rounded to subnormal numbers, and 0.
    #[test]
    fn beyond_the_table_speeds_are_saturated() {
        let power = |k: i32| 2.0_f64.powi(k);
        for m in [256.0, 300.25, 400.125, 511.9375] {
            let kept = epsilon(m, END);
            assert!((kept / (R5 / f64::powi(m, 5)) - 1.0).abs() < 2e-15);
            for k in 2..235 {
                let found = epsilon(m * power(k), END);
                let wanted =
                    if k < 190 { kept * power(-5 * k) } else { kept * power(-900) * power(900 - 5 * k) };
                assert!(found == wanted || (found - wanted).abs() <= 5e-324, "{m} {k}: {found:e} {wanted:e}");
                assert_eq!(one_minus_epsilon(m * power(k), END), 1.0 - found);
            }
        }
        assert_eq!([epsilon(power(216), END), epsilon(1e300, END), epsilon(f64::INFINITY, END)], [0.0; 3]);
        assert!(epsilon(power(213), END) > 0.0);
    }

    /// From a velocity `u^5` is the velocity itself, and so is `R^5/epsilon`.
    #[test]
    fn beyond_the_table_a_velocity_keeps_its_digits() {
        let law = Restitution::from_factor(1.0, END);
        for i in 0..2000 {
            let g = 1.3e16 * 1.37_f64.powi(i);
            if g < 1e300 {
                assert!((law.epsilon(g) * g / R5 - 1.0).abs() <= 3.0 * f64::EPSILON, "{g:e}");
            }
        }
    }

    #[test]
    fn beyond_the_table_the_inverse_is_a_fifth_root() {
        for i in 0..1300 {
            let u = 1050.0 * 1.1_f64.powi(i);
            if u > 1e60 {
                break;
            }
            let back = u_of_epsilon(R5 / (u * u * u * u * u), END);
            assert!((back / u - 1.0).abs() <= 1e-15, "{u:e} {back:e}");
        }
        // The smallest number is that of no larger u.
        let last = u_of_epsilon(5e-324, END);
        assert!((last / 6.364_228e64 - 1.0).abs() < 1e-6, "{last:e}");
    }
}
