//! The contact that ends at zero force.

use super::fifth_root::Root;
use super::pieces::{Grid, Rows, polynomial};
use super::rounding::{Number, Rooted, square_root, two_product};
use super::tables::zero_force::{BEYOND, LIMIT, NEAR_HALVES, NEAR_WHOLES, PIECES, ROOT_GRID, ROOT_PIECES};

pub(crate) use super::tables::zero_force::{GRID, NEAR_END};

/// The pieces, for batches: those in `sqrt(u)`, then those in `u`.
pub(crate) static TABLE: Rows<ROWS> = Rows::of(&PIECES);
pub(crate) const ROWS: usize = PIECES.len().next_power_of_two();

/// From here on an argument is rounded beyond the table.
pub(crate) const TABLE_END: f64 = GRID.end(PIECES.len() - ROOT_PIECES);
/// Below, `epsilon` is 1; the table gives that but for its rounding.
pub(crate) const NOTHING_LOST: f64 = f64::EPSILON / 16.0;
/// Pieces of 1/32 of a factor of two in `u^(-1/3) + 1/16`.
const GRID_BEYOND: Grid = Grid::new(1.0 / 16.0, 5, 0.0);

#[inline(always)]
pub(crate) fn epsilon(u: f64) -> f64 {
    if u < NEAR_END {
        return if u >= 0.0 { near_one(u) } else { f64::NAN };
    }
    let (index, centre) = place(u);
    match PIECES.get(index as usize) {
        Some(piece) => piece.value(u - centre),
        None => beyond(u, 0.0),
    }
}

#[inline(always)]
pub(crate) fn epsilon_of_root(root: Root) -> f64 {
    let estimate = root.estimate();
    if estimate < NEAR_END {
        return near_one(root.distance(0.0));
    }
    let (index, centre) = place(estimate);
    match PIECES.get(index as usize) {
        Some(piece) => piece.value(root.distance(centre)),
        None => far_root(root),
    }
}

#[inline(always)]
pub(crate) fn one_minus_epsilon(u: f64) -> f64 {
    if u < NEAR_END {
        return if u >= 0.0 { near(u) } else { f64::NAN };
    }
    let (index, centre) = place(u);
    match PIECES.get(index as usize) {
        Some(piece) => piece.one_minus(u - centre),
        None => 1.0 - beyond(u, 0.0),
    }
}

/// The row for a `u` from `NEAR_END` on, beyond the table for others, and its centre.
#[inline(always)]
pub(crate) fn place(u: f64) -> (u64, f64) {
    let (index, centre) = GRID.locate(u);
    ((index as u64).wrapping_add(ROOT_PIECES as u64), centre)
}

/// The row for a `u` below `NEAR_END`, in whose square root `epsilon` is smooth, and the distance of the root from its centre.
#[inline(always)]
pub(crate) fn place_near(u: f64) -> (u64, f64) {
    let root = square_root(u);
    let (index, centre) = ROOT_GRID.locate(root);
    (index as u64, root - centre)
}

/// `epsilon` on `[0, NEAR_END)`.
#[inline(always)]
fn near_one(u: f64) -> f64 {
    let (index, t) = place_near(u);
    let value = PIECES[(index as usize).min(ROOT_PIECES - 1)].value(t);
    if u < NOTHING_LOST { 1.0 } else { value }
}

/// `1 - epsilon = u (a(u) + u^(3/2) b(u))` on `[0, NEAR_END)`.
#[inline(always)]
pub(crate) fn near<T: Rooted>(u: T) -> T {
    near_by_root(u.clone().square_root(), u)
}

/// The same with the square root of `u` given.
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

#[cold]
fn far_root(root: Root) -> f64 {
    let u = root.distance(0.0);
    beyond(u, root.distance(u))
}

/// `epsilon(u + low)` for `u >= TABLE_END`, and what is not a velocity.
///
/// ```text
/// epsilon = (3/2)^(2/3) u^(-5/3) (1 + s(u^(-1/3)))
/// ```
#[cold]
fn beyond(u: f64, low: f64) -> f64 {
    const LARGE: f64 = f64::from_bits((1023 + 300) << 52);
    const SCALE: f64 = f64::from_bits((1023 - 300) << 52);
    const SCALED_ROOT: f64 = f64::from_bits((1023 - 100) << 52);
    const SCALED_POWER: f64 = f64::from_bits((1023 - 500) << 52);
    if u < LARGE {
        return if u >= 0.0 { power_law(u, low, 1.0) } else { f64::NAN };
    }
    if u.is_nan() {
        return u; // the exponent of a number is what the power law starts from
    }
    if u.is_infinite() {
        return 0.0;
    }
    power_law(u * SCALE, low * SCALE, SCALED_ROOT) * SCALED_POWER
}

/// The power law, with `u^(-1/3) = r (1 - d)^(-1/3)`, `d = 1 - u r^3`, and `r` of 17 bits so that its
/// cube is exact; the roundings of `r^5 (3/2)^(2/3)` are carried along. `root_scale` turns `u^(-1/3)` of a scaled `u` back.
fn power_law(u: f64, low: f64, root_scale: f64) -> f64 {
    let r = short_inverse_cube_root(u);
    let (r2, r3) = (r * r, r * r * r);
    let (product, error) = two_product(u, r3);
    let d = (1.0 - product) - error;
    let (r5, r5_error) = two_product(r2, r3);
    let (whole, error) = two_product(r5, LIMIT[0]);
    let power = d * (5.0 / 3.0 + d * (20.0 / 9.0 + d * (220.0 / 81.0 + d * (770.0 / 243.0))));
    let argument = root_scale * r * (1.0 + d * (1.0 / 3.0 + d * (2.0 / 9.0 + d * (14.0 / 81.0))));
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
