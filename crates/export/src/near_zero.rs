//! `(1 - epsilon)/u` near `u = 0`.

use super::chebyshev::{PREC, monomials, nodes};
use super::interpolated_curve::InterpolatedCurve;
use rug::Float;
use rug::ops::Pow;

/// Returns the polynomial in `u` of degree `degree` through Chebyshev nodes of `[0, high]`.
pub(super) fn loss_in_u(reference: &InterpolatedCurve, degree: usize, high: f64) -> Vec<f64> {
    let zero = Float::new(PREC);
    let nodes = nodes(&zero, &Float::with_val(PREC, high), degree + 1);
    let values: Vec<Float> = nodes.iter().map(|u| reference.one_minus_epsilon(u) / u).collect();
    monomials(&nodes, &values, &zero).iter().map(Float::to_f64).collect()
}

/// Returns `a` and `b` of `a(u) + u^(3/2) b(u)` through as many Chebyshev nodes in `sqrt(u)`.
pub(super) fn loss_in_halves(
    reference: &InterpolatedCurve,
    wholes: usize,
    halves: usize,
    high: f64,
) -> (Vec<f64>, Vec<f64>) {
    let nodes = nodes(&Float::new(PREC), &Float::with_val(PREC, high).sqrt(), wholes + halves);
    let powers = (0..wholes).map(|k| 2 * k).chain((0..halves).map(|k| 2 * k + 3));
    let powers: Vec<u32> = powers.map(|k| k as u32).collect();
    let mut rows: Vec<Vec<Float>> = Vec::new();
    for w in &nodes {
        let u = w.clone().square();
        let mut row: Vec<Float> = powers.iter().map(|k| Float::with_val(PREC, w.pow(k))).collect();
        row.push(reference.one_minus_epsilon(&u) / u);
        rows.push(row);
    }
    let mut solution: Vec<f64> = solve(rows).iter().map(Float::to_f64).collect();
    let b = solution.split_off(wholes);
    (solution, b)
}

/// Solves a linear system, the right side as last column, by elimination with pivots.
fn solve(mut rows: Vec<Vec<Float>>) -> Vec<Float> {
    let size = rows.len();
    for column in 0..size {
        let largest = (column..size).max_by(|i, j| {
            let (x, y) = (rows[*i][column].clone().abs(), rows[*j][column].clone().abs());
            x.partial_cmp(&y).unwrap_or(std::cmp::Ordering::Equal)
        });
        rows.swap(column, largest.unwrap_or(column));
        let pivot = rows[column].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != column) {
            let factor = Float::with_val(PREC, &row[column] / &pivot[column]);
            for (entry, above) in row.iter_mut().zip(&pivot).skip(column) {
                *entry -= Float::with_val(PREC, &factor * above);
            }
        }
    }
    (0..size).map(|i| Float::with_val(PREC, &rows[i][size] / &rows[i][i])).collect()
}
