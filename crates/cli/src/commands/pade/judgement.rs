//! What is said about an approximant.

use crate::{Cell, CliError, Table};
use restitution_approximate::{
    ApproximateError, Expansion, FARTHEST, Judged, Request, ValidRange, decimal, error_bound, error_text,
    quality,
};
use restitution_pade::{PadeError, Reach, Verdict};

impl From<ApproximateError> for CliError {
    fn from(error: ApproximateError) -> Self {
        if error.is_request_at_fault() { Self::usage(error) } else { Self::failure(error) }
    }
}

impl From<PadeError> for CliError {
    fn from(error: PadeError) -> Self {
        match error {
            PadeError::Undecided { .. } | PadeError::PrecisionExhausted { .. } => Self::failure(error),
            _ => Self::usage(error),
        }
    }
}

/// Says where a range was cut short, if it was.
pub fn cut_short(valid: &ValidRange) -> Option<String> {
    let end = decimal(&valid.range.1);
    valid.is_cut.then(|| format!("critical damping lies a little beyond u = {end}: from there on the bodies never separate, so errors are looked for up to {end}"))
}

/// Writes poles, zeros, trend and values of an approximant in `variable`.
pub fn say(table: &mut Table, verdict: &Verdict, [poles, zeros]: &[Vec<String>; 2], variable: &str) {
    let number = verdict.zeros.map_or("everywhere".into(), Cell::from);
    table.said("poles", "real poles on [0, inf)", verdict.poles.into());
    if !poles.is_empty() {
        table.said("pole_places", &format!("poles at {variable}"), Cell::Text(poles.join(", ")));
    }
    table.said("zeros", "real zeros on [0, inf)", number);
    if !zeros.is_empty() {
        table.said("zero_places", &format!("zeros at {variable}"), Cell::Text(zeros.join(", ")));
    }
    table.said("trend", "trend", Cell::text(verdict.trend));
    table.said("bounds", "values", Cell::text(verdict.bounds));
}

/// Writes the verdict below the table and into the fields of its JSON form.
///
/// # Errors
///
/// Those of the certified values.
pub fn report(
    table: &mut Table,
    expansion: &Expansion,
    request: &Request,
    judged: &Judged,
) -> Result<(), CliError> {
    let (entry, verdict) = (&judged.approximant, &judged.verdict);
    table.said("exact_type", "exact type", Cell::text(entry.exact_type()));
    table.said("contact_order", "order of contact at 0", entry.contact().order().into());
    if request.at_infinity > 0 {
        table.said("met_at_infinity", "conditions met at infinity", entry.met_at_infinity().into());
    }
    say(table, verdict, &judged.places, expansion.variable().name());
    let quality = quality(expansion, entry, request)?;
    let (low, high) = (decimal(&quality.range.range.0), decimal(&quality.range.range.1));
    let label = format!("largest relative error seen for {low} <= u <= {high}");
    table.said("largest_error", &label, Cell::digits(error_bound(&quality.worst.error)));
    table.said("largest_error_at", "seen at u", Cell::digits(decimal(&quality.worst.at)));
    let reach = match quality.reach {
        Reach::Everywhere if quality.followed.is_cut => decimal(&quality.followed.range.1),
        Reach::Everywhere => format!("{FARTHEST} or more"),
        Reach::UpTo(u) => decimal(&u),
    };
    let label = format!("relative error at most {} up to u", error_text(&request.level));
    table.said("error_reach", &label, Cell::digits(reach));
    cut_short(&quality.range).into_iter().for_each(|cut| table.note(cut));
    Ok(())
}
