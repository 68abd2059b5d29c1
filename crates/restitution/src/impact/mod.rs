//! How a contact meets: its coefficient at a velocity and back, the course of one collision, when the theory applies, time steps.

mod collision;
mod course;
mod time_step;
mod validity;

pub use collision::{ViscoelasticContact, characteristic_velocity_from, characteristic_velocity_from_loss};
pub use course::{Course, LARGEST_FOLLOWED_U};
pub use time_step::{TimeStep, time_step_error, time_step_for};
pub use validity::{Validity, Verdict};
