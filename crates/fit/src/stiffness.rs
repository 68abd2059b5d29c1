//! Stiffness and damping of a contact, from how long the collisions last.

use crate::fit::quantile;
use crate::{Fit, FitError, Measurement};
use restitution::{Contact, Course, End, LARGEST_FOLLOWED_U, MaterialError};

/// Up to so many rows each duration is integrated; beyond, they are interpolated in a table of as many.
const INTEGRATED: usize = 512;

/// The force of a contact per effective mass, from the durations of its collisions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stiffness {
    /// `rho/m_eff` of the force `rho (xi^(3/2) + (3/2) A sqrt(xi) xi')`, in m^(-1/2) s^(-2).
    pub per_mass: f64,
    /// Its interval of 95 % confidence.
    pub per_mass_interval: (f64, f64),
    /// The dissipative constant `A`, in s.
    pub dissipative_constant: f64,
    /// Its interval of 95 % confidence.
    pub dissipative_interval: (f64, f64),
    /// The standard deviation of the durations, relative to what they should be.
    pub scatter: f64,
    /// The rows whose durations were used.
    pub rows: usize,
    /// The rows left out because their damping is beyond `u = 20`, up to which durations are known.
    pub beyond: usize,
}

impl Stiffness {
    /// The relative standard error of [`per_mass`](Self::per_mass), a quarter of its interval.
    pub fn per_mass_error(&self) -> f64 {
        quarter(self.per_mass_interval)
    }

    /// The relative standard error of [`dissipative_constant`](Self::dissipative_constant), a quarter of its interval.
    pub fn dissipative_error(&self) -> f64 {
        quarter(self.dissipative_interval)
    }

    /// Returns the elastic contact of bodies with this effective radius (m) and mass (kg).
    ///
    /// # Errors
    ///
    /// [`MaterialError::NotPositive`], [`MaterialError::OutOfRange`].
    pub fn contact(&self, radius: f64, mass: f64) -> Result<Contact, MaterialError> {
        Contact::with_prefactor(radius, mass, self.per_mass * mass)
    }
}

fn quarter((low, high): (f64, f64)) -> f64 {
    0.25 * (high / low).ln()
}

/// Fits stiffness and damping to durations (s) of the collisions to which `fit` was made; `unit_size` is that of its velocities in m/s.
///
/// With `u = b g^(1/5)` from the coefficients, a contact lasts `t_c = T(u) tau`, `tau = (m_eff/rho)^(2/5) g^(-1/5)`, so that
///
/// ```text
/// L = mean of ln t_c + (1/5) ln g - ln T(u),   rho/m_eff = e^(-5 L/2),   A = (2/3) b e^L
/// ```
///
/// with the duration `T(u)` of the scaled collision ([`Course`]).
///
/// # Error bound
///
/// The intervals suppose equal relative noise of the durations, independent of that of the coefficients: with `c` the mean of `d ln T/d ln u`,
/// `var(ln rho/m_eff) = (25/4) (var(L) + c^2 var(ln b))` and `var(ln A) = var(L) + (1-c)^2 var(ln b)`. How often they held the
/// truth: docs/materials.md.
///
/// # Errors
///
/// [`FitError::TooFewRows`] if fewer than two rows are below `u = 20`; [`FitError::Durations`] for another number of durations than of rows;
/// [`FitError::Duration`], [`FitError::OutOfRange`].
///
/// # Examples
///
/// ```
/// use restitution::{Contact, End, ViscoelasticContact};
/// use restitution_fit::{FitError, Loss, Measurement, fit, stiffness};
///
/// let (pair, end) = (ViscoelasticContact::new(Contact::new(0.01, 0.1, 1e9).unwrap(), 1e-5).unwrap(), End::ZeroCompression);
/// let rows = [0.1, 1.0].map(|g| Measurement::new(g, pair.epsilon(g, end).unwrap()).unwrap());
/// let durations = [0.1, 1.0].map(|g| pair.course(g, end).unwrap().unwrap().duration);
/// let fitted = fit(&rows, end, Loss::Squares)?;
/// let found = stiffness(&rows, &durations, 1.0, &fitted)?;
/// assert!((found.dissipative_constant / 1e-5 - 1.0).abs() < 1e-9);
///
/// assert!(matches!(stiffness(&rows, &durations[..1], 1.0, &fitted), Err(FitError::Durations { .. })));
/// # Ok::<(), FitError>(())
/// ```
pub fn stiffness(
    rows: &[Measurement],
    durations: &[f64],
    unit_size: f64,
    fit: &Fit,
) -> Result<Stiffness, FitError> {
    if rows.len() != durations.len() {
        return Err(FitError::Durations { rows: rows.len(), durations: durations.len() });
    }
    if let Some(value) = durations.iter().copied().find(|t| !(*t > 0.0 && t.is_finite())) {
        return Err(FitError::Duration { value });
    }
    let curve = fit.curve();
    let known = rows.iter().zip(durations).map(|(row, t)| (curve.u(row.velocity()), row.velocity(), *t));
    let known = known.filter(|(u, ..)| *u <= LARGEST_FOLLOWED_U).collect::<Vec<_>>();
    if known.len() < 2 {
        return Err(FitError::TooFewRows { rows: known.len() });
    }
    let table = Durations::of(known.iter().map(|(u, ..)| *u), fit.end);
    let n = known.len() as f64;
    let single = known.iter().map(|(u, g, t)| t.ln() + 0.2 * (g * unit_size).ln() - table.ln(*u));
    let single = single.collect::<Vec<_>>();
    let mean = single.iter().sum::<f64>() / n;
    let scatter = (single.iter().map(|l| (l - mean).powi(2)).sum::<f64>() / (n - 1.0)).sqrt();
    let slope = known.iter().map(|(u, ..)| table.slope(*u)).sum::<f64>() / n;
    let (own, of_b) = (scatter * scatter / n, (fit.log_error / 5.0).powi(2));
    let quantile = quantile(false, n - 1.0);
    let around = |value: f64, variance: f64| {
        let width = (quantile * variance.sqrt()).exp();
        (value / width, value * width)
    };
    // u = b g^(1/5) with g in m/s
    let b = curve.u(1.0) * unit_size.powf(-0.2);
    let (per_mass, dissipative_constant) = ((-2.5 * mean).exp(), b * mean.exp() / 1.5);
    if !per_mass.is_normal() || !dissipative_constant.is_normal() {
        return Err(FitError::OutOfRange);
    }
    Ok(Stiffness {
        per_mass,
        per_mass_interval: around(per_mass, 6.25 * (own + slope * slope * of_b)),
        dissipative_constant,
        dissipative_interval: around(dissipative_constant, own + (1.0 - slope).powi(2) * of_b),
        scatter,
        rows: known.len(),
        beyond: rows.len() - known.len(),
    })
}

