//! The languages that evaluators are written in.

mod c;
mod fortran;
mod python;
mod rust;

use super::listing::Listing;

/// A language that evaluators are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// Rust, 2018 and later, a module.
    Rust,
    /// C99, C++11 and CUDA, a header.
    C,
    /// Fortran 2008, a module.
    Fortran,
    /// Python 3, plain floats and NumPy arrays.
    Python,
}

impl Language {
    /// Returns the evaluator as source code.
    pub fn write(self, listing: &Listing) -> String {
        match self {
            Self::Rust => rust::write(listing),
            Self::C => c::write(listing),
            Self::Fortran => fortran::write(listing),
            Self::Python => python::write(listing),
        }
    }
}

/// Puts `prefix` before each line of the head, and nothing behind an empty one.
fn head(listing: &Listing, prefix: &str) -> String {
    listing.head().iter().map(|line| format!("{prefix}{line}").trim_end().to_owned() + "\n").collect()
}

/// A number with 17 significant digits, which give the f64 back.
fn number(x: f64) -> String {
    format!("{x:.16e}")
}

/// The numbers of a row, with `suffix` behind each.
fn row(numbers: &[f64], suffix: &str) -> String {
    numbers.iter().map(|x| number(*x) + suffix).collect::<Vec<_>>().join(", ")
}
