//! Workspace tests, one binary.

mod bounds;
mod citations;
mod direct;
mod pade_constructions;
mod pade_contact;
mod pade_series;
mod support;
