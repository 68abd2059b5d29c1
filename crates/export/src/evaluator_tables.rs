//! The tables of the crate `restitution`.

use crate::Reference;
use crate::centred::interpolate;
use crate::chebyshev::PREC;
use crate::grid::Grid;
use crate::near_zero::{loss_in_halves, loss_in_u};
use rug::Float;
use std::fmt::Write as _;

/// Degree of the polynomials: seven coefficients and a complement fill a cache line.
const DEGREE: usize = 6;
/// The first line of every generated table.
pub(crate) const HEAD: &str = "// Written by `make tables`; compared by tests/it/tables_fresh.rs.\n";

/// A table of centred pieces.
struct Centred {
    grid: Grid,
    first: u64,
    rows: Vec<Vec<f64>>,
    /// The largest relative error of the polynomials.
    approximation: f64,
}

impl Centred {
    fn fit(reference: &Reference, grid: Grid, low: f64, high: f64) -> Self {
        let first = grid.number(low);
        let mut table = Self { grid, first, rows: Vec::new(), approximation: 0.0 };
        for number in first..=grid.number(high) {
            let (row, error) = interpolate(grid, number, DEGREE, &|u| reference.epsilon(u));
            table.rows.push(row);
            table.approximation = table.approximation.max(error);
        }
        table
    }
}

/// Returns `tables/zero_compression.rs`.
pub fn zero_compression_tables(reference: &Reference) -> String {
    let (grid, near_end, far) = (Grid { shift: 8.0, bits: 9 }, 1.0 / 32.0, 7.0_f64);
    let pieces = Centred::fit(reference, grid, 0.0, far - 1.0 / 1024.0);
    let mut text = opening("Contact that ends at zero compression.", &pieces, near_end, 0.0, far);
    let near = loss_in_u(reference, 7, near_end);
    let _ = writeln!(text, "/// `R^5`, and what its rounding leaves.");
    let _ =
        writeln!(text, "#[rustfmt::skip]\npub(crate) const R5: [f64; 2] = {:?};", split(reference.factor()));
    let _ = writeln!(text, "/// `(1 - epsilon)/u` on `[0, NEAR_END)`.");
    let _ = writeln!(text, "#[rustfmt::skip]\npub(crate) const NEAR: [f64; {}] = {near:?};", near.len());
    text.push_str(&piece_table(reference, &pieces));
    text
}

/// Returns `tables/zero_force.rs`.
pub fn zero_force_tables(reference: &Reference) -> String {
    let (grid, near_end, far) = (Grid { shift: 0.5, bits: 6 }, 1.0 / 16.0, 1023.5_f64);
    let pieces = Centred::fit(reference, grid, near_end, far - 1.0 / 1024.0);
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
    text
}

/// The head of a table, its grid and its limits.
fn opening(title: &str, pieces: &Centred, near_end: f64, start: f64, far: f64) -> String {
    let Grid { shift, bits } = pieces.grid;
    format!(
        "//! {title}\n{HEAD}\nuse crate::pieces::{{Grid, Piece, piece}};\n\n\
         /// Below, `1 - epsilon` has a form of its own.\npub(crate) const NEAR_END: f64 = {near_end:?};\n\
         /// From here on the power law takes over.\npub(crate) const FAR: f64 = {far:?};\n\
         /// Where the pieces lie.\npub(crate) const GRID: Grid = Grid::new({shift:?}, {bits}, {start:?});\n"
    )
}

fn piece_table(reference: &Reference, pieces: &Centred) -> String {
    let mut text = format!(
        "/// The pieces; the approximation is off by at most {:.1e} of epsilon.\n#[rustfmt::skip]\npub(crate) static PIECES: [Piece; {}] = [\n",
        pieces.approximation,
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
    let departure = |x: &Float| reference.departure(&(1u32 / Float::with_val(PREC, x * x) / x));
    let fit = |number: u64| interpolate(grid, number, DEGREE, &departure).0;
    (grid.number(0.0)..=grid.number(1.0 / far.cbrt())).map(fit).collect()
}

/// A number as a sum of two f64.
fn split(x: &Float) -> [f64; 2] {
    let high = x.to_f64();
    [high, Float::with_val(PREC, x - high).to_f64()]
}
