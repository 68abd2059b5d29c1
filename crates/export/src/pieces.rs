//! Piecewise polynomials that fall, from 1 at 0 to 0 at infinity, in floating point too.

use crate::chebyshev::{PREC, coefficients, monomials, nodes};
use crate::falling::{Flaw, room_below, starts_at_one};
use crate::grid::Grid;
use crate::target::Law;
use crate::{ExportError, InterpolatedCurve};
use rug::Float;
use std::f64::consts::PI;

/// Pieces that are tried before all of them are made.
const SAMPLES: usize = 16;
/// A part of a piece, so short that the piece is fitted as if all of it was used.
const NEXT_TO_NOTHING: f64 = 1e-9;
/// Half an ulp relative to the number, 2^-53.
const ROUNDING: f64 = f64::EPSILON / 2.0;
/// Nodes beyond the degree, on which the error of a piece is measured.
const EXTRA_NODES: usize = 7;
/// Up to here the loss `1 - epsilon` has a polynomial of its own; the pieces beyond keep the tolerance of both.
pub(crate) const NEAR: f64 = 0.5;

/// The parts of the bound of an approximation, relative to the function.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bound {
    /// What the polynomials and their rounded constants leave: the sum of the Chebyshev coefficients of the error.
    pub approximation: f64,
    /// The rounding of `u + shift`.
    pub argument: f64,
    /// The rounding of the evaluation.
    pub evaluation: f64,
    /// What the law at infinity leaves.
    pub law: f64,
}

impl Bound {
    /// The sum of the parts.
    pub fn total(&self) -> f64 {
        self.approximation + self.argument + self.evaluation + self.law
    }

    /// The larger of each part.
    fn max(self, other: Self) -> Self {
        Self {
            approximation: self.approximation.max(other.approximation),
            argument: self.argument.max(other.argument),
            evaluation: self.evaluation.max(other.evaluation),
            law: self.law.max(other.law),
        }
    }
}

/// What a table shall be.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// Where the pieces lie.
    pub grid: Grid,
    /// The degree of the polynomials, 1 at least.
    pub degree: usize,
    /// The range of `u`.
    pub range: (f64, f64),
    /// The law that follows where the range ends.
    pub law: Option<Law>,
    /// The value at the end of the range, if it shall not be that of `epsilon`.
    pub last_value: Option<f64>,
    /// The largest relative error.
    pub tolerance: f64,
}

impl Shape {
    /// Where the table ends, but for the first period of the law.
    pub(crate) fn high(&self) -> f64 {
        self.law.map_or(self.range.1, |law| law.from)
    }
}

/// A piecewise polynomial for a range of `u`.
///
/// A row `c` of piece `[a, b)` gives
///
/// ```text
/// epsilon(u) = c_0 + s (c_1 + s (c_2 + …)),    s = (b - u)/(b - a)
/// ```
///
/// # Guarantees
///
/// Evaluated with any order of operations that adds `c_0` last, with fused multiply-add or without, rounding to
/// nearest: `epsilon(0) = 1` exactly, `0 <= epsilon <= 1`, and `u < v` gives `epsilon(u) >= epsilon(v)` for all f64 of
/// the range. Every row is checked for it in exact arithmetic when it is made (`falling.rs`).
#[derive(Clone, Debug)]
pub struct Pieces {
    /// The grid.
    pub grid: Grid,
    /// The number that the grid gives the first piece.
    pub first: u64,
    /// Coefficients of every piece, constant first.
    pub rows: Vec<Vec<f64>>,
    /// The law at infinity: its period is tabulated in the last rows, on a grid without shift.
    pub law: Option<Law>,
    /// The row in which the law's first period starts; their number without a law.
    pub law_row: usize,
    /// The largest of each part over the pieces.
    pub bound: Bound,
    /// The bound of `1 - epsilon` from the table, relative to that, from row [`Self::near_row`] on.
    pub loss_bound: f64,
}

