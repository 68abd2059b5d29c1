//! Which of several laws follows the data best.

use crate::fit::check;
use crate::problem::{Curve, MANY, Problem, golden_section};
use crate::{FitError, Measurement};
use restitution::End;

/// A mean residual below it is rounding: laws that come closer are not told apart.
const ROUNDING: f64 = 1e-10;
/// The exponents among which that of a power law is sought.
const EXPONENTS: (f64, f64) = (-3.0, 3.0);
/// The exponent of plastic spheres far beyond their yield velocity (\[Johnson1985\], sec. 11.5).
const PLASTIC_EXPONENT: f64 = 0.25;

/// A law of the coefficient of restitution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Viscoelastic spheres; the parameter is `g*`.
    Viscoelastic(End),
    /// `epsilon = c`.
    Constant,
    /// `epsilon = (g/c)^(-1/4)`, plastic spheres; the parameter is `c`, where the line reaches 1.
    Plastic,
    /// `epsilon = c g^(-q)`; the parameters are `c`, the coefficient at unit velocity, and `q`.
    Power,
    /// Formula (35) of \[RPBS1999\] as printed; the parameter is `g*`.
    Printed35,
}

impl Law {
    /// The laws that are compared unless others are asked for.
    pub const USUAL: [Self; 5] = [
        Self::Viscoelastic(End::ZeroCompression),
        Self::Viscoelastic(End::ZeroForce),
        Self::Constant,
        Self::Plastic,
        Self::Power,
    ];

    /// The number of its parameters.
    pub fn parameters(self) -> usize {
        if self == Self::Power { 2 } else { 1 }
    }
}

/// A law fitted to data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LawFit {
    /// The law.
    pub law: Law,
    /// `g*` or `c`: a velocity in the unit of the table, or a coefficient for [`Law::Constant`] and [`Law::Power`].
    pub scale: f64,
    /// The exponent `q` of [`Law::Power`] and [`Law::Plastic`].
    pub exponent: Option<f64>,
    /// `sqrt(sum r^2/n)`, weighted if standard deviations are given.
    pub residual: f64,
    /// The information criterion; `None` if there are too few rows for it.
    pub criterion: Option<f64>,
}

impl LawFit {
    /// A difference from which another law is clearly better: the odds are 3 to 1.
    pub const CLEARLY: f64 = 2.0;

    /// By how much the criterion exceeds that of another law; `None` if either has none.
    pub fn behind(&self, other: &Self) -> Option<f64> {
        Some(self.criterion? - other.criterion?)
    }

    /// The fitted coefficient at a velocity in the unit of the table.
    pub fn epsilon(&self, velocity: f64) -> f64 {
        match self.law {
            Law::Viscoelastic(end) => {
                restitution::Restitution::from_g_star(self.scale, end).epsilon(velocity)
            }
            Law::Printed35 => {
                Curve::Printed.epsilon((velocity / self.scale).powf(0.2) / crate::problem::slope())
            }
            Law::Constant => self.scale,
            Law::Plastic => (velocity / self.scale).powf(-PLASTIC_EXPONENT),
            Law::Power => self.scale * velocity.powf(-self.exponent.unwrap_or(0.0)),
        }
    }
}

/// Fits several laws to the same data by least squares and returns them, best first.
///
/// Best is the smallest value of Akaike's criterion with its correction for few rows \[HT1989\],
///
/// ```text
/// AICc = n ln(sum r^2/n) + 2 k + 2 k (k+1)/(n-k-1),    k = parameters + 1 for the scatter,
/// ```
///
/// or, with given standard deviations, `sum (r/sigma)^2 + 2 k`, `k` the parameters alone. A difference of 2 says little, one of
/// 10 a lot. Laws without a criterion, for want of rows, come last, by their residuals. A law that cannot be fitted, such as a
/// viscoelastic one if no row is below 1, is left out.
///
/// # Errors
///
/// [`FitError::TooFewRows`], [`FitError::OneVelocity`], [`FitError::MixedSigma`].
///
/// # Examples
///
/// ```
/// use restitution_fit::{FitError, Law, Measurement, compare};
///
/// let rows = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0]
///     .into_iter()
///     .map(|g: f64| Measurement::new(g, 0.5 * g.powf(-0.25)))
///     .collect::<Result<Vec<_>, _>>()?;
/// let fits = compare(&rows, &Law::USUAL)?;
/// assert_eq!(fits[0].law, Law::Plastic);
///
/// assert!(matches!(compare(&rows[..1], &Law::USUAL), Err(FitError::TooFewRows { .. })));
/// # Ok::<(), FitError>(())
/// ```
pub fn compare(rows: &[Measurement], laws: &[Law]) -> Result<Vec<LawFit>, FitError> {
    match check(rows) {
        Err(FitError::NoDamping { .. }) | Ok(()) => {}
        Err(error) => return Err(error),
    }
    let mut fits = laws.iter().filter_map(|law| law.fit(rows)).collect::<Vec<_>>();
    let key = |fit: &LawFit| (fit.criterion.is_none(), fit.criterion.unwrap_or(fit.residual));
    fits.sort_by(|a, b| key(a).0.cmp(&key(b).0).then(key(a).1.total_cmp(&key(b).1)));
    Ok(fits)
}

