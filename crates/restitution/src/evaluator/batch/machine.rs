//! What a processor is asked for: rows of a table, looked up and evaluated side by side.

use crate::evaluator::fifth_root::{ROOTS, piece_at};
use crate::evaluator::pieces::{LENGTH, Rows, distance, one_minus, polynomial};
use crate::evaluator::rounding::Divided;
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

/// What becomes of a row.
pub(super) trait Reading {
    fn of<T: Divided>(c: &[T; LENGTH], complement: T, t: T) -> T;
}

/// `epsilon`.
pub(super) struct Kept;
/// `1 - epsilon`.
pub(super) struct Lost;
/// The `t` at which `epsilon` differs by so much from that of the centre.
pub(super) struct Distance;

impl Reading for Kept {
    #[inline(always)]
    fn of<T: Divided>(c: &[T; LENGTH], _: T, t: T) -> T {
        polynomial(c, t)
    }
}

impl Reading for Lost {
    #[inline(always)]
    fn of<T: Divided>(c: &[T; LENGTH], complement: T, t: T) -> T {
        one_minus(c, complement, t)
    }
}

impl Reading for Distance {
    #[inline(always)]
    fn of<T: Divided>(c: &[T; LENGTH], _: T, change: T) -> T {
        distance(c, change)
    }
}

/// A set of instructions that a block is evaluated with.
pub(super) trait Machine: Copy {
    /// Writes what becomes of the row that starts at each word, at `centre + t`.
    fn read<R: Reading, const N: usize>(
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
    fn read<R: Reading, const N: usize>(
        self,
        table: &Rows<N>,
        start: &Block<u64>,
        t: &Block<f64>,
        out: &mut [f64; BLOCK],
    ) {
        for i in 0..BLOCK {
            let piece = table.row(start[i]);
            out[i] = R::of(&piece.all(), piece.complement(), t[i]);
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
            [root[i], reciprocal[i]] = ROOTS[piece_at(index[i])];
        }
    }
}
