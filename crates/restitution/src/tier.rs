//! One cheaper evaluator: polynomials on pieces that keep a tolerance.

use crate::rounding::multiply_add;
use crate::{End, epsilon};

/// Polynomials of degree `WIDTH - 1` on `ROWS` pieces that keep a tolerance.
///
/// A piece is where `u + shift` has the same leading bits; the bits behind say how far its end is, as a part `s` of its
/// width, and `epsilon = c_0 + s (c_1 + s (c_2 + …))`.
///
/// # Error bound
///
/// The relative error is at most [`Tier::tolerance`] for every `u >= 0`: below [`Tier::far`] by the table,
/// from there on by [`epsilon`]. `tests/it/tiers.rs` checks it.
///
/// # Guarantees
///
/// `epsilon(0) = 1` exactly, `0 <= epsilon <= 1`, and a larger `u` never gives a larger `epsilon` below [`Tier::far`] and
/// across it, with fused multiply-add or without: the exporter checks each row for it in exact arithmetic
/// (docs/export.md). Beyond, what is said of [`epsilon`] holds.
///
/// # Examples
///
/// ```
/// use restitution::{End, epsilon, tiers};
///
/// let rough = tiers::ZERO_FORCE_1E6.epsilon(0.7);
/// assert!((rough / epsilon(0.7, End::ZeroForce) - 1.0).abs() <= 1e-6);
/// assert_eq!(tiers::ZERO_FORCE_1E6.epsilon(0.0), 1.0);
/// assert!(tiers::ZERO_FORCE_1E6.epsilon(-0.7).is_nan());
/// ```
#[derive(Debug)]
pub struct Tier<const ROWS: usize, const WIDTH: usize> {
    end: End,
    tolerance: f64,
    far: f64,
    shift: f64,
    bits: u32,
    rows: [[f64; WIDTH]; ROWS],
}

impl<const ROWS: usize, const WIDTH: usize> Tier<ROWS, WIDTH> {
    pub(crate) const fn new(
        end: End,
        tolerance: f64,
        far: f64,
        shift: f64,
        bits: u32,
        rows: [[f64; WIDTH]; ROWS],
    ) -> Self {
        Self { end, tolerance, far, shift, bits, rows }
    }

    /// Where the contact ends.
    #[must_use]
    pub const fn end(&self) -> End {
        self.end
    }

    /// The largest relative error.
    #[must_use]
    pub const fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Where the table ends and [`epsilon`] takes over.
    #[must_use]
    pub const fn far(&self) -> f64 {
        self.far
    }

    /// Returns `epsilon(u)` within the tolerance; NaN for NaN and below zero.
    #[inline]
    #[must_use]
    pub fn epsilon(&self, u: f64) -> f64 {
        if (0.0..self.far).contains(&u) { self.within(u) } else { epsilon(u, self.end) }
    }

    /// Writes `epsilon(u)` of each element to `out`, as far as the shorter of the two reaches.
    #[inline]
    pub fn epsilon_batch(&self, u: &[f64], out: &mut [f64]) {
        for (u, out) in u.chunks(256).zip(out.chunks_mut(256)) {
            let all_within = u.iter().fold(true, |all, u| all & (*u >= 0.0) & (*u < self.far));
            for (u, out) in u.iter().zip(out) {
                *out = if all_within { self.within(*u) } else { self.epsilon(*u) };
            }
        }
    }

    #[inline(always)]
    fn within(&self, u: f64) -> f64 {
        let (bits, rest) = ((u + self.shift).to_bits(), 52 - self.bits);
        let index = ((bits >> rest) - (self.shift.to_bits() >> rest)) as usize;
        let row = &self.rows[index.min(ROWS - 1)];
        let fraction = (bits << self.bits) & (u64::MAX >> 12);
        let distance = 2.0 - f64::from_bits(1.0_f64.to_bits() | fraction);
        multiply_add(distance, slope(row, distance), row[0])
    }
}

/// Returns `c_1 + c_2 s + …`, by pairs.
#[inline(always)]
fn slope<const WIDTH: usize>(c: &[f64; WIDTH], s: f64) -> f64 {
    let s2 = s * s;
    let pair = |k: usize| multiply_add(c[k + 1], s, c[k]);
    let (mut value, mut k) =
        if WIDTH.is_multiple_of(2) { (c[WIDTH - 1], WIDTH - 1) } else { (pair(WIDTH - 2), WIDTH - 2) };
    while k > 1 {
        k -= 2;
        value = multiply_add(value, s2, pair(k));
    }
    value
}
