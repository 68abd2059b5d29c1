//! Piecewise polynomials on a grid that the exponent and leading bits of a shifted argument number.

use super::chebyshev::{PREC, coefficients, monomials, nodes};
use super::error::ExportError;
use super::reference::Reference;
use rug::Float;

/// Half an ulp relative to the number, 2^-53.
const ROUNDING: f64 = f64::EPSILON / 2.0;
/// Nodes beyond the degree, on which the neglected Chebyshev coefficients are measured.
const EXTRA_NODES: usize = 6;

/// The variable of the polynomials.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variable {
    /// `u`.
    U,
    /// `sqrt(u)`, in which the contact that ends at zero force is analytic at 0.
    SqrtU,
}

/// Where the pieces lie: `2^-bits` of a factor of two each, in `x + shift`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// What is added to the variable.
    pub shift: f64,
    /// Leading bits of `x + shift` that number the pieces.
    pub bits: u32,
}

/// The parts of the bound of an approximation, relative to the function.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bound {
    /// What the polynomials leave out: twice the sum of the neglected Chebyshev coefficients.
    pub approximation: f64,
    /// The rounding of the constants.
    pub constants: f64,
    /// The rounding of the evaluation, of the square root in it too.
    pub evaluation: f64,
}

impl Bound {
    /// The sum of the parts.
    pub fn total(&self) -> f64 {
        self.approximation + self.constants + self.evaluation
    }

    /// The larger of each part.
    fn max(self, other: Self) -> Self {
        Self {
            approximation: self.approximation.max(other.approximation),
            constants: self.constants.max(other.constants),
            evaluation: self.evaluation.max(other.evaluation),
        }
    }
}

/// A piecewise polynomial for a range of `u`.
#[derive(Clone, Debug)]
pub struct Pieces {
    /// The variable of the polynomials.
    pub variable: Variable,
    /// The grid.
    pub grid: Grid,
    /// The number that the grid gives the first piece.
    pub first: u64,
    /// Coefficients in `x - centre`, constant first, of every piece.
    pub rows: Vec<Vec<f64>>,
    /// The largest of each part over the pieces.
    pub bound: Bound,
}

impl Variable {
    /// The value of the variable.
    pub fn of(self, u: f64) -> f64 {
        if self == Self::U { u } else { u.sqrt() }
    }

    /// `u` of a value of the variable.
    pub(super) fn u(self, x: &Float) -> Float {
        if self == Self::U { x.clone() } else { x.clone().square() }
    }
}

impl Grid {
    /// The number of the piece that `x` lies in.
    pub fn number(&self, x: f64) -> u64 {
        (x + self.shift).to_bits() >> (52 - self.bits)
    }

    /// Where piece `number` starts.
    pub fn start(&self, number: u64) -> f64 {
        f64::from_bits(number << (52 - self.bits)) - self.shift
    }

    /// The centre of piece `number`.
    pub fn centre(&self, number: u64) -> f64 {
        f64::from_bits((2 * number + 1) << (51 - self.bits)) - self.shift
    }
}

impl Pieces {
    /// Fits the pieces from `low` to `high` in `u`, the last one whole.
    ///
    /// # Errors
    ///
    /// [`ExportError::Tolerance`] as soon as a piece's bound exceeds `tolerance`.
    pub fn fit(
        reference: &Reference,
        variable: Variable,
        grid: Grid,
        degree: usize,
        (low, high): (f64, f64),
        tolerance: f64,
    ) -> Result<Self, ExportError> {
        let first = grid.number(variable.of(low));
        let last = grid.number(variable.of(high));
        let mut pieces = Self { variable, grid, first, rows: Vec::new(), bound: Bound::default() };
        for number in first..=last {
            let (row, bound) = fit_one(reference, variable, grid, degree, number);
            pieces.bound = pieces.bound.max(bound);
            pieces.rows.push(row);
            if pieces.bound.total() > tolerance {
                return Err(ExportError::Tolerance { tolerance, reached: pieces.bound.total() });
            }
        }
        Ok(pieces)
    }

    /// Evaluates as the exported sources do, to the bit.
    pub fn epsilon(&self, u: f64) -> f64 {
        let x = self.variable.of(u);
        let number = self.grid.number(x);
        let t = x - self.grid.centre(number);
        let row = number.checked_sub(self.first).and_then(|i| self.rows.get(usize::try_from(i).ok()?));
        row.map_or(f64::NAN, |row| row.iter().rev().fold(0.0, |sum, c| sum * t + c))
    }
}

/// The polynomial of piece `number`, rounded, and its bound.
fn fit_one(
    reference: &Reference,
    variable: Variable,
    grid: Grid,
    degree: usize,
    number: u64,
) -> (Vec<f64>, Bound) {
    let float = |x: f64| Float::with_val(PREC, x);
    let (low, centre, high) = (grid.start(number), grid.centre(number), grid.start(number + 1));
    let sample = |count: usize| {
        let nodes = nodes(&float(low), &float(high), count);
        let values: Vec<Float> = nodes.iter().map(|x| reference.epsilon(&variable.u(x))).collect();
        (nodes, values)
    };
    let (points, values) = sample(degree + 1);
    let row: Vec<f64> = monomials(&points, &values, &float(centre)).iter().map(Float::to_f64).collect();
    let (_, values) = sample(degree + 1 + EXTRA_NODES);
    let least = values.iter().map(Float::to_f64).fold(f64::INFINITY, f64::min);
    let neglected: f64 = coefficients(&values).iter().skip(degree + 1).map(|c| c.to_f64().abs()).sum();
    let bound = Bound {
        approximation: 2.0 * neglected / least,
        ..rounding(&row, variable, centre, high - centre, least)
    };
    (row, bound)
}

/// The rounding errors of a row on `|t| <= reach` (Higham, *Accuracy and Stability*, 2002, sec. 5.1):
/// one of the sum, `2 k + 1` of the term of degree `k`, and that of the square root.
fn rounding(row: &[f64], variable: Variable, centre: f64, reach: f64, least: f64) -> Bound {
    let (mut constants, mut evaluation, mut slope) = (row[0].abs(), row[0].abs(), 0.0);
    let mut power = 1.0;
    for (k, c) in row.iter().enumerate().skip(1) {
        slope += k as f64 * c.abs() * power;
        power *= reach;
        constants += c.abs() * power;
        evaluation += (2 * k + 1) as f64 * c.abs() * power;
    }
    if variable == Variable::SqrtU {
        evaluation += slope * (centre.abs() + reach);
    }
    let relative = ROUNDING / least;
    Bound { approximation: 0.0, constants: constants * relative, evaluation: evaluation * relative }
}
