//! The coefficient of restitution of viscoelastic spheres in f64: fast, with a stated bound.
//!
//! Two spheres meet at the velocity `g` and part at `epsilon g`. All that `epsilon` depends on is one number,
//! `u = (3/2) A (rho/m_eff)^(2/5) g^(1/5)`, and the end of the contact, [`End`]. The crate has four rooms:
//!
//! | room | to know | ask |
//! |---|---|---|
//! | evaluator | `epsilon` at a damping, and what it is short of one | [`epsilon`], [`one_minus_epsilon`], [`epsilon_batch`] |
//! | | `epsilon` at a velocity | [`Restitution`], from `g*` |
//! | | the damping of a measured `epsilon` | [`u_of_epsilon`], [`u_of_one_minus_epsilon`], [`u_of_epsilon_batch`] |
//! | | `epsilon` to 3, 6 or 9 digits, for less time | [`tiers`] |
//! | bodies | what a material does | [`Material`], [`Contact`], [`dissipative_constant`] |
//! | impact | how a collision goes, and whether the model holds | [`ViscoelasticContact`], [`Course`], [`Validity`] |
//! | | which time step a simulation may take | [`time_step_for`], [`time_step_error`] |
//! | codes | what to tell a simulation code | [`codes`] |
//!
//! The evaluator needs neither `std` nor an allocator; the other rooms need the feature `std`, which is on by default.
//!
//! What most people need:
//!
//! ```
//! use restitution::{End, Restitution, epsilon_batch};
//!
//! // from a characteristic velocity, in m/s
//! let ice = Restitution::from_g_star(0.0046, End::ZeroCompression);
//! let (epsilon, u) = (ice.epsilon(0.01), ice.u(0.01));
//! assert!(0.3 < epsilon && epsilon < 0.4 && u > 1.0);
//!
//! // many at once, here from the damping
//! let mut values = [0.0; 3];
//! epsilon_batch(&[0.0, u, 1e3], &mut values, End::ZeroCompression);
//! assert!(values[0] == 1.0 && (values[1] - epsilon).abs() < 1e-15);
//! ```
//!
//! and from one measurement to any other velocity:
//!
//! ```
//! # #[cfg(feature = "std")]
//! # fn main() -> Result<(), restitution::MaterialError> {
//! use restitution::{Contact, End, ViscoelasticContact};
//!
//! let pair = Contact::new(0.0025, 6.5e-4, 5.5e8)?; // R_eff in m, m_eff in kg, E in Pa
//! let pair = ViscoelasticContact::from_measurement(pair, 0.5, 0.6, End::ZeroForce)?; // 0.6 at 0.5 m/s
//! assert!(pair.epsilon(1.0, End::ZeroForce)? < 0.6);
//! assert!(pair.epsilon(-1.0, End::ZeroForce).is_err());
//! # Ok(())
//! # }
//! # #[cfg(not(feature = "std"))]
//! # fn main() {}
//! ```
//!
//! # How large an error can be
//!
//! [`bounds`] holds every bound of the evaluator once, with what it rests on and the test that keeps it; documents and
//! comments are compared with it. The main ones: [`epsilon`] has [`EPSILON`](crate::bounds::EPSILON), at most 2 ulp (proved) but at zero force
//! beyond `u = 1023.99`; [`one_minus_epsilon`] has [`ONE_MINUS_EPSILON`](crate::bounds::ONE_MINUS_EPSILON), at most 3 ulp (proved); from a velocity
//! it is [`EPSILON_OF_VELOCITY`](crate::bounds::EPSILON_OF_VELOCITY), at most 3 ulp (proved). A batch gives the bits of single calls; a tier keeps its
//! [`tolerance`](tiers::Tier::tolerance).
#![cfg_attr(not(feature = "std"), no_std)]

mod evaluator;

#[cfg(feature = "std")]
mod bodies;
#[cfg(feature = "std")]
pub mod codes;
#[cfg(feature = "std")]
mod impact;

#[doc(hidden)]
pub use evaluator::forms;
pub use evaluator::{
    End, Restitution, bounds, epsilon, epsilon_batch, fifth_root, one_minus_epsilon, one_minus_epsilon_batch,
    tiers, u_of_epsilon, u_of_epsilon_batch, u_of_one_minus_epsilon, u_of_one_minus_epsilon_batch,
};
#[cfg(feature = "std")]
pub use {
    bodies::{
        Contact, DissipationFormula, Material, MaterialError, Plane, Sphere, combined_dissipative_constant,
        dissipative_constant, effective, sphere_mass,
    },
    impact::{
        Course, LARGEST_FOLLOWED_U, TimeStep, Validity, Verdict, ViscoelasticContact,
        characteristic_velocity_from, characteristic_velocity_from_loss, time_step_error, time_step_for,
    },
};

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
