//! Polynomials about the centres of their pieces, as the tables of the crate `restitution` have them.

use crate::chebyshev::{PREC, monomials, nodes};
use crate::grid::Grid;
use rug::Float;

impl Grid {
    /// The centre of piece `number`.
    pub(crate) fn centre(&self, number: u64) -> f64 {
        f64::from_bits((2 * number + 1) << (self.rest() - 1)) - self.shift
    }
}

/// Returns the polynomial through the Chebyshev nodes of piece `number`.
pub(crate) fn interpolate(
    grid: Grid,
    number: u64,
    degree: usize,
    function: &dyn Fn(&Float) -> Float,
) -> Vec<f64> {
    let float = |x: f64| Float::with_val(PREC, x);
    let points = nodes(&float(grid.start(number)), &float(grid.start(number + 1)), degree + 1);
    let values: Vec<Float> = points.iter().map(function).collect();
    monomials(&points, &values, &float(grid.centre(number))).iter().map(Float::to_f64).collect()
}
