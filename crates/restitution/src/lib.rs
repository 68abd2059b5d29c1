//! The coefficient of restitution of viscoelastic spheres in f64: fast, with a stated bound.
#![cfg_attr(not(feature = "std"), no_std)]

mod batch;
mod end;
mod epsilon;
mod fifth_root;
mod pieces;
mod rounding;
mod tables;
mod velocity;
mod zero_compression;
mod zero_force;

pub use batch::epsilon_batch;
pub use end::End;
pub use epsilon::{epsilon, one_minus_epsilon};
pub use fifth_root::fifth_root;
pub use velocity::Restitution;
