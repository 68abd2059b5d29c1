//! `1 - epsilon(u)` with all its digits near `u = 0`.

use crate::chebyshev::{PREC, coefficients, monomials, nodes};
use crate::pieces::Pieces;
use crate::{ExportError, InterpolatedCurve};
use restitution::End;
use rug::Float;
use std::f64::consts::PI;

/// Half an ulp relative to the number, 2^-53.
const ROUNDING: f64 = f64::EPSILON / 2.0;
/// The largest degree that is tried.
const LARGEST_DEGREE: usize = 30;
/// Nodes beyond the degree, on which the error is measured.
const EXTRA_NODES: usize = 8;
/// In place of `u = 0`, where `(1 - epsilon)/u` is a limit.
const NEXT_TO_NOTHING: f64 = f64::from_bits(1 << 52);

/// The variable of the polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variable {
    /// `u`.
    U,
    /// `sqrt(u)`, in which the contact that ends at zero force is analytic at 0.
    SqrtU,
}

/// `1 - epsilon = u (c_0 + c_1 x + c_2 x^2 + …)`, with `x = u` or `sqrt(u)`, where `u` is small; beyond, what the table
/// of `epsilon` leaves of 1.
#[derive(Clone, Debug)]
pub struct Loss {
    /// The variable `x`.
    pub variable: Variable,
    /// The coefficients, `c_0 = -C_1` first; empty where the range starts beyond.
    pub coefficients: Vec<f64>,
    /// The row of the table from which on the table is used.
    pub near_row: usize,
    /// The relative error, near 0 and beyond.
    pub bound: f64,
}

impl Loss {
    /// Fits the polynomial so that the loss goes over into that of `pieces`.
    ///
    /// # Errors
    ///
    /// [`ExportError::Tolerance`] if no polynomial of degree 30 or less keeps `tolerance`.
    pub fn fit(
        reference: &InterpolatedCurve,
        pieces: &Pieces,
        range: (f64, f64),
        tolerance: f64,
    ) -> Result<Self, ExportError> {
        let variable = match reference.end() {
            End::ZeroCompression => Variable::U,
            End::ZeroForce => Variable::SqrtU,
        };
        let near_row = pieces.near_row();
        let mut loss = Self { variable, coefficients: Vec::new(), near_row, bound: pieces.loss_bound };
        if near_row == 0 {
            return Ok(loss);
        }
        let end = pieces.law.map_or(range.1, |law| law.from);
        let high = pieces.near_end().min(end);
        let last = pieces.rows.get(near_row - 1).filter(|_| high < end).map(|row| (1.0 - row[0]) / high);
        let mut reached = f64::INFINITY;
        for degree in 1..=LARGEST_DEGREE {
            let row = loss.interpolate(reference, degree, high, last);
            let (approximation, rounding) = loss.errors(reference, &row, high);
            reached = approximation;
            if approximation <= tolerance {
                loss.coefficients = row;
                loss.bound = loss.bound.max(approximation + rounding);
                return Ok(loss);
            }
        }
        Err(ExportError::Tolerance { tolerance, reached })
    }

    /// The polynomial through both ends of `[0, high]` and points between them.
    fn interpolate(
        &self,
        reference: &InterpolatedCurve,
        degree: usize,
        high: f64,
        last: Option<f64>,
    ) -> Vec<f64> {
        let end = self.of(&Float::with_val(PREC, high));
        let part = |k: usize| (PI * k as f64 / (2 * degree) as f64).sin().powi(2);
        let points: Vec<Float> = (0..=degree).map(|k| Float::with_val(PREC, &end * part(k))).collect();
        let mut values: Vec<Float> = points.iter().map(|x| self.ratio(reference, x)).collect();
        if let Some(value) = last {
            values[degree] = Float::with_val(PREC, value);
        }
        monomials(&points, &values, &Float::new(PREC)).iter().map(Float::to_f64).collect()
    }

    /// The relative errors of approximation and of rounding.
    fn errors(&self, reference: &InterpolatedCurve, row: &[f64], high: f64) -> (f64, f64) {
        let end = self.of(&Float::with_val(PREC, high));
        let mut least = f64::INFINITY;
        let errors: Vec<Float> = nodes(&Float::new(PREC), &end, row.len() + EXTRA_NODES)
            .iter()
            .map(|x| {
                let exact = self.ratio(reference, x);
                least = least.min(exact.to_f64());
                row.iter().rev().fold(Float::new(PREC), |sum, c| sum * x + *c) - exact
            })
            .collect();
        let sum: f64 = coefficients(&errors).iter().map(|c| c.to_f64().abs()).sum();
        let (end, of_root) = (end.to_f64(), usize::from(self.variable == Variable::SqrtU));
        let terms = row.iter().enumerate();
        let rounded: f64 =
            terms.map(|(k, c)| ((2 + of_root) * k + 1) as f64 * c.abs() * end.powi(k as i32)).sum();
        (sum / least, ROUNDING * (1.0 + rounded / least))
    }

    /// The variable of an argument.
    fn of(&self, u: &Float) -> Float {
        if self.variable == Variable::U { u.clone() } else { u.clone().sqrt() }
    }

    /// `(1 - epsilon)/u` at a value of the variable.
    fn ratio(&self, reference: &InterpolatedCurve, x: &Float) -> Float {
        let u = if self.variable == Variable::U { x.clone() } else { x.clone().square() };
        let u = if u.is_zero() { Float::with_val(PREC, NEXT_TO_NOTHING) } else { u };
        reference.one_minus_epsilon(&u) / u
    }

    /// Evaluates as the exported sources do, to the bit.
    pub fn at(&self, pieces: &Pieces, u: f64) -> f64 {
        let place = pieces.locate(u);
        if place.index < self.near_row && !self.coefficients.is_empty() {
            let x = if self.variable == Variable::U { u } else { u.sqrt() };
            return u * self.coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c);
        }
        if place.periods > 0 { 1.0 - pieces.epsilon(u) } else { (1.0 - place.row[0]) - place.rise() }
    }
}
