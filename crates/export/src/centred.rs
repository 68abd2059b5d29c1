//! Polynomials about the centres of their pieces, as the tables of the crate `restitution` have them.

use crate::chebyshev::{PREC, coefficients, monomials, nodes};
use crate::grid::Grid;
use rug::Float;

/// Nodes beyond the degree, on which the neglected Chebyshev coefficients are measured.
const EXTRA_NODES: usize = 6;

impl Grid {
    /// The centre of piece `number`.
    pub(crate) fn centre(&self, number: u64) -> f64 {
        f64::from_bits((2 * number + 1) << (self.rest() - 1)) - self.shift
    }
}

/// Returns the polynomial through the Chebyshev nodes of piece `number` and twice the sum of the Chebyshev
/// coefficients that it neglects, relative to the function.
pub(crate) fn interpolate(
    grid: Grid,
    number: u64,
    degree: usize,
    function: &dyn Fn(&Float) -> Float,
) -> (Vec<f64>, f64) {
    let float = |x: f64| Float::with_val(PREC, x);
    let (low, high) = (float(grid.start(number)), float(grid.start(number + 1)));
    let sample = |count: usize| {
        let points = nodes(&low, &high, count);
        let values: Vec<Float> = points.iter().map(function).collect();
        (points, values)
    };
    let (points, values) = sample(degree + 1);
    let row = monomials(&points, &values, &float(grid.centre(number))).iter().map(Float::to_f64).collect();
    let (_, values) = sample(degree + 1 + EXTRA_NODES);
    let neglected: f64 = coefficients(&values).iter().skip(degree + 1).map(|c| c.to_f64().abs()).sum();
    let least = values.iter().map(Float::to_f64).fold(f64::INFINITY, f64::min);
    (row, 2.0 * neglected / least)
}