/// The logarithm of the scaled duration as a function of `u`.
enum Durations {
    /// One integration for each value.
    Integrated(End),
    /// A table over `u` at equal distances in `sqrt(u)`: the first place, the distance, the values.
    Table(f64, f64, Vec<f64>),
}

impl Durations {
    fn of(values: impl ExactSizeIterator<Item = f64> + Clone, end: End) -> Self {
        if values.len() <= INTEGRATED {
            return Self::Integrated(end);
        }
        let range = values.fold((f64::INFINITY, 0.0_f64), |(low, high), u| (low.min(u), high.max(u)));
        let (low, high) = ((0.9 * range.0).sqrt(), (1.02 * range.1).min(LARGEST_FOLLOWED_U).sqrt());
        let step = (high - low) / (INTEGRATED - 1) as f64;
        let place = |k: usize| (low + step * k as f64).min(high).powi(2).min(LARGEST_FOLLOWED_U);
        Self::Table(low, step, (0..INTEGRATED).map(|k| integrated(place(k), end)).collect())
    }

    fn ln(&self, u: f64) -> f64 {
        match self {
            Self::Integrated(end) => integrated(u, *end),
            Self::Table(low, step, values) => {
                let x = (u.sqrt() - low) / step;
                let first = (x as usize).clamp(1, values.len() - 3) - 1;
                let t = x - first as f64; // Lagrange on four places around
                let [a, b, c, d] = [0, 1, 2, 3].map(|k| values[first + k]);
                let (t1, t2, t3) = (t - 1.0, t - 2.0, t - 3.0);
                -a * t1 * t2 * t3 / 6.0 + b * t * t2 * t3 / 2.0 - c * t * t1 * t3 / 2.0
                    + d * t * t1 * t2 / 6.0
            }
        }
    }

    /// `d ln T/d ln u`.
    fn slope(&self, u: f64) -> f64 {
        const H: f64 = 1e-3;
        let (below, above) = (u * (1.0 - H), (u * (1.0 + H)).min(LARGEST_FOLLOWED_U));
        (self.ln(above) - self.ln(below)) / (above / below).ln()
    }
}

fn integrated(u: f64, end: End) -> f64 {
    Course::follow(u, end).map_or(f64::NAN, |course| course.duration.ln())
}
