//! Arguments that hurt: all bit patterns, the corners of f64, what a table's grid may break at, neighbours.

use crate::random::{Source, bits, by_ratio, choose, near};
use rand::{Rng, RngExt};

/// Corners of the format, and numbers at which a formula may change.
pub const SPECIAL: [u64; 35] = [
    0,                     // 0
    0x8000_0000_0000_0000, // -0
    1,                     // the smallest subnormal
    0x8000_0000_0000_0001,
    0x000f_ffff_ffff_ffff, // the largest subnormal
    0x0010_0000_0000_0000, // the smallest normal
    0x7fef_ffff_ffff_ffff, // the largest number
    0xffef_ffff_ffff_ffff,
    0x7ff0_0000_0000_0000, // infinity
    0xfff0_0000_0000_0000,
    0x7ff8_0000_0000_0000, // NaN
    0xfff8_0000_0000_0000, // what x86 makes of 0/0
    0x7ff0_0000_0000_0001, // signalling NaN
    0xfff0_0000_0000_0001,
    0x7fff_ffff_ffff_ffff,
    0xffff_ffff_ffff_ffff,
    0x3ff0_0000_0000_0000, // 1
    0xbff0_0000_0000_0000,
    0x3fe0_0000_0000_0000, // 1/2
    0x3ca0_0000_0000_0000, // 2^-53
    0x3cb0_0000_0000_0000,
    0x3c90_0000_0000_0000,
    0x3fb0_0000_0000_0000, // 1/16
    0x3fa0_0000_0000_0000, // 1/32
    0x401c_0000_0000_0000, // 7
    0x401f_4000_0000_0000, // 7.8125
    0x4020_0000_0000_0000, // 8
    0x408f_f800_0000_0000, // 1023
    0x408f_fff0_0000_0000, // 1023.998
    0x4090_0000_0000_0000, // 1024
    0x4950_0000_0000_0000, // 2^150
    0x52b0_0000_0000_0000, // 2^300
    0x4d70_0000_0000_0000, // 2^216
    0x412b_a3d1_b1f0_0000, // about e^14
    0x4330_0000_0000_0000, // 2^52
];

/// What grids of pieces add to their argument, of those that are in use or may be.
const SHIFTS: [f64; 11] = [0.0, 1.0 / 512.0, 1.0 / 16.0, 0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0];

/// Returns `count` arguments, many kinds side by side, as batches meet them least gladly.
pub fn mixture(random: &mut Source, count: usize) -> Vec<f64> {
    let mut arguments = Vec::with_capacity(count);
    while arguments.len() < count {
        let run = random.random_range(1..100).min(count - arguments.len());
        let kind = random.random_range(0..8);
        let start = by_ratio(random, 1e-6, 1e4);
        for i in 0..run {
            arguments.push(match kind {
                0..=2 => bits(random),
                3 => special(random),
                4 => by_ratio(random, 1e-20, 1e6),
                5 => breakpoint(random),
                6 => start * (1.0 + 1e-3 * i as f64),
                _ => decimal(random),
            });
        }
    }
    arguments
}

/// A corner, or one of its neighbours.
pub fn special(random: &mut Source) -> f64 {
    let corner = f64::from_bits(*choose(random, &SPECIAL));
    near(random, corner, 2)
}

/// A number at which `x + shift` reaches a multiple of a small power of two of its own size, or a neighbour.
fn breakpoint(random: &mut Source) -> f64 {
    let shift = *choose(random, &SHIFTS);
    let bits = random.random_range(2..9);
    let grid = by_ratio(random, 0.01, 2000.0) + shift;
    let start = f64::from_bits(grid.to_bits() >> (52 - bits) << (52 - bits)) - shift;
    near(random, start, 3)
}

/// A number as people type it.
fn decimal(random: &mut Source) -> f64 {
    let digits = random.random_range(0..1000);
    let typed = f64::from(digits) * 10f64.powi(random.random_range(-5..2));
    near(random, typed, 1)
}

/// A positive number as a physical quantity may have it, or a corner.
pub fn quantity(random: &mut Source, low: f64, high: f64) -> f64 {
    match random.next_u32() % 16 {
        0 => bits(random),
        1 => special(random),
        2 => by_ratio(random, 1e-300, 1e300),
        _ => by_ratio(random, low, high),
    }
}
