//! A viscoelastic contact: Hertz's law and its dissipative constant.

use crate::bodies::error::{at_least_zero, finite, in_range, positive};
use crate::evaluator::tables::constants::{DELTA_OVER_U, ELASTIC_COMPRESSION, ELASTIC_DURATION, SLOPE};
use crate::{Contact, Course, End, MaterialError, Restitution, fifth_root};

/// A contact with the force `rho (xi^(3/2) + (3/2) A sqrt(xi) xi')` (eq. 5 of \[RPBS1999\]).
///
/// # Examples
///
/// ```
/// use restitution::{Contact, End, Material, MaterialError, Sphere, ViscoelasticContact};
///
/// let ice = Material::new(9.4e9, 0.33, 917.0)?;
/// let ball = Sphere::new(ice, 0.0275)?;
/// let contact = Contact::of_spheres(&ball, &ball)?;
/// let pair = ViscoelasticContact::from_measurement(contact, 0.01, 0.5, End::ZeroCompression)?;
/// assert!((pair.epsilon(0.01, End::ZeroCompression)? - 0.5).abs() < 1e-15);
///
/// let impossible = ViscoelasticContact::from_measurement(contact, 0.01, 1.5, End::ZeroCompression);
/// assert_eq!(impossible, Err(MaterialError::Epsilon { value: 1.5 }));
/// # Ok::<(), MaterialError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViscoelasticContact {
    contact: Contact,
    a: f64,
}

impl ViscoelasticContact {
    /// Returns the contact with dissipative constant `a`, in s.
    ///
    /// # Errors
    ///
    /// [`MaterialError::Negative`] for a constant below zero or not finite.
    pub fn new(contact: Contact, a: f64) -> Result<Self, MaterialError> {
        Ok(Self { contact, a: at_least_zero("dissipative constant A", a)? })
    }

    /// Returns the contact whose characteristic velocity is `g_star` (m/s), by eq. (31) solved for `A`.
    ///
    /// # Errors
    ///
    /// [`MaterialError::NotPositive`] or [`MaterialError::OutOfRange`].
    pub fn from_characteristic_velocity(contact: Contact, g_star: f64) -> Result<Self, MaterialError> {
        let root = fifth_root(positive("characteristic velocity g*", g_star)?);
        Self::with_damping(contact, 1.0 / (SLOPE * root))
    }

    /// Returns the contact that rebounds with `epsilon` at impact velocity `velocity` (m/s).
    ///
    /// The inverse of [`epsilon`](Self::epsilon), exact but for rounding: one measured pair fixes `A`.
    ///
    /// # Errors
    ///
    /// [`MaterialError::Epsilon`] unless `0 < epsilon < 1`; [`MaterialError::NotPositive`],
    /// [`MaterialError::OutOfRange`].
    pub fn from_measurement(
        contact: Contact,
        velocity: f64,
        epsilon: f64,
        end: End,
    ) -> Result<Self, MaterialError> {
        let root = fifth_root(positive("velocity", velocity)?);
        Self::with_damping(contact, damping_of(epsilon, end)? / root)
    }

    /// Returns the contact that loses `lost = 1 - epsilon` at impact velocity `velocity` (m/s), for coefficients near 1.
    ///
    /// # Errors
    ///
    /// As [`from_measurement`](Self::from_measurement).
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution::{Contact, End, MaterialError, ViscoelasticContact, one_minus_epsilon};
    ///
    /// let (contact, end) = (Contact::new(0.01, 0.1, 1e9)?, End::ZeroCompression);
    /// let pair = ViscoelasticContact::from_loss(contact, 0.5, 1e-12, end)?; // epsilon = 0.999999999999
    /// assert!((one_minus_epsilon(pair.u(0.5)?, end) / 1e-12 - 1.0).abs() < 1e-14);
    ///
    /// assert_eq!(ViscoelasticContact::from_loss(contact, 0.5, 0.0, end), Err(MaterialError::Epsilon { value: 1.0 }));
    /// # Ok::<(), MaterialError>(())
    /// ```
    pub fn from_loss(contact: Contact, velocity: f64, lost: f64, end: End) -> Result<Self, MaterialError> {
        let root = fifth_root(positive("velocity", velocity)?);
        Self::with_damping(contact, damping_of_loss(lost, end)? / root)
    }

