//! Attacks on the promises of the project: independent ways contradict each other on random and adversarial
//! requests.
//!
//! A [`Part`] attacks one kind of promise, case by case; [`campaign`] runs parts over both cores, keeps a state file from
//! which it resumes, and sums up in a [`Tally`]. A case is determined by the seed, its part and its number alone, so
//! that every fault can be repeated by itself. docs/reliability.md says what is promised and how each
//! promise is attacked.

pub mod campaign;
pub mod certified;
pub mod commands;
pub mod data_files;
pub mod ends;
pub mod exports;
pub mod f64_functions;
pub mod parsers;
pub mod parts;
pub mod random;
pub mod sandbox;
pub mod state;
pub mod tally;

pub use parts::{Part, Size};
pub use tally::Tally;
