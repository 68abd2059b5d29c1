//! Certified direct integration of the equation of motion, for every velocity.
//!
//! [`Collision`] gives `epsilon(u)` for any damping `u >= 0`, any number of digits, both ends of contact
//! and any force law with rational exponents, each digit proved. It is what every approximation of the
//! project is judged by, and shares no formula with the expansion of the appendix. Method and proofs are
//! in `docs/direct-integration.md`.

mod collision;
mod compression;
mod coordinate;
mod damping;
mod dashpot;
mod envelope;
mod equation;
mod error;
mod exit;
mod fixed;
mod interpolant;
mod interpolation;
mod online;
mod overdamping;
#[cfg(test)]
mod perturbed;
mod phase_arc;
mod phase_sides;
#[cfg(test)]
mod polynomial;
mod precision;
mod saturation;
mod stepper;
mod time;
mod time_arc;
mod time_series;
mod turning;
mod turning_arc;
mod turning_point;
mod turning_series;
mod zero_force;

pub use collision::Collision;
pub use damping::{Damping, EqualSpheres, VelocityScale};
pub use error::DirectError;
pub use interpolant::{Interpolant, Variable};
/// One word for all crates, from the one that may depend on nothing; nothing else comes from there.
#[doc(no_inline)]
pub use restitution::End;
pub use saturation::{saturation_radius, saturation_speed};

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
