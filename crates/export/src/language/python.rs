//! Python.

use super::{head, number, row};
use crate::{Listing, Pieces, Variable};

const TEMPLATE: &str = r#""""{HEAD}
epsilon(u) takes a number or a NumPy array. Self-check: python FILE
"""

import math

# Coefficients of each piece, in the distance to its centre, constant first.
_COEFFICIENTS = [
{TABLE}]
_LOW, _HIGH = {LOW}, {HIGH}
_SHIFT = {SHIFT}  # added to the variable before its leading bits number the piece
_BITS = {BITS}
_FIRST = {FIRST}
_as_array = None


def epsilon(u):
    """Coefficient of restitution at u, a number or an array; NaN outside the range."""
    if isinstance(u, (int, float)):
        return _of_float(float(u))
    return _of_array(u)


def _of_float(u):
    if not _LOW <= u <= _HIGH:
        return math.nan
    x = {FLOAT_X}
    mantissa, exponent = math.frexp(x + _SHIFT)
    leading = int(math.ldexp(mantissa, _BITS + 1))
    number = ((exponent + 1022) << _BITS) + leading - (1 << _BITS)
    t = x - (math.ldexp(leading + 0.5, exponent - _BITS - 1) - _SHIFT)
    total = 0.0
    for c in reversed(_COEFFICIENTS[number - _FIRST]):
        total = total * t + c
    return total


def _of_array(u):
    import numpy as np

    global _as_array
    if _as_array is None:
        _as_array = np.array(_COEFFICIENTS).T.copy()
    u = np.asarray(u, dtype=np.float64)
    inside = (u >= _LOW) & (u <= _HIGH)
    x = {ARRAY_X}
    mantissa, exponent = np.frexp(x + _SHIFT)
    leading = np.ldexp(mantissa, _BITS + 1).astype(np.int64)
    number = ((exponent.astype(np.int64) + 1022) << _BITS) + leading - (1 << _BITS)
    t = x - (np.ldexp(leading + 0.5, exponent - _BITS - 1) - _SHIFT)
    row = number - _FIRST
    total = np.zeros_like(t)
    for c in _as_array[::-1]:
        total = total * t + c[row]
    return np.where(inside, total, np.nan)


# u, certified epsilon
_CHECK = [
{POINTS}]

if __name__ == "__main__":
    worst = max(abs(epsilon(u) / exact - 1) for u, exact in _CHECK)
    print(f"largest relative error {worst:.2e}, tolerance {TOLERANCE}")
    raise SystemExit(0 if worst <= {TOLERANCE} else 1)
"#;

pub(super) fn write(listing: &Listing) -> String {
    let Pieces { grid, first, variable, ref rows, .. } = listing.pieces;
    let lines = |rows: &mut dyn Iterator<Item = Vec<f64>>| -> String {
        rows.map(|numbers| format!("    ({}),\n", row(&numbers, ""))).collect()
    };
    let inside = "np.where(inside, u, _LOW)";
    let (float_x, array_x) = match variable {
        Variable::U => ("u".to_owned(), inside.to_owned()),
        Variable::SqrtU => ("math.sqrt(u)".to_owned(), format!("np.sqrt({inside})")),
    };
    TEMPLATE
        .replace("{HEAD}", &head(listing, ""))
        .replace("{TABLE}", &lines(&mut rows.iter().cloned()))
        .replace("{LOW}", &number(listing.range.0))
        .replace("{HIGH}", &number(listing.range.1))
        .replace("{FLOAT_X}", &float_x)
        .replace("{ARRAY_X}", &array_x)
        .replace("{SHIFT}", &number(grid.shift))
        .replace("{BITS}", &grid.bits.to_string())
        .replace("{FIRST}", &first.to_string())
        .replace("{POINTS}", &lines(&mut listing.checks.iter().map(|(u, e)| vec![*u, *e])))
        .replace("{TOLERANCE}", &format!("{:e}", listing.tolerance))
}
