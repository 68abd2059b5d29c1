//! Rust.

use super::{head, number, row};
use crate::{Listing, Pieces, Variable};

const TEMPLATE: &str = r"{HEAD}//
// Self-check: rustc --test FILE && run it, or `cargo test` with this file as a module.

/// Coefficients of each piece, in the distance to its centre, constant first.
#[rustfmt::skip]
#[allow(clippy::all)]
static COEFFICIENTS: [[f64; {WIDTH}]; {ROWS}] = [
{TABLE}];
/// What is added to the variable before its leading bits number the piece.
const SHIFT: f64 = {SHIFT};

/// Returns the coefficient of restitution at `u`; NaN outside the range.
#[inline]
pub fn epsilon(u: f64) -> f64 {
    if !({LOW}..={HIGH}).contains(&u) {
        return f64::NAN;
    }
    let x = {X};
    let number = (x + SHIFT).to_bits() >> {DROP};
    let centre = f64::from_bits((2 * number + 1) << {HALF_DROP}) - SHIFT;
    let row = &COEFFICIENTS[(number - {FIRST}) as usize];
    row.iter().rev().fold(0.0, |sum, c| sum * (x - centre) + c)
}

/// Writes the coefficient of restitution at each `u` to `out`, as far as the shorter reaches.
pub fn epsilon_slice(u: &[f64], out: &mut [f64]) {
    for (u, out) in u.iter().zip(out) {
        *out = epsilon(*u);
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn certified_values_are_met() {
        #[rustfmt::skip]
        let certified: [[f64; 2]; {CHECKS}] = [
{POINTS}        ];
        for [u, exact] in certified {
            let error = (super::epsilon(u) / exact - 1.0).abs();
            assert!(error <= {TOLERANCE}, {MESSAGE});
        }
    }
}
";

pub(super) fn write(listing: &Listing) -> String {
    let Pieces { grid, first, variable, ref rows, .. } = listing.pieces;
    let lines = |indent: &str, rows: &mut dyn Iterator<Item = Vec<f64>>| -> String {
        rows.map(|numbers| format!("{indent}[{}],\n", row(&numbers, ""))).collect()
    };
    TEMPLATE
        .replace("{HEAD}", &head(listing, "// "))
        .replace("{WIDTH}", &listing.width().to_string())
        .replace("{ROWS}", &rows.len().to_string())
        .replace("{TABLE}", &lines("    ", &mut rows.iter().cloned()))
        .replace("{LOW}", &number(listing.range.0))
        .replace("{HIGH}", &number(listing.range.1))
        .replace("{X}", if variable == Variable::U { "u" } else { "u.sqrt()" })
        .replace("{SHIFT}", &number(grid.shift))
        .replace("{DROP}", &(52 - grid.bits).to_string())
        .replace("{HALF_DROP}", &(51 - grid.bits).to_string())
        .replace("{FIRST}", &first.to_string())
        .replace("{CHECKS}", &listing.checks.len().to_string())
        .replace("{POINTS}", &lines("            ", &mut listing.checks.iter().map(|(u, e)| vec![*u, *e])))
        .replace("{TOLERANCE}", &format!("{:e}", listing.tolerance))
        .replace("{MESSAGE}", r#""u = {u:e}: relative error {error:e}""#)
}
