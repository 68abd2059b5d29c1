//! Padé approximants and closed forms, as text for Python's classes.

use crate::errors::value;
use crate::theory::{Certified, certified, law};
use crate::work::{self, Watch};
use num_traits::One;
use pyo3::prelude::*;
use restitution_closed::{Family, Language, Reduction, closed_form as closed};
use restitution_law::ForceLaw;
use restitution_pade::{PadeError, PadeType, approximant};
use restitution_real::{Ball, Balls};
use restitution_series::{Quantity, coefficients_watched};

/// How often the digits of the series are doubled before an approximant is given up.
const ATTEMPTS: usize = 6;

/// Numerator and denominator of the `[L/M]` approximant of epsilon in `s`, `u` or `sqrt-u`.
#[pyfunction]
pub fn pade(
    py: Python<'_>,
    numerator: usize,
    denominator: usize,
    variable: &str,
    digits: usize,
    law: &str,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<(Vec<Certified>, Vec<Certified>)> {
    let family = match variable {
        "u" => Quantity::Restitution,
        "s" => Quantity::ScaledRestitution,
        "sqrt-u" => Quantity::DelayedRecovery,
        _ => return Err(value(format!("'{variable}' is no variable: give 's', 'u' or 'sqrt-u'"))),
    };
    let law = self::law(law)?;
    let asked = PadeType::new(numerator, denominator);
    work::run(py, Some(order(asked)), progress, move |watch| constants(family, asked, digits, &law, watch))?
}

/// The order of the series that an approximant takes.
fn order(asked: PadeType) -> usize {
    asked.numerator.saturating_add(asked.denominator).max(1)
}

type Quotient = (Vec<Certified>, Vec<Certified>);

/// Raises the digits of the series until those of the constants are proved.
fn constants(
    family: Quantity,
    asked: PadeType,
    digits: usize,
    law: &ForceLaw,
    watch: &Watch,
) -> PyResult<Quotient> {
    let order = order(asked);
    let mut known = digits + 10 + 2 * order;
    for _ in 0..ATTEMPTS {
        let series = series(family, order, known, law, watch)?;
        let field = Balls::new(u32::try_from(known * 4 + 64).unwrap_or(u32::MAX / 2));
        match approximant(&field, &series, asked) {
            Ok(found) => {
                let shown = |part: &[Ball]| {
                    part.iter().map(|ball| ball.to_digits_and_radius(digits)).collect::<Option<Vec<_>>>()
                };
                if let (Some(num), Some(den)) = (shown(found.num()), shown(found.den())) {
                    return Ok((num, den));
                }
            }
            Err(PadeError::Undecided { .. }) => {}
            Err(error) => return Err(value(error)),
        }
        known *= 2;
    }
    Err(value(format!(
        "the constants of {asked} could not be proved to {digits} digits: ask for fewer, or for another type"
    )))
}

/// The series in the variable, with what is known exactly exact.
fn series(
    family: Quantity,
    order: usize,
    digits: usize,
    law: &ForceLaw,
    watch: &Watch,
) -> PyResult<Vec<Ball>> {
    let watched = coefficients_watched(family, law, order, digits, &mut |k| watch.set(k));
    let mut values = watched.map_err(value)?;
    values.truncate(order + 1);
    values[0] = Ball::one();
    if family == Quantity::ScaledRestitution {
        values[1] = Ball::one();
        values = values.into_iter().enumerate().map(|(k, a)| if k % 2 == 1 { -a } else { a }).collect();
    }
    Ok(values)
}

/// `(text, latex, mpmath, sympy, value)` of a closed form.
#[pyfunction]
pub fn closed_form(
    py: Python<'_>,
    quantity: &str,
    order: usize,
    digits: usize,
    law: &str,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<(String, String, String, String, Certified)> {
    let family = match quantity {
        "C" => Family::Restitution,
        "a" => Family::Scaled,
        "h" => Family::DelayedRecovery,
        _ => return Err(value(format!("'{quantity}' has no closed form here: give 'C', 'a' or 'h'"))),
    };
    let law = self::law(law)?;
    work::run(py, None, progress, move |_| {
        let form = closed(family, &law, order, Reduction::Special).map_err(value)?;
        let [text, latex, python, sympy] =
            [Language::Text, Language::Latex, Language::Python, Language::Sympy]
                .map(|way| form.expression(way));
        let digits = certified(&form.value(digits).map_err(value)?, digits)?;
        Ok((text, latex, python, sympy, digits))
    })?
}
