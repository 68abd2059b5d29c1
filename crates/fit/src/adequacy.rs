//! Whether the law follows the data at all.

use crate::fit::check;
use crate::problem::{Curve, Problem};
use crate::{Fit, FitError, Measurement};
use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor, StudentsT};

/// How often sound data are called unsound: the level of [`Adequacy::is_doubtful`].
pub const FALSE_ALARMS: f64 = 0.05;
/// One sound table of so many is called doubtful.
pub const TABLES_PER_FALSE_ALARM: f64 = 1.0 / FALSE_ALARMS;
/// The part of the false alarms that is left to the test of a rise.
const RISE_SHARE: f64 = 0.2;
/// Residuals below it are rounding, of which nothing is tested.
const ROUNDING: f64 = 1e-12;
/// A direction shorter than this share of itself, once the others are taken out, is none of its own.
const DEPENDENT: f64 = 1e-7;

/// What a test looks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Departure {
    /// A smooth one: residuals that follow a polynomial of `ln g` (F test of added terms).
    Smooth,
    /// A coefficient that rises with velocity, which that of a viscoelastic body never does (one-sided t test).
    Rise,
    /// Means of repeated measurements off the curve by more than the repetitions scatter (F test of lack of fit).
    LackOfFit,
    /// Residuals beyond the given standard deviations (chi-square test).
    Sigma,
}

/// One test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Test {
    /// What it looks for.
    pub departure: Departure,
    /// F, t or chi-square.
    pub statistic: f64,
    /// The degrees of freedom, of numerator and denominator for F.
    pub degrees: (usize, usize),
    /// How often data that follow the law with normal noise give such a statistic or a larger one.
    pub p: f64,
}

/// Whether the law follows the data: several tests with one known rate of false alarms.
#[derive(Clone, Debug, PartialEq)]
pub struct Adequacy {
    /// The tests that the data allow; none for two rows, or if the curve passes through every row.
    pub tests: Vec<Test>,
}

impl Adequacy {
    /// The smallest p of the tests over its share of the false alarms, so that these stay below the level asked for in
    /// all (Bonferroni): a fifth for [`Departure::Rise`], which data that fall hardly ever use up, the rest in equal parts.
    pub fn p(&self) -> Option<f64> {
        let smallest = self.tests.iter().map(|test| test.p / self.share(test)).min_by(f64::total_cmp)?;
        Some(smallest.min(1.0))
    }

    fn share(&self, test: &Test) -> f64 {
        match (test.departure, self.tests.len()) {
            (_, 1) => 1.0,
            (Departure::Rise, _) => RISE_SHARE,
            (_, number) => {
                let others = number - usize::from(self.of(Departure::Rise).is_some());
                (if others < number { 1.0 - RISE_SHARE } else { 1.0 }) / others as f64
            }
        }
    }

    fn of(&self, departure: Departure) -> Option<&Test> {
        self.tests.iter().find(|test| test.departure == departure)
    }

    /// Whether the data do not follow the law, with at most one false alarm in twenty.
    pub fn is_doubtful(&self) -> bool {
        self.p().is_some_and(|p| p < FALSE_ALARMS)
    }

    /// Whether the coefficient rises with velocity, at the same level.
    pub fn rises(&self) -> bool {
        self.of(Departure::Rise).is_some_and(|test| test.p / self.share(test) < FALSE_ALARMS)
    }
}

