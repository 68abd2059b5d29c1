//! One collision as it was measured.

use crate::FitError;
use restitution::Restitution;

/// The largest coefficient that is taken for a noisy measurement: beyond it the rebound has four times the
/// energy of the impact, and a percentage or a wrong column is likelier than noise.
pub const LARGEST_MEASURED_EPSILON: f64 = 2.0;
/// The standard acceleration of gravity, in m/s^2 (3rd CGPM, 1901).
pub const STANDARD_GRAVITY: f64 = 9.806_65;

/// One measured pair: impact velocity `g` and coefficient of restitution, perhaps with its standard deviation.
///
/// # Examples
///
/// ```
/// use restitution_fit::{FitError, Measurement};
///
/// let noisy = Measurement::new(0.001, 1.02)?; // noise may lift a coefficient above 1
/// assert_eq!(noisy.epsilon(), 1.02);
///
/// assert_eq!(Measurement::new(0.001, 57.0), Err(FitError::Epsilon { value: 57.0 }));
/// # Ok::<(), FitError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    velocity: f64,
    epsilon: f64,
    sigma: Option<f64>,
}

impl Measurement {
    /// Returns the pair of impact velocity (m/s, or any unit: `g*` comes out in the same) and coefficient.
    ///
    /// # Errors
    ///
    /// [`FitError::Velocity`] for a velocity that is not positive and finite, [`FitError::Epsilon`] for a
    /// coefficient outside (0, 2].
    pub fn new(velocity: f64, epsilon: f64) -> Result<Self, FitError> {
        if !(velocity > 0.0 && velocity.is_finite()) {
            return Err(FitError::Velocity { value: velocity });
        }
        if !(epsilon > 0.0 && epsilon <= LARGEST_MEASURED_EPSILON) {
            return Err(FitError::Epsilon { value: epsilon });
        }
        Ok(Self { velocity, epsilon, sigma: None })
    }

    /// The same with the standard deviation of the coefficient.
    ///
    /// # Errors
    ///
    /// [`FitError::Sigma`] unless it is positive and finite.
    pub fn with_sigma(self, sigma: f64) -> Result<Self, FitError> {
        if sigma > 0.0 && sigma.is_normal() {
            Ok(Self { sigma: Some(sigma), ..self })
        } else {
            Err(FitError::Sigma { value: sigma })
        }
    }

    /// From the speeds before and after: `epsilon = after/before`, whatever their signs.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_fit::Measurement;
    ///
    /// assert_eq!(Measurement::of_speeds(-2.0, 1.0)?, Measurement::new(2.0, 0.5)?);
    /// assert!(Measurement::of_speeds(0.0, 1.0).is_err());
    /// # Ok::<(), restitution_fit::FitError>(())
    /// ```
    pub fn of_speeds(before: f64, after: f64) -> Result<Self, FitError> {
        Self::new(before.abs(), after.abs() / before.abs())
    }

    /// From the heights of a drop and of its rebound, in one unit, with the acceleration of gravity to match.
    ///
    /// ```text
    /// g = sqrt(2 a h_drop),   epsilon = sqrt(h_rebound/h_drop)
    /// ```
    ///
    /// Free fall from rest: the drag of the air is left out, and makes `epsilon` come out too small.
    ///
    /// # Errors
    ///
    /// [`FitError::Height`] unless both heights are positive and finite; as [`new`](Self::new).
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_fit::{Measurement, STANDARD_GRAVITY};
    ///
    /// let drop = Measurement::of_heights(0.2, 0.05, STANDARD_GRAVITY)?;
    /// assert!((drop.velocity() - 1.9806).abs() < 1e-4 && drop.epsilon() == 0.5);
    ///
    /// assert!(Measurement::of_heights(0.2, -0.05, STANDARD_GRAVITY).is_err());
    /// # Ok::<(), restitution_fit::FitError>(())
    /// ```
    pub fn of_heights(drop: f64, rebound: f64, gravity: f64) -> Result<Self, FitError> {
        for value in [drop, rebound] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(FitError::Height { value });
            }
        }
        Self::new((2.0 * gravity * drop).sqrt(), (rebound / drop).sqrt())
    }

    /// The impact velocity.
    pub fn velocity(&self) -> f64 {
        self.velocity
    }

    /// The coefficient of restitution.
    pub fn epsilon(&self) -> f64 {
        self.epsilon
    }

    /// By how much the coefficient exceeds that of a curve, whose velocities have the same unit.
    pub fn residual(&self, curve: &Restitution) -> f64 {
        self.epsilon - curve.epsilon(self.velocity)
    }

    /// The standard deviation of the coefficient, if it is known.
    pub fn sigma(&self) -> Option<f64> {
        self.sigma
    }
}

/// Returns the collisions of a ball left to bounce, from the times of its impacts.
///
/// Between impacts at `t_k` and `t_(k+1)` the ball flies for `T_k`, leaves and returns with `a T_k/2`; so
///
/// ```text
/// g_k = a T_(k-1)/2,   epsilon_k = T_k/T_(k-1)
/// ```
///
/// at the impact of `t_k`: `n` times make `n - 2` collisions. Drag and the duration of the contacts are left out.
///
/// # Errors
///
/// [`FitError::BounceTimes`] for fewer than three times or times that do not increase; as [`Measurement::new`].
///
/// # Examples
///
/// ```
/// use restitution_fit::{bounces, STANDARD_GRAVITY};
///
/// let collisions = bounces(&[0.0, 0.4, 0.7, 0.9], STANDARD_GRAVITY)?;
/// assert_eq!(collisions.len(), 2);
/// assert!((collisions[0].epsilon() - 0.75).abs() < 1e-12);
/// assert!((collisions[0].velocity() - 9.80665 * 0.2).abs() < 1e-12);
///
/// assert!(bounces(&[0.0, 0.4], STANDARD_GRAVITY).is_err());
/// # Ok::<(), restitution_fit::FitError>(())
/// ```
pub fn bounces(times: &[f64], gravity: f64) -> Result<Vec<Measurement>, FitError> {
    if times.len() < 3 {
        return Err(FitError::BounceTimes { number: times.len() });
    }
    let flights = times.windows(2).map(|pair| pair[1] - pair[0]).collect::<Vec<_>>();
    if !flights.iter().all(|flight| *flight > 0.0 && flight.is_finite()) {
        return Err(FitError::BounceTimes { number: times.len() });
    }
    flights.windows(2).map(|pair| Measurement::new(0.5 * gravity * pair[0], pair[1] / pair[0])).collect()
}
