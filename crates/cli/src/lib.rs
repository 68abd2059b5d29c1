//! The command `restitution`: arguments in, one table out.
//!
//! [`run`] reads the arguments and carries one subcommand out. What subcommands share lives here:
//! parsed arguments ([`args`], [`units`]), which files it reads ([`input`]), where its tables go ([`output`]),
//! errors and exit codes ([`error`]), the limits of the machine ([`memory`]) and the progress bar
//! ([`progress`]). The subcommands themselves, and how to add one, are in [`commands`]. Nothing is computed here: arithmetic in
//! double precision is a lint that is denied, but for grids of arguments and bytes of memory.

#![deny(clippy::float_arithmetic)]

pub mod args;
pub mod commands;
pub mod error;
pub mod hint;
pub mod input;
pub mod interrupt;
#[expect(clippy::float_arithmetic, reason = "points of grids")]
pub mod list;
#[expect(clippy::float_arithmetic, reason = "bytes")]
pub mod memory;
pub mod output;
pub mod progress;

pub mod unexpected;

pub use commands::run;
pub use error::CliError;
pub use output::OutputArgs;
pub use restitution_law::exact;
pub use restitution_table::{Cell, Table};
pub use restitution_units as units;

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
