//! What is exact and what is certified, as Python's own numbers and as text.

use crate::errors::value;
use crate::work::{self, Watch};
use num_rational::BigRational;
use pyo3::prelude::*;
use restitution_direct::{Collision, saturation_radius, saturation_speed};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{DelayedRecovery, Quantity, SeriesError, TimeOrder};

/// A value with its proved digits, and how far the true value is from them at most.
pub type Certified = (String, String);

/// The steps of work that tells its share.
const PERCENT: usize = 100;

/// The law that a text names.
pub fn law(text: &str) -> PyResult<ForceLaw> {
    text.parse().map_err(value)
}

/// The digits asked for, and their radius.
pub fn certified(ball: &Ball, digits: usize) -> PyResult<Certified> {
    let shown = ball.to_digits_and_radius(digits);
    shown.ok_or_else(|| value(format!("{digits} digits could not be proved: ask for fewer")))
}

/// `(value, radius)` of the coefficients of order 0 to `order`.
#[pyfunction]
pub fn coefficients(
    py: Python<'_>,
    quantity: &str,
    order: usize,
    digits: usize,
    law: &str,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Vec<Certified>> {
    let family = match quantity {
        "C" => Quantity::Restitution,
        "a" => Quantity::ScaledRestitution,
        "y" => Quantity::Compression,
        "h" => Quantity::DelayedRecovery,
        _ => {
            return Err(value(format!(
                "'{quantity}' is no family of coefficients: give 'C', 'a', 'y', 'h' or 'psi'"
            )));
        }
    };
    let law = self::law(law)?;
    let values = work::run(py, Some(order), progress, move |watch: &Watch| {
        restitution_closed::coefficients(family, &law, order, digits, &mut |k| watch.set(k))
    })?;
    values.map_err(value)?.iter().map(|ball| certified(ball, digits)).collect()
}

/// The exact coefficients of Psi, orders 0 to `order`.
#[pyfunction]
pub fn psi(py: Python<'_>, order: usize, law: &str) -> PyResult<Vec<BigRational>> {
    let end = DelayedRecovery::new(&self::law(law)?).map_err(value)?;
    work::run(py, None, None, move |_| end.psi(order))
}

/// `(n, exponent, coefficient)` of the trajectories up to a power of time.
#[pyfunction]
pub fn trajectory(
    py: Python<'_>,
    damping_order: usize,
    time_order: BigRational,
    law: &str,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Vec<(usize, BigRational, BigRational)>> {
    let law = self::law(law)?;
    let work = move |watch: &Watch| rows(&law, damping_order, &time_order, watch);
    work::run(py, Some(PERCENT), progress, work)?.map_err(value)
}

/// The coefficients of `x_0 .. x_N` that belong to powers of time up to `last`.
fn rows(
    law: &ForceLaw,
    damping_order: usize,
    last: &BigRational,
    watch: &Watch,
) -> Result<Vec<(usize, BigRational, BigRational)>, SeriesError> {
    let within = TimeOrder::new(law, last);
    let trajectories = within.trajectories(damping_order, &|share| {
        watch.set(PERCENT * share.numer() / share.denom());
    });
    let mut rows = Vec::new();
    for n in 0..=trajectories.damping_order() {
        for (j, coefficient) in within.coefficients(&trajectories, n)?.iter().enumerate() {
            let exponent = trajectories.exponent(n, j);
            let exponent = BigRational::new((*exponent.numer()).into(), (*exponent.denom()).into());
            rows.push((n, exponent, coefficient.clone()));
        }
    }
    Ok(rows)
}

/// `epsilon(u)` by certified integration, for the exact damping `u`.
#[pyfunction]
pub fn epsilon_digits(
    py: Python<'_>,
    u: BigRational,
    digits: usize,
    law: &str,
    end: &str,
    loss: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Certified> {
    let collision = Collision::new(&self::law(law)?, crate::errors::end(end)?).map_err(value)?;
    let ball = work::run(py, None, progress, move |_| match loss {
        true => collision.one_minus_epsilon(&u, digits),
        false => collision.epsilon(&u, digits),
    })?;
    certified(&ball.map_err(value)?, digits)
}

/// `R` and `R^(1/p)`: `lim u epsilon^p`, and the exit speed at unlimited velocity.
#[pyfunction]
pub fn saturation(py: Python<'_>, digits: usize, law: &str) -> PyResult<(Certified, Certified)> {
    let law = self::law(law)?;
    let (radius, speed) = work::run(py, None, None, move |_| {
        (saturation_radius(&law, digits), saturation_speed(&law, digits))
    })?;
    Ok((certified(&radius.map_err(value)?, digits)?, certified(&speed.map_err(value)?, digits)?))
}
