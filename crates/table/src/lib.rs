//! Tables of exact and certified numbers, and the forms in which they are printed.
//!
//! A [`Table`] has named columns and rows of [`Cell`]s; [`Table::render`] prints it as text, CSV, JSON, LaTeX or Markdown ([`Format`]). Digits pass
//! through as they are given: nothing is rounded on the way, and a cell that is rounded says so by how it was made.

mod format;
mod render;
mod table;

pub use format::Format;
pub use table::{Cell, Table};

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
