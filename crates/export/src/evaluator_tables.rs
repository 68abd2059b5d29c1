//! The tables of the crate `restitution`.

use crate::InterpolatedCurve;
use crate::centred::{interpolate, row};
use crate::chebyshev::PREC;
use crate::grid::Grid;
use crate::near_zero::{loss_in_halves, loss_in_u};
use rug::Float;
use std::fmt::Write as _;

/// Degree of the polynomials of the power law at zero force.
const DEGREE: usize = 7;
/// The first line of every generated table.
pub(crate) const HEAD: &str = "// Written by `make tables`; compared by tests/it/tables_fresh.rs.\n";

/// The last piece holds it: `u + shift` grows to 1024 there at both ends.
const FAR: f64 = 1022.0;

/// Functions of a number.
type Function<'a> = &'a dyn Fn(&Float) -> Float;

/// A table of centred pieces.
struct Centred {
    grid: Grid,
    first: u64,
    rows: Vec<Vec<f64>>,
}

impl Centred {
    /// The pieces from 0 to the one that holds `last`.
    fn fit(function: Function, grid: Grid, last: f64) -> Self {
        let first = grid.number(0.0);
        let rows = (first..=grid.number(last)).map(|number| row(grid, number, function)).collect();
        Self { grid, first, rows }
    }
}

/// Returns `tables/zero_compression.rs`.
pub fn zero_compression_tables(reference: &InterpolatedCurve) -> String {
    let (grid, near_end) = (Grid { shift: 1.0, bits: 7 }, 1.0 / 32.0);
    let pieces = Centred::fit(&|u| reference.epsilon(u), grid, FAR);
    let mut text = opening("Contact that ends at zero compression.", &pieces, near_end);
    let near = loss_in_u(reference, 7, near_end);
    let _ = writeln!(text, "/// `R^5`, and what its rounding leaves.");
    let _ =
        writeln!(text, "#[rustfmt::skip]\npub(crate) const R5: [f64; 2] = {:?};", split(reference.factor()));
    let _ = writeln!(text, "/// `(1 - epsilon)/u` on `[0, NEAR_END)`.");
    let _ = writeln!(text, "#[rustfmt::skip]\npub(crate) const NEAR: [f64; {}] = {near:?};", near.len());
    text.push_str(&piece_table(&pieces, reference));
    text
}

/// Returns `tables/zero_force.rs`.
pub fn zero_force_tables(reference: &InterpolatedCurve) -> String {
    let (grid, near_end) = (Grid { shift: 1.0 / 512.0, bits: 6 }, 1.0 / 16.0);
    let pieces = Centred::fit(&|u| reference.epsilon(u), grid, FAR);
    let mut text = opening("Contact that ends at zero force.", &pieces, near_end);
    let (a, b) = loss_in_halves(reference, 9, 6, near_end);
    let beyond = departure_rows(reference, FAR);
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
    text.push_str(&piece_table(&pieces, reference));
    let _ = writeln!(text, "/// `epsilon u^(5/3)/LIMIT - 1` in pieces of `u^(-1/3)`.");
    let _ = writeln!(text, "#[rustfmt::skip]\npub(crate) static BEYOND: [[f64; 8]; {}] = [", beyond.len());
    for row in beyond {
        let _ = writeln!(text, "    {row:?},");
    }
    text.push_str("];\n");
    text
}

/// The head of a table, its grid and its limits.
fn opening(title: &str, pieces: &Centred, near_end: f64) -> String {
    let Grid { shift, bits } = pieces.grid;
    format!(
        "//! {title}\n{HEAD}\nuse crate::evaluator::pieces::{{Grid, ROWS, Rows, piece}};\n\n\
         /// Below, `1 - epsilon` has a form of its own.\npub(crate) const NEAR_END: f64 = {near_end:?};\n\
         /// Where the pieces lie.\npub(crate) const GRID: Grid = Grid::new({shift:?}, {bits}, 0.0);\n\
         /// How many they are.\npub(crate) const COUNT: usize = {};\n",
        pieces.rows.len()
    )
}

/// The pieces, with the complement of each centre.
fn piece_table(pieces: &Centred, reference: &InterpolatedCurve) -> String {
    let mut text = String::from(
        "/// The pieces; docs/evaluator.md says what is proved of them.\n#[rustfmt::skip]\npub(crate) static TABLE: Rows<ROWS> = Rows::of(&[\n",
    );
    for (i, row) in pieces.rows.iter().enumerate() {
        let centre = Float::with_val(PREC, pieces.grid.centre(pieces.first + i as u64));
        let complement = reference.one_minus_epsilon(&centre).to_f64();
        let _ = writeln!(text, "    piece({row:?}, {complement:?}),");
    }
    text + "]);\n"
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
