//! The characteristic velocity from a table of measurements.

use crate::collision::SLOPE;
use crate::{End, FitError, Measurement, Restitution};
use std::vec::Vec;

/// How a residual counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Loss {
    /// Its square: least squares, right for noise that is the same everywhere.
    #[default]
    Squares,
    /// Huber's: its square up to 1.345 times the scatter, linear beyond, so that outliers pull less
    /// (\[Huber1964\]; the scatter is the median absolute residual over 0.6745).
    Huber,
}

/// Huber's constant: 95 % of the efficiency of least squares on normal noise.
const HUBER: f64 = 1.345;
/// The median absolute deviation of the standard normal distribution.
const NORMAL_MAD: f64 = 0.674_489_750_196_081_7;
/// The relative error of `u` beyond which the data are said to say nothing: two standard errors reach zero.
const UNINFORMATIVE: f64 = 0.5;
/// Points of the first search between the smallest and the largest `u` that single rows ask for.
const SEARCH_POINTS: usize = 64;
/// Reweightings of Huber's fit; each one lowers the loss, and some ten suffice.
const REWEIGHTINGS: usize = 100;

/// A fitted characteristic velocity and how well it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// The characteristic velocity `g*`, in the unit of the velocities.
    pub characteristic_velocity: f64,
    /// The standard error of `ln g*`: `g*` lies within a factor of its exponential, at one standard error.
    pub log_error: f64,
    /// The standard deviation of the residuals, `sqrt(sum r^2/(n-1))`.
    pub scatter: f64,
    /// The largest residual, with its sign: measured less fitted.
    pub largest_residual: f64,
    /// The row of the largest residual, counted from 0.
    pub largest_residual_row: usize,
    /// The number of rows.
    pub rows: usize,
    /// The number of rows that count less than the others ([`Loss::Huber`]).
    pub outliers: usize,
    /// How often the residuals change sign along the velocities.
    pub sign_changes: usize,
}

impl Fit {
    /// The interval of `g*` at one standard error, `g* exp(-error)` to `g* exp(error)`.
    pub fn interval(&self) -> (f64, f64) {
        let factor = self.log_error.exp();
        (self.characteristic_velocity / factor, self.characteristic_velocity * factor)
    }

    /// Whether the residuals run together: three standard deviations fewer changes of sign than noise would have.
    ///
    /// Then the curve of a viscoelastic collision does not follow the data, and the standard error, which supposes
    /// independent noise, understates how uncertain `g*` is.
    pub fn is_systematic(&self) -> bool {
        let pairs = self.rows as f64 - 1.0;
        (self.sign_changes as f64) < 0.5 * pairs - 1.5 * pairs.sqrt()
    }

    /// The fitted coefficient at an impact velocity in the unit of the table.
    pub fn epsilon(&self, velocity: f64, end: End) -> f64 {
        Restitution::from_g_star(self.characteristic_velocity, end).epsilon(velocity)
    }
}

/// Fits the characteristic velocity to measured pairs.
///
/// With `u = b g^(1/5)` the sum of the losses of `epsilon_i - epsilon(b g_i^(1/5))` is minimised over `b`. Below the
/// smallest `b` that a single row asks for all residuals pull up, above the largest all pull down, so the
/// minimum lies between: it is found by a search of that interval and golden section, from the right start
/// whatever the noise. The standard error is that of the linearised problem,
///
/// ```text
/// var(ln b) = sum psi^2/(n-1) / (mean psi')^2 / sum J^2,   J_i = d epsilon/d ln b,   var(ln g*) = 25 var(ln b)
/// ```
///
/// with `psi = r` for least squares (\[Huber1981\], sec. 7.6). Rows with a coefficient above 1 are noise and stay: to
/// drop them would bias the fit. Cost: some hundred evaluations a row.
///
/// # Errors
///
/// [`FitError`]: fewer than two rows, one velocity only, no damping at all, or so much scatter that `u` is not
/// known to half of itself.
///
/// # Examples
///
/// ```
/// use restitution::{End, FitError, Loss, Measurement, fit};
///
/// let rows = [(0.001, 0.71), (0.01, 0.57), (0.1, 0.43)]
///     .into_iter()
///     .map(|(g, epsilon)| Measurement::new(g, epsilon))
///     .collect::<Result<Vec<_>, _>>()?;
/// let result = fit(&rows, End::ZeroCompression, Loss::Squares)?;
/// let (low, high) = result.interval();
/// assert!(low < result.characteristic_velocity && result.characteristic_velocity < high);
///
/// assert_eq!(fit(&rows[..1], End::ZeroCompression, Loss::Squares), Err(FitError::TooFewRows { rows: 1 }));
/// # Ok::<(), FitError>(())
/// ```
pub fn fit(rows: &[Measurement], end: End, loss: Loss) -> Result<Fit, FitError> {
    check(rows)?;
    let problem = Problem::new(rows, end);
    let interval = problem.interval()?;
    let ones = std::vec![1.0; rows.len()];
    let mut log_b = problem.minimum(interval, &ones);
    let mut scale = f64::INFINITY;
    if loss == Loss::Huber {
        (log_b, scale) = problem.reweighted(interval, log_b);
    }
    problem.result(log_b, scale)
}

