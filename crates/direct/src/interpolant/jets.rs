//! Polynomials in the part `theta` of a step and the deviation `delta` of the damping, in fixed point.

use crate::fixed::{BOUND_BITS, from_fixed, size, upper_bound, zero};
use restitution_real::Ball;
use restitution_real::kronecker;
use rug::Integer;

/// `Sum_(k,j) c_kj theta^k delta^j`, `0 <= theta <= 1`, `-1 <= delta <= 1`, in units of `2^-bits`.
///
/// Row `k` is a jet: the coefficient of `theta^k`, a polynomial in `delta`.
#[derive(Clone, Debug)]
pub(crate) struct Jets {
    pub(crate) width: usize,
    pub(crate) bits: u32,
    pub(crate) coefficients: Vec<Integer>,
}

impl Jets {
    /// One row.
    pub(crate) fn constant(row: &[Integer], bits: u32) -> Self {
        Self { width: row.len(), bits, coefficients: row.to_vec() }
    }

    pub(crate) fn rows(&self) -> usize {
        self.coefficients.len() / self.width
    }

    pub(crate) fn row(&self, k: usize) -> &[Integer] {
        &self.coefficients[k * self.width..(k + 1) * self.width]
    }

    /// The exact product, in units of the product of the units.
    pub(crate) fn product(&self, other: &Self) -> Self {
        let width = self.width + other.width - 1;
        let spread = |x: &Self| -> Vec<Integer> {
            let mut out = vec![Integer::new(); x.rows() * width];
            for k in 0..x.rows() {
                out[k * width..k * width + x.width].clone_from_slice(x.row(k));
            }
            out
        };
        let len = (self.rows() + other.rows() - 1) * width;
        let coefficients = kronecker::product(&spread(self), &spread(other), len);
        Self { width, bits: self.bits + other.bits, coefficients }
    }

    /// Cuts off rows and columns and rounds to `bits`; `lost` grows by the largest possible difference.
    pub(crate) fn rounded(&self, rows: usize, width: usize, bits: u32, lost: &mut Ball) -> Self {
        let (rows, width, shift) = (rows.min(self.rows()), width.min(self.width), self.bits - bits);
        let mut out = Vec::with_capacity(rows * width);
        let mut dropped = Integer::new();
        for k in 0..self.rows() {
            let (kept, cut) = self.row(k).split_at(if k < rows { width } else { 0 });
            out.extend(kept.iter().map(|c| Integer::from(c >> shift)));
            for c in cut {
                dropped += &*c.as_abs();
            }
        }
        *lost += upper_bound(&from_fixed(&dropped, self.bits, BOUND_BITS));
        if shift > 0 {
            *lost += from_fixed(&Integer::from(out.len()), bits, BOUND_BITS);
        }
        Self { width, bits, coefficients: out }
    }

