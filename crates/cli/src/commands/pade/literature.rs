//! Published constants beside the regenerated ones.

use crate::{Cell, CliError, Table};
use restitution_approximate::published;

/// Every published approximant, as printed and regenerated to `digits` digits.
pub fn table(digits: usize) -> Result<Table, CliError> {
    let mut table = Table::new(&["work", "approximant", "part", "k", "printed", "value"])
        .titled("Published Padé constants and what they should be");
    for approximant in published(digits)? {
        let (work, what) = (approximant.work, approximant.what);
        for (part, k, value) in &approximant.constants {
            let printed = approximant.printed(part, *k).map_or(Cell::Empty, Cell::digits);
            let value = Cell::digits(value);
            table.push(vec![work.into(), what.into(), (*part).into(), (*k).into(), printed, value]);
        }
    }
    table.note("Table I is the [1/4] approximant with a_5 set to 0, fed with a_3 = 0.315119 and a_4 = 0.161167, which are wrong: right are a_3 = 0.340729..., a_4 = 0.197020...");
    table.note("the six printed digits of a_3 and a_4 leave the fourth decimal of d_1, d_2 and d_3 open: Table I as printed lies within what they allow");
    table.note("with every coefficient right, a_5 included, the [1/4] approximant in s has a zero near s = 3.31 and is negative beyond");
    Ok(table)
}