    /// Returns the contact of which a collision at `velocity` (m/s) lost `lost = 1 - epsilon` and lasted `duration` (s).
    ///
    /// The coefficient gives `u`, the duration the time unit, and both together the force without any elastic constant:
    ///
    /// ```text
    /// tau = t_c/T(u),   rho = m_eff tau^(-5/2) g^(-1/2),   A = (2/3) u tau
    /// ```
    ///
    /// with the duration `T(u)` of the scaled collision ([`Course`]).
    ///
    /// # Errors
    ///
    /// As [`from_measurement`](Self::from_measurement); [`MaterialError::NotFollowed`] for `u` beyond [`LARGEST_FOLLOWED_U`](crate::LARGEST_FOLLOWED_U).
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution::{Contact, End, MaterialError, ViscoelasticContact};
    ///
    /// let pair = ViscoelasticContact::new(Contact::new(0.01, 0.1, 1e9)?, 1e-5)?;
    /// let end = End::ZeroForce;
    /// let (lost, duration) = (1.0 - pair.epsilon(0.5, end)?, pair.course(0.5, end)?.unwrap().duration);
    /// let found = ViscoelasticContact::from_duration(0.01, 0.1, 0.5, lost, duration, end)?;
    /// assert!((found.dissipative_constant() / 1e-5 - 1.0).abs() < 1e-12);
    /// assert!((found.contact().effective_modulus() / 1e9 - 1.0).abs() < 1e-12);
    ///
    /// assert!(ViscoelasticContact::from_duration(0.01, 0.1, 0.5, lost, 0.0, end).is_err());
    /// # Ok::<(), MaterialError>(())
    /// ```
    pub fn from_duration(
        radius: f64,
        mass: f64,
        velocity: f64,
        lost: f64,
        duration: f64,
        end: End,
    ) -> Result<Self, MaterialError> {
        let u = damping_of_loss(lost, end)?;
        let scaled = Course::follow(u, end).ok_or(MaterialError::NotFollowed { u })?;
        let tau = positive("duration", duration)? / scaled.duration;
        let rho =
            positive("effective mass", mass)? / (tau * tau * (tau * positive("velocity", velocity)?).sqrt());
        let contact = Contact::with_prefactor(radius, mass, in_range("force prefactor", rho)?)?;
        Self::new(contact, in_range("dissipative constant A", u * tau / 1.5)?)
    }

    /// Returns the contact with `u = damping g^(1/5)`.
    fn with_damping(contact: Contact, damping: f64) -> Result<Self, MaterialError> {
        let a = in_range("dissipative constant A", damping / (1.5 * contact.rate()))?;
        Self::new(contact, a)
    }

    /// The elastic contact.
    pub fn contact(&self) -> &Contact {
        &self.contact
    }

    /// The dissipative constant `A`, in s.
    pub fn dissipative_constant(&self) -> f64 {
        self.a
    }

    /// The damping parameter `u = (3/2) A (rho/m_eff)^(2/5) g^(1/5)` at impact velocity `velocity` (m/s).
    ///
    /// # Errors
    ///
    /// [`MaterialError::Negative`] for a velocity below zero, [`MaterialError::OutOfRange`].
    pub fn u(&self, velocity: f64) -> Result<f64, MaterialError> {
        let u = 1.5 * self.a * self.contact.rate() * fifth_root(at_least_zero("velocity", velocity)?);
        finite("damping parameter u", u)
    }

    /// The coefficient `delta = (5/4)^(3/5) u` of the dimensionless equation (10), eq. (14).
    ///
    /// # Errors
    ///
    /// As [`u`](Self::u).
    pub fn delta(&self, velocity: f64) -> Result<f64, MaterialError> {
        finite("coefficient delta", DELTA_OVER_U * self.u(velocity)?)
    }

    /// The characteristic velocity `g* = (1.15344... (3/2) A (rho/m_eff)^(2/5))^(-5)` of eq. (31), in m/s.
    ///
    /// # Errors
    ///
    /// [`MaterialError::OutOfRange`] if there is no damping, or so little that f64 cannot hold `g*`.
    pub fn characteristic_velocity(&self) -> Result<f64, MaterialError> {
        let slope = SLOPE * 1.5 * self.a * self.contact.rate();
        in_range("characteristic velocity g*", slope.powi(5)).map(f64::recip)
    }

    /// The coefficient of restitution at impact velocity `velocity` (m/s).
    ///
    /// # Errors
    ///
    /// As [`u`](Self::u).
    pub fn epsilon(&self, velocity: f64, end: End) -> Result<f64, MaterialError> {
        Ok(crate::epsilon(self.u(velocity)?, end))
    }

    /// The same as a function of velocity alone, for the inner loop of a simulation.
    ///
    /// NaN at every velocity if there is no damping, or so little or so much of it that `u_1^5` is beyond f64.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution::{Contact, End, MaterialError, ViscoelasticContact};
    ///
    /// let pair = ViscoelasticContact::new(Contact::new(0.01, 0.1, 1e9)?, 1e-6)?;
    /// let curve = pair.restitution(End::ZeroForce);
    /// assert!((curve.epsilon(0.2) - pair.epsilon(0.2, End::ZeroForce)?).abs() < 1e-15);
    ///
    /// let elastic = ViscoelasticContact::new(*pair.contact(), 0.0)?;
    /// assert!(elastic.restitution(End::ZeroForce).epsilon(0.2).is_nan());
    /// # Ok::<(), MaterialError>(())
    /// ```
    pub fn restitution(&self, end: End) -> Restitution {
        Restitution::from_u_at_unit_velocity(1.5 * self.a * self.contact.rate(), end)
    }

