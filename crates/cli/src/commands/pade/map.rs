//! A map of the Padé table.

use super::judgement::range_with_values;
use crate::progress::Progress;
use crate::{Cell, CliError, Table};
use restitution_approximate::{
    ApproximateError, Expansion, Request, decimal, error_bound, error_on_range, first_bits, nearest,
};
use restitution_pade::{Approximant, Interval, PadeError, PadeType, Verdict, verdict, with_precision};
use restitution_real::{Ball, Balls};
use std::collections::HashMap;

/// How often the precision may double for one entry.
const ATTEMPTS: u32 = 8;

/// Every approximant up to `[N/N]` with its verdict and its largest error on the range.
pub fn table(expansion: &Expansion, request: &Request) -> Result<Table, CliError> {
    let side = request.asked.numerator;
    let (range, cut) = range_with_values(expansion, &request.range)?;
    let request = &Request { range, ..request.clone() };
    let mut table = Table::new(&["L", "M", "type", "contact", "poles", "zeros", "trend", "values", "error"])
        .titled(format!("Padé table of eps in {} up to {}", expansion.variable().name(), request.asked));
    let progress = Progress::steps("approximants", ((side + 1) * (side + 1)) as u64);
    let mut series = HashMap::new();
    for numerator in 0..=side {
        for denominator in 0..=side {
            let asked = PadeType::new(numerator, denominator);
            table.push(row(expansion, request, asked, &mut series)?);
            progress.advance(1);
        }
    }
    let (low, high) = (decimal(&request.range.0), decimal(&request.range.1));
    table.note(format!("type: exact type in lowest terms; contact: order of contact; poles, zeros: on [0, inf); error: largest relative error seen for {low} <= u <= {high}, empty if a pole lies there"));
    cut.into_iter().for_each(|cut| table.note(cut));
    Ok(table)
}

fn row(
    expansion: &Expansion,
    request: &Request,
    asked: PadeType,
    series: &mut HashMap<u32, Vec<Ball>>,
) -> Result<Vec<Cell>, CliError> {
    let head = |cells: Vec<Cell>| [vec![asked.numerator.into(), asked.denominator.into()], cells].concat();
    let (entry, verdict) = match find(expansion, request, asked, series) {
        Ok(found) => found?,
        Err(PadeError::PrecisionExhausted { .. }) => {
            return Ok(head([vec!["undecided".into()], vec![Cell::Empty; 6]].concat()));
        }
        Err(error) => return Err(error.into()),
    };
    let error = match error_on_range(expansion, &entry, &request.range) {
        Ok(worst) if verdict.poles == 0 => Cell::Digits(error_bound(&worst.error)),
        _ => Cell::Empty,
    };
    Ok(head(vec![
        Cell::text(entry.exact_type()),
        entry.contact().order().into(),
        verdict.poles.into(),
        verdict.zeros.map_or("everywhere".into(), Cell::from),
        Cell::text(verdict.trend),
        Cell::text(verdict.bounds),
        error,
    ]))
}

type Found = (Approximant<Balls>, Verdict);

/// One entry; the outer error is about the approximant, the inner one about its coefficients.
fn find(
    expansion: &Expansion,
    request: &Request,
    asked: PadeType,
    series: &mut HashMap<u32, Vec<Ball>>,
) -> Result<Result<Found, ApproximateError>, PadeError> {
    let first = first_bits(request.asked, 20);
    with_precision(first, first * ATTEMPTS, |bits| {
        let known = match series.get(&bits) {
            Some(known) => known,
            None => match expansion.coefficients(request.asked.conditions() + 1, bits) {
                Ok(known) => series.entry(bits).or_insert(known),
                Err(error) => return Ok(Ok(Err(error))),
            },
        };
        let found = match nearest(expansion, known, asked, bits) {
            Ok(found) => found,
            Err(error) => return Ok(Ok(Err(error))),
        };
        Ok(found.and_then(|entry| verdict(&entry, &Interval::HalfLine).map(|verdict| Ok((entry, verdict)))))
    })
}
