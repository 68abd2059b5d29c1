//! The tables of the crate `restitution`.

use crate::InterpolatedCurve;
use crate::centred::interpolate;
use crate::chebyshev::PREC;
use crate::grid::Grid;
use crate::near_zero::{loss_in_halves, loss_in_u};
use rug::Float;
use std::fmt::Write as _;

/// Degree of the polynomials: their coefficients and a complement fill a cache line.
const DEGREE: usize = 7;
/// The first line of every generated table.
pub(crate) const HEAD: &str = "// Written by `make tables`; compared by tests/it/tables_fresh.rs.\n";

/// Functions of a number.
type Function<'a> = &'a dyn Fn(&Float) -> Float;

/// A table of centred pieces.
struct Centred {
    grid: Grid,
    first: u64,
    rows: Vec<Vec<f64>>,
}

impl Centred {
    fn fit(function: Function, grid: Grid, low: f64, high: f64) -> Self {
        let first = grid.number(low);
        let row = |number| interpolate(grid, number, DEGREE, function);
        Self { grid, first, rows: (first..=grid.number(high)).map(row).collect() }
    }

    /// The grid whose piece 0 starts at `start`, as source.
    fn place(&self, start: f64) -> String {
        format!("Grid::new({:?}, {}, {start:?})", self.grid.shift, self.grid.bits)
    }
}

/// Returns `tables/zero_compression.rs`.
pub fn zero_compression_tables(reference: &InterpolatedCurve) -> String {
    let (grid, near_end, far) = (Grid { shift: 8.0, bits: 9 }, 1.0 / 32.0, 7.0_f64);
    let pieces = Centred::fit(&|u| reference.epsilon(u), grid, 0.0, far - 1.0 / 1024.0);
    let outer =
        Centred::fit(&|m| reference.power_law(m), Grid { shift: 0.0, bits: 8 }, 1.0, 2.0 - 1.0 / 1024.0);
    let mut text = opening("Contact that ends at zero compression.", &pieces, near_end, 0.0, far);
    let near = loss_in_u(reference, 7, near_end);
    let _ = writeln!(text, "/// `R^5`, and what its rounding leaves.");
    let _ =
        writeln!(text, "#[rustfmt::skip]\npub(crate) const R5: [f64; 2] = {:?};", split(reference.factor()));
    let _ = writeln!(text, "/// `(1 - epsilon)/u` on `[0, NEAR_END)`.");
    let _ = writeln!(text, "#[rustfmt::skip]\npub(crate) const NEAR: [f64; {}] = {near:?};", near.len());
    let _ = writeln!(
        text,
        "/// So many pieces lie in `u`; then follow those of `R^5/m^5` in the significand `m`."
    );
    let _ = writeln!(text, "pub(crate) const INNER: usize = {};", pieces.rows.len());
    let _ = writeln!(
        text,
        "/// Where the latter lie.\npub(crate) const OUTER_GRID: Grid = {};",
        outer.place(1.0)
    );
    let complement = |u: &Float| reference.one_minus_epsilon(u).to_f64();
    text.push_str(&piece_table(&[(&pieces, &complement), (&outer, &|_| 0.0)]));
    text
}

/// Returns `tables/zero_force.rs`.
pub fn zero_force_tables(reference: &InterpolatedCurve) -> String {
    let (grid, near_end, far) = (Grid { shift: 0.5, bits: 6 }, 1.0 / 16.0, 1023.5_f64);
    let pieces = Centred::fit(&|u| reference.epsilon(u), grid, near_end, far - 1.0 / 1024.0);
    let by_root = |root: &Float| reference.epsilon(&root.clone().square());
    // One piece more: the root of what lies just below is rounded to that of the end.
    let near = Centred::fit(&by_root, Grid { shift: 1.0, bits: 6 }, 0.0, near_end.sqrt());
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
    let _ =
        writeln!(text, "/// So many pieces lie in `sqrt(u)`, below `NEAR_END`; then follow those in `u`.");
    let _ = writeln!(text, "pub(crate) const ROOT_PIECES: usize = {};", near.rows.len());
    let _ =
        writeln!(text, "/// Where the former lie.\npub(crate) const ROOT_GRID: Grid = {};", near.place(0.0));
    let complement = |u: &Float| reference.one_minus_epsilon(u).to_f64();
    text.push_str(&piece_table(&[(&near, &|_| 0.0), (&pieces, &complement)]));
    let _ = writeln!(text, "/// `epsilon u^(5/3)/LIMIT - 1` in pieces of `u^(-1/3)`.");
    let _ = writeln!(text, "#[rustfmt::skip]\npub(crate) static BEYOND: [[f64; 8]; {}] = [", beyond.len());
    for row in beyond {
        let _ = writeln!(text, "    {row:?},");
    }
    text.push_str("];\n");
    text
}

/// The head of a table, its grid and its limits.
fn opening(title: &str, pieces: &Centred, near_end: f64, start: f64, far: f64) -> String {
    format!(
        "//! {title}\n{HEAD}\nuse crate::evaluator::pieces::{{Grid, Piece, piece}};\n\n\
         /// Below, `1 - epsilon` has a form of its own.\npub(crate) const NEAR_END: f64 = {near_end:?};\n\
         /// From here on the power law takes over.\npub(crate) const FAR: f64 = {far:?};\n\
         /// Where the pieces in `u` lie.\npub(crate) const GRID: Grid = {};\n",
        pieces.place(start)
    )
}

/// Pieces of one grid, with the complement of each centre.
type Part<'a> = (&'a Centred, &'a dyn Fn(&Float) -> f64);

/// The pieces of several grids.
fn piece_table(parts: &[Part]) -> String {
    let count: usize = parts.iter().map(|(pieces, _)| pieces.rows.len()).sum();
    let mut text = format!(
        "/// The pieces; docs/evaluator.md says what is proved of them.\n#[rustfmt::skip]\npub(crate) static PIECES: [Piece; {count}] = [\n",
    );
    for (pieces, complement) in parts {
        for (i, row) in pieces.rows.iter().enumerate() {
            let centre = Float::with_val(PREC, pieces.grid.centre(pieces.first + i as u64));
            let _ = writeln!(text, "    piece({row:?}, {:?}),", complement(&centre));
        }
    }
    text + "];\n"
}

/// The departure from the power law in `u^(-1/3)`, up to that of `far`.
fn departure_rows(reference: &InterpolatedCurve, far: f64) -> Vec<Vec<f64>> {
    let grid = Grid { shift: 1.0 / 16.0, bits: 5 };
    let departure = |x: &Float| reference.departure(&(1u32 / Float::with_val(PREC, x * x) / x));
    let fit = |number: u64| interpolate(grid, number, DEGREE, &departure);
    (grid.number(0.0)..=grid.number(1.0 / far.cbrt())).map(fit).collect()
}

/// A number as a sum of two f64.
fn split(x: &Float) -> [f64; 2] {
    let high = x.to_f64();
    [high, Float::with_val(PREC, x - high).to_f64()]
}
