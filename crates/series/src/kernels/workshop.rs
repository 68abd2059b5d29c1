//! Sums of products of fixed-point series: transformed once, multiplied exactly, rounded once.

use super::basis::{Level, Radix};
use super::fixed::Fixed;
use super::lanes::{Lanes, turn, vectorised};
use super::prime::{Primes, capacity, groups_for, primes};
use super::transform::Roots;
use rayon::prelude::*;
use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// Pieces of memory that are kept to be used again.
const MOST_KEPT: usize = 8;
/// Operations on eight primes below which a second thread costs more than it brings.
const WORTH_SPLITTING: usize = 10_000;
/// Products of reduced residues, each below `0.8 p` with its weight, that are summed before the sum is reduced.
const LAZY: usize = 8;
/// Places that are summed together, to stay in the first cache.
const BLOCK: usize = 64;
/// Coefficients that are taken to residues and back together.
pub(super) const TOGETHER: usize = 32;

/// Fixed-point series of one absolute precision and the tools to multiply them.
pub(crate) struct Workshop {
    pub(super) bits: u32,
    pub(super) width: usize,
    /// Bits by which coefficients are expected to fall with each term, as a fraction.
    decay: (usize, usize),
    pub(super) primes: Vec<Primes>,
    radix: Radix,
    roots: Mutex<HashMap<usize, Arc<Vec<Roots>>>>,
    levels: Mutex<HashMap<(usize, u32), Arc<Level>>>,
    pub(super) overflow: AtomicBool,
    /// Memory that was used and will be again: the system gives pages slowly.
    used: Mutex<Vec<Vec<Lanes>>>,
}

/// A series as values at roots of unity modulo the first groups of primes; reduced.
#[derive(Clone, Debug)]
pub(crate) struct Transformed {
    pub(super) size: usize,
    pub(super) count: usize,
    pub(super) len: usize,
    pub(super) extent: Extent,
    pub(super) values: Vec<Lanes>,
}

/// How large coefficients are: `|c_j| < 2^peak` and `|c_j| < 2^(reach - fall(j))`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Extent {
    pub(super) peak: u32,
    pub(super) reach: u32,
}

impl Extent {
    /// Bits that hold every coefficient.
    pub(super) fn bits(self) -> u32 {
        self.peak.min(self.reach)
    }

    /// The extent of numbers larger by so many bits.
    pub fn plus(self, bits: u32) -> Self {
        Self { peak: self.peak + bits, reach: self.reach + bits }
    }

    /// The extent of products, but for the number of terms.
    pub fn times(self, other: Self) -> Self {
        Self { peak: self.peak + other.peak, reach: self.reach + other.reach }
    }

    /// The extent of either.
    pub fn or(self, other: Self) -> Self {
        Self { peak: self.peak.max(other.peak), reach: self.reach.max(other.reach) }
    }
}

impl Transformed {
    /// The number of terms and their extent.
    fn scale(&self) -> (usize, Extent) {
        (self.len, self.extent)
    }

    /// Every coefficient times a small number.
    pub fn times(&self, shop: &Workshop, factor: u32) -> Self {
        let mut product = self.clone();
        for (row, primes) in product.values.chunks_mut(self.size).zip(&shop.primes) {
            multiply(primes, row, factor.into());
        }
        product.extent = product.extent.plus(32 - factor.leading_zeros());
        product
    }
}

/// A sum of products before it is transformed back; reduced.
#[derive(Clone)]
pub(crate) struct Sum {
    pub(super) size: usize,
    pub(super) count: usize,
    pub(super) extent: Extent,
    pub(super) values: Vec<Lanes>,
}

/// A product with an integer weight.
pub(crate) type Term<'t> = (i64, &'t Transformed, &'t Transformed);

impl Workshop {
    /// For multiples of `2^-bits`, `bits >= 64`, of absolute value below `2^head`.
    pub fn new(bits: u32, head: u32, decay: (usize, usize)) -> Self {
        let width = (bits + head) as usize / 64 + 1;
        let primes = primes(groups_for(2 * (bits + head) + 96));
        let radix = Radix::new(&primes, width);
        Self {
            bits,
            width,
            decay,
            primes,
            radix,
            roots: Mutex::default(),
            levels: Mutex::default(),
            overflow: AtomicBool::new(false),
            used: Mutex::default(),
        }
    }

    /// Whether a sum may have been too large for its words: then nothing that followed counts.
    pub fn overflowed(&self) -> bool {
        self.overflow.load(Ordering::Relaxed)
    }

    /// The bits after the point.
    pub fn bits(&self) -> u32 {
        self.bits
    }