fn check(rows: &[Measurement]) -> Result<(), FitError> {
    let [first, _, ..] = rows else { return Err(FitError::TooFewRows { rows: rows.len() }) };
    if rows.iter().all(|row| row.velocity() == first.velocity()) {
        return Err(FitError::OneVelocity { velocity: first.velocity() });
    }
    if rows.iter().all(|row| row.epsilon() >= 1.0) {
        return Err(FitError::NoDamping { rows: rows.len() });
    }
    Ok(())
}

/// The rows as `(g^(1/5), epsilon)`, with `g` in units of a typical velocity.
struct Problem {
    rows: Vec<(f64, f64)>,
    unit: f64,
    end: End,
}

impl Problem {
    fn new(rows: &[Measurement], end: End) -> Self {
        let unit = rows.iter().map(|row| row.velocity().ln()).sum::<f64>() / rows.len() as f64;
        let scaled = |row: &Measurement| ((0.2 * (row.velocity().ln() - unit)).exp(), row.epsilon());
        Self { rows: rows.iter().map(scaled).collect(), unit: unit.exp(), end }
    }

    /// The logarithms of the smallest and the largest `b` that single rows ask for.
    fn interval(&self) -> Result<(f64, f64), FitError> {
        let asked = |&(root, epsilon): &(f64, f64)| (crate::u_of_epsilon(epsilon, self.end) / root).ln();
        let inner = self.rows.iter().filter(|row| row.1 < 1.0).map(asked);
        let (low, high) =
            inner.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), b| (low.min(b), high.max(b)));
        // a row above 1 asks for b = 0: far enough down all the others pull up harder
        let low = if self.rows.iter().any(|row| row.1 >= 1.0) { low.min(high - 20.0) } else { low };
        if low.is_finite() && high.is_finite() { Ok((low, high)) } else { Err(FitError::OutOfRange) }
    }

    fn residuals(&self, log_b: f64) -> impl Iterator<Item = f64> {
        let b = log_b.exp();
        self.rows.iter().map(move |(root, epsilon)| epsilon - crate::epsilon(b * root, self.end))
    }

    fn loss(&self, log_b: f64, weights: &[f64]) -> f64 {
        self.residuals(log_b).zip(weights).map(|(r, w)| w * r * r).sum()
    }

    /// Returns the minimum of the weighted sum of squares: the best of a grid, then golden section around it.
    fn minimum(&self, (low, high): (f64, f64), weights: &[f64]) -> f64 {
        let step = (high - low) / SEARCH_POINTS as f64;
        let points = (0..=SEARCH_POINTS).map(|k| low + step * k as f64);
        let best = points.min_by(|&a, &b| self.loss(a, weights).total_cmp(&self.loss(b, weights)));
        let best = best.unwrap_or(low);
        let start = golden_section(|x| self.loss(x, weights), best - step, best + step);
        self.polished(start, weights)
    }

    /// Gauss-Newton from a point close to the minimum, to the last digits that a sum of squares cannot show.
    fn polished(&self, start: f64, weights: &[f64]) -> f64 {
        let mut log_b = start;
        for _ in 0..8 {
            let slopes = self.slopes(log_b);
            let terms = self.residuals(log_b).zip(&slopes).zip(weights);
            let (up, down) =
                terms.fold((0.0, 0.0), |(up, down), ((r, j), w)| (up + w * r * j, down + w * j * j));
            let step = up / down;
            if step.abs() > 1e-4 || step.is_nan() {
                return start;
            }
            log_b += step;
        }
        log_b
    }

    /// Huber's fit by weights `min(1, k s/|r|)`; returns the scale `s`, too.
    fn reweighted(&self, interval: (f64, f64), start: f64) -> (f64, f64) {
        let mut log_b = start;
        let mut scale = self.scale(log_b);
        for _ in 0..REWEIGHTINGS {
            let limit = HUBER * scale;
            let weights = self.residuals(log_b).map(|r| if r.abs() <= limit { 1.0 } else { limit / r.abs() });
            let next = self.minimum(interval, &weights.collect::<Vec<_>>());
            let moved = (next - log_b).abs();
            log_b = next;
            scale = self.scale(log_b);
            if moved < 1e-12 {
                break;
            }
        }
        (log_b, scale)
    }

    /// The scatter by the median absolute residual.
    fn scale(&self, log_b: f64) -> f64 {
        let mut sizes = self.residuals(log_b).map(f64::abs).collect::<Vec<_>>();
        sizes.sort_by(f64::total_cmp);
        let middle = sizes.len() / 2;
        let median =
            if sizes.len() % 2 == 1 { sizes[middle] } else { 0.5 * (sizes[middle - 1] + sizes[middle]) };
        median / NORMAL_MAD
    }

    /// `d epsilon/d ln b` of every row, by central differences.
    fn slopes(&self, log_b: f64) -> Vec<f64> {
        const H: f64 = 1e-4;
        let epsilon = |log_b: f64, root: f64| crate::epsilon(log_b.exp() * root, self.end);
        let slope =
            |&(root, _): &(f64, f64)| (epsilon(log_b + H, root) - epsilon(log_b - H, root)) / (2.0 * H);
        self.rows.iter().map(slope).collect()
    }

    fn sign_changes(&self, residuals: &[f64]) -> usize {
        let mut order = (0..residuals.len()).collect::<Vec<_>>();
        order.sort_by(|&a, &b| self.rows[a].0.total_cmp(&self.rows[b].0));
        order.windows(2).filter(|pair| residuals[pair[0]] * residuals[pair[1]] < 0.0).count()
    }

    fn result(&self, log_b: f64, scale: f64) -> Result<Fit, FitError> {
        let residuals = self.residuals(log_b).collect::<Vec<_>>();
        let limit = HUBER * scale;
        let inside = residuals.iter().filter(|r| r.abs() <= limit || scale == 0.0).count();
        let n = residuals.len() as f64;
        let psi = residuals.iter().map(|r| if scale == 0.0 { *r } else { r.clamp(-limit, limit) });
        let variance = psi.map(|r| r * r).sum::<f64>() / (n - 1.0) / (inside as f64 / n).powi(2);
        let information = self.slopes(log_b).iter().map(|j| j * j).sum::<f64>();
        let relative_error = (variance / information).sqrt();
        if relative_error.is_nan() || relative_error > UNINFORMATIVE {
            return Err(FitError::Uninformative { relative_error });
        }
        let characteristic_velocity = self.unit * (-5.0 * (SLOPE.ln() + log_b)).exp();
        if !characteristic_velocity.is_normal() {
            return Err(FitError::OutOfRange);
        }
        let largest = (0..residuals.len()).max_by(|&a, &b| residuals[a].abs().total_cmp(&residuals[b].abs()));
        let largest = largest.unwrap_or(0);
        Ok(Fit {
            characteristic_velocity,
            log_error: 5.0 * relative_error,
            scatter: (residuals.iter().map(|r| r * r).sum::<f64>() / (n - 1.0)).sqrt(),
            largest_residual: residuals[largest],
            largest_residual_row: largest,
            rows: residuals.len(),
            outliers: residuals.len() - inside,
            sign_changes: self.sign_changes(&residuals),
        })
    }
}

/// Returns the minimum of a function with one minimum in the interval, to about the root of the rounding.
fn golden_section(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (high - ratio * (high - low), low + ratio * (high - low));
    let (mut fa, mut fb) = (f(a), f(b));
    for _ in 0..80 {
        if fa <= fb {
            (high, b, fb) = (b, a, fa);
            a = high - ratio * (high - low);
            fa = f(a);
        } else {
            (low, a, fa) = (a, b, fb);
            b = low + ratio * (high - low);
            fb = f(b);
        }
    }
    0.5 * (low + high)
}
