//! The table of recommended approximants.

use crate::progress::Progress;
use crate::{Cell, CliError, Table};
use restitution_approximate::{Candidate, Goal, KNOWN, ONE_POINT_COST, TWO_POINT_COST, WIDEST};
use restitution_approximate::{decimal, error_bound, error_text, recommended};
use restitution_direct::End;

/// The table of recommended approximants for both ends of contact.
pub fn table() -> Result<Table, CliError> {
    let columns = ["end", "u", "error", "L", "M", "at_infinity", "cost", "largest_error", "seen_at"];
    let mut table = Table::new(&columns).titled("Recommended approximants of eps for viscoelastic spheres");
    let progress = Progress::steps("costs", (ONE_POINT_COST + TWO_POINT_COST) as u64);
    for (end, name) in [(End::ZeroCompression, "zero-compression"), (End::ZeroForce, "zero-force")] {
        let goals = recommended(end, || progress.advance(1))?;
        goals.iter().for_each(|goal| table.push(row(name, goal)));
    }
    for note in notes() {
        table.note(note);
    }
    Ok(table)
}

fn notes() -> [String; 4] {
    [
        "L, M: degrees in u, or in sqrt(u) where the contact ends at zero force; at_infinity: conditions met at infinity (restitution pade L M --at-infinity=K)".to_owned(),
        "cost: L + M, the multiplications of one evaluation; of the cheapest the one with the smallest error; none has a pole or a value <= 0 on its range".to_owned(),
        format!("largest_error: seen on a grid of certified values, refined around the maximum, not proved between its points; searched: L <= M <= L + {WIDEST} up to cost {ONE_POINT_COST}, two-point [L/L+5] up to cost {TWO_POINT_COST}, all from at most {KNOWN} coefficients; empty: none found"),
        "with the end of contact at zero force eps falls off like u^(-5/3), which no quotient of polynomials in sqrt(u) does: none can serve all u".to_owned(),
    ]
}

fn row(end: &str, goal: &Goal) -> Vec<Cell> {
    let head = vec![end.into(), Cell::digits(goal.span.name()), Cell::digits(error_text(&goal.level))];
    let tail = goal.reached.as_ref().map_or(vec![Cell::Empty; 6], |reached| {
        let Candidate { asked, at_infinity } = reached.candidate;
        vec![
            asked.numerator.into(),
            asked.denominator.into(),
            at_infinity.into(),
            (asked.numerator + asked.denominator).into(),
            Cell::Digits(error_bound(&reached.worst.error)),
            Cell::Digits(decimal(&reached.worst.at)),
        ]
    });
    [head, tail].concat()
}