    /// The duration of the collision without damping, `2 T tau = 3.218... tau`, in s; closed form.
    ///
    /// # Errors
    ///
    /// As [`Contact::time_unit`].
    pub fn elastic_duration(&self, velocity: f64) -> Result<f64, MaterialError> {
        in_range("duration", ELASTIC_DURATION * self.contact.time_unit(velocity)?)
    }

    /// The maximal compression without damping, `(5/4)^(2/5) g tau`, in m; closed form.
    ///
    /// Damping can only lower it: the kinetic energy has to pay for both.
    ///
    /// # Errors
    ///
    /// As [`Contact::time_unit`].
    pub fn elastic_compression(&self, velocity: f64) -> Result<f64, MaterialError> {
        in_range("maximal compression", ELASTIC_COMPRESSION * velocity * self.contact.time_unit(velocity)?)
    }

    /// The course of the damped collision, in s and m; `None` for `u` beyond [`LARGEST_FOLLOWED_U`](crate::LARGEST_FOLLOWED_U).
    ///
    /// # Errors
    ///
    /// As [`u`](Self::u) and [`Contact::time_unit`].
    pub fn course(&self, velocity: f64, end: End) -> Result<Option<Course>, MaterialError> {
        let time = self.contact.time_unit(velocity)?;
        let Some(course) = Course::follow(self.u(velocity)?, end) else {
            return Ok(None);
        };
        Ok(Some(Course {
            time_to_turning: in_range("time to the turning point", time * course.time_to_turning)?,
            maximal_compression: in_range(
                "maximal compression",
                velocity * time * course.maximal_compression,
            )?,
            duration: in_range("duration", time * course.duration)?,
        }))
    }
}

/// Returns the characteristic velocity `g*` at which one measured pair fixes the whole curve.
///
/// `g* = g/(1.15344... u)^5` with `u` from `epsilon`; no material is needed.
///
/// # Errors
///
/// As [`ViscoelasticContact::from_measurement`].
///
/// # Examples
///
/// ```
/// use restitution::{End, MaterialError, characteristic_velocity_from};
///
/// let g_star = characteristic_velocity_from(0.01, 0.55, End::ZeroCompression)?;
/// assert!(g_star > 0.0);
///
/// let nothing = characteristic_velocity_from(0.01, 1.0, End::ZeroCompression);
/// assert_eq!(nothing, Err(MaterialError::Epsilon { value: 1.0 }));
/// # Ok::<(), MaterialError>(())
/// ```
pub fn characteristic_velocity_from(velocity: f64, epsilon: f64, end: End) -> Result<f64, MaterialError> {
    let s = SLOPE * damping_of(epsilon, end)?;
    in_range("characteristic velocity g*", positive("velocity", velocity)? / s.powi(5))
}

/// Returns the characteristic velocity of a collision that lost `lost = 1 - epsilon`, for coefficients near 1.
///
/// # Errors
///
/// As [`characteristic_velocity_from`].
///
/// # Examples
///
/// ```
/// use restitution::{End, characteristic_velocity_from, characteristic_velocity_from_loss};
///
/// let end = End::ZeroForce;
/// let one = characteristic_velocity_from_loss(0.5, 0.25, end)?;
/// assert!((one / characteristic_velocity_from(0.5, 0.75, end)? - 1.0).abs() < 1e-14);
/// assert!(characteristic_velocity_from_loss(0.5, 0.0, end).is_err());
/// # Ok::<(), restitution::MaterialError>(())
/// ```
pub fn characteristic_velocity_from_loss(velocity: f64, lost: f64, end: End) -> Result<f64, MaterialError> {
    let s = SLOPE * damping_of_loss(lost, end)?;
    in_range("characteristic velocity g*", positive("velocity", velocity)? / s.powi(5))
}

fn damping_of(epsilon: f64, end: End) -> Result<f64, MaterialError> {
    if !(epsilon > 0.0 && epsilon < 1.0) {
        return Err(MaterialError::Epsilon { value: epsilon });
    }
    in_range("damping parameter u", crate::u_of_epsilon(epsilon, end))
}

fn damping_of_loss(lost: f64, end: End) -> Result<f64, MaterialError> {
    if !(lost > 0.0 && lost < 1.0) {
        return Err(MaterialError::Epsilon { value: 1.0 - lost });
    }
    in_range("damping parameter u", crate::u_of_one_minus_epsilon(lost, end))
}
