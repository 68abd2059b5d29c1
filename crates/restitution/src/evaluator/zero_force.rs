//! The contact that ends at zero force.

use super::curve::Curve;
use super::fifth_root::fifth_root;
use super::index::Index;
use super::pieces::{Grid, ROWS, Rows, polynomial};
use super::rounding::{Number, Rooted, square_root, two_product};
use super::tables::zero_force::{BEYOND, COUNT, GRID, LIMIT, NEAR_END, NEAR_HALVES, NEAR_WHOLES, TABLE};

/// Pieces of 1/32 of a factor of two in `u^(-1/3) + 1/16`.
const GRID_BEYOND: Grid = Grid::new(1.0 / 16.0, 5, 0.0);

/// The end at zero force.
pub(crate) struct ZeroForce;

static INDEX: Index = Index::of(&TABLE, COUNT);

impl Curve for ZeroForce {
    const TABLE: &'static Rows<ROWS> = &TABLE;
    const INDEX: &'static Index = &INDEX;
    const GRID: Grid = GRID;
    const COUNT: usize = COUNT;
    const NEAR_END: f64 = NEAR_END;

    /// ```text
    /// epsilon = (3/2)^(2/3) u^(-5/3) (1 + s(u^(-1/3)))
    /// ```
    ///
    /// `2^-300` of `u`, where every power that counts is normal, and `2^500` of `epsilon`.
    #[cold]
    fn beyond(u: f64, low: f64) -> f64 {
        const SCALE: f64 = f64::from_bits((1023 - 300) << 52);
        const SCALED_POWER: f64 = f64::from_bits((1023 - 500) << 52);
        if u.is_infinite() {
            return 0.0;
        }
        power_law(u * SCALE, low * SCALE) * SCALED_POWER
    }

    /// `1 - epsilon = u (a(u) + u^(3/2) b(u))` on `[0, NEAR_END)`.
    #[inline(always)]
    fn near<T: Rooted>(u: T) -> T {
        near_by_root(u.clone().square_root(), u)
    }

    const NEAR: [f64; 2] = [NEAR_WHOLES[0], NEAR_WHOLES[1]];

    #[inline(always)]
    fn near_slope(u: f64) -> f64 {
        let (a, b) = (&NEAR_WHOLES, &NEAR_HALVES);
        let wholes = a[0] + u * (2.0 * a[1] + u * (3.0 * a[2] + u * (4.0 * a[3])));
        wholes + u * square_root(u) * (2.5 * b[0] + u * (3.5 * b[1] + u * (4.5 * b[2])))
    }

    /// From `u = ((3/2)^(2/3)/epsilon)^(3/5)`, by the ratio that is still missing; all of it `2^-300` times as large, where every power is normal.
    fn inverse_beyond(kept: f64) -> f64 {
        const TWO_TO_500: f64 = f64::from_bits((1023 + 500) << 52);
        const TWO_TO_300: f64 = f64::from_bits((1023 + 300) << 52);
        /// Steps after which the ratio, which falls to a tenth or less in each, has long been rounding alone.
        const STEPS: usize = 40;
        let kept = kept * TWO_TO_500;
        let root = fifth_root(LIMIT[0] / kept);
        let mut u = root * root * root;
        for _ in 0..STEPS {
            let ratio = power_law(u, 0.0) / kept - 1.0;
            u += u * (0.6 * ratio);
            if ratio.abs() <= 2.0 * f64::EPSILON {
                break;
            }
        }
        u * TWO_TO_300
    }
}

/// `2^-100`, for the cube root of a scaled `u`.
const SCALED_ROOT: f64 = f64::from_bits((1023 - 100) << 52);

/// `1 - epsilon` on `[0, NEAR_END)`, with the square root of `u` given.
#[inline(always)]
pub(crate) fn near_by_root<T: Number>(root: T, u: T) -> T {
    let pair = |c: &[f64], k: usize| u.clone().multiply_add(u.of(c[k + 1]), u.of(c[k]));
    let (a, b) = (&NEAR_WHOLES, &NEAR_HALVES);
    let u2 = u.clone() * u.clone();
    let u4 = u2.clone() * u2.clone();
    let low = u2.clone().multiply_add(pair(a, 3), pair(a, 1));
    let high = u2.clone().multiply_add(pair(a, 7), pair(a, 5));
    let halves = u2.multiply_add(pair(b, 2), pair(b, 0));
    let halves = u4.clone().multiply_add(pair(b, 4), halves);
    let rest = root.multiply_add(halves, u4.multiply_add(high, low));
    u.clone() * u.clone().multiply_add(rest, u.of(a[0]))
}