    /// The sum of both, the coarser units first taken to the finer.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        let bits = self.bits.max(other.bits);
        let (width, rows) = (self.width.max(other.width), self.rows().max(other.rows()));
        let mut out = vec![Integer::new(); width * rows];
        for x in [self, other] {
            for k in 0..x.rows() {
                for (j, c) in x.row(k).iter().enumerate() {
                    out[k * width + j] += Integer::from(c << (bits - x.bits));
                }
            }
        }
        Self { width, bits, coefficients: out }
    }

    /// The polynomial with its sign turned.
    pub(crate) fn negative(mut self) -> Self {
        self.coefficients.iter_mut().for_each(|c| *c = -std::mem::take(c));
        self
    }

    /// A bound of the absolute value: the sum of all `|c_kj|`.
    pub(crate) fn size(&self) -> Ball {
        size(&self.coefficients, self.bits)
    }

    /// A bound of the integral of the absolute value over `theta`.
    pub(crate) fn integral(&self) -> Ball {
        (0..self.rows()).fold(zero(), |sum, k| {
            sum + size(self.row(k), self.bits) / Ball::from_integer(k as i64 + 1, BOUND_BITS)
        })
    }

    /// The derivative with respect to `theta`.
    pub(crate) fn derivative(&self) -> Self {
        let rows = 1..self.rows();
        let coefficients =
            rows.flat_map(|k| self.row(k).iter().map(move |c| Integer::from(c * k as u64))).collect();
        Self { width: self.width, bits: self.bits, coefficients }
    }

    /// The value at `theta = 1`, a jet.
    pub(crate) fn end(&self) -> Vec<Integer> {
        let mut sum = self.row(0).to_vec();
        for k in 1..self.rows() {
            for (s, c) in sum.iter_mut().zip(self.row(k)) {
                *s += c;
            }
        }
        sum
    }

    /// Bounds from below and above: those of the chord, less or more the bend and the deviation.
    pub(crate) fn range(&self) -> Range {
        let column = |k: usize| if k < self.rows() { self.row(k)[0].clone() } else { Integer::new() };
        let (start, end) = (column(0), column(0) + column(1));
        let mut rest = Integer::new();
        for k in 0..self.rows() {
            for c in &self.row(k)[usize::from(k < 2)..] {
                rest += &*c.as_abs();
            }
        }
        let (low, high) = if start < end { (start, end) } else { (end, start) };
        Range::between(&(low - &rest), &(high + rest), self.bits)
    }

    /// The value at `theta(delta)`, a jet of one row, with a bound of its error.
    ///
    /// Horner's rule; every truncation is counted and carried on with the size of `theta`.
    pub(crate) fn at(&self, theta: &Self) -> (Self, Ball) {
        let reach = theta.size();
        let mut sum = Self::constant(self.row(self.rows() - 1), self.bits);
        let mut error = zero();
        for k in (0..self.rows() - 1).rev() {
            let mut lost = zero();
            let product = schoolbook(&sum.coefficients, theta.row(0));
            let bits = self.bits + theta.bits;
            let product = Self { width: product.len(), bits, coefficients: product };
            sum = product.rounded(1, self.width, self.bits, &mut lost);
            sum.coefficients.iter_mut().zip(self.row(k)).for_each(|(s, c)| *s += c);
            error = upper_bound(&(error * &reach + lost));
        }
        (sum, error)
    }
}

/// Bounds of a function.
#[derive(Clone, Debug)]
pub(crate) struct Range {
    pub(crate) low: Ball,
    pub(crate) high: Ball,
}

impl Range {
    /// The bounds `low` and `high` in units of `2^-bits`.
    fn between(low: &Integer, high: &Integer, bits: u32) -> Self {
        let ball = |x: &Integer| from_fixed(x, bits, BOUND_BITS);
        Self { low: crate::fixed::lower_bound(&ball(low)), high: upper_bound(&ball(high)) }
    }

    /// The largest absolute value.
    pub(crate) fn largest(&self) -> Ball {
        if (&self.high + &self.low).is_positive() { self.high.abs() } else { self.low.abs() }
    }

    /// The least absolute value; `None` if the sign is not known.
    pub(crate) fn least(&self) -> Option<Ball> {
        if self.low.is_positive() {
            return Some(self.low.clone());
        }
        self.high.is_negative().then(|| self.high.abs())
    }
}

/// The full product of two jets.
pub(crate) fn schoolbook(a: &[Integer], b: &[Integer]) -> Vec<Integer> {
    let mut out = vec![Integer::new(); a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            out[i + j] += x * y;
        }
    }
    out
}

/// The quotient of two jets in units of `2^-bits`, without a bound of its error.
pub(crate) fn quotient(a: &[Integer], b: &[Integer], bits: u32) -> Option<Vec<Integer>> {
    let first = b.first().filter(|first| !first.is_zero())?;
    let mut out: Vec<Integer> = Vec::with_capacity(a.len());
    for (j, x) in a.iter().enumerate() {
        let mut left = Integer::from(x << bits);
        for (i, c) in out.iter().enumerate() {
            if let Some(b) = b.get(j - i) {
                left -= c * b;
            }
        }
        out.push(left / first);
    }
    Some(out)
}

#[cfg(test)]
mod tests;
