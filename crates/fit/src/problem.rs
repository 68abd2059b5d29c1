//! The least-squares problem of one unknown, `u = b g^(1/5)`.

use crate::{FitError, Measurement};
use restitution::End;
use std::vec::Vec;

/// Huber's constant: 95 % of the efficiency of least squares on normal noise.
pub(crate) const HUBER: f64 = 1.345;
/// The median absolute deviation of the standard normal distribution.
const NORMAL_MAD: f64 = 0.674_489_750_196_081_7;
/// Points of the first search between the smallest and the largest `u` that single rows ask for.
const SEARCH_POINTS: usize = 64;
/// Reweightings of Huber's fit; each one lowers the loss, and some ten suffice.
const REWEIGHTINGS: usize = 100;
/// From so many rows on, the search runs on a sample, and Gauss-Newton goes on from there on all rows.
pub(crate) const MANY: usize = 4000;
/// Steps of Gauss-Newton: from a good start three or four suffice.
const STEPS: usize = 30;

/// The coefficient as a function of `u`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Curve {
    /// That of viscoelastic spheres.
    Exact(End),
    /// Formula (35) of \[RPBS1999\] with the constants that its Table I prints, a function of `|C_1| u`.
    Printed,
}

impl Curve {
    pub(crate) fn epsilon(self, u: f64) -> f64 {
        match self {
            Self::Exact(end) => restitution::epsilon(u, end),
            Self::Printed => {
                let s = slope() * u;
                (1.0 + 2.5839 * s) / (1.0 + s * (3.5839 + s * (2.9839 + s * (1.1487 + s * 0.3265))))
            }
        }
    }

    /// A `u` at which the coefficient is about `epsilon`.
    fn u_near(self, epsilon: f64) -> f64 {
        let end = if let Self::Exact(end) = self { end } else { End::ZeroCompression };
        restitution::u_of_epsilon(epsilon, end)
    }
}

/// `|C_1|`, with which `g* = (|C_1| b)^-5`.
pub(crate) fn slope() -> f64 {
    1.0 / restitution::Restitution::from_g_star(1.0, End::ZeroCompression).u(1.0)
}

/// The rows as `(g^(1/5), epsilon, 1/sigma)`, with `g` in units of a typical velocity.
#[derive(Clone)]
pub(crate) struct Problem {
    pub(crate) rows: Vec<(f64, f64, f64)>,
    pub(crate) unit: f64,
    pub(crate) curve: Curve,
}

impl Problem {
    pub(crate) fn new(rows: &[Measurement], curve: Curve) -> Self {
        let unit = rows.iter().map(|row| row.velocity().ln()).sum::<f64>() / rows.len() as f64;
        let scaled = |row: &Measurement| {
            let root = (0.2 * (row.velocity().ln() - unit)).exp();
            (root, row.epsilon(), row.sigma().map_or(1.0, f64::recip))
        };
        Self { rows: rows.iter().map(scaled).collect(), unit: unit.exp(), curve }
    }

    /// The best `ln b` by least squares.
    pub(crate) fn best(&self) -> Result<f64, FitError> {
        if self.rows.len() > MANY
            && let Some(log_b) = self.sample().best().ok().and_then(|start| self.descend(start, &[]))
        {
            return Ok(log_b);
        }
        Ok(self.minimum(self.interval()?, &[]))
    }

    /// The best `ln b` by Huber's loss, and the scale `s` beyond whose 1.345-fold it is linear.
    pub(crate) fn best_huber(&self) -> Result<(f64, f64), FitError> {
        let mut log_b = self.best()?;
        let mut scale = self.scale(log_b);
        let interval = self.interval()?;
        for _ in 0..REWEIGHTINGS {
            let limit = HUBER * scale;
            let weight = |r: f64| if r.abs() <= limit { 1.0 } else { limit / r.abs() };
            let weights = self.residuals(log_b).map(weight).collect::<Vec<_>>();
            let many = self.rows.len() > MANY;
            let next = if many { self.descend(log_b, &weights) } else { None };
            let next = next.unwrap_or_else(|| self.minimum(interval, &weights));
            let moved = (next - log_b).abs();
            log_b = next;
            scale = self.scale(log_b);
            if moved < 1e-12 {
                break;
            }
        }
        Ok((log_b, scale))
    }

    /// Some of the rows, spread over all of them.
    fn sample(&self) -> Self {
        let stride = self.rows.len() / (MANY / 2);
        let rows = self.rows.iter().step_by(stride.max(1)).copied().collect();
        Self { rows, ..self.clone_empty() }
    }

    fn clone_empty(&self) -> Self {
        Self { rows: Vec::new(), unit: self.unit, curve: self.curve }
    }

