//! Approximants of a series from a file.

use super::Form;
use super::judgement::say;
use crate::exact::Exact;
use crate::{Cell, CliError, Table, input};
use restitution_approximate::{judge_series, rational_digits};
use restitution_pade::{Contact, PadeType};
use std::path::Path;

/// The largest file that is read, in bytes.
const LARGEST_FILE: u64 = 4_000_000;

/// The approximant of the series in a file, in the variable x.
pub fn table(path: &Path, asked: PadeType, form: Form, digits: usize) -> Result<Table, CliError> {
    let name = path.display();
    let series = read(path)?;
    let needed = asked.conditions();
    if series.len() < needed {
        return Err(CliError::usage(format!(
            "'{name}' has {} coefficients, and {asked} needs {needed}: give more of them, or smaller degrees",
            series.len()
        )));
    }
    let series = series.iter().map(|number| number.value().clone()).collect::<Vec<_>>();
    let judged = judge_series(&series, asked, digits)?;
    let found = &judged.approximant;
    let shown = |value: &_| Cell::Digits(rational_digits(value, digits));
    let mut table = match form {
        Form::Quotient => {
            let mut table = Table::new(&["part", "k", "value", "decimal"]);
            for (part, p) in [("num", found.num()), ("den", found.den())] {
                for (k, value) in p.iter().enumerate() {
                    table.push(vec![part.into(), k.into(), Cell::digits(value), shown(value)]);
                }
            }
            table
        }
        Form::ContinuedFraction => {
            let fraction = found.continued_fraction()?;
            let mut table = Table::new(&["link", "power", "value", "decimal"]);
            let links = fraction.links.iter().map(|link| (link.power, &link.coefficient));
            for (k, (power, value)) in std::iter::once((0, &fraction.constant)).chain(links).enumerate() {
                table.push(vec![k.into(), power.into(), Cell::digits(value), shown(value)]);
            }
            table
        }
    }
    .titled(format!("{asked} Padé approximant in x of the {} coefficients in {name}", series.len()));
    table.said("exact_type", "exact type", Cell::text(found.exact_type()));
    let contact = match found.contact() {
        Contact::Exactly(order) => order.to_string(),
        Contact::AtLeast(order) => format!("{order} or more"),
    };
    table.said("contact_order", "order of contact at 0", Cell::Text(contact));
    say(&mut table, &judged.verdict, &judged.places, "x");
    Ok(table)
}

/// Reads coefficients, constant term first, separated by blanks, commas, semicolons or lines; `#` begins a comment.
fn read(path: &Path) -> Result<Vec<Exact>, CliError> {
    let name = path.display();
    let bytes = input::read(path, LARGEST_FILE, "give a series of coefficients")?;
    let text = String::from_utf8(bytes).map_err(|_| {
        CliError::usage(format!("'{name}' is not text: give numbers such as 1, -0.25 or 3/7"))
    })?;
    let mut series = Vec::new();
    for (line, content) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let content = content.split('#').next().unwrap_or_default();
        let words = content.split(|c: char| c.is_whitespace() || c == ',' || c == ';');
        for word in words.filter(|word| !word.is_empty()) {
            let number: Exact = word
                .parse()
                .map_err(|error| CliError::usage(format!("'{name}' line {}: {error}", line + 1)))?;
            series.push(number);
        }
    }
    if series.is_empty() {
        return Err(CliError::usage(format!(
            "'{name}' has no coefficient: give numbers such as 1, -0.25 or 3/7, the constant term first"
        )));
    }
    Ok(series)
}
