//! What meets: materials, spheres and planes, their contact, and the errors of what is said about them.

mod contact;
mod dissipation;
pub(crate) mod error;
mod material;

pub use contact::{Contact, Plane, effective};
pub use dissipation::{DissipationFormula, combined_dissipative_constant, dissipative_constant};
pub use error::MaterialError;
pub use material::{Material, Sphere, sphere_mass};