impl Law {
    fn fit(self, rows: &[Measurement]) -> Option<LawFit> {
        let (scale, exponent, sum) = match self {
            Self::Viscoelastic(end) => one_parameter(rows, Curve::Exact(end))?,
            Self::Printed35 => one_parameter(rows, Curve::Printed)?,
            Self::Constant => constant(rows),
            Self::Plastic => power(rows, Some(PLASTIC_EXPONENT))?,
            Self::Power => power(rows, None)?,
        };
        let n = rows.len() as f64;
        let known = rows[0].sigma().is_some();
        let residual = (sum / n).sqrt();
        let parameters = self.parameters();
        let criterion = if known {
            Some(sum + 2.0 * parameters as f64)
        } else {
            let k = (parameters + 1) as f64;
            let likelihood = 2.0 * n * residual.max(ROUNDING).ln();
            (n - k - 1.0 > 0.0).then(|| likelihood + 2.0 * k + 2.0 * k * (k + 1.0) / (n - k - 1.0))
        };
        scale.is_finite().then_some(LawFit { law: self, scale, exponent, residual, criterion })
    }
}

type Fitted = (f64, Option<f64>, f64);

fn one_parameter(rows: &[Measurement], curve: Curve) -> Option<Fitted> {
    let problem = Problem::new(rows, curve);
    let log_b = problem.best().ok()?;
    Some((problem.characteristic_velocity(log_b), None, problem.loss(log_b, &[])))
}

fn weight(row: &Measurement) -> f64 {
    row.sigma().map_or(1.0, |sigma| 1.0 / (sigma * sigma))
}

fn constant(rows: &[Measurement]) -> Fitted {
    let (sum, total) =
        rows.iter().fold((0.0, 0.0), |(s, t), row| (s + weight(row) * row.epsilon(), t + weight(row)));
    let mean = sum / total;
    (mean, None, rows.iter().map(|row| weight(row) * (row.epsilon() - mean).powi(2)).sum())
}

/// `epsilon = a exp(-q x)`, `x = ln g` less its mean; `a` follows from `q`.
struct PowerProblem {
    /// `(x, epsilon, weight)`.
    rows: Vec<(f64, f64, f64)>,
    middle: f64,
}

impl PowerProblem {
    fn new(rows: &[Measurement], stride: usize) -> Self {
        let middle = rows.iter().map(|row| row.velocity().ln()).sum::<f64>() / rows.len() as f64;
        let scaled = |row: &Measurement| (row.velocity().ln() - middle, row.epsilon(), weight(row));
        Self { rows: rows.iter().step_by(stride).map(scaled).collect(), middle }
    }

    fn amplitude(&self, q: f64) -> f64 {
        let (up, down) = self.rows.iter().fold((0.0, 0.0), |(up, down), (x, y, w)| {
            let f = (-q * x).exp();
            (up + w * f * y, down + w * f * f)
        });
        up / down
    }

    fn loss(&self, q: f64) -> f64 {
        let a = self.amplitude(q);
        self.rows.iter().map(|(x, y, w)| w * (y - a * (-q * x).exp()).powi(2)).sum()
    }

    /// The best exponent: of a grid, then by golden section.
    fn exponent(&self, (low, high): (f64, f64), points: usize) -> f64 {
        let step = (high - low) / points as f64;
        let valued = (0..=points).map(|k| low + step * k as f64).map(|q| (q, self.loss(q)));
        let best = valued.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0.0, |(q, _)| q);
        golden_section(|q| self.loss(q), best - step, best + step)
    }
}

fn power(rows: &[Measurement], exponent: Option<f64>) -> Option<Fitted> {
    let problem = PowerProblem::new(rows, 1);
    let q = match exponent {
        Some(q) => q,
        None if rows.len() > MANY => {
            let sampled = PowerProblem::new(rows, rows.len() / (MANY / 2)).exponent(EXPONENTS, 120);
            problem.exponent((sampled - 0.05, sampled + 0.05), 2)
        }
        None => problem.exponent(EXPONENTS, 120),
    };
    let a = problem.amplitude(q);
    let scale = match exponent {
        Some(q) => (a.ln() / q + problem.middle).exp(),
        None => a * (q * problem.middle).exp(),
    };
    (a > 0.0).then(|| (scale, Some(q), problem.loss(q)))
}
