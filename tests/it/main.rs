//! Workspace tests, one binary.

mod approximate;
mod bounds;
mod citations;
mod codes;
mod dimensional;
mod direct;
mod direct_hard;
mod fit;
mod materials;
mod pade_constants;
mod pade_constructions;
mod pade_contact;
mod pade_series;
mod pade_stability;
mod support;
mod time_step;