/// Where an evaluation takes place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place<'a> {
    pub(crate) row: &'a [f64],
    pub(crate) index: usize,
    pub(crate) distance: f64,
    pub(crate) width: f64,
    pub(crate) periods: u32,
}

impl Pieces {
    /// Fits the pieces.
    ///
    /// # Errors
    ///
    /// [`ExportError::Tolerance`] as soon as a piece's bound exceeds the tolerance, or a piece cannot be proved to fall.
    pub fn fit(reference: &InterpolatedCurve, shape: &Shape) -> Result<Self, ExportError> {
        let departure = shape.law.map_or(0.0, |law| law.departure);
        let bound = Bound { law: 2.0 * departure, ..Bound::default() };
        let (low, high) = (shape.range.0, shape.high());
        let first = shape.grid.number(low);
        let mut pieces = Self {
            grid: shape.grid,
            first,
            rows: Vec::new(),
            law: shape.law,
            law_row: 0,
            bound,
            loss_bound: 0.0,
        };
        let epsilon = |u: &Float| reference.epsilon(u);
        let value_at = |u: f64| if u == 0.0 { 1.0 } else { epsilon(&float(u)).to_f64() };
        let piece = |number: u64, left: f64| {
            Piece::new(shape, number, left, high.min(shape.grid.start(number + 1)), &epsilon)
        };
        let last = shape.grid.number(high);
        for number in (first..=last).step_by((last - first) as usize / SAMPLES + 1) {
            let mut sample = pieces.clone();
            let start = shape.grid.start(number);
            let left = if number == first {
                value_at(start)
            } else {
                lowered(shape, start, float(value_at(start))).to_f64()
            };
            sample.push(shape, piece(number, left), &epsilon)?;
        }
        let mut left = value_at(shape.grid.start(first));
        for number in first..=last {
            left = pieces.push(shape, piece(number, left), &epsilon)?;
        }
        pieces.law_row = pieces.rows.len();
        if let Some(law) = shape.law {
            let offset = (left / epsilon(&float(law.from)) - 1u32).to_f64().abs();
            pieces.bound.law += offset;
            pieces.add_law(shape, &law, left)?;
        }
        Ok(pieces)
    }

    /// Appends the first period of the law through `value`.
    fn add_law(&mut self, shape: &Shape, law: &Law, value: f64) -> Result<(), ExportError> {
        let shape = Shape { grid: Grid { shift: 0.0, ..shape.grid }, ..*shape };
        let target = |u: &Float| law.at(value, u);
        let mut left = value;
        for number in shape.grid.number(law.from)..shape.grid.number(law.period_end()) {
            let piece = Piece::new(&shape, number, left, shape.grid.start(number + 1), &target);
            left = self.push(&shape, piece, &target)?;
        }
        Ok(())
    }

    /// Appends a piece if it is good enough and returns its value at the right end, which the next must not exceed.
    fn push(
        &mut self,
        shape: &Shape,
        piece: Result<Piece, Flaw>,
        target: &dyn Fn(&Float) -> Float,
    ) -> Result<f64, ExportError> {
        let refused = |reached: f64| ExportError::Tolerance { tolerance: shape.tolerance, reached };
        let piece = piece.map_err(|_| refused(f64::INFINITY))?;
        let bound = piece.bound(shape, target);
        self.bound = self.bound.max(bound);
        let of_loss = piece.in_loss(&Bound { law: self.bound.law, ..bound });
        self.loss_bound = self.loss_bound.max(of_loss.total());
        let reached = self.bound.total().max(of_loss.approximation);
        if reached > shape.tolerance {
            return Err(refused(reached));
        }
        self.rows.push(piece.row);
        Ok(piece.right_value)
    }

