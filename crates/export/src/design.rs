//! The cheapest table of pieces for a tolerance and a range.

use super::error::ExportError;
use super::pieces::{Grid, Pieces, Variable};
use super::reference::Reference;
use restitution::End;

/// What is added to the variable, tried in turn: the larger, the evener the pieces.
const SHIFTS: [f64; 8] = [8.0, 4.0, 2.0, 1.0, 0.5, 0.25, 0.125, 0.0625];
/// Constants that a table may have, tried in turn: 4, 16 and 64 KiB.
const TABLE_SIZES: [u64; 3] = [512, 2048, 8192];
/// The largest degree, beyond which more pieces are cheaper.
const LARGEST_DEGREE: usize = 8;
/// Of the tolerance, what the polynomials may use.
const SHARE: f64 = 0.98;

/// Returns the table of least degree, and of least size for that, whose bound keeps `tolerance`.
///
/// At zero force the variable is `u` where that is enough and `sqrt(u)` where it isn't.
///
/// # Errors
///
/// [`ExportError::Tolerance`] if no table does.
pub fn design(reference: &Reference, tolerance: f64, range: (f64, f64)) -> Result<Pieces, ExportError> {
    let variables: &[Variable] = match reference.end() {
        End::ZeroCompression => &[Variable::U],
        End::ZeroForce => &[Variable::U, Variable::SqrtU],
    };
    let mut refused = ExportError::Tolerance { tolerance, reached: f64::INFINITY };
    for size in TABLE_SIZES {
        for variable in variables {
            for degree in 1..=LARGEST_DEGREE {
                match smallest(reference, *variable, degree, (range, tolerance), size) {
                    Ok(Some(pieces)) => return Ok(pieces),
                    Ok(None) => {}
                    Err(ExportError::Tolerance { reached, .. }) => {
                        refused = ExportError::Tolerance { tolerance, reached }
                    }
                    Err(error) => return Err(error),
                }
            }
        }
    }
    Err(refused)
}

/// The smallest table of one degree; `None` or the last refusal if none fits into `size` constants.
fn smallest(
    reference: &Reference,
    variable: Variable,
    degree: usize,
    (range, tolerance): ((f64, f64), f64),
    size: u64,
) -> Result<Option<Pieces>, ExportError> {
    let mut best: Option<Pieces> = None;
    let mut refused = None;
    for shift in SHIFTS {
        for bits in 0..=12 {
            let grid = Grid { shift, bits };
            let count = grid.number(variable.of(range.1)) - grid.number(variable.of(range.0)) + 1;
            let largest = best.as_ref().map_or(size, |best| (best.rows.len() * (degree + 1)) as u64 - 1);
            if count * (degree as u64 + 1) > largest {
                break;
            }
            match Pieces::fit(reference, variable, grid, degree, range, tolerance * SHARE) {
                Ok(pieces) => {
                    best = Some(pieces);
                    break;
                }
                Err(error) => refused = Some(error),
            }
        }
    }
    match (best, refused) {
        (None, Some(error)) => Err(error),
        (best, _) => Ok(best),
    }
}
