//! The characteristic velocity from measurements, whether the law fits them, and which law fits best.

use crate::curve::Restitution;
use crate::elementwise::contiguous;
use crate::errors::{self, value};
use numpy::PyArrayMethods;
use pyo3::prelude::*;
use restitution_fit::{Departure, Law, Loss, Measurement, adequacy};

/// The result of `fit`: the characteristic velocity, and whether the law follows the data at all.
#[pyclass(frozen, subclass, module = "restitution", name = "_Fit")]
#[derive(Clone)]
pub struct Fit {
    fit: restitution_fit::Fit,
    adequacy: restitution_fit::Adequacy,
}

#[pymethods]
impl Fit {
    /// A copy, which a subclass in Python is made of.
    #[new]
    fn new(fit: &Self) -> Self {
        fit.clone()
    }

    /// The characteristic velocity g* of eq. (31), in the unit of the velocities.
    #[getter]
    fn g_star(&self) -> f64 {
        self.fit.characteristic_velocity
    }

    /// The standard error of ln g*.
    #[getter]
    fn log_error(&self) -> f64 {
        self.fit.log_error
    }

    /// The interval of g* that the library states, as a pair.
    #[getter]
    fn interval(&self) -> (f64, f64) {
        self.fit.interval
    }

    /// The standard deviation of the residuals in epsilon.
    #[getter]
    fn scatter(&self) -> f64 {
        self.fit.scatter
    }

    /// The residual in epsilon that is largest in size.
    #[getter]
    fn largest_residual(&self) -> f64 {
        self.fit.largest_residual
    }

    /// The position of the row with the largest residual.
    #[getter]
    fn largest_residual_row(&self) -> usize {
        self.fit.largest_residual_row
    }

    /// The number of rows used.
    #[getter]
    fn rows(&self) -> usize {
        self.fit.rows
    }

    /// How often data that follow the law look as unlike it as these, by the strictest test; None without a test.
    #[getter]
    fn p(&self) -> Option<f64> {
        self.adequacy.p()
    }

    /// Whether the law does not follow the data, with at most one false alarm in twenty.
    #[getter]
    fn is_doubtful(&self) -> bool {
        self.adequacy.is_doubtful()
    }

    /// Whether epsilon rises with the velocity, which that of viscoelastic bodies never does.
    #[getter]
    fn rises(&self) -> bool {
        self.adequacy.rises()
    }

    /// The tests made: name, statistic and p of each.
    #[getter]
    fn tests(&self) -> Vec<(&'static str, f64, f64)> {
        let name = |departure| match departure {
            Departure::Smooth => "smooth",
            Departure::Rise => "rise",
            Departure::LackOfFit => "lack of fit",
            Departure::Sigma => "sigma",
        };
        self.adequacy.tests.iter().map(|test| (name(test.departure), test.statistic, test.p)).collect()
    }

    /// The curve that was fitted, of the base class that `restitution.Fit.restitution` dresses.
    #[getter]
    fn curve(&self) -> Restitution {
        Restitution::of(self.fit.curve(), Some(self.fit.characteristic_velocity))
    }

    fn __repr__(&self) -> String {
        let (low, high) = self.fit.interval;
        format!(
            "Fit(g_star={:.6}, interval=({low:.6}, {high:.6}), scatter={:.3e}, rows={}, end='{}'{})",
            self.fit.characteristic_velocity,
            self.fit.scatter,
            self.fit.rows,
            errors::name(self.fit.end),
            if self.adequacy.is_doubtful() { ", the law does not follow these data" } else { "" }
        )
    }
}

/// Fits g* to measured coefficients of restitution.
#[pyfunction]
#[pyo3(signature = (g, epsilon, sigma, end, loss))]
pub fn fit(
    g: &Bound<'_, PyAny>,
    epsilon: &Bound<'_, PyAny>,
    sigma: Option<&Bound<'_, PyAny>>,
    end: &str,
    loss: &str,
) -> PyResult<Fit> {
    let end = errors::end(end)?;
    let loss = match loss {
        "squares" => Loss::Squares,
        "huber" => Loss::Huber,
        _ => return Err(value(format!("'{loss}' is no loss: give 'squares' or 'huber'"))),
    };
    let rows = measurements(g, epsilon, sigma)?;
    let found = g.py().detach(|| {
        let fit = restitution_fit::fit(&rows, end, loss)?;
        let adequacy = adequacy(&rows, &fit)?;
        Ok(Fit { fit, adequacy })
    });
    found.map_err(|error: restitution_fit::FitError| value(error))
}

/// `(name, scale, exponent, residual, criterion)` of the usual laws, best first.
#[pyfunction]
#[allow(clippy::type_complexity)]
pub fn compare(
    g: &Bound<'_, PyAny>,
    epsilon: &Bound<'_, PyAny>,
    sigma: Option<&Bound<'_, PyAny>>,
) -> PyResult<Vec<(&'static str, f64, Option<f64>, f64, Option<f64>)>> {
    let rows = measurements(g, epsilon, sigma)?;
    let fits = g.py().detach(|| restitution_fit::compare(&rows, &Law::USUAL)).map_err(value)?;
    let name = |law| match law {
        Law::Viscoelastic(restitution::End::ZeroCompression) => "viscoelastic, zero compression",
        Law::Viscoelastic(restitution::End::ZeroForce) => "viscoelastic, zero force",
        Law::Constant => "constant",
        Law::Plastic => "plastic",
        Law::Power => "power",
        Law::Printed35 => "formula (35) as printed",
    };
    Ok(fits.iter().map(|fit| (name(fit.law), fit.scale, fit.exponent, fit.residual, fit.criterion)).collect())
}

fn measurements(
    g: &Bound<'_, PyAny>,
    epsilon: &Bound<'_, PyAny>,
    sigma: Option<&Bound<'_, PyAny>>,
) -> PyResult<Vec<Measurement>> {
    let (g, epsilon) = (contiguous(g)?.readonly(), contiguous(epsilon)?.readonly());
    let (g, epsilon) = (g.as_slice()?, epsilon.as_slice()?);
    if g.len() != epsilon.len() {
        let (a, b) = (g.len(), epsilon.len());
        return Err(value(format!(
            "{a} velocities and {b} coefficients make no pairs: give as many of each"
        )));
    }
    let rows = g.iter().zip(epsilon).map(|(g, epsilon)| Measurement::new(*g, *epsilon));
    let Some(sigma) = sigma else { return rows.collect::<Result<_, _>>().map_err(value) };
    let sigma = contiguous(sigma)?.readonly();
    let sigma = sigma.as_slice()?;
    if sigma.len() != g.len() && sigma.len() != 1 {
        let (a, b) = (sigma.len(), g.len());
        return Err(value(format!(
            "{a} standard deviations for {b} rows: give one for each, or one for all"
        )));
    }
    rows.zip(sigma.iter().cycle())
        .map(|(row, sigma)| row?.with_sigma(*sigma))
        .collect::<Result<_, _>>()
        .map_err(value)
}
