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
mod products;
mod rows;
mod small_primes;
mod transform;
mod workshop;

pub(crate) use basis::{Level, Table};
pub(crate) use fixed::{Fixed, power_of_two};
pub(crate) use lanes::{LANES, Lanes, arch, turn, vectorised};
pub(crate) use prime::{Primes, groups_for, primes};
pub(crate) use rows::{Convolution, Rows, block_for};
pub(crate) use small_primes::SmallPrimes;
pub(crate) use transform::{Roots, least_length, size_for};
pub(crate) use workshop::{Extent, Sum, Term, Transformed, Workshop};

/// Lets glibc keep memory that was freed, up to 64 MiB, instead of giving it back to the system page by page: whole
/// milliseconds where many series of some megabytes come and go.
///
/// A block that is mapped and unmapped raises its thresholds (mallopt(3), `M_MMAP_THRESHOLD`); elsewhere it does nothing.
pub(crate) fn keep_freed_memory() {
    const MOST: usize = 32 << 20;
    drop(std::hint::black_box(Vec::<u8>::with_capacity(MOST - (64 << 10))));
}
