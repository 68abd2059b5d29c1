//! Workspace tests, one binary.

mod approximate;
mod bounds;
mod citations;
mod dimensional;
mod direct;
mod pade_constructions;
mod pade_contact;
mod pade_series;
mod support;
