//! Polynomials about the centres of their pieces, as the tables of the crate `restitution` have them.

use crate::chebyshev::{PREC, monomials, nodes};
use crate::grid::Grid;
use restitution::forms::packed;
use rug::Float;

/// Coefficients of the Chebyshev polynomials of degree 4 to 7.
const CHEBYSHEV: [&[i32]; 4] =
    [&[1, 0, -8, 0, 8], &[0, 5, 0, -20, 0, 16], &[-1, 0, 18, 0, -48, 0, 32], &[0, -7, 0, 56, 0, -112, 0, 64]];

impl Grid {
    /// The centre of piece `number`.
    pub(crate) fn centre(&self, number: u64) -> f64 {
        f64::from_bits((2 * number + 1) << (self.rest() - 1)) - self.shift
    }
}

/// Returns the polynomial through the Chebyshev nodes of piece `number`.
fn through_nodes(grid: Grid, number: u64, degree: usize, function: &dyn Fn(&Float) -> Float) -> Vec<Float> {
    let float = |x: f64| Float::with_val(PREC, x);
    let points = nodes(&float(grid.start(number)), &float(grid.start(number + 1)), degree + 1);
    let values: Vec<Float> = points.iter().map(function).collect();
    monomials(&points, &values, &float(grid.centre(number)))
}

/// The same, rounded.
pub(crate) fn interpolate(
    grid: Grid,
    number: u64,
    degree: usize,
    function: &dyn Fn(&Float) -> Float,
) -> Vec<f64> {
    through_nodes(grid, number, degree, function).iter().map(Float::to_f64).collect()
}

/// The polynomial of degree 7 as a row of the table keeps it.
///
/// What the short words of `c_7` to `c_4` leave of a coefficient, `r t^k`, goes to the lower ones but for a multiple of `T_k(t/h)`, which is
/// smaller by `2^(k-1)`.
pub(crate) fn row(grid: Grid, number: u64, function: &dyn Fn(&Float) -> Float) -> Vec<f64> {
    let mut c = through_nodes(grid, number, 7, function);
    let half = Float::with_val(PREC, grid.width(number)) / 2u32;
    for k in [7, 6, 5, 4] {
        let kept = packed(std::array::from_fn(|j| c[j].to_f64()))[k];
        let mut rest = Float::with_val(PREC, &c[k] - kept) >> (k as u32 - 1);
        c[k] = Float::with_val(PREC, kept);
        for j in (0..k).rev() {
            rest *= &half;
            c[j] -= Float::with_val(PREC, &rest * CHEBYSHEV[k - 4][j]);
        }
    }
    c.iter().map(Float::to_f64).collect()
}
