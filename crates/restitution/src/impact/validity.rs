//! Whether a collision is one that the theory is about.

use crate::bodies::error::{finite, positive};
use crate::{End, Material, MaterialError, ViscoelasticContact};

/// The ratio below which a condition "much smaller" is said to hold: a choice, not a theorem.
const MUCH_SMALLER: f64 = 0.1;
/// The ratio above which it is said to be violated: a choice, too.
const COMPARABLE: f64 = 1.0 / 3.0;

/// What a ratio says about a condition "much smaller than".
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The ratio is below 0.1.
    Holds,
    /// The ratio is between 0.1 and 1/3.
    Doubtful,
    /// The ratio is above 1/3.
    Violated,
}

impl Verdict {
    /// Judges a ratio that should be much smaller than 1; NaN is a violation.
    pub fn of(ratio: f64) -> Self {
        if ratio < MUCH_SMALLER {
            Self::Holds
        } else if ratio <= COMPARABLE {
            Self::Doubtful
        } else {
            Self::Violated
        }
    }
}

/// The ratios that the theory wants to be small, at one impact velocity.
///
/// Conditions (i) and (ii) of section II of \[RPBS1999\] ask for stresses linear in strain and strain rate, and
/// Hertz's law for a contact small against the spheres: the ratio at hand is that of the contact radius to the
/// effective radius. Condition (iii) asks for quasistatic motion, `g << c` and `tau_vis << t_c`.
///
/// # Examples
///
/// ```
/// use restitution::{Contact, End, Material, MaterialError, Sphere, Validity, Verdict, ViscoelasticContact};
///
/// let ice = Material::new(9.4e9, 0.33, 917.0)?;
/// let ball = Sphere::new(ice, 0.0275)?;
/// let contact = Contact::of_spheres(&ball, &ball)?;
/// let pair = ViscoelasticContact::from_characteristic_velocity(contact, 0.003)?;
/// let slow = Validity::of(&pair, &ice, 0.01)?;
/// assert_eq!(Verdict::of(slow.velocity_over_sound), Verdict::Holds);
///
/// assert!(matches!(Validity::of(&pair, &ice, 0.0), Err(MaterialError::NotPositive { .. })));
/// # Ok::<(), MaterialError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Validity {
    /// Impact velocity over the speed of sound, `g/c`.
    pub velocity_over_sound: f64,
    /// Relaxation time over duration, `A/t_c`.
    ///
    /// `A` is the relaxation time where one time governs all of the stress. Since `t_c = 3.218... tau` up to
    /// damping, the ratio is `0.207 u` to first order: the condition is one on `u` alone.
    pub relaxation_over_duration: f64,
    /// Contact radius over effective radius, `sqrt(xi_max/R_eff)`.
    pub contact_over_radius: f64,
}

impl Validity {
    /// Computes the ratios; `material` is the softer of the two bodies'.
    ///
    /// The duration and the compression are those of the damped collision, or, for `u` beyond
    /// [`LARGEST_FOLLOWED_U`](crate::LARGEST_FOLLOWED_U), of the undamped one.
    ///
    /// # Errors
    ///
    /// [`MaterialError::NotPositive`] for a velocity that is not positive; [`MaterialError::OutOfRange`].
    pub fn of(pair: &ViscoelasticContact, material: &Material, velocity: f64) -> Result<Self, MaterialError> {
        let velocity = positive("velocity", velocity)?;
        let (compression, duration) = match pair.course(velocity, End::ZeroForce)? {
            Some(course) => (course.maximal_compression, course.duration),
            None => (pair.elastic_compression(velocity)?, pair.elastic_duration(velocity)?),
        };
        Ok(Self {
            velocity_over_sound: finite(
                "velocity over the speed of sound",
                velocity / material.sound_speed(),
            )?,
            relaxation_over_duration: finite(
                "relaxation time over duration",
                pair.dissipative_constant() / duration,
            )?,
            contact_over_radius: finite(
                "contact radius over effective radius",
                (compression / pair.contact().effective_radius()).sqrt(),
            )?,
        })
    }

    /// The three ratios with what they compare.
    pub fn ratios(&self) -> [(&'static str, f64); 3] {
        [
            ("velocity / sound speed", self.velocity_over_sound),
            ("relaxation time / duration", self.relaxation_over_duration),
            ("contact radius / effective radius", self.contact_over_radius),
        ]
    }
}
