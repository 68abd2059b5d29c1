//! What a processor is asked for: rows of a table, looked up and evaluated side by side.

use crate::evaluator::fifth_root::ROOTS;
use crate::evaluator::pieces::Rows;
use crate::evaluator::tier::value;
use core::ops::{Deref, DerefMut};

/// How many arguments are looked at together.
pub(super) const BLOCK: usize = 32;

/// Arguments that are looked at together, where a vector of any width is loaded and stored at once.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(super) struct Block<T>(pub(super) [T; BLOCK]);

impl<T: Copy + Default> Block<T> {
    #[inline(always)]
    pub(super) fn zeros() -> Self {
        Self([T::default(); BLOCK])
    }
}

impl<T> Deref for Block<T> {
    type Target = [T; BLOCK];

    #[inline(always)]
    fn deref(&self) -> &[T; BLOCK] {
        &self.0
    }
}

impl<T> DerefMut for Block<T> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [T; BLOCK] {
        &mut self.0
    }
}

/// A set of instructions that a block is evaluated with.
pub(super) trait Machine: Copy {
    /// Writes the coefficient at `centre + t` of the row that starts at each word.
    fn values<const N: usize>(
        self,
        table: &Rows<N>,
        start: &Block<u64>,
        t: &Block<f64>,
        out: &mut [f64; BLOCK],
    );

    /// Writes one less the coefficient.
    fn losses<const N: usize>(
        self,
        table: &Rows<N>,
        start: &Block<u64>,
        t: &Block<f64>,
        out: &mut [f64; BLOCK],
    );

    /// Writes the values of rows of a tier.
    fn tier<const N: usize, const WIDTH: usize>(
        self,
        table: &Rows<N>,
        start: &Block<u64>,
        distance: &Block<f64>,
        out: &mut [f64; BLOCK],
    );

    /// Writes the roots and the reciprocals of the pieces of the fifth root.
    fn roots(self, index: &Block<u64>, root: &mut Block<f64>, reciprocal: &mut Block<f64>);
}

/// The instructions that the crate is compiled for.
#[derive(Clone, Copy)]
pub(super) struct Compiled;

impl Machine for Compiled {
    #[inline(always)]
    fn values<const N: usize>(
        self,
        table: &Rows<N>,
        start: &Block<u64>,
        t: &Block<f64>,
        out: &mut [f64; BLOCK],
    ) {
        for i in 0..BLOCK {
            out[i] = table.row(start[i]).value(t[i]);
        }
    }

    #[inline(always)]
    fn losses<const N: usize>(
        self,
        table: &Rows<N>,
        start: &Block<u64>,
        t: &Block<f64>,
        out: &mut [f64; BLOCK],
    ) {
        for i in 0..BLOCK {
            out[i] = table.row(start[i]).one_minus(t[i]);
        }
    }

    #[inline(always)]
    fn tier<const N: usize, const WIDTH: usize>(
        self,
        table: &Rows<N>,
        start: &Block<u64>,
        distance: &Block<f64>,
        out: &mut [f64; BLOCK],
    ) {
        for i in 0..BLOCK {
            let row = table.words(start[i]);
            let c: [f64; WIDTH] = core::array::from_fn(|k| f64::from_bits(row[k]));
            out[i] = value(&c, distance[i]);
        }
    }

    #[inline(always)]
    fn roots(self, index: &Block<u64>, root: &mut Block<f64>, reciprocal: &mut Block<f64>) {
        for i in 0..BLOCK {
            [root[i], reciprocal[i]] = ROOTS[(index[i] as usize).min(ROOTS.len() - 1)];
        }
    }
}
