//! Workspace tests, one binary.

mod approximate;
mod audit;
mod bounds;
mod certified;
mod citations;
mod codes;
mod dimensional;
mod direct;
mod direct_hard;
mod export;
mod fast_vs_direct;
mod fit;
mod materials;
mod pade_constants;
mod pade_constructions;
mod pade_contact;
mod pade_series;
mod pade_stability;
mod support;
mod tables_fresh;
mod tiers;
mod time_step;
mod velocity;
