//! The evaluator: `epsilon` and what belongs to it in f64, without `std`, without allocation.

mod batch;
#[cfg(all(test, feature = "std", not(target_feature = "fma")))]
mod bits;
pub mod bounds;
mod curve;
mod end;
mod epsilon;
mod fifth_root;
#[doc(hidden)]
pub mod forms;
mod index;
mod inverse;
mod pieces;
mod rounding;
pub(crate) mod tables;
mod tier;
pub mod tiers;
mod velocity;
mod zero_compression;
mod zero_force;

pub use batch::{epsilon_batch, one_minus_epsilon_batch, u_of_epsilon_batch, u_of_one_minus_epsilon_batch};
pub use end::End;
pub use epsilon::{epsilon, one_minus_epsilon};
pub use fifth_root::fifth_root;
pub use inverse::{u_of_epsilon, u_of_one_minus_epsilon};
pub use velocity::Restitution;