    /// Replaces the approximation's part of the bound, which is sampled in a search, by what bounds it between the samples
    /// too ([`InterpolatedCurve::largest`]).
    pub(crate) fn bound_between_samples(&mut self, reference: &InterpolatedCurve, high: f64) {
        let mut largest = 0.0_f64;
        for (i, row) in self.rows[..self.law_row].iter().enumerate() {
            let number = self.first + i as u64;
            let (start, width) = (self.grid.start(number), self.grid.width(number));
            let error = |u: &Float| {
                let s = (Float::with_val(PREC, start - u) + width) / width;
                let sum = row.iter().rev().fold(float(0.0), |sum, c| sum * &s + *c);
                sum - if u.is_zero() { float(1.0) } else { reference.epsilon(u) }
            };
            for (low, high) in reference.split(start, high.min(start + width)) {
                if low < high {
                    let least = reference.epsilon(&float(high)).to_f64();
                    largest = largest.max(reference.largest(low, high, &error) / least);
                }
            }
        }
        let in_law = self.bound.approximation * f64::from(u8::from(self.law.is_some()));
        self.bound.approximation = largest.max(in_law);
    }

    /// The first row that starts at `NEAR` or later; the loss has a polynomial of its own before.
    pub fn near_row(&self) -> usize {
        let number = self.grid.number(NEAR);
        let next = number + u64::from(self.grid.start(number) < NEAR);
        next.saturating_sub(self.first) as usize
    }

    /// Where row `near_row` starts.
    pub fn near_end(&self) -> f64 {
        self.grid.start(self.first + self.near_row() as u64)
    }

    /// Finds the piece of `u`, which must lie in the range.
    pub(crate) fn locate(&self, u: f64) -> Place<'_> {
        let (u, periods, grid) = match self.law {
            Some(law) if u >= law.from => {
                let (u, periods) = law.reduce(u);
                (u, periods, Grid { shift: 0.0, ..self.grid })
            }
            _ => (u, 0, self.grid),
        };
        let (first, offset) = match self.law {
            Some(law) if u >= law.from => (grid.number(law.from), self.law_row),
            _ => (self.first, 0),
        };
        let number = grid.number(u);
        let index = (number - first) as usize + offset;
        let index = index.min(self.rows.len() - 1);
        Place {
            row: &self.rows[index],
            index,
            distance: grid.distance(u),
            width: grid.width(number),
            periods,
        }
    }

    /// Evaluates `epsilon` as the exported sources do, to the bit.
    pub fn epsilon(&self, u: f64) -> f64 {
        let place = self.locate(u);
        (place.row[0] + place.rise()) * 2.0_f64.powi(-5 * place.periods as i32)
    }

    /// Evaluates `d epsilon/d u` as the exported sources do.
    pub fn slope(&self, u: f64) -> f64 {
        let place = self.locate(u);
        let octaves = self.law.map_or(0, |law| law.octaves);
        let scale = -((5 + octaves) as i32) * place.periods as i32;
        let terms = place.row.iter().enumerate().skip(1).rev();
        let derivative = terms.fold(0.0, |sum, (k, c)| sum * place.distance + k as f64 * c);
        -derivative / place.width * 2.0_f64.powi(scale)
    }
}

impl Place<'_> {
    /// What `epsilon` has above its value at the end of the piece.
    pub(crate) fn rise(&self) -> f64 {
        let s = self.distance;
        self.row.iter().skip(1).rev().fold(0.0, |sum, c| sum * s + c) * s
    }
}

/// One polynomial.
struct Piece {
    row: Vec<f64>,
    number: u64,
    /// Where it starts and where it is used to.
    span: (f64, f64),
    /// What it gives at the right end at least.
    right_value: f64,
}

