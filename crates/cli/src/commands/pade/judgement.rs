//! One approximant and everything that is said about it.

use super::expansion::Expansion;
use crate::{Cell, CliError, Table};
use num_rational::BigRational;
use num_traits::ToPrimitive;
use restitution_pade::{
    Approximant, Interval, PadeError, PadeType, RationalFunction, Reach, Verdict, WorstError, approximant,
    grid, largest_error, largest_reach, places, two_point, verdict, with_precision,
};
use restitution_real::{Ball, Balls, OrderedField};
use rug::Float;
use rug::float::Round;

/// Intervals of the grid on which errors are looked for.
pub const GRID: u32 = 40;
/// Largest damping up to which an error level is followed.
const FARTHEST: i64 = 20;
/// Precision above which no further attempt is made, in multiples of the first.
const ATTEMPTS: u32 = 32;

/// What is asked about an approximant.
#[derive(Clone, Debug)]
pub struct Request {
    /// The degrees.
    pub asked: PadeType,
    /// How many conditions it meets at infinity.
    pub at_infinity: usize,
    /// Digits of its constants.
    pub digits: usize,
    /// The range of `u` on which its error is looked for.
    pub range: (BigRational, BigRational),
    /// The relative error whose reach is wanted.
    pub level: BigRational,
}

/// An approximant with its verdict.
#[derive(Debug)]
pub struct Judged {
    /// The approximant.
    pub approximant: Approximant<Balls>,
    /// Its verdict on the half-line.
    pub verdict: Verdict,
    /// The places of its poles and of its zeros there, with proved digits.
    pub places: [Vec<String>; 2],
}

/// The most digits of a place.
const PLACE_DIGITS: usize = 10;

/// The places of the zeros of a polynomial on the half-line, with proved digits.
///
/// # Errors
///
/// [`PadeError::Undecided`].
pub fn shown_places<F: OrderedField>(
    field: &F,
    p: &[F::Number],
    digits: usize,
) -> Result<Vec<String>, PadeError> {
    const GUARD: usize = 10;
    let digits = digits.min(PLACE_DIGITS);
    let bits = u32::try_from(4 * (digits + GUARD)).unwrap_or(u32::MAX);
    let text = |(low, high): (BigRational, BigRational)| {
        let ball = if low == high {
            Ball::from_rational(&low, bits)
        } else {
            let ends = [&low, &high].map(|end| Ball::from_rational(end, 2 * bits));
            Ball::between(&ends[0].lower(), &ends[1].upper(), 2 * bits)
        };
        let fewer = (1..digits).rev().find_map(|digits| ball.to_digits(digits));
        shown(&ball, digits).or(fewer).ok_or(PadeError::Undecided { what: "the place of a zero" })
    };
    places(field, p, digits + GUARD)?.into_iter().map(text).collect()
}

/// Bits to begin with: the digits wanted and what the elimination is likely to lose.
pub fn first_bits(asked: PadeType, digits: usize) -> u32 {
    let degree = asked.numerator.saturating_add(asked.denominator);
    u32::try_from(64 + digits.saturating_mul(10) / 3 + degree.saturating_mul(10)).unwrap_or(u32::MAX / 64)
}

/// Finds the approximant and its verdict, with all digits of its constants proved.
///
/// # Errors
///
/// What the expansion says; [`PadeError`] as a usage error or a failure.
pub fn judge(expansion: &Expansion, request: &Request) -> Result<Judged, CliError> {
    let count = request.asked.conditions() - request.at_infinity.min(request.asked.conditions() - 1) + 2;
    let first = first_bits(request.asked, request.digits);
    with_precision(first, first.saturating_mul(ATTEMPTS), |bits| {
        let series = expansion.coefficients(count, bits)?;
        let found = if request.at_infinity > 0 {
            let infinity = expansion.at_infinity(request.at_infinity, bits)?;
            two_point(&Balls::new(bits), &series, request.asked, &infinity)
        } else {
            nearest(expansion, &series, request.asked, bits)?
        };
        Ok(found.and_then(|approximant| {
            constants(approximant.function(), request.digits)?;
            let verdict = verdict(&approximant, &Interval::HalfLine)?;
            let function = approximant.function();
            let place = |p: &[Ball]| shown_places(function.field(), p, request.digits);
            let places = [place(function.den())?, place(function.num())?];
            Ok(Judged { approximant, verdict, places })
        }))
    })
}

