//! Products of series by number-theoretic transforms modulo primes below `2^50`.
//!
//! One mechanism for exact and certified work: [`Primes`] and [`Roots`] multiply modulo eight primes at once, in
//! vectors of the floating-point unit; [`Level`] takes residues modulo many primes back to integers; [`Fixed`] is a series of
//! fixed-point numbers, and [`Workshop`] multiplies such series exactly and rounds once. [`Rows`] are series in a
//! second variable that become known one after the other.

mod basis;
mod digits;
mod fixed;
mod lanes;
mod prime;
mod rows;
mod transform;
mod workshop;

pub(crate) use basis::{Level, Table};
pub(crate) use fixed::{Fixed, power_of_two};
pub(crate) use lanes::{LANES, Lanes, turn, vectorised};
pub(crate) use prime::{Primes, groups_for, primes};
pub(crate) use rows::{Convolution, Rows, block_for};
pub(crate) use transform::{Roots, size_for};
pub(crate) use workshop::{Extent, Sum, Term, Transformed, Workshop};
