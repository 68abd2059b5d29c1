//! The tables of a fit.

use crate::{Cell, CliError, Table};
use restitution::End;
use restitution_fit::{
    Adequacy, Data, Departure, FALSE_ALARMS, Fit, Law, LawFit, Stiffness, TABLES_PER_FALSE_ALARM,
};

/// How many lines of a table are named in a note.
const NAMED_LINES: usize = 5;

/// The characteristic velocity and whether it means anything.
pub(super) fn summary(data: &Data, fit: &Fit, verdict: &Adequacy, laws: &[LawFit]) -> Table {
    let mut table = Table::new(&["quantity", "symbol", "value", "unit"]);
    let mut add = |quantity: &str, symbol: &str, value: Cell, unit: &str| {
        table.push(vec![quantity.into(), symbol.into(), value, unit.into()]);
    };
    let (low, high) = fit.interval;
    let significant = |value| Cell::uncertain(value, fit.log_error);
    add("characteristic velocity", "g*", significant(fit.characteristic_velocity), &data.unit);
    add("lower end, 95 % confidence", "g*_low", significant(low), &data.unit);
    add("upper end, 95 % confidence", "g*_high", significant(high), &data.unit);
    add("standard error of ln g*", "s_ln", Cell::rounded(fit.log_error, 3), "");
    add("scatter of epsilon", "s", Cell::rounded(fit.scatter, 3), "");
    add("largest residual of epsilon", "r", Cell::rounded(fit.largest_residual, 3), "");
    add("line of the largest residual", "", line(data, fit.largest_residual_row), "");
    add("rows", "n", fit.rows.into(), "");
    add("rows that count less", "", fit.outliers.into(), "");
    add("chance of such a misfit", "p", verdict.p().map_or(Cell::Empty, |p| Cell::rounded(p, 2)), "");
    for remark in &data.remarks {
        table.note(remark);
    }
    judge(&mut table, fit, verdict, laws);
    note_above_one(&mut table, data);
    table
}

/// Adds what the durations of the contacts say.
pub(super) fn add_stiffness(table: &mut Table, found: &Stiffness) {
    let mut add = |quantity: &str, symbol: &str, value: Cell, unit: &str| {
        table.push(vec![quantity.into(), symbol.into(), value, unit.into()]);
    };
    let (stiff, damped) = (found.per_mass_interval, found.dissipative_interval);
    let (stiff_error, damped_error) = (found.per_mass_error(), found.dissipative_error());
    let rate = "m^(-1/2) s^(-2)";
    add("stiffness over mass", "rho/m_eff", Cell::uncertain(found.per_mass, stiff_error), rate);
    add("lower end, 95 % confidence", "", Cell::uncertain(stiff.0, stiff_error), rate);
    add("upper end, 95 % confidence", "", Cell::uncertain(stiff.1, stiff_error), rate);
    add("dissipative constant", "A", Cell::uncertain(found.dissipative_constant, damped_error), "s");
    add("lower end, 95 % confidence", "A_low", Cell::uncertain(damped.0, damped_error), "s");
    add("upper end, 95 % confidence", "A_high", Cell::uncertain(damped.1, damped_error), "s");
    add("relative scatter of durations", "s_t", Cell::rounded(found.scatter, 3), "");
    if found.beyond > 0 {
        table
            .note(format!("{} durations beyond u = 20, up to which they are known, left out.", found.beyond));
    }
}

/// Adds what follows for bodies of known effective radius (m) and mass (kg).
pub(super) fn add_bodies(
    table: &mut Table,
    found: &Stiffness,
    (radius, mass): (f64, f64),
) -> Result<(), CliError> {
    let contact = found.contact(radius, mass).map_err(CliError::usage)?;
    let mut add = |quantity: &str, symbol: &str, value: f64, unit: &str| {
        let value = Cell::uncertain(value, found.per_mass_error());
        table.push(vec![quantity.into(), symbol.into(), value, unit.into()]);
    };
    add("force prefactor", "rho", contact.force_prefactor(), "N/m^(3/2)");
    add("effective modulus", "E", contact.effective_modulus(), "Pa");
    Ok(())
}

/// What was fitted, for a remark.
pub(super) fn in_a_line(data: &Data, fit: &Fit, verdict: &Adequacy) -> String {
    let significant = |value| Cell::uncertain(value, fit.log_error).plain();
    let (low, high) = fit.interval;
    let doubt = match (verdict.rises(), verdict.is_doubtful()) {
        (true, _) => "; but epsilon rises with the velocity, which no viscoelastic body does",
        (_, true) => "; but the data do not follow the curve of a viscoelastic collision",
        _ => "",
    };
    format!(
        "fitted to {} rows: g* = {} {unit}, 95 % confidence {} to {} {unit}{doubt}",
        fit.rows,
        significant(fit.characteristic_velocity),
        significant(low),
        significant(high),
        unit = data.unit
    )
}

/// Says in plain sentences what the tests and the comparison found.
fn judge(table: &mut Table, fit: &Fit, verdict: &Adequacy, laws: &[LawFit]) {
    if verdict.rises() {
        table.note("epsilon rises with the velocity, while that of a viscoelastic body falls: no g* describes these data.");
    } else if verdict.is_doubtful() {
        table.note(format!(
            "The data do not follow the curve of a viscoelastic collision (p {}; sound data give p < {FALSE_ALARMS} once in {:.0} tables): g* is less certain than its interval says.",
            chance(verdict.p().unwrap_or(0.0)),
            TABLES_PER_FALSE_ALARM,
        ));
    } else if verdict.tests.is_empty() && fit.rows < 3 {
        table.note("Two rows leave nothing to test the law with.");
    }
    let own = laws.iter().find(|other| other.law == Law::Viscoelastic(fit.end));
    if let (Some(best), Some(own)) = (laws.first(), own)
        && let Some(difference) = own.behind(best).filter(|difference| *difference > LawFit::CLEARLY)
    {
        table.note(format!(
            "{} fits better (AICc lower by {difference:.1}); see --table laws.",
            capital(&name(best.law))
        ));
    }
}