/// The approximant with contact at 0 alone, by the reciprocal series where that knows more.
///
/// # Errors
///
/// Those of [`Expansion::reciprocal`]; the inner ones are those of [`approximant`].
pub fn nearest(
    expansion: &Expansion,
    series: &[Ball],
    asked: PadeType,
    bits: u32,
) -> Result<Result<Approximant<Balls>, PadeError>, CliError> {
    let field = Balls::new(bits);
    let turned = PadeType::new(asked.denominator, asked.numerator);
    Ok(match expansion.reciprocal(series, bits)? {
        Some(reciprocal) => approximant(&field, &reciprocal, turned).and_then(|found| found.reciprocal()),
        None => approximant(&field, series, asked),
    })
}

/// A constant in decimals: part, index, digits.
pub type Constant = (&'static str, usize, String);

/// The constants of an approximant.
///
/// # Errors
///
/// [`PadeError::Undecided`] if a ball does not prove the digits.
pub fn constants(function: &RationalFunction<Balls>, digits: usize) -> Result<Vec<Constant>, PadeError> {
    let parts = [("num", function.num()), ("den", function.den())];
    let all = parts.into_iter().flat_map(|(part, p)| p.iter().enumerate().map(move |(k, c)| (part, k, c)));
    let undecided = PadeError::Undecided { what: "the last digit of a constant" };
    all.map(|(part, k, c)| Ok((part, k, shown(c, digits).ok_or(undecided.clone())?))).collect()
}

/// The value in decimals, `None` if its digits are not proved; an exact integer has no tail of zeros.
pub fn shown(value: &Ball, digits: usize) -> Option<String> {
    match value.mid().to_integer() {
        Some(n) if value.is_exact() && value.mid().is_integer() => Some(n.to_string()),
        _ => value.to_digits(digits),
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

/// The largest relative error on the range of the request.
pub fn error_on_range(
    expansion: &Expansion,
    approximant: &Approximant<Balls>,
    range: &(BigRational, BigRational),
) -> Result<WorstError, CliError> {
    let points = grid(&range.0, &range.1, GRID)?;
    largest_error(approximant.function(), &points, |u| expansion.sample(u))
}

/// How far the error stays at or below the level.
fn reach(
    expansion: &Expansion,
    judged: &Judged,
    level: &BigRational,
    farthest: &BigRational,
) -> Result<Reach, CliError> {
    let points = grid(&BigRational::from_integer(0.into()), farthest, 2 * GRID)?;
    largest_reach(judged.approximant.function(), &points, level, |u| expansion.sample(u))
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
    let reach = match reach(expansion, judged, &request.level, &farthest)? {
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

/// An upper bound with two digits.
pub fn error_bound(error: &Ball) -> String {
    let up: Float = error.upper();
    up.to_string_radix_round(10, Some(2), Round::Up)
}

/// A level such as `1e-3` as it is usually written.
pub fn error_text(level: &BigRational) -> String {
    format!("{:e}", level.to_f64().unwrap_or(f64::NAN))
}

/// A point of a grid to four digits, rounded down.
pub fn decimal(value: &BigRational) -> String {
    let near = Float::with_val(64, value.to_f64().unwrap_or(f64::NAN));
    let text = near.to_string_radix_round(10, Some(4), Round::Down);
    text.parse::<f64>().map_or(text, |x| x.to_string())
}
