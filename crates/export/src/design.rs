//! The cheapest table of pieces for a tolerance and a range.

use crate::grid::Grid;
use crate::pieces::{Pieces, Shape};
use crate::target::Law;
use crate::{ExportError, InterpolatedCurve};

/// The least and the largest relative error that can be asked for.
const TOLERANCES: (f64, f64) = (1e-15, 0.1);
/// The largest `u` that can be asked for.
const LARGEST_U: f64 = 1e6;
/// Exponents of two of what is added to `u`: the larger, the evener the pieces.
const SHIFTS: std::ops::RangeInclusive<i32> = -14..=3;
/// Constants that a table may have, tried in turn: 4, 16 and 64 KiB.
const TABLE_SIZES: [u64; 3] = [512, 2048, 8192];
/// The largest degree, beyond which more pieces are cheaper.
const LARGEST_DEGREE: usize = 8;
/// Most leading bits that number the pieces.
const LARGEST_BITS: u32 = 12;
/// Of the tolerance, what the table may use.
const SHARE: f64 = 0.98;

/// What a table is designed for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// The largest relative error of `epsilon`.
    pub tolerance: f64,
    /// The range of `u`.
    pub range: (f64, f64),
    /// What follows beyond the range.
    pub beyond: Beyond,
}

impl Request {
    /// Checks the numbers.
    ///
    /// # Errors
    ///
    /// [`ExportError::WrongTolerance`] outside 1e-15 to 0.1, [`ExportError::WrongRange`] outside
    /// `0 <= LO < HI <= 1e6`.
    pub fn check(&self) -> Result<(), ExportError> {
        let (low, high) = self.range;
        if !(TOLERANCES.0..=TOLERANCES.1).contains(&self.tolerance) {
            return Err(ExportError::WrongTolerance);
        }
        if !(0.0 <= low && low < high && high <= LARGEST_U) {
            return Err(ExportError::WrongRange);
        }
        Ok(())
    }

    /// The largest `u` at which a table for this request needs the function, for [`InterpolatedCurve::up_to`].
    pub fn reach(&self) -> f64 {
        if self.beyond == Beyond::Law { f64::INFINITY } else { 2.0 * (self.range.1 + 8.0) }
    }
}

/// What an evaluator gives beyond the range that was asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Beyond {
    /// NaN.
    #[default]
    NotANumber,
    /// Values within the tolerance for every `u`: a table as long as it takes, then the law at infinity.
    Law,
}

/// Returns the table of least degree, and of least size for that, whose bound keeps the tolerance.
///
/// Cost: seconds for tolerances near 1e-15, less for others.
///
/// # Errors
///
/// Those of [`Request::check`], [`ExportError::Tolerance`] if no table keeps the tolerance, [`ExportError::Law`] if the
/// law at infinity comes too late.
///
/// # Examples
///
/// ```
/// use restitution::End;
/// use restitution_export::{Beyond, ExportError, InterpolatedCurve, Request, design};
///
/// let request = Request { tolerance: 1e-4, range: (0.0, 2.0), beyond: Beyond::NotANumber };
/// let reference = InterpolatedCurve::up_to(End::ZeroCompression, request.reach())?;
/// let table = design(&reference, &request)?;
/// assert_eq!(table.epsilon(0.0), 1.0);
/// assert!((table.epsilon(1.0) / 0.331_164_810_466_640_94 - 1.0).abs() <= 1e-4);
///
/// let request = Request { tolerance: 1e-17, ..request };
/// assert!(matches!(design(&reference, &request), Err(ExportError::WrongTolerance)));
/// # Ok::<(), ExportError>(())
/// ```
pub fn design(reference: &InterpolatedCurve, request: &Request) -> Result<Pieces, ExportError> {
    request.check()?;
    let law = match request.beyond {
        Beyond::NotANumber => None,
        Beyond::Law => Some(Law::within(reference, request.tolerance)?),
    };
    let shape = Shape {
        grid: Grid { shift: 1.0, bits: 0 },
        degree: 1,
        range: request.range,
        law,
        last_value: None,
        tolerance: request.tolerance * SHARE,
    };
    let mut pieces = cheapest(reference, &shape, &TABLE_SIZES, request.tolerance)?;
    pieces.bound_between_samples(reference, shape.high());
    let reached = pieces.bound.total();
    if reached > request.tolerance {
        return Err(ExportError::Tolerance { tolerance: request.tolerance, reached });
    }
    Ok(pieces)
}

/// The cheapest table for everything in `shape` but its grid and its degree.
pub(crate) fn cheapest(
    reference: &InterpolatedCurve,
    shape: &Shape,
    sizes: &[u64],
    tolerance: f64,
) -> Result<Pieces, ExportError> {
    let mut reached = f64::INFINITY;
    for size in sizes {
        for degree in 1..=LARGEST_DEGREE {
            match smallest(reference, &Shape { degree, ..*shape }, *size) {
                Ok(pieces) => return Ok(pieces),
                Err(best) => reached = reached.min(best),
            }
        }
    }
    Err(ExportError::Tolerance { tolerance, reached })
}

/// The smallest table of one degree, or the least error of what fits into `size` constants.
fn smallest(reference: &InterpolatedCurve, shape: &Shape, size: u64) -> Result<Pieces, f64> {
    let constants = shape.degree as u64 + 1;
    let (mut best, mut reached): (Option<Pieces>, _) = (None, f64::INFINITY);
    for exponent in SHIFTS.rev() {
        for bits in 0..=LARGEST_BITS {
            let shape = Shape { grid: Grid { shift: 2.0_f64.powi(exponent), bits }, ..*shape };
            let largest = best.as_ref().map_or(size, |best| best.rows.len() as u64 * constants - 1);
            if rows(&shape) * constants > largest {
                break;
            }
            match Pieces::fit(reference, &shape) {
                Ok(pieces) => {
                    best = Some(pieces);
                    break;
                }
                Err(ExportError::Tolerance { reached: this, .. }) => reached = reached.min(this),
                Err(_) => {}
            }
        }
    }
    best.ok_or(reached)
}

/// The number of rows that a table will have.
fn rows(shape: &Shape) -> u64 {
    let of_law = shape.law.map_or(0, |law| u64::from(law.octaves) << shape.grid.bits);
    shape.grid.number(shape.high()) - shape.grid.number(shape.range.0) + 1 + of_law
}
