//! Interpolation at Chebyshev nodes, in MPFR floats.

use rug::float::Constant;
use rug::{Assign, Float};

/// Bits of everything that is interpolated.
pub(super) const PREC: u32 = 200;

/// Returns the `count` Chebyshev nodes of `[low, high]`.
pub(super) fn nodes(low: &Float, high: &Float, count: usize) -> Vec<Float> {
    let middle = Float::with_val(PREC, low + high) / 2u32;
    let half = Float::with_val(PREC, high - low) / 2u32;
    (0..count).map(|i| Float::with_val(PREC, &half * angle(2 * i + 1, count).cos()) + &middle).collect()
}

/// Returns the coefficients `c_k` of `sum c_k T_k` through values at [`nodes`].
pub(super) fn coefficients(values: &[Float]) -> Vec<Float> {
    let count = values.len();
    let cosines: Vec<Float> = (0..4 * count).map(|m| angle(m, count).cos()).collect();
    let coefficient = |k: usize| {
        let mut sum = Float::new(PREC);
        for (i, value) in values.iter().enumerate() {
            sum += Float::with_val(PREC, value * &cosines[k * (2 * i + 1) % (4 * count)]);
        }
        sum * if k == 0 { 1u32 } else { 2u32 } / count as u32
    };
    (0..count).map(coefficient).collect()
}

/// `pi m/(2 count)`.
fn angle(m: usize, count: usize) -> Float {
    Float::with_val(PREC, Constant::Pi) * m as u32 / (2 * count) as u32
}

/// Returns `sum c_k T_k(t)` by Clenshaw's recurrence at the precision of `t`.
pub(super) fn clenshaw(coefficients: &[Float], t: &Float) -> Float {
    let prec = t.prec();
    let twice = Float::with_val(prec, t * 2u32);
    let (mut next, mut after, mut sum) = (Float::new(prec), Float::new(prec), Float::new(prec));
    for c in coefficients.iter().skip(1).rev() {
        // next, after = twice next - after + c, next
        sum.assign(&twice * &next);
        sum -= &after;
        sum += c;
        std::mem::swap(&mut next, &mut after);
        std::mem::swap(&mut sum, &mut next);
    }
    sum.assign(t * &next);
    sum -= after;
    sum += coefficients.first().unwrap_or(&Float::new(prec));
    sum
}

/// Returns the monomials in `x - centre` of the polynomial through `values` at `nodes`.
pub(super) fn monomials(nodes: &[Float], values: &[Float], centre: &Float) -> Vec<Float> {
    let mut divided = values.to_vec();
    for order in 1..nodes.len() {
        for i in (order..nodes.len()).rev() {
            let rise = Float::with_val(PREC, &divided[i] - &divided[i - 1]);
            divided[i] = rise / Float::with_val(PREC, &nodes[i] - &nodes[i - order]);
        }
    }
    let mut polynomial: Vec<Float> = Vec::new();
    for (node, value) in nodes.iter().zip(&divided).rev() {
        let shift = Float::with_val(PREC, node - centre);
        let mut next = vec![Float::new(PREC); polynomial.len() + 1];
        for (k, c) in polynomial.iter().enumerate() {
            next[k] -= Float::with_val(PREC, c * &shift);
            next[k + 1] += c;
        }
        next[0] += value;
        polynomial = next;
    }
    polynomial
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_is_interpolated_exactly() {
        let (low, high) = (Float::with_val(PREC, 1), Float::with_val(PREC, 3));
        let nodes = nodes(&low, &high, 4);
        let cube = |x: &Float| Float::with_val(PREC, x * x) * x;
        let values: Vec<Float> = nodes.iter().map(cube).collect();
        let monomials = monomials(&nodes, &values, &Float::with_val(PREC, 2));
        let rounded: Vec<f64> = monomials.iter().map(Float::to_f64).collect();
        assert_eq!(rounded, [8.0, 12.0, 6.0, 1.0]);
        let at_half = clenshaw(&coefficients(&values), &Float::with_val(PREC, 0.5)).to_f64();
        assert_eq!(at_half, 2.5_f64.powi(3));
    }
}