/// Tests whether measured pairs follow the fitted law.
///
/// The residuals of a fit of one parameter are, to first order, free of the direction `J_i = d epsilon_i/d ln b`, and
/// normal otherwise. Four tests, none of which depends on the order of the rows:
///
/// ```text
/// smooth       F = (sum of squares along k further directions / k) / (what is left / (n - 1 - k)),
///              directions ln g; 1, ln g; 1, ln g, (ln g)^2 for n = 4, 5; 6 ... 9; from 10 on
/// rise         t of the slope of epsilon against ln g, n - 2 degrees of freedom, one-sided, n >= 3
/// lack of fit  F = ((S - S_pure)/(m - 1)) / (S_pure/(n - m)),  S_pure around the means of m velocities measured n times
/// sigma        S against chi-square with n - 1 degrees of freedom, if standard deviations are given
/// ```
///
/// # Error bound
///
/// The rates of false alarms are exact for a linear law with normal noise of equal size (or of the given `sigma_i`). For this
/// one they were measured: tests/it/adequacy.rs.
///
/// # Errors
///
/// As [`fit`](crate::fit).
///
/// # Examples
///
/// ```
/// use restitution::End;
/// use restitution_fit::{FitError, Loss, Measurement, adequacy, fit};
///
/// let rising = [(0.1, 0.2), (0.2, 0.31), (0.4, 0.44), (0.8, 0.52), (1.6, 0.65)]
///     .into_iter()
///     .map(|(g, epsilon)| Measurement::new(g, epsilon))
///     .collect::<Result<Vec<_>, _>>()?;
/// let fitted = fit(&rising, End::ZeroCompression, Loss::Squares)?;
/// let verdict = adequacy(&rising, &fitted)?;
/// assert!(verdict.is_doubtful() && verdict.rises());
///
/// assert_eq!(adequacy(&[], &fitted), Err(FitError::TooFewRows { rows: 0 }));
/// # Ok::<(), FitError>(())
/// ```
pub fn adequacy(rows: &[Measurement], fit: &Fit) -> Result<Adequacy, FitError> {
    check(rows)?;
    if fit.largest_residual.abs() < ROUNDING {
        return Ok(Adequacy { tests: Vec::new() });
    }
    let problem = Problem::new(rows, Curve::Exact(fit.end));
    let log_b = ((problem.unit / fit.characteristic_velocity).ln() / 5.0) - crate::problem::slope().ln();
    let residuals = problem.residuals(log_b).collect::<Vec<_>>();
    let sample = Sample::new(rows, &problem);
    let tests = [
        sample.smooth(&residuals, problem.slopes(log_b)),
        sample.rise(),
        sample.lack_of_fit(&residuals),
        sample.sigma(&residuals),
    ];
    Ok(Adequacy { tests: tests.into_iter().flatten().collect() })
}

/// The rows as the tests see them.
struct Sample {
    /// `ln g`, from -1 to 1.
    x: Vec<f64>,
    epsilon: Vec<f64>,
    /// `1/sigma`.
    scale: Vec<f64>,
    /// The rows by velocity.
    order: Vec<usize>,
    known: bool,
}

