//! Products of series by number-theoretic transforms modulo word-size primes.
//!
//! One mechanism for exact and certified work: [`Prime`] and [`Roots`] multiply modulo one prime;
//! [`Basis`] carries integers to residues modulo many primes and back; [`Fixed`] is a series of
//! fixed-point numbers, and [`Workshop`] multiplies such series exactly and rounds once. [`Rows`] are series in a
//! second variable that become known one after the other.

mod basis;
mod fixed;
mod prime;
mod rows;
mod transform;
mod workshop;

pub(crate) use fixed::{Fixed, power_of_two};
pub(crate) use prime::Prime;
pub(crate) use rows::{Convolution, Rows, block_for};
pub(crate) use transform::{Roots, size_for};
pub(crate) use workshop::{Extent, Group, Sum, Transformed, Workshop};
