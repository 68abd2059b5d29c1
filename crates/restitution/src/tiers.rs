//! Cheaper evaluators for a stated tolerance.
//!
//! A simulation that needs `epsilon` to 1e-6 need not pay for 1e-16: the statics here have fewer and
//! lower polynomials. `restitution export` writes such a table for any tolerance and range.

use crate::pieces::Grid;
use crate::rounding::multiply_add;
use crate::{End, epsilon};

pub use crate::tables::tiers::{
    ZERO_COMPRESSION_1E3, ZERO_COMPRESSION_1E6, ZERO_COMPRESSION_1E9, ZERO_FORCE_1E3, ZERO_FORCE_1E6,
    ZERO_FORCE_1E9,
};

/// Polynomials of degree `WIDTH - 1` on `ROWS` pieces that keep a tolerance.
///
/// # Error bound
///
/// The relative error is at most [`Tier::tolerance`] for every `u >= 0`: up to [`Tier::far`] by the table,
/// beyond by [`epsilon`]. `tests/it/tiers.rs` checks it.
///
/// # Examples
///
/// ```
/// use restitution::{End, epsilon, tiers};
///
/// let rough = tiers::ZERO_FORCE_1E6.epsilon(0.7);
/// assert!((rough / epsilon(0.7, End::ZeroForce) - 1.0).abs() <= 1e-6);
/// assert!(tiers::ZERO_FORCE_1E6.epsilon(-0.7).is_nan());
/// ```
#[derive(Debug)]
pub struct Tier<const ROWS: usize, const WIDTH: usize> {
    end: End,
    tolerance: f64,
    far: f64,
    grid: Grid,
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
        Self { end, tolerance, far, grid: Grid::new(shift, bits, 0.0), rows }
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

    /// The largest `u` of the table.
    #[must_use]
    pub const fn far(&self) -> f64 {
        self.far
    }

    /// Returns `epsilon(u)` within the tolerance; NaN for NaN and below zero.
    #[inline]
    #[must_use]
    pub fn epsilon(&self, u: f64) -> f64 {
        if (0.0..=self.far).contains(&u) { self.within(u) } else { epsilon(u, self.end) }
    }

    /// Writes `epsilon(u)` of each element to `out`, as far as the shorter of the two reaches.
    #[inline]
    pub fn epsilon_batch(&self, u: &[f64], out: &mut [f64]) {
        for (u, out) in u.chunks(256).zip(out.chunks_mut(256)) {
            let all_within = u.iter().fold(true, |all, u| all & (*u >= 0.0) & (*u <= self.far));
            for (u, out) in u.iter().zip(out) {
                *out = if all_within { self.within(*u) } else { self.epsilon(*u) };
            }
        }
    }

    #[inline(always)]
    fn within(&self, u: f64) -> f64 {
        let (index, centre) = self.grid.locate(u);
        let t = u - centre;
        polynomial(&self.rows[index.min(ROWS - 1)], t)
    }
}

/// Returns `c_0 + c_1 t + …`, the even and the odd powers side by side; two coefficients at least.
#[inline(always)]
fn polynomial<const WIDTH: usize>(c: &[f64; WIDTH], t: f64) -> f64 {
    let t2 = t * t;
    let (mut upper, mut lower, mut left) = (c[WIDTH - 1], c[WIDTH - 2], WIDTH - 2);
    while left >= 2 {
        upper = multiply_add(upper, t2, c[left - 1]);
        lower = multiply_add(lower, t2, c[left - 2]);
        left -= 2;
    }
    let value = multiply_add(upper, t, lower);
    if left == 1 { multiply_add(value, t, c[0]) } else { value }
}
