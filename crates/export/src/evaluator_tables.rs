//! The tables of the crate `restitution`.

use super::chebyshev::{PREC, monomials, nodes};
use super::near_zero::{loss_in_halves, loss_in_u};
use super::pieces::Grid;
use super::{ExportError, Pieces, Reference, Variable, design};
use restitution::End;
use rug::Float;
use std::fmt::Write as _;

/// Degree of the polynomials: seven coefficients and a complement fill a cache line.
const DEGREE: usize = 6;
/// The tiers' range; beyond it they hand over to the full evaluator.
const TIER_RANGE: (f64, f64) = (0.0, 8.0);
const TIERS: [(&str, f64); 3] = [("1E3", 1e-3), ("1E6", 1e-6), ("1E9", 1e-9)];
const HEAD: &str =
    "// Written by `restitution export --lang evaluator-tables`; compared by tests/it/tables_fresh.rs.\n";

/// Returns `tables/zero_compression.rs`.
///
/// # Errors
///
/// [`ExportError::Tolerance`] never, as the tables fit; it is there for the signature of the fit.
pub fn zero_compression_tables(reference: &Reference) -> Result<String, ExportError> {
    let (grid, near_end, far) = (Grid { shift: 8.0, bits: 9 }, 1.0 / 32.0, 7.0_f64);
    let pieces = Pieces::fit(reference, Variable::U, grid, DEGREE, (0.0, far - 1.0 / 1024.0), f64::INFINITY)?;
    let mut text = opening("Contact that ends at zero compression.", &pieces, near_end, 0.0, far);
    let near = loss_in_u(reference, 7, near_end);
    let _ = writeln!(text, "/// `R^5`, and what its rounding leaves.");
    let _ =
        writeln!(text, "#[rustfmt::skip]\npub(crate) const R5: [f64; 2] = {:?};", split(reference.factor()));
    let _ = writeln!(text, "/// `(1 - epsilon)/u` on `[0, NEAR_END)`.");
    let _ = writeln!(text, "#[rustfmt::skip]\npub(crate) const NEAR: [f64; {}] = {near:?};", near.len());
    text.push_str(&piece_table(reference, &pieces));
    Ok(text)
}

/// Returns `tables/zero_force.rs`.
///
/// # Errors
///
/// As [`zero_compression_tables`].
pub fn zero_force_tables(reference: &Reference) -> Result<String, ExportError> {
    let (grid, near_end, far) = (Grid { shift: 0.5, bits: 6 }, 1.0 / 16.0, 1023.5_f64);
    let pieces =
        Pieces::fit(reference, Variable::U, grid, DEGREE, (near_end, far - 1.0 / 1024.0), f64::INFINITY)?;
    let mut text = opening("Contact that ends at zero force.", &pieces, near_end, near_end, far);
    let (a, b) = loss_in_halves(reference, 9, 6, near_end);
    let beyond = departure_rows(reference, far);
    let _ = writeln!(text, "/// `(3/2)^(2/3)`, and what its rounding leaves.");
    let _ = writeln!(
        text,
        "#[rustfmt::skip]\npub(crate) const LIMIT: [f64; 2] = {:?};",
        split(reference.factor())
    );
    let _ = writeln!(text, "/// `(1 - epsilon)/u` on `[0, NEAR_END)`: the whole powers of `u`.");
    let _ = writeln!(text, "#[rustfmt::skip]\npub(crate) const NEAR_WHOLES: [f64; {}] = {a:?};", a.len());
    let _ = writeln!(text, "/// The same: the powers of `u` that follow `u^(3/2)`.");
    let _ = writeln!(text, "#[rustfmt::skip]\npub(crate) const NEAR_HALVES: [f64; {}] = {b:?};", b.len());
    text.push_str(&piece_table(reference, &pieces));
    let _ = writeln!(text, "/// `epsilon u^(5/3)/LIMIT - 1` in pieces of `u^(-1/3)`.");
    let _ = writeln!(text, "#[rustfmt::skip]\npub(crate) static BEYOND: [[f64; 7]; {}] = [", beyond.len());
    for row in beyond {
        let _ = writeln!(text, "    {row:?},");
    }
    text.push_str("];\n");
    Ok(text)
}

