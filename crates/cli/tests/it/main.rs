//! The command, run as its users run it; one binary.

mod audit;
mod epsilon;
mod export;
mod materials;
mod pade;
mod readme;
mod report;
mod shared;
mod support;
