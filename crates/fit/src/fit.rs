//! The characteristic velocity from a table of measurements.

use crate::problem::{Curve, HUBER, MANY, Problem};
use crate::{FitError, Measurement};
use restitution::{End, Restitution};
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

/// How a residual counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Loss {
    /// Its square: least squares, right for normal noise.
    #[default]
    Squares,
    /// Huber's: its square up to 1.345 times the scatter, linear beyond, so that outliers pull less
    /// (\[Huber1964\]; the scatter is the median absolute residual over 0.6745).
    Huber,
}

/// The relative error of `u` beyond which the data are said to say nothing: two standard errors reach zero.
const UNINFORMATIVE: f64 = 0.5;
/// The level of the stated interval.
const LEVEL: f64 = 0.95;
/// How far in `ln b` the ends of an interval are sought: `g*` changes by a factor e^100.
const FARTHEST: f64 = 20.0;

/// A fitted characteristic velocity and how well it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// The characteristic velocity `g*`, in the unit of the velocities.
    pub characteristic_velocity: f64,
    /// The standard error of `ln g*`.
    pub log_error: f64,
    /// The ends of the interval that holds `g*` with 95 % confidence; 0 or infinite where the data set no limit.
    pub interval: (f64, f64),
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
    /// Where the contact ends.
    pub end: End,
}

impl Fit {
    /// The fitted coefficient at an impact velocity in the unit of the table.
    pub fn epsilon(&self, velocity: f64) -> f64 {
        self.curve().epsilon(velocity)
    }

    /// The fitted coefficient as a function of velocity.
    pub fn curve(&self) -> Restitution {
        Restitution::from_g_star(self.characteristic_velocity, self.end)
    }
}

/// Fits the characteristic velocity to measured pairs.
///
/// With `u = b g^(1/5)` the sum of the losses of `(epsilon_i - epsilon(b g_i^(1/5)))/sigma_i` is minimised over `b`,
/// with equal `sigma_i` if none are given. Below the smallest `b` that a single row asks for all residuals pull up,
/// above the largest all pull down, so the minimum lies between: it is found by a search of that interval and golden
/// section, from the right start whatever the noise.
///
/// # Error bound
///
/// The standard error is that of the linearised problem, with `psi = r` for least squares (\[Huber1981\], sec. 7.6):
///
/// ```text
/// var(ln b) = sum psi^2/(n-1) / (mean psi')^2 / sum J^2,   J_i = d epsilon/d ln b / sigma_i,   var(ln g*) = 25 var(ln b)
/// ```
///
/// Least squares with given `sigma_i` takes them at their word: `var(ln b) = 1/sum J^2`. The interval holds the `b` with
/// `S(b) <= S_min + t^2 s^2`, `t` of Student's distribution with `n - 1` degrees of freedom (of the normal one with given
/// `sigma_i`), so that it is right at few rows and for a curved `S`; Huber's is `t` standard errors wide. Over 1,000
/// simulated tables each, it held `g*` in 94 to 96 % (docs/materials.md).
///
/// Rows with a coefficient above 1 are noise and stay: to drop them would bias the fit. Cost: some hundred
/// evaluations a row, or twenty beyond 4000 rows.
///
/// # Errors
///
/// [`FitError`]: fewer than two rows, one velocity only, no damping at all, standard deviations for some rows only, or
/// so much scatter that `u` is not known to half of itself.
///
/// # Examples
///
/// ```
/// use restitution::End;
/// use restitution_fit::{FitError, Loss, Measurement, fit};
///
/// let rows = [(0.001, 0.71), (0.01, 0.57), (0.1, 0.43)]
///     .into_iter()
///     .map(|(g, epsilon)| Measurement::new(g, epsilon))
///     .collect::<Result<Vec<_>, _>>()?;
/// let result = fit(&rows, End::ZeroCompression, Loss::Squares)?;
/// let (low, high) = result.interval;
/// assert!(low < result.characteristic_velocity && result.characteristic_velocity < high);
///
/// assert_eq!(fit(&rows[..1], End::ZeroCompression, Loss::Squares), Err(FitError::TooFewRows { rows: 1 }));
/// # Ok::<(), FitError>(())
/// ```
pub fn fit(rows: &[Measurement], end: End, loss: Loss) -> Result<Fit, FitError> {
    check(rows)?;
    let problem = Problem::new(rows, Curve::Exact(end));
    let (log_b, scale) = match loss {
        Loss::Squares => (problem.best()?, f64::INFINITY),
        Loss::Huber => problem.best_huber()?,
    };
    result(&problem, rows, log_b, scale, end)
}