fn note_above_one(table: &mut Table, data: &Data) {
    let above = data.rows.iter().zip(&data.lines).filter(|(row, _)| row.epsilon() > 1.0);
    let mut lines = above.map(|(_, line)| line.to_string()).collect::<Vec<_>>();
    if lines.is_empty() {
        return;
    }
    let more = lines.len().saturating_sub(NAMED_LINES);
    lines.truncate(NAMED_LINES);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    table.note(format!("Coefficients above 1, kept as noise: line {}{more}.", lines.join(", ")));
}

/// Every row beside its fitted value.
pub(super) fn residuals(data: &Data, fit: &Fit) -> Table {
    let mut table = Table::new(&["line", "velocity", "epsilon", "fitted", "residual"]);
    let curve = fit.curve();
    for (row, line) in data.rows.iter().zip(&data.lines) {
        let fitted = curve.epsilon(row.velocity());
        let cells = [row.velocity(), row.epsilon(), fitted, row.residual(&curve)];
        table.push(
            [Cell::from(*line as usize)]
                .into_iter()
                .chain(cells.map(|value| Cell::rounded(value, 10)))
                .collect(),
        );
    }
    table.note(format!("Velocities in {}.", data.unit));
    table
}

/// The laws, best first.
pub(super) fn laws(data: &Data, fits: &[LawFit]) -> Table {
    let mut table =
        Table::new(&["law", "formula", "parameter", "value", "unit", "q", "residual", "AICc", "difference"]);
    for fit in fits {
        let (formula, parameter, unit) = match fit.law {
            Law::Viscoelastic(_) => ("exact", "g*", data.unit.as_str()),
            Law::Printed35 => ("eq. 35, Table I", "g*", data.unit.as_str()),
            Law::Constant => ("c", "c", ""),
            Law::Plastic => ("(g/c)^(-1/4)", "c", data.unit.as_str()),
            Law::Power => ("c g^(-q)", "c", ""),
        };
        let criterion = |value: Option<f64>| value.map_or(Cell::Empty, |value| Cell::decimals(value, 2));
        table.push(vec![
            Cell::text(name(fit.law)),
            formula.into(),
            parameter.into(),
            Cell::rounded(fit.scale, 4),
            unit.into(),
            fit.exponent.map_or(Cell::Empty, |q| Cell::rounded(q, 4)),
            Cell::rounded(fit.residual, 3),
            criterion(fit.criterion),
            criterion(fits.first().and_then(|best| fit.behind(best))),
        ]);
    }
    for remark in &data.remarks {
        table.note(remark);
    }
    if data.unit != "m/s" {
        table.note(format!("g in {}.", data.unit));
    }
    table.note("Best first, by Akaike's criterion for few rows; a difference below 2 says little, one above 10 a lot.");
    table
}

/// The tests, one by one.
pub(super) fn tests(verdict: &Adequacy, fit: &Fit) -> Table {
    let mut table = Table::new(&["departure", "test", "statistic", "degrees", "p"]);
    for test in &verdict.tests {
        let (departure, kind) = match test.departure {
            Departure::Smooth => ("smooth", "F"),
            Departure::Rise => ("rising", "t"),
            Departure::LackOfFit => ("beyond the repetitions", "F"),
            Departure::Sigma => ("beyond sigma", "chi-square"),
        };
        let degrees = match test.degrees {
            (one, 0) => one.to_string(),
            (one, other) => format!("{one}, {other}"),
        };
        table.push(vec![
            departure.into(),
            kind.into(),
            Cell::rounded(test.statistic, 4),
            Cell::Text(degrees),
            Cell::rounded(test.p, 3),
        ]);
    }
    match verdict.p() {
        Some(p) => table.note(format!(
            "Together p {}: {}; sound data are called unsound once in {:.0} tables at most.",
            chance(p),
            if verdict.is_doubtful() {
                "the law does not follow the data"
            } else {
                "nothing speaks against the law"
            },
            TABLES_PER_FALSE_ALARM,
        )),
        None if fit.rows < 3 => table.note("Two rows leave nothing to test the law with."),
        None => table.note("The curve passes through every row."),
    }
    table
}

fn name(law: Law) -> String {
    match law {
        Law::Viscoelastic(End::ZeroCompression) => "viscoelastic, to zero compression".to_owned(),
        Law::Viscoelastic(End::ZeroForce) => "viscoelastic, to zero force".to_owned(),
        Law::Printed35 => "viscoelastic, as printed".to_owned(),
        Law::Constant => "constant".to_owned(),
        Law::Plastic => "plastic".to_owned(),
        Law::Power => "power".to_owned(),
    }
}

fn capital(name: &str) -> String {
    let mut letters = name.chars();
    let law = if name.contains(',') { "" } else { " law" };
    letters.next().map_or(String::new(), |first| format!("{}{}{law}", first.to_uppercase(), letters.as_str()))
}

/// `= 0.012`, or `< 1e-9`, beyond which no noise is normal.
fn chance(p: f64) -> String {
    if p < 1e-9 { "< 1e-9".to_owned() } else { format!("= {}", Cell::rounded(p, 2).plain()) }
}

fn line(data: &Data, row: usize) -> Cell {
    data.lines.get(row).map_or(Cell::Empty, |line| (*line as usize).into())
}