/// The power law, with `u^(-1/3) = r (1 - d)^(-1/3)`, `d = 1 - u r^3`, and `r` of 17 bits so that its
/// cube is exact; the roundings of `r^5 (3/2)^(2/3)` are carried along. Of a damping that is scaled by `2^-300` it gives `2^500 epsilon`.
fn power_law(u: f64, low: f64) -> f64 {
    let r = short_inverse_cube_root(u);
    let (r2, r3) = (r * r, r * r * r);
    let (product, error) = two_product(u, r3);
    let d = (1.0 - product) - error;
    let (r5, r5_error) = two_product(r2, r3);
    let (whole, error) = two_product(r5, LIMIT[0]);
    let power = d * (5.0 / 3.0 + d * (20.0 / 9.0 + d * (220.0 / 81.0 + d * (770.0 / 243.0))));
    let argument = SCALED_ROOT * r * (1.0 + d * (1.0 / 3.0 + d * (2.0 / 9.0 + d * (14.0 / 81.0))));
    let (index, centre) = GRID_BEYOND.locate(argument);
    let correction = polynomial(&BEYOND[index.min(BEYOND.len() - 1)], argument - centre);
    let factor = power + correction + power * correction - low / u * (5.0 / 3.0);
    whole + (whole * factor + (error + r5_error * LIMIT[0] + r5 * LIMIT[1]))
}

/// `u^(-1/3)` to 17 bits: from a third of the exponent, two steps of third order, and a cut.
fn short_inverse_cube_root(u: f64) -> f64 {
    let mut r = f64::from_bits(0x553e_f0ff_289d_d796 - u.to_bits() / 3);
    for _ in 0..2 {
        let d = 1.0 - u * r * r * r;
        r += r * d * (1.0 / 3.0 + d * (2.0 / 9.0));
    }
    f64::from_bits(r.to_bits() & 0xffff_fff0_0000_0000)
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use crate::{End, Restitution, epsilon, one_minus_epsilon, u_of_epsilon};

    const END: End = End::ZeroForce;

    #[test]
    fn certified_values_are_given() {
        for (u, kept) in [
            (0.01, 0.988_547_439_642_729_4),
            (1.0, 0.393_930_603_229_873_2),
            (30.0, 0.004_395_127_976_402_98),
            (500.0, 0.000_041_579_961_868_367_055),
            (2000.0, 0.000_004_127_142_830_369_126),
            (1e6, 1.310_370_692_049_669e-10),
            (1e30, 1.310_370_697_104_448_3e-50),
        ] {
            assert!((epsilon(u, END) / kept - 1.0).abs() <= 2.0 * f64::EPSILON, "{u}");
            assert!((one_minus_epsilon(u, END) / (1.0 - kept) - 1.0).abs() <= 1e-14, "{u}");
            assert!((u_of_epsilon(kept, END) / u - 1.0).abs() <= 1e-14, "{u}");
        }
    }

    /// `(3/2)^(2/3) u^(-5/3)`, for cubes from where its correction is nothing; scaled above 2^300.
    #[test]
    fn the_power_law_keeps_its_digits() {
        let limit: f64 = 1.310_370_697_104_448_2; // and 1e-16
        for k in 60..330 {
            for m in [1.0_f64, 1.125, 1.375, 1.75] {
                let root = m * 2.0_f64.powi(k - 20);
                let u = root * root * root;
                let power = (root * root) * (root * root) * root;
                if u.is_finite() && power.is_finite() && power < 1e300 {
                    let off = epsilon(u, END) * power / limit - 1.0;
                    assert!(off.abs() <= 3.0 * f64::EPSILON || root < 1e8, "{u:e}: {off:e}");
                }
            }
        }
        // From a velocity, u = g^(1/5): epsilon = (3/2)^(2/3) g^(-1/3).
        let law = Restitution::from_factor(1.0, END);
        for k in 40..100 {
            let root = 1.375_f64 * 2.0_f64.powi(3 * k);
            let off = law.epsilon(root * root * root) * root / limit - 1.0;
            assert!(off.abs() <= 3.0 * f64::EPSILON || k < 60, "{k}: {off:e}");
        }
        assert_eq!(epsilon(f64::INFINITY, END), 0.0);
        assert!(epsilon(f64::MAX, END) == 0.0 && epsilon(1e190, END) > 0.0);
    }
}