impl Sample {
    fn new(rows: &[Measurement], problem: &Problem) -> Self {
        let logs = rows.iter().map(|row| row.velocity().ln()).collect::<Vec<_>>();
        let (low, high) =
            logs.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(*x), h.max(*x)));
        let mut order = (0..rows.len()).collect::<Vec<_>>();
        order.sort_unstable_by(|&a, &b| rows[a].velocity().total_cmp(&rows[b].velocity()).then(a.cmp(&b)));
        Self {
            x: logs.iter().map(|x| (2.0 * x - low - high) / (high - low)).collect(),
            epsilon: rows.iter().map(Measurement::epsilon).collect(),
            scale: problem.rows.iter().map(|row| row.2).collect(),
            order,
            known: rows[0].sigma().is_some(),
        }
    }

    /// The rows of each velocity.
    fn velocities(&self) -> impl Iterator<Item = &[usize]> {
        self.order.chunk_by(|&a, &b| self.x[a] == self.x[b])
    }

    fn smooth(&self, residuals: &[f64], slopes: Vec<f64>) -> Option<Test> {
        let powers: &[i32] = match self.velocities().count().min(residuals.len()) {
            0..4 => return None,
            4..6 => &[1],
            6..10 => &[1, 0],
            _ => &[1, 0, 2],
        };
        let mut basis = Vec::new();
        extend(&mut basis, slopes);
        let (mut explained, mut terms) = (0.0, 0);
        let removed = basis.first().map_or(0.0, |tangent| dot(tangent, residuals).powi(2));
        for power in powers {
            let direction = self.x.iter().zip(&self.scale).map(|(x, scale)| scale * x.powi(*power));
            if extend(&mut basis, direction.collect()) {
                terms += 1;
                explained += basis.last().map_or(0.0, |direction| dot(direction, residuals).powi(2));
            }
        }
        let rest = dot(residuals, residuals) - removed - explained;
        f_test(Departure::Smooth, (explained, terms), (rest, (residuals.len() - 1).checked_sub(terms)?))
    }

    fn rise(&self) -> Option<Test> {
        let degrees = self.x.len().checked_sub(2).filter(|degrees| *degrees > 0)?;
        let weights = self.scale.iter().map(|scale| scale * scale);
        let mean = |values: &[f64]| {
            let (sum, total) =
                weights.clone().zip(values).fold((0.0, 0.0), |(s, t), (w, v)| (s + w * v, t + w));
            sum / total
        };
        let (mean_x, mean_y) = (mean(&self.x), mean(&self.epsilon));
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for ((x, y), w) in self.x.iter().zip(&self.epsilon).zip(weights) {
            xx += w * (x - mean_x).powi(2);
            xy += w * (x - mean_x) * (y - mean_y);
            yy += w * (y - mean_y).powi(2);
        }
        let left = (yy - xy * xy / xx).max(0.0);
        if yy == 0.0 {
            return None;
        }
        let statistic = xy / xx / (left / degrees as f64 / xx).sqrt();
        let p = StudentsT::new(0.0, 1.0, degrees as f64).ok().map(|student| upper(&student, statistic))?;
        Some(Test { departure: Departure::Rise, statistic, degrees: (degrees, 0), p })
    }

    fn lack_of_fit(&self, residuals: &[f64]) -> Option<Test> {
        let (mut pure, mut velocities) = (0.0, 0_usize);
        for group in self.velocities() {
            velocities += 1;
            let weight = |k: usize| self.scale[k] * self.scale[k];
            let total = group.iter().map(|&k| weight(k)).sum::<f64>();
            let mean = group.iter().map(|&k| weight(k) * self.epsilon[k]).sum::<f64>() / total;
            pure += group.iter().map(|&k| weight(k) * (self.epsilon[k] - mean).powi(2)).sum::<f64>();
        }
        let repetitions = residuals.len() - velocities;
        let lack = (dot(residuals, residuals) - pure).max(0.0);
        f_test(Departure::LackOfFit, (lack, velocities - 1), (pure, repetitions))
    }

    fn sigma(&self, residuals: &[f64]) -> Option<Test> {
        if !self.known {
            return None;
        }
        let (statistic, degrees) = (dot(residuals, residuals), residuals.len() - 1);
        let p = upper(&ChiSquared::new(degrees as f64).ok()?, statistic);
        Some(Test { departure: Departure::Sigma, statistic, degrees: (degrees, 0), p })
    }
}

/// `F` of a sum of squares with its degrees of freedom against another; `None` without degrees of freedom.
fn f_test(departure: Departure, above: (f64, usize), below: (f64, usize)) -> Option<Test> {
    if above.1 == 0 || below.1 == 0 || (above.0 <= 0.0 && below.0 <= 0.0) {
        return None;
    }
    let statistic = above.0 / above.1 as f64 / (below.0.max(0.0) / below.1 as f64);
    let p = upper(&FisherSnedecor::new(above.1 as f64, below.1 as f64).ok()?, statistic);
    Some(Test { departure, statistic, degrees: (above.1, below.1), p })
}

/// The probability of more than `statistic`, which may be infinite.
fn upper(distribution: &impl ContinuousCDF<f64, f64>, statistic: f64) -> f64 {
    if statistic == f64::INFINITY { 0.0 } else { distribution.sf(statistic) }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Adds the part of a direction that is perpendicular to a basis, if there is one; returns whether there is.
fn extend(basis: &mut Vec<Vec<f64>>, mut direction: Vec<f64>) -> bool {
    let length = dot(&direction, &direction).sqrt();
    for _ in 0..2 {
        for known in basis.iter() {
            let along = dot(known, &direction);
            direction.iter_mut().zip(known).for_each(|(d, k)| *d -= along * k);
        }
    }
    let left = dot(&direction, &direction).sqrt();
    let own = left > DEPENDENT * length;
    if own {
        direction.iter_mut().for_each(|d| *d /= left);
        basis.push(direction);
    }
    own
}
