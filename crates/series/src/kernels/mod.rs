//! Products of series by number-theoretic transforms modulo word-size primes.
//!
//! One mechanism for exact and certified work: [`Prime`] and [`Roots`] multiply modulo one prime;
//! [`Basis`] carries integers to residues modulo many primes and back; [`Fixed`] is a series of
//! fixed-point numbers, and [`Workshop`] multiplies such series exactly and rounds once.

mod basis;
mod fixed;
mod prime;
mod transform;
mod workshop;

pub(crate) use fixed::{Fixed, power_of_two};
pub(crate) use prime::Prime;
pub(crate) use transform::{Roots, size_for};
pub(crate) use workshop::{Extent, Sum, Transformed, Workshop};