    /// The logarithms of the smallest and the largest `b` that single rows ask for.
    fn interval(&self) -> Result<(f64, f64), FitError> {
        let asked = |&(root, epsilon, _): &(f64, f64, f64)| (self.curve.u_near(epsilon) / root).ln();
        let inner = self.rows.iter().filter(|row| row.1 < 1.0).map(asked);
        let (low, high) =
            inner.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), b| (low.min(b), high.max(b)));
        // a row above 1 asks for b = 0: far enough down all the others pull up harder
        let low = if self.rows.iter().any(|row| row.1 >= 1.0) { low.min(high - 20.0) } else { low };
        let room = if self.curve == Curve::Printed { 1.0 } else { 0.0 };
        if low.is_finite() && high.is_finite() {
            Ok((low - room, high + room))
        } else {
            Err(FitError::OutOfRange)
        }
    }

    /// The residuals in units of their standard deviations, if those are known.
    pub(crate) fn residuals(&self, log_b: f64) -> impl Iterator<Item = f64> {
        let b = log_b.exp();
        self.rows.iter().map(move |(root, epsilon, scale)| scale * (epsilon - self.curve.epsilon(b * root)))
    }

    /// The sum of squares; no weights are ones.
    pub(crate) fn loss(&self, log_b: f64, weights: &[f64]) -> f64 {
        if weights.is_empty() {
            return self.residuals(log_b).map(|r| r * r).sum();
        }
        self.residuals(log_b).zip(weights).map(|(r, w)| w * r * r).sum()
    }

    /// Returns the minimum of the weighted sum of squares: the best of a grid, then golden section around it.
    fn minimum(&self, (low, high): (f64, f64), weights: &[f64]) -> f64 {
        let step = (high - low) / SEARCH_POINTS as f64;
        let points = (0..=SEARCH_POINTS).map(|k| low + step * k as f64);
        let valued = points.map(|point| (point, self.loss(point, weights)));
        let best = valued.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(low, |(point, _)| point);
        let start = golden_section(|x| self.loss(x, weights), best - step, best + step);
        self.descend(start, weights).filter(|end| (end - start).abs() <= 1e-3).unwrap_or(start)
    }

    /// Gauss-Newton, to the last digits that a sum of squares cannot show; `None` if it does not arrive.
    fn descend(&self, start: f64, weights: &[f64]) -> Option<f64> {
        let mut log_b = start;
        for _ in 0..STEPS {
            let slopes = self.slopes(log_b);
            let weight = |k: usize| weights.get(k).copied().unwrap_or(1.0);
            let (mut up, mut down) = (0.0, 0.0);
            for (k, (r, j)) in self.residuals(log_b).zip(&slopes).enumerate() {
                up += weight(k) * r * j;
                down += weight(k) * j * j;
            }
            let step = up / down;
            if step.is_nan() || step.abs() > 1.0 {
                return None;
            }
            log_b += step;
            if step.abs() < 1e-15 * log_b.abs().max(1.0) {
                break;
            }
        }
        let arrived = self.loss(log_b, weights) <= self.loss(start, weights) * (1.0 + 1e-9);
        arrived.then_some(log_b)
    }

    /// The scatter by the median absolute residual.
    fn scale(&self, log_b: f64) -> f64 {
        let mut sizes = self.residuals(log_b).map(f64::abs).collect::<Vec<_>>();
        let middle = sizes.len() / 2;
        let (below, upper, _) = sizes.select_nth_unstable_by(middle, f64::total_cmp);
        let upper = *upper;
        let lower = below.iter().copied().fold(0.0, f64::max);
        let odd = !sizes.len().is_multiple_of(2);
        (if odd { upper } else { 0.5 * (lower + upper) }) / NORMAL_MAD
    }

    /// `d epsilon/d ln b` of every row over its standard deviation, by central differences.
    pub(crate) fn slopes(&self, log_b: f64) -> Vec<f64> {
        const H: f64 = 1e-4;
        let (below, above) = ((log_b - H).exp(), (log_b + H).exp());
        let slope = |&(root, _, scale): &(f64, f64, f64)| {
            scale * (self.curve.epsilon(above * root) - self.curve.epsilon(below * root)) / (2.0 * H)
        };
        self.rows.iter().map(slope).collect()
    }

    /// The characteristic velocity that belongs to `ln b`.
    pub(crate) fn characteristic_velocity(&self, log_b: f64) -> f64 {
        self.unit * (-5.0 * (slope().ln() + log_b)).exp()
    }
}

/// Returns the minimum of a function with one minimum in the interval, to about the root of the rounding.
pub(crate) fn golden_section(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (high - ratio * (high - low), low + ratio * (high - low));
    let (mut fa, mut fb) = (f(a), f(b));
    for _ in 0..45 {
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