    /// The words of a coefficient.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Bits by which coefficient `j` is expected below the first: at most down to the noise of rounding.
    ///
    /// `fall(i) + fall(j) + 1 >= fall(i + j)`, so that products inherit it.
    pub(super) fn fall(&self, j: usize) -> u32 {
        ((j * self.decay.0 / self.decay.1) as u32).min(self.bits - 40)
    }

    pub(super) fn extent(&self, series: &Fixed) -> Extent {
        let place = |j: usize| {
            let bits = bits_of(series.words(j));
            Extent { peak: bits, reach: bits + self.fall(j) }
        };
        (0..series.len()).map(place).fold(Extent::default(), Extent::or)
    }

    pub(super) fn roots(&self, size: usize) -> Arc<Vec<Roots>> {
        let mut roots = self.roots.lock().unwrap_or_else(PoisonError::into_inner);
        let make = || Arc::new(self.primes.par_iter().map(|&primes| Roots::new(primes, size)).collect());
        Arc::clone(roots.entry(size).or_insert_with(make))
    }

    pub(super) fn level(&self, count: usize, shift: u32) -> Arc<Level> {
        let mut levels = self.levels.lock().unwrap_or_else(PoisonError::into_inner);
        let make = || Arc::new(Level::new(&self.primes[..count], shift));
        Arc::clone(levels.entry((count, shift)).or_insert_with(make))
    }

    /// So many numbers of any value.
    pub(super) fn memory(&self, len: usize) -> Vec<Lanes> {
        let mut memory = self.used.lock().unwrap_or_else(PoisonError::into_inner).pop().unwrap_or_default();
        memory.resize(len, Lanes::ZERO);
        memory
    }

    /// Takes memory back for [`Self::memory`].
    pub(super) fn give_back(&self, memory: Vec<Lanes>) {
        let mut used = self.used.lock().unwrap_or_else(PoisonError::into_inner);
        if used.len() < MOST_KEPT {
            used.push(memory);
        }
    }

    /// The residues of a series modulo the first `count` groups of primes, those of one coefficient side by side.
    pub(super) fn residues(&self, series: &Fixed, count: usize) -> Vec<Lanes> {
        let mut residues = self.memory(series.len() * count);
        let reduce = |(i, out): (usize, &mut [Lanes])| {
            let words = &series.all_words()[i * TOGETHER * self.width..][..out.len() / count * self.width];
            self.radix.residues(words, self.width, count, out);
        };
        for_each_piece(&mut residues, TOGETHER * count, self.effort(), reduce);
        residues
    }

    /// Transforms a series of at most `size` terms modulo the first `count` groups of primes.
    pub fn transform(&self, series: &Fixed, size: usize, count: usize) -> Transformed {
        assert!(series.len() <= size && count <= self.primes.len(), "a transform too small for its series");
        let roots = self.roots(size);
        let residues = self.residues(series, count);
        let mut values = vec![Lanes::ZERO; size * count];
        let fill =
            |(i, row): (usize, &mut [Lanes])| fill_and_transform(&roots[i], &residues, (i, count), row);
        for_each_piece(&mut values, size, self.effort(), fill);
        self.give_back(residues);
        Transformed { size, count, len: series.len(), extent: self.extent(series), values }
    }

    /// The sum of products, each with its weight, modulo as many primes as its size needs.
    pub fn sum(&self, terms: &[Term]) -> Sum {
        self.sum_for(terms, terms[0].1.size, Extent::default())
    }

    /// The sum of products modulo as many primes as the extent given needs, or more.
    pub fn sum_for(&self, terms: &[Term], size: usize, extent: Extent) -> Sum {
        let most = terms
            .iter()
            .map(|(weight, a, b)| extent_of(*weight, a.scale(), b.scale()))
            .fold(Extent::default(), Extent::or);
        let needed = most.plus(terms.len().max(1).ilog2() + 2);
        let count = groups_for(extent.bits().min(capacity(self.primes.len())).max(needed.bits()));
        debug_assert!(terms.iter().all(|(_, a, b)| a.size == size && b.size == size));
        let known = terms.iter().map(|(_, a, b)| a.count.min(b.count)).min().unwrap_or(count);
        if known < count {
            self.overflow.store(true, Ordering::Relaxed);
        }
        let count = count.min(known);
        let mut values = self.memory(size * count);
        values.fill(Lanes::ZERO);
        self.add_terms(terms, size, &mut values);
        Sum { size, count, extent: needed, values }
    }

