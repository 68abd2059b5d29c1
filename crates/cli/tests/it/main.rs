//! The command, run as its users run it; one binary.

mod audit;
mod epsilon;
mod export;
mod materials;
mod readme;
mod shared;
mod support;
