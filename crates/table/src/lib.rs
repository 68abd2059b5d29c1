//! Tables of exact and certified numbers, and the forms in which they are printed.

mod format;
mod render;
mod table;

pub use format::Format;
pub use table::{Cell, Table};