    /// Sets the extent of a sum to which products were added; notices if it has too few primes for it.
    pub fn set_extent(&self, sum: &mut Sum, extent: Extent) {
        sum.extent = extent;
        if groups_for(extent.bits()) > sum.count {
            self.overflow.store(true, Ordering::Relaxed);
        }
    }

    /// Adds products to a sum, if it has the primes for them.
    pub fn add(&self, sum: &mut Sum, terms: &[Term]) -> Option<()> {
        let most = terms
            .iter()
            .map(|&(weight, a, b)| extent_of(weight, a.scale(), b.scale()))
            .fold(Extent::default(), Extent::or);
        sum.extent = sum.extent.or(most.plus(terms.len().ilog2() + 1)).plus(1);
        if groups_for(sum.extent.bits()) > sum.count {
            return None;
        }
        self.add_terms(terms, sum.size, &mut sum.values);
        Some(())
    }

    /// Adds products to values modulo the first groups of primes.
    pub(super) fn add_terms(&self, terms: &[Term], size: usize, values: &mut [Lanes]) {
        let fill = |(i, row): (usize, &mut [Lanes])| add_terms(&self.primes[i], terms, i * size, row);
        for_each_piece(values, size, terms.len(), fill);
    }

    /// Operations on each residue on the way from words to transforms, or back.
    pub(super) fn effort(&self) -> usize {
        self.width + 10
    }

    /// Groups of primes that suffice for a product of any two series of this precision.
    pub fn all_primes(&self) -> usize {
        self.primes.len()
    }
}

/// Does the same for one piece of so many values after the other, side by side where so many operations on each are worth it.
pub(super) fn for_each_piece<T: Send>(
    values: &mut [T],
    piece: usize,
    operations: usize,
    work: impl Fn((usize, &mut [T])) + Sync + Send,
) {
    if is_costly(values.len(), operations) {
        values.par_chunks_mut(piece.max(1)).enumerate().for_each(work);
    } else {
        values.chunks_mut(piece.max(1)).enumerate().for_each(work);
    }
}

/// Whether so many operations on each of so many values are worth a second thread.
pub(super) fn is_costly(values: usize, operations: usize) -> bool {
    values * operations > WORTH_SPLITTING
}

/// Puts the residues modulo group `i` of `count`, which stand side by side, into a row, zeros behind, and transforms it.
pub(super) fn fill_and_transform(
    roots: &Roots,
    residues: &[Lanes],
    (i, count): (usize, usize),
    row: &mut [Lanes],
) {
    let len = residues.len() / count;
    for (value, residues) in row.iter_mut().zip(residues.chunks_exact(count)) {
        *value = residues[i];
    }
    row[len..].fill(Lanes::ZERO);
    roots.forward(row);
}

/// The extent of a weighted product of factors with so many terms and such an extent.
pub(super) fn extent_of(weight: i64, (a, x): (usize, Extent), (b, y): (usize, Extent)) -> Extent {
    let terms = a.min(b).max(1);
    x.times(y).plus(64 - weight.unsigned_abs().leading_zeros() + terms.ilog2() + 2)
}

/// Bits of the absolute value, at most one too many.
fn bits_of(words: &[u64]) -> u32 {
    super::fixed::significant_bits(words)
}

vectorised! {
    /// Every value times an integer.
    fn multiply(primes: &'a Primes, values: &'a mut [Lanes], factor: i64) {
        let primes = *primes;
        let factor = primes.integer(factor);
        for value in values {
            turn();
            *value = primes.reduce(primes.mul(*value, factor));
        }
    }
}

vectorised! {
    /// Adds weighted products of the values from `start` on.
    fn add_terms(primes: &'a Primes, terms: &'a [Term<'a>], start: usize, row: &'a mut [Lanes]) {
        let primes = *primes;
        for (start, row) in (start..).step_by(BLOCK).zip(row.chunks_mut(BLOCK)) {
            for terms in terms.chunks(LAZY) {
                for (weight, a, b) in terms {
                    let (a, b) = (&a.values[start..start + row.len()], &b.values[start..start + row.len()]);
                    if *weight == 1 {
                        for ((sum, &x), &y) in row.iter_mut().zip(a).zip(b) {
                            turn();
                            *sum = *sum + primes.mul(x, y);
                        }
                    } else {
                        let weight = primes.integer(*weight);
                        for ((sum, &x), &y) in row.iter_mut().zip(a).zip(b) {
                            turn();
                            *sum = *sum + primes.mul(primes.mul(x, y), weight);
                        }
                    }
                }
                for sum in row.iter_mut() {
                    turn();
                    *sum = primes.reduce(*sum);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