pub(crate) fn check(rows: &[Measurement]) -> Result<(), FitError> {
    let [first, _, ..] = rows else { return Err(FitError::TooFewRows { rows: rows.len() }) };
    if rows.iter().any(|row| row.sigma().is_some() != first.sigma().is_some()) {
        return Err(FitError::MixedSigma);
    }
    if rows.iter().all(|row| row.velocity() == first.velocity()) {
        return Err(FitError::OneVelocity { velocity: first.velocity() });
    }
    if rows.iter().all(|row| row.epsilon() >= 1.0) {
        return Err(FitError::NoDamping { rows: rows.len() });
    }
    Ok(())
}

/// `scale` is infinite for least squares.
fn result(
    problem: &Problem,
    rows: &[Measurement],
    log_b: f64,
    scale: f64,
    end: End,
) -> Result<Fit, FitError> {
    let n = rows.len() as f64;
    let limit = HUBER * scale;
    let robust = limit.is_finite() && scale > 0.0;
    let inside = problem.residuals(log_b).filter(|r| !robust || r.abs() <= limit).count();
    let psi = problem.residuals(log_b).map(|r| if robust { r.clamp(-limit, limit) } else { r });
    let known = rows[0].sigma().is_some() && !robust;
    let variance =
        if known { 1.0 } else { psi.map(|r| r * r).sum::<f64>() / (n - 1.0) / (inside as f64 / n).powi(2) };
    let information = problem.slopes(log_b).iter().map(|j| j * j).sum::<f64>();
    let error = (variance / information).sqrt();
    if !error.is_finite() {
        return Err(FitError::Insensitive);
    }
    if error > UNINFORMATIVE {
        return Err(FitError::Uninformative { relative_error: error });
    }
    let characteristic_velocity = problem.characteristic_velocity(log_b);
    if !characteristic_velocity.is_normal() {
        return Err(FitError::OutOfRange);
    }
    let quantile = quantile(known, n - 1.0);
    let profile = !robust && rows.len() <= MANY;
    let side = |direction: f64| {
        let linear = log_b + direction * quantile * error;
        let found = if profile {
            profile_end(problem, log_b, direction * error, quantile * quantile * variance)
        } else {
            Some(linear)
        };
        found.map(|log_b| problem.characteristic_velocity(log_b))
    };
    let plain = |k: usize| rows[k].epsilon() - problem.curve.epsilon(log_b.exp() * problem.rows[k].0);
    let largest = (0..rows.len()).max_by(|&a, &b| plain(a).abs().total_cmp(&plain(b).abs())).unwrap_or(0);
    Ok(Fit {
        characteristic_velocity,
        log_error: 5.0 * error,
        interval: (side(1.0).unwrap_or(0.0), side(-1.0).unwrap_or(f64::INFINITY)),
        scatter: ((0..rows.len()).map(|k| plain(k).powi(2)).sum::<f64>() / (n - 1.0)).sqrt(),
        largest_residual: plain(largest),
        largest_residual_row: largest,
        rows: rows.len(),
        outliers: rows.len() - inside,
        end,
    })
}

/// The two-sided quantile of the normal distribution or of Student's.
pub(crate) fn quantile(normal: bool, degrees: f64) -> f64 {
    let upper = 0.5 + 0.5 * LEVEL;
    if normal {
        return Normal::standard().inverse_cdf(upper);
    }
    StudentsT::new(0.0, 1.0, degrees).map_or(f64::INFINITY, |student| student.inverse_cdf(upper))
}

/// Where the sum of squares has risen by `rise`, going from the minimum in steps of `step`.
fn profile_end(problem: &Problem, log_b: f64, step: f64, rise: f64) -> Option<f64> {
    let target = problem.loss(log_b, &[]) + rise;
    let (mut near, mut stride) = (log_b, 0.5 * step);
    if step == 0.0 || rise == 0.0 {
        return Some(log_b);
    }
    loop {
        let far = near + stride;
        if (far - log_b).abs() > FARTHEST {
            return None;
        }
        if problem.loss(far, &[]) >= target {
            return Some(bisect(|x| problem.loss(x, &[]) < target, near, far));
        }
        near = far;
        stride *= 1.2;
    }
}

/// Halves the way between a place where `below` holds and one where it does not.
fn bisect(below: impl Fn(f64) -> bool, mut inside: f64, mut outside: f64) -> f64 {
    for _ in 0..50 {
        let middle = 0.5 * (inside + outside);
        if below(middle) { inside = middle } else { outside = middle }
    }
    0.5 * (inside + outside)
}
