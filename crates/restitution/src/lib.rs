//! The coefficient of restitution of viscoelastic spheres in f64: fast, with a stated bound.
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
pub mod codes;
#[cfg(feature = "std")]
mod collision;
#[cfg(feature = "std")]
mod contact;
#[cfg(feature = "std")]
mod course;
#[cfg(feature = "std")]
mod dissipation;
#[cfg(feature = "std")]
mod error;
#[cfg(feature = "std")]
mod material;
#[cfg(feature = "std")]
mod time_step;
#[cfg(feature = "std")]
mod validity;

pub use batch::{epsilon_batch, one_minus_epsilon_batch, u_of_epsilon_batch};
#[cfg(feature = "std")]
pub use collision::{ViscoelasticContact, characteristic_velocity_from, characteristic_velocity_from_loss};
#[cfg(feature = "std")]
pub use contact::{Contact, Plane, effective};
#[cfg(feature = "std")]
pub use course::{Course, LARGEST_FOLLOWED_U};
#[cfg(feature = "std")]
pub use dissipation::{DissipationFormula, combined_dissipative_constant, dissipative_constant};
pub use end::End;
pub use epsilon::{epsilon, one_minus_epsilon};
#[cfg(feature = "std")]
pub use error::MaterialError;
pub use fifth_root::fifth_root;
pub use inverse::{u_of_epsilon, u_of_one_minus_epsilon};
#[cfg(feature = "std")]
pub use material::{Material, Sphere, sphere_mass};
#[cfg(feature = "std")]
pub use time_step::{time_step_error, time_step_for};
#[cfg(feature = "std")]
pub use validity::{Validity, Verdict};
pub use velocity::Restitution;

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