/// Returns `tables/tiers.rs`.
///
/// # Errors
///
/// [`ExportError::Tolerance`] if no table keeps a tier's tolerance.
pub fn tier_tables(references: [&Reference; 2]) -> Result<String, ExportError> {
    let mut text = format!("//! Cheaper tiers.\n{HEAD}\nuse crate::End;\nuse crate::tiers::Tier;\n");
    for reference in references {
        for (name, tolerance) in TIERS {
            let pieces = design(reference, tolerance, TIER_RANGE)?;
            text.push_str(&tier(reference.end(), name, tolerance, &pieces));
        }
    }
    Ok(text)
}

fn tier(end: End, name: &str, tolerance: f64, pieces: &Pieces) -> String {
    let (title, variant) = match end {
        End::ZeroCompression => ("ZERO_COMPRESSION", "ZeroCompression"),
        End::ZeroForce => ("ZERO_FORCE", "ZeroForce"),
    };
    let (rows, width, Grid { shift, bits }) = (pieces.rows.len(), pieces.rows[0].len(), pieces.grid);
    let mut text = format!(
        "\n/// To {tolerance:e}; contact ends at {}.\n#[rustfmt::skip]\npub static {title}_{name}: Tier<{rows}, {width}> = Tier::new(End::{variant}, {tolerance:e}, {:?}, {shift:?}, {bits}, [\n",
        title.to_lowercase().replace('_', " "),
        TIER_RANGE.1
    );
    for row in &pieces.rows {
        let _ = writeln!(text, "    {row:?},");
    }
    text + "]);\n"
}

/// The head of a table, its grid and its limits.
fn opening(title: &str, pieces: &Pieces, near_end: f64, start: f64, far: f64) -> String {
    let Grid { shift, bits } = pieces.grid;
    format!(
        "//! {title}\n{HEAD}\nuse crate::pieces::{{Grid, Piece, piece}};\n\n\
         /// Below, `1 - epsilon` has a form of its own.\npub(crate) const NEAR_END: f64 = {near_end:?};\n\
         /// From here on the power law takes over.\npub(crate) const FAR: f64 = {far:?};\n\
         /// Where the pieces lie.\npub(crate) const GRID: Grid = Grid::new({shift:?}, {bits}, {start:?});\n"
    )
}

fn piece_table(reference: &Reference, pieces: &Pieces) -> String {
    let mut text = format!(
        "/// The pieces; the approximation is off by at most {:.1e} of epsilon.\n#[rustfmt::skip]\npub(crate) static PIECES: [Piece; {}] = [\n",
        pieces.bound.approximation,
        pieces.rows.len()
    );
    for (i, row) in pieces.rows.iter().enumerate() {
        let centre = Float::with_val(PREC, pieces.grid.centre(pieces.first + i as u64));
        let complement = reference.one_minus_epsilon(&centre).to_f64();
        let _ = writeln!(text, "    piece({row:?}, {complement:?}),");
    }
    text + "];\n"
}

/// The departure from the power law in `u^(-1/3)`, up to that of `far`.
fn departure_rows(reference: &Reference, far: f64) -> Vec<Vec<f64>> {
    let grid = Grid { shift: 1.0 / 16.0, bits: 5 };
    let float = |x: f64| Float::with_val(PREC, x);
    let fit = |number: u64| {
        let points = nodes(&float(grid.start(number)), &float(grid.start(number + 1)), DEGREE + 1);
        let value = |x: &Float| reference.departure(&(1u32 / Float::with_val(PREC, x * x) / x));
        let values: Vec<Float> = points.iter().map(value).collect();
        monomials(&points, &values, &float(grid.centre(number))).iter().map(Float::to_f64).collect()
    };
    (grid.number(0.0)..=grid.number(1.0 / far.cbrt())).map(fit).collect()
}

/// A number as a sum of two f64.
fn split(x: &Float) -> [f64; 2] {
    let high = x.to_f64();
    [high, Float::with_val(PREC, x - high).to_f64()]
}
