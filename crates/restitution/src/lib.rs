//! The coefficient of restitution of viscoelastic spheres in f64: fast, with a stated bound.
//!
//! | to know | ask |
//! |---|---|
//! | `epsilon` at a damping, and what it is of | [`epsilon`], [`one_minus_epsilon`], [`epsilon_batch`] |
//! | `epsilon` at a velocity | [`Restitution`], from `g*` |
//! | the damping of a measured `epsilon` | [`u_of_epsilon`], [`u_of_one_minus_epsilon`], [`u_of_epsilon_batch`] |
//! | `epsilon` to 3, 6 or 9 digits, for less time | [`tiers`] |
//! | how large an error can be, and why | [`bounds`]: every bound stands there, once |
//! | what a material does (feature `std`) | [`Material`], [`Contact`], [`ViscoelasticContact`], [`Course`], [`Validity`] |
//! | which time step a simulation may take (`std`) | [`time_step_for`], [`time_step_error`] |
//! | what to tell a simulation code (`std`) | [`codes`] |
//!
//! What most people need:
//!
//! ```
//! use restitution::{Contact, End, Restitution, ViscoelasticContact};
//! # fn main() -> Result<(), restitution::MaterialError> {
//! // from a characteristic velocity, in m/s
//! let ice = Restitution::from_g_star(0.0046, End::ZeroCompression);
//! let (epsilon, back) = (ice.epsilon(0.01), ice.u(0.01));
//! assert!(0.3 < epsilon && epsilon < 0.4 && back > 1.0);
//!
//! // from one measurement, 0.6 at 0.5 m/s, to any other velocity
//! let pair = Contact::new(0.0025, 6.5e-4, 5.5e8)?; // R_eff, m_eff, E
//! let pair = ViscoelasticContact::from_measurement(pair, 0.5, 0.6, End::ZeroForce)?;
//! assert!(pair.epsilon(1.0, End::ZeroForce)? < 0.6);
//! # Ok(())
//! # }
//! ```
#![cfg_attr(not(feature = "std"), no_std)]

mod batch;
pub mod bounds;
mod end;
mod epsilon;
mod fifth_root;
#[doc(hidden)]
pub mod forms;
mod inverse;
mod pieces;
mod rounding;
mod tables;
mod tier;
pub mod tiers;
mod velocity;
mod zero_compression;
mod zero_force;

#[cfg(feature = "std")]
mod bodies;
#[cfg(feature = "std")]
pub mod codes;
#[cfg(feature = "std")]
mod impact;

pub use batch::{epsilon_batch, one_minus_epsilon_batch, u_of_epsilon_batch};
#[cfg(feature = "std")]
pub use bodies::{
    Contact, DissipationFormula, Material, MaterialError, Plane, Sphere, combined_dissipative_constant,
    dissipative_constant, effective, sphere_mass,
};
pub use end::End;
pub use epsilon::{epsilon, one_minus_epsilon};
pub use fifth_root::fifth_root;
#[cfg(feature = "std")]
pub use impact::{
    Course, LARGEST_FOLLOWED_U, Validity, Verdict, ViscoelasticContact, characteristic_velocity_from,
    characteristic_velocity_from_loss, time_step_error, time_step_for,
};
pub use inverse::{u_of_epsilon, u_of_one_minus_epsilon};
pub use velocity::Restitution;

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
