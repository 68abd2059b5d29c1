//! What is said about an approximant.

use crate::{Cell, CliError, Table};
use num_rational::BigRational;
use restitution_approximate::{
    ApproximateError, Expansion, Judged, Request, decimal, error_bound, error_on_range, error_reach,
    error_text,
};
use restitution_pade::{PadeError, Reach, Verdict};

/// Largest damping up to which an error level is followed.
const FARTHEST: i64 = 20;

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

/// The range of the request as far as there are values, with a note where it is cut short.
///
/// # Errors
///
/// Usage if the whole range lies beyond the critical damping.
pub fn range_with_values(
    expansion: &Expansion,
    (low, high): &(BigRational, BigRational),
) -> Result<((BigRational, BigRational), Option<String>), CliError> {
    let end = expansion.reach(high)?;
    if end == *high {
        return Ok(((low.clone(), end), None));
    }
    let shown = decimal(&end);
    if end <= *low {
        return Err(CliError::usage(format!(
            "beyond u = {shown} the bodies never separate and there is no value to compare with: give --range with a smaller end"
        )));
    }
    let note = format!(
        "critical damping lies a little beyond u = {shown}: from there on the bodies never separate, so errors are looked for up to {shown}"
    );
    Ok(((low.clone(), end), Some(note)))
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
    let (range, cut) = range_with_values(expansion, &request.range)?;
    let worst = error_on_range(expansion, entry, &range)?;
    let (low, high) = (decimal(&range.0), decimal(&range.1));
    let label = format!("largest relative error seen for {low} <= u <= {high}");
    table.said("largest_error", &label, Cell::digits(error_bound(&worst.error)));
    table.said("largest_error_at", "seen at u", Cell::digits(decimal(&worst.at)));
    let farthest = expansion.reach(&BigRational::from_integer(FARTHEST.into()))?;
    let reach = match error_reach(expansion, entry, &request.level, &farthest)? {
        Reach::Everywhere if cut.is_some() => decimal(&farthest),
        Reach::Everywhere => format!("{FARTHEST} or more"),
        Reach::UpTo(u) => decimal(&u),
    };
    let label = format!("relative error at most {} up to u", error_text(&request.level));
    table.said("error_reach", &label, Cell::digits(reach));
    if let Some(cut) = cut {
        table.note(cut);
    }
    Ok(())
}
