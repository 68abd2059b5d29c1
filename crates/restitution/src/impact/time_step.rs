//! The time step that a discrete-element code needs for a wanted error of epsilon.

use crate::bodies::error::positive;
use crate::{MaterialError, ViscoelasticContact};

/// The largest `u` at which the error was measured.
pub const LARGEST_U: f64 = 20.0;
/// The largest step at which it was measured, in units of `tau`.
pub const LARGEST_STEP: f64 = 0.1;
/// The bound is `(FLOOR + GROWTH min(u, 1)) dt/tau`.
const FLOOR: f64 = 0.0025;
const GROWTH: f64 = 0.07;

/// Returns a bound of the error that a time step causes in epsilon, both ends of contact.
///
/// LAMMPS, LIGGGHTS, MercuryDPM, YADE and ESyS-Particle all step
///
/// ```text
/// v_(n+1/2) = v_(n-1/2) + dt F(x_n, v_(n-1/2))/m,   x_(n+1) = x_n + dt v_(n+1/2)
/// ```
///
/// whose dashpot lags half a step behind: the error is of first order. `step` is `dt/tau` with the time unit of
/// [`Contact::time_unit`](crate::Contact::time_unit); a collision lasts 3.2 of them or longer.
///
/// # Error bound
///
/// Measured, not proved: `|error| <= (0.0025 + 0.07 min(u, 1)) dt/tau` for `dt <= tau/10`, `u <= 20` and wherever
/// between two steps the contact begins. The worst ratio of error to bound seen on the grid of
/// `tests/it/time_step.rs`, which runs the codes' scheme, is 0.824.
///
/// # Errors
///
/// [`MaterialError::TimeStepRange`] outside that range.
///
/// # Examples
///
/// ```
/// use restitution::{MaterialError, time_step_error, time_step_for};
///
/// let step = time_step_for(1.0, 1e-4)?; // for an error of at most 1e-4 at u = 1
/// assert!(time_step_error(1.0, step)? <= 1e-4);
///
/// assert!(matches!(time_step_error(1.0, 0.5), Err(MaterialError::TimeStepRange { .. })));
/// # Ok::<(), MaterialError>(())
/// ```
pub fn time_step_error(u: f64, step: f64) -> Result<f64, MaterialError> {
    let growth = error_per_step(u)?;
    if positive("time step", step)? > LARGEST_STEP {
        return Err(MaterialError::TimeStepRange { u, largest: LARGEST_U });
    }
    Ok(growth * step)
}

/// Returns the largest time step, in units of `tau`, whose error of epsilon is at most `error`.
///
/// At most `tau/10`. Take it at the highest impact velocity: slower collisions have a longer `tau` and a
/// smaller `u`, hence a smaller error.
///
/// # Errors
///
/// [`MaterialError::NotPositive`] for an error that is not positive, [`MaterialError::TimeStepRange`] for `u`
/// outside 0..=20.
pub fn time_step_for(u: f64, error: f64) -> Result<f64, MaterialError> {
    Ok((positive("wanted error", error)? / error_per_step(u)?).min(LARGEST_STEP))
}

fn error_per_step(u: f64) -> Result<f64, MaterialError> {
    if !(0.0..=LARGEST_U).contains(&u) {
        return Err(MaterialError::TimeStepRange { u, largest: LARGEST_U });
    }
    Ok(FLOOR + GROWTH * u.min(1.0))
}

/// A time step of a code at one impact velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeStep {
    /// The step `dt`, in s.
    pub seconds: f64,
    /// `dt/tau`, in the time unit of [`Contact::time_unit`](crate::Contact::time_unit).
    pub per_time_unit: f64,
    /// The bound of the error that it causes in epsilon.
    pub error: f64,
}

impl TimeStep {
    /// The step as a share of another time, in s.
    pub fn share_of(&self, seconds: f64) -> f64 {
        self.seconds / seconds
    }
}

impl ViscoelasticContact {
    /// Returns the largest time step at an impact velocity (m/s) whose error of epsilon is at most `error`, by [`time_step_for`].
    ///
    /// # Errors
    ///
    /// Those of [`time_step_for`], and [`MaterialError::NotPositive`] for a velocity that is not positive.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution::{Contact, MaterialError, ViscoelasticContact};
    ///
    /// let pair = ViscoelasticContact::new(Contact::new(0.01, 0.1, 1e9)?, 1e-5)?;
    /// let step = pair.time_step_for(0.5, 1e-4)?;
    /// assert_eq!(pair.time_step(0.5, step.seconds)?.seconds, step.seconds);
    /// assert!((pair.time_step(0.5, step.seconds)?.error / 1e-4 - 1.0).abs() < 1e-12);
    ///
    /// assert!(pair.time_step_for(0.5, 0.0).is_err());
    /// # Ok::<(), MaterialError>(())
    /// ```
    pub fn time_step_for(&self, velocity: f64, error: f64) -> Result<TimeStep, MaterialError> {
        let (u, tau) = (self.u(velocity)?, self.contact().time_unit(velocity)?);
        let per_time_unit = time_step_for(u, error)?;
        Ok(TimeStep {
            seconds: per_time_unit * tau,
            per_time_unit,
            error: time_step_error(u, per_time_unit)?,
        })
    }

    /// Returns what a time step (s) does at an impact velocity (m/s), by [`time_step_error`].
    ///
    /// # Errors
    ///
    /// Those of [`time_step_error`], and [`MaterialError::NotPositive`] for a velocity that is not positive.
    pub fn time_step(&self, velocity: f64, seconds: f64) -> Result<TimeStep, MaterialError> {
        let (u, tau) = (self.u(velocity)?, self.contact().time_unit(velocity)?);
        let per_time_unit = seconds / tau;
        Ok(TimeStep { seconds, per_time_unit, error: time_step_error(u, per_time_unit)? })
    }
}
