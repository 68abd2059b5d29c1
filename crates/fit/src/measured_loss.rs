//! One measured collision whose loss may be small: exact numbers in, so that `1 - epsilon` keeps its digits.

use crate::FitError;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};

/// The impact velocity of one collision and what was lost of it, from the numbers as they were typed.
///
/// [`Measurement`](crate::Measurement) holds `epsilon`, as tables do; a collision that is inverted alone needs `1 - epsilon`, which
/// rounding spoils where bodies are nearly elastic.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_fit::{FitError, MeasuredLoss};
///
/// let one = BigRational::from_integer(1.into());
/// let nearly = BigRational::new(999_999_999_999_i64.into(), 1_000_000_000_000_i64.into());
/// assert_eq!(MeasuredLoss::of_coefficient(&one, &nearly)?.lost(), 1e-12);
///
/// assert_eq!(MeasuredLoss::of_coefficient(&one, &one), Err(FitError::NothingLost { epsilon: 1.0 }));
/// # Ok::<(), FitError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredLoss {
    velocity: f64,
    lost: f64,
}

impl MeasuredLoss {
    /// From the impact velocity in m/s and the coefficient.
    ///
    /// # Errors
    ///
    /// [`FitError::Velocity`] unless the velocity is positive, [`FitError::NothingLost`] unless `0 < epsilon < 1`.
    pub fn of_coefficient(velocity: &BigRational, epsilon: &BigRational) -> Result<Self, FitError> {
        Self::new(to_f64(velocity), to_f64(&(BigRational::one() - epsilon)))
    }

    /// From the speeds before and after, whatever their signs: `1 - epsilon = 1 - after/before`.
    ///
    /// # Errors
    ///
    /// As [`of_coefficient`](Self::of_coefficient).
    ///
    /// # Examples
    ///
    /// ```
    /// use num_rational::BigRational;
    /// use restitution_fit::{FitError, MeasuredLoss};
    ///
    /// let speed = |n: i64| BigRational::new(n.into(), 10.into());
    /// let found = MeasuredLoss::of_speeds(&speed(-12), &speed(9))?;
    /// assert_eq!((found.velocity(), found.lost()), (1.2, 0.25));
    ///
    /// assert!(MeasuredLoss::of_speeds(&speed(0), &speed(9)).is_err());
    /// # Ok::<(), FitError>(())
    /// ```
    pub fn of_speeds(before: &BigRational, after: &BigRational) -> Result<Self, FitError> {
        let before = positive(before.abs(), |value| FitError::Velocity { value })?;
        let ratio = after.abs() / &before;
        Self::of_coefficient(&before, &ratio)
    }

    /// From the heights of a drop and of its rebound, in m, and the acceleration of gravity, in m/s^2.
    ///
    /// ```text
    /// g = sqrt(2 a h_drop),   1 - epsilon = (1 - q)/(1 + sqrt(q)),   q = h_rebound/h_drop
    /// ```
    ///
    /// Free fall from rest: the drag of the air is left out. Error bound: a few ulp.
    ///
    /// # Errors
    ///
    /// [`FitError::Height`] unless both heights are positive, [`FitError::Gravity`] unless the acceleration is; as
    /// [`of_coefficient`](Self::of_coefficient).
    ///
    /// # Examples
    ///
    /// ```
    /// use num_rational::BigRational;
    /// use restitution_fit::{FitError, MeasuredLoss, STANDARD_GRAVITY};
    ///
    /// let height = |n: i64| BigRational::new(n.into(), 100.into());
    /// let found = MeasuredLoss::of_heights(&height(20), &height(5), STANDARD_GRAVITY)?;
    /// assert!((found.velocity() - 1.9806).abs() < 1e-4 && found.lost() == 0.5);
    ///
    /// let below = MeasuredLoss::of_heights(&height(20), &height(-5), STANDARD_GRAVITY);
    /// assert_eq!(below, Err(FitError::Height { value: -0.05 }));
    /// # Ok::<(), FitError>(())
    /// ```
    pub fn of_heights(drop: &BigRational, rebound: &BigRational, gravity: f64) -> Result<Self, FitError> {
        let height = |value: &BigRational| positive(value.clone(), |value| FitError::Height { value });
        let ratio = height(rebound)? / height(drop)?;
        let velocity = (2.0 * acceleration(gravity)? * to_f64(drop)).sqrt();
        Self::new(velocity, to_f64(&(BigRational::one() - &ratio)) / (1.0 + to_f64(&ratio).sqrt()))
    }

    /// From the times of three successive impacts of a bouncing ball, in s, and the acceleration of gravity, in m/s^2.
    ///
    /// ```text
    /// g = a (t_2 - t_1)/2,   epsilon = (t_3 - t_2)/(t_2 - t_1)
    /// ```
    ///
    /// # Errors
    ///
    /// [`FitError::BounceTimes`] unless they increase, [`FitError::Gravity`]; as [`of_coefficient`](Self::of_coefficient).
    ///
    /// # Examples
    ///
    /// ```
    /// use num_rational::BigRational;
    /// use restitution_fit::{FitError, MeasuredLoss, STANDARD_GRAVITY};
    ///
    /// let times = |times: [i64; 3]| times.map(|n| BigRational::new(n.into(), 4.into()));
    /// let found = MeasuredLoss::of_impacts(&times([4, 6, 7]), STANDARD_GRAVITY)?;
    /// assert_eq!((found.velocity(), found.lost()), (9.80665 * 0.25, 0.5));
    ///
    /// let twice = MeasuredLoss::of_impacts(&times([0, 4, 4]), STANDARD_GRAVITY);
    /// assert_eq!(twice, Err(FitError::BounceTimes { number: 3 }));
    /// # Ok::<(), FitError>(())
    /// ```
    pub fn of_impacts(times: &[BigRational; 3], gravity: f64) -> Result<Self, FitError> {
        let (first, second) = (&times[1] - &times[0], &times[2] - &times[1]);
        if !first.is_positive() || !second.is_positive() {
            return Err(FitError::BounceTimes { number: times.len() });
        }
        let velocity = 0.5 * acceleration(gravity)? * to_f64(&first);
        Self::new(velocity, to_f64(&(BigRational::one() - second / first)))
    }

    fn new(velocity: f64, lost: f64) -> Result<Self, FitError> {
        if !(velocity > 0.0 && velocity.is_finite()) {
            return Err(FitError::Velocity { value: velocity });
        }
        if !(lost > 0.0 && lost < 1.0) {
            return Err(FitError::NothingLost { epsilon: 1.0 - lost });
        }
        Ok(Self { velocity, lost })
    }

    /// The impact velocity, in m/s.
    pub fn velocity(&self) -> f64 {
        self.velocity
    }

    /// `1 - epsilon`.
    pub fn lost(&self) -> f64 {
        self.lost
    }

    /// `epsilon`, rounded.
    pub fn epsilon(&self) -> f64 {
        1.0 - self.lost
    }
}

/// The acceleration of gravity if it is one.
fn acceleration(gravity: f64) -> Result<f64, FitError> {
    if gravity > 0.0 && gravity.is_finite() { Ok(gravity) } else { Err(FitError::Gravity { value: gravity }) }
}

fn positive(value: BigRational, error: impl Fn(f64) -> FitError) -> Result<BigRational, FitError> {
    if value.is_positive() { Ok(value) } else { Err(error(to_f64(&value))) }
}

fn to_f64(value: &BigRational) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}