impl Piece {
    /// Interpolates `target` at the ends and between, so that the value at the start does not exceed `left`.
    fn new(
        shape: &Shape,
        number: u64,
        left: f64,
        end: f64,
        target: &dyn Fn(&Float) -> Float,
    ) -> Result<Self, Flaw> {
        let (start, width) = (shape.grid.start(number), shape.grid.width(number));
        let (mut row, zero) = (vec![0.0; shape.degree + 1], float(0.0));
        let last = Float::with_val(PREC, start - float(end)) / width + 1u32;
        let points =
            distances(shape.degree, if end - start > width * NEXT_TO_NOTHING { &last } else { &zero });
        let u_of = |s: &Float| start + Float::with_val(PREC, 1 - s) * width;
        let mut values: Vec<Float> = points.iter().map(|s| target(&u_of(s))).collect();
        let wanted = shape.last_value.filter(|_| end == shape.range.1 && points[0] == last);
        values[0] = wanted.map_or_else(|| lowered(shape, end, values[0].clone()), float);
        values[shape.degree] = float(left);
        let exact = monomials(&points, &values, &zero);
        for (c, exact) in row.iter_mut().zip(&exact) {
            *c = exact.to_f64();
        }
        row[1] = room_below(left, &row)?;
        if start == 0.0 && left == 1.0 {
            starts_at_one(&row)?;
        }
        let right_value = crate::falling::least(&row, &last);
        crate::falling::falls(&row, shape.grid.rest())?;
        Ok(Self { row, number, span: (start, end), right_value })
    }

    /// The parts of the bound relative to the loss, from [`NEAR`] on: with a subtraction more.
    fn in_loss(&self, bound: &Bound) -> Bound {
        let left: f64 = self.row.iter().sum();
        if self.span.0 < NEAR {
            return Bound::default();
        }
        let factor = left / (1.0 - left);
        Bound {
            approximation: bound.approximation * factor,
            argument: bound.argument * factor,
            evaluation: bound.evaluation * factor + 2.0 * ROUNDING,
            law: bound.law * factor,
        }
    }

    /// The parts of the bound.
    fn bound(&self, shape: &Shape, target: &dyn Fn(&Float) -> Float) -> Bound {
        let (start, end) = self.span;
        let width = shape.grid.width(self.number);
        let errors: Vec<Float> = nodes(&float(start), &float(end), shape.degree + EXTRA_NODES)
            .iter()
            .map(|u| {
                let s = (Float::with_val(PREC, start - u) + width) / width;
                let sum = self.row.iter().rev().fold(float(0.0), |sum, c| sum * &s + *c);
                sum - target(u)
            })
            .collect();
        let error: f64 = coefficients(&errors).iter().map(|c| c.to_f64().abs()).sum();
        let rising = |k: usize| self.row[k].abs();
        let sum: f64 = (1..self.row.len()).map(|k| (2 * k + 1) as f64 * rising(k)).sum();
        let slope: f64 = (1..self.row.len()).map(|k| k as f64 * rising(k)).sum();
        let least = self.right_value;
        Bound {
            approximation: error / least,
            argument: slope / width * shape.grid.rounding(self.number) / least,
            evaluation: ROUNDING * (1.0 + sum / least),
            law: 0.0,
        }
    }
}

/// Where a piece is interpolated: at the Chebyshev points of the second kind, from its right end (0) to its start (1),
/// the nearest of them moved to `end`, which comes first.
fn distances(degree: usize, end: &Float) -> Vec<Float> {
    let part = |k: usize| (PI * k as f64 / (2 * degree) as f64).sin().powi(2);
    let mut points: Vec<Float> = (0..=degree).map(|k| float(part(k))).collect();
    let away = |k: &usize| (part(*k) - end.to_f64()).abs();
    let nearest = (0..degree).min_by(|i, j| away(i).total_cmp(&away(j))).unwrap_or(0);
    points[nearest] = points[0].clone();
    points[0] = end.clone();
    points
}

/// The value at the right end of a piece: of a chord, half the tolerance below, so that its sag lies on both sides.
fn lowered(shape: &Shape, end: f64, value: Float) -> Float {
    if shape.degree > 1 || end == shape.high() {
        return value;
    }
    value * (1.0 - 0.49 * shape.tolerance)
}

fn float(x: f64) -> Float {
    Float::with_val(PREC, x)
}
