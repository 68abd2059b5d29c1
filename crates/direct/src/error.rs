use num_rational::BigRational;
use restitution_law::ForceLaw;
use restitution_real::RealError;

/// Why a collision could not be integrated.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DirectError {
    /// The damping is negative or not a finite number.
    #[error("the damping u must be a number >= 0, not {u}")]
    Damping {
        /// The damping that was given, to a few digits.
        u: String,
    },
    /// An impact velocity that is negative.
    #[error("the impact velocity is negative: give its size")]
    NegativeVelocity,
    /// A velocity at which the damping is infinite.
    #[error("at velocity 0 the damping of this law is infinite: give a positive velocity")]
    InfiniteDamping,
    /// A constant of the bodies that must be positive.
    #[error("{what} must be positive")]
    NotPositive {
        /// What must be positive.
        what: &'static str,
    },
    /// No step could be proved any more at this precision.
    #[error("no step of the integration could be proved below a length of {length}: give a less extreme u")]
    StepVanished {
        /// The last length that was tried.
        length: String,
    },
    /// The damping stops the rebound: the bodies approach zero compression without reaching it.
    #[error(
        "with u = {u} and the law {law} the bodies never separate, the restitution coefficient is 0: give a smaller u, or end the contact at zero force"
    )]
    Overdamped {
        /// The force law.
        law: Box<ForceLaw>,
        /// The damping that was given, to a few digits.
        u: String,
    },
    /// The coefficient is positive and smaller than any number that can be held.
    #[error(
        "with u = {u} and the law {law} the restitution coefficient is positive and below 10^-300000000, too small to be given: give a smaller u"
    )]
    Vanishing {
        /// The force law.
        law: Box<ForceLaw>,
        /// The damping that was given, to a few digits.
        u: String,
    },
    /// The steps that can be proved are too short to follow the motion.
    #[error(
        "the motion was not followed to its end in {steps} steps: give a less extreme u, or end the contact at zero force"
    )]
    Stiff {
        /// The steps that were taken.
        steps: u32,
    },
    /// At no precision that was tried could the motion be told from one that comes to rest.
    #[error(
        "the rebound is so faint that {bits} bits do not tell it from rest: give a smaller u, or end the contact at zero force"
    )]
    Faint {
        /// The working precision that was reached.
        bits: u32,
    },
    /// The force has no zero on the way out that this end of the contact could mean.
    #[error(
        "with the law {law} the force need not vanish on the way out: the end at zero force needs A > GAMMA"
    )]
    NoZeroForce {
        /// The force law.
        law: Box<ForceLaw>,
    },
    /// An interval, a degree or a precision that an interpolant cannot have.
    #[error(
        "an interpolant needs 0 <= from <= to, a degree of at most 100 and 40 to 20000 bits, not {interval}"
    )]
    Interval {
        /// What was asked for.
        interval: String,
    },
    /// The motion has a branch point at zero compression.
    #[error(
        "no interpolant for the law {law}: it needs (GAMMA+1)/(A+1) as a fraction of numbers up to 12; enclose single dampings instead"
    )]
    NoInterpolant {
        /// The force law.
        law: Box<ForceLaw>,
    },
    /// The exit speed does not saturate for this law.
    #[error(
        "the law {law} has no finite exit speed at high velocity: it needs A > GAMMA and 2 GAMMA > A - 1"
    )]
    NoSaturation {
        /// The force law.
        law: Box<ForceLaw>,
    },
    /// The exit speed saturates, but too slowly to be followed.
    #[error(
        "the exit speed of the law {law} saturates too slowly to be computed: choose a law whose velocity exponent is larger than {exponent}"
    )]
    SlowSaturation {
        /// The force law.
        law: Box<ForceLaw>,
        /// The exponent `p` with which `u ~ g^p`.
        exponent: Box<BigRational>,
    },
    /// The digits asked for were not reached.
    #[error(transparent)]
    Real(#[from] RealError),
}
