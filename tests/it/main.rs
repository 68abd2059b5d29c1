//! Workspace tests, one binary.

mod pade_constructions;
mod pade_contact;
mod pade_series;
