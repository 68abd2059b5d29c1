//! Tables of exact and certified numbers, and the forms in which they are printed.

mod format;
mod render;
mod table;

pub use format::Format;
pub use table::{Cell, Table};

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
