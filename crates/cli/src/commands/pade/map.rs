//! A map of the Padé table.

use super::judgement::cut_short;
use crate::progress::Progress;
use crate::{Cell, CliError, Table};
use restitution_approximate::{Entry, Expansion, Request, ValidRange, decimal, error_bound, map};
use restitution_pade::PadeType;

/// Every approximant up to `[N/N]` with its verdict and its largest error on the range.
pub fn table(expansion: &Expansion, request: &Request) -> Result<Table, CliError> {
    let mut table = Table::new(&["L", "M", "type", "contact", "poles", "zeros", "trend", "values", "error"])
        .titled(format!("Padé table of eps in {} up to {}", expansion.variable().name(), request.asked));
    let valid = ValidRange::new(expansion, &request.range)?;
    let PadeType { numerator, denominator } = request.asked;
    let progress = Progress::steps("approximants", ((numerator + 1) * (denominator + 1)) as u64);
    let entries = map(expansion, request, || progress.advance(1))?;
    drop(progress);
    entries.iter().for_each(|entry| table.push(row(entry)));
    let (low, high) = (decimal(&valid.range.0), decimal(&valid.range.1));
    table.note(format!("type: exact type in lowest terms; contact: order of contact; poles, zeros: on [0, inf); error: largest relative error seen for {low} <= u <= {high}, empty if a pole lies there"));
    cut_short(&valid).into_iter().for_each(|cut| table.note(cut));
    Ok(table)
}

fn row(entry: &Entry) -> Vec<Cell> {
    let rest =
        entry.found.as_ref().map_or([vec!["undecided".into()], vec![Cell::Empty; 6]].concat(), |found| {
            let (approximant, verdict) = (&found.approximant, &found.verdict);
            vec![
                Cell::text(approximant.exact_type()),
                approximant.contact().order().into(),
                verdict.poles.into(),
                verdict.zeros.map_or("everywhere".into(), Cell::from),
                Cell::text(verdict.trend),
                Cell::text(verdict.bounds),
                found.worst.as_ref().map_or(Cell::Empty, |worst| Cell::Digits(error_bound(&worst.error))),
            ]
        });
    [vec![entry.asked.numerator.into(), entry.asked.denominator.into()], rest].concat()
}
