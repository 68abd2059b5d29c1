//! Sums of products of fixed-point series: transformed once, multiplied exactly, rounded once.

use super::basis::{Level, Radix, Table};
use super::fixed::Fixed;
use super::lanes::{Lanes, turn, vectorised};
use super::prime::{Primes, capacity, groups_for, primes};
use super::transform::{Roots, size_for};
use rayon::prelude::*;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// Operations on eight primes below which a second thread costs more than it brings.
const WORTH_SPLITTING: usize = 10_000;
/// Products of reduced residues, each below `0.8 p` with its weight, that are summed before the sum is reduced.
const LAZY: usize = 8;
/// Places that are summed together, to stay in the first cache.
const BLOCK: usize = 64;
/// Coefficients that are taken to residues and back together.
const TOGETHER: usize = 32;
/// Steps by which fewer primes are used for coefficients that are known to be smaller.
const LEVELS: usize = 8;

/// Fixed-point series of one absolute precision and the tools to multiply them.
pub(crate) struct Workshop {
    bits: u32,
    width: usize,
    /// Bits by which coefficients are expected to fall with each term, as a fraction.
    decay: (usize, usize),
    pub(super) primes: Vec<Primes>,
    radix: Radix,
    roots: Mutex<HashMap<usize, Arc<Vec<Roots>>>>,
    levels: Mutex<HashMap<(usize, u32), Arc<Level>>>,
    overflow: AtomicBool,
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
    peak: u32,
    reach: u32,
}

impl Extent {
    /// Bits that hold every coefficient.
    fn bits(self) -> u32 {
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
    fn fall(&self, j: usize) -> u32 {
        ((j * self.decay.0 / self.decay.1) as u32).min(self.bits - 40)
    }

    fn extent(&self, series: &Fixed) -> Extent {
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

    fn level(&self, count: usize, shift: u32) -> Arc<Level> {
        let mut levels = self.levels.lock().unwrap_or_else(PoisonError::into_inner);
        let make = || Arc::new(Level::new(&self.primes[..count], shift));
        Arc::clone(levels.entry((count, shift)).or_insert_with(make))
    }

    /// Transforms a series of at most `size` terms modulo the first `count` groups of primes.
    pub fn transform(&self, series: &Fixed, size: usize, count: usize) -> Transformed {
        assert!(series.len() <= size && count <= self.primes.len(), "a transform too small for its series");
        let roots = self.roots(size);
        let words = series.all_words();
        let mut residues = vec![Lanes::ZERO; series.len() * count];
        let mut values = vec![Lanes::ZERO; size * count];
        let reduce =
            |(words, out): (&[u64], &mut [Lanes])| self.radix.residues(words, self.width, count, out);
        let fill = |residues: &[Lanes], i: usize, row: &mut [Lanes]| {
            for (value, residue) in row.iter_mut().zip(residues.iter().skip(i).step_by(count)) {
                *value = *residue;
            }
            roots[i].forward(row);
        };
        if count * size * (self.width + 10) > WORTH_SPLITTING {
            let pieces = words.par_chunks(TOGETHER * self.width);
            pieces.zip(residues.par_chunks_mut(TOGETHER * count)).for_each(reduce);
            values.par_chunks_mut(size).enumerate().for_each(|(i, row)| fill(&residues, i, row));
        } else {
            reduce((words, &mut residues));
            values.chunks_mut(size).enumerate().for_each(|(i, row)| fill(&residues, i, row));
        }
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
        let mut values = vec![Lanes::ZERO; size * count];
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
        if terms.len() * values.len() > WORTH_SPLITTING {
            values.par_chunks_mut(size).enumerate().for_each(fill);
        } else {
            values.chunks_mut(size).enumerate().for_each(fill);
        }
    }

    /// Transforms back and returns the first `len` coefficients divided by `2^shift`, `shift >= 64`.
    ///
    /// Each has an error of at most 1/2 and `2^-20` of its unit.
    pub fn settle(&self, sum: Sum, len: usize, shift: u32) -> Fixed {
        self.settle_range(sum, 0..len, shift)
    }

    /// As [`Self::settle`], for some of the coefficients.
    fn settle_range(&self, mut sum: Sum, range: Range<usize>, shift: u32) -> Fixed {
        let (size, count) = (sum.size, sum.count);
        if sum.extent.bits() > shift + 64 * self.width as u32 - 2 {
            self.overflow.store(true, Ordering::Relaxed);
        }
        let roots = self.roots(size);
        let back = |(i, row): (usize, &mut [Lanes])| roots[i].backward(row);
        let costly = count * size * (count + 10) > WORTH_SPLITTING;
        if costly {
            sum.values.par_chunks_mut(size).enumerate().for_each(back);
        } else {
            sum.values.chunks_mut(size).enumerate().for_each(back);
        }
        let step = count.div_ceil(LEVELS);
        let needed = |j: usize| {
            let bits = sum.extent.reach.saturating_sub(self.fall(j)).min(sum.extent.peak);
            groups_for(bits.max(shift)).next_multiple_of(step).min(count)
        };
        let scales: Vec<Lanes> = roots[..count].iter().map(Roots::scale).collect();
        let table = Table { values: &sum.values, stride: size, scales: &scales };
        let mut words = vec![0; range.len() * self.width];
        let write = |(chunk, words): (usize, &mut [u64])| {
            let first = range.start + chunk * TOGETHER;
            let places: Vec<usize> = (first..first + words.len() / self.width).collect();
            let mut rest = words;
            for places in places.chunk_by(|&i, &j| needed(i) == needed(j)) {
                let (words, after) = std::mem::take(&mut rest).split_at_mut(places.len() * self.width);
                let count = needed(places[0]);
                self.level(count, shift).write(&self.primes[..count], &table, places, words);
                rest = after;
            }
        };
        if costly {
            words.par_chunks_mut(self.width * TOGETHER).enumerate().for_each(write);
        } else {
            words.chunks_mut(self.width * TOGETHER).enumerate().for_each(write);
        }
        Fixed::from_words(words, self.width)
    }

    /// The first `len` coefficients of the product, in units of the factors.
    ///
    /// Digits of a factor that the smallness of the other makes worthless are left away first.
    pub fn product(&self, a: &Fixed, b: &Fixed, len: usize) -> Fixed {
        self.products(&[(1, a, b)], 0..len)
    }

    /// Some coefficients of a sum of products whose first factors have one length, and whose second have one.
    ///
    /// The transforms are so long that what is folded over falls below the range, and no longer.
    pub fn products(&self, terms: &[(i64, &Fixed, &Fixed)], range: Range<usize>) -> Fixed {
        let len = range.end;
        let mut factors: Vec<(Fixed, Fixed)> =
            terms.iter().map(|(_, a, b)| (a.truncated(len), b.truncated(len))).collect();
        let bits = |second: bool| {
            factors.iter().map(|(a, b)| if second { b.bits() } else { a.bits() }).max().unwrap_or(0)
        };
        let spare = |other: u32| self.bits.saturating_sub(other + 16);
        let (drop_a, drop_b) = (spare(bits(true)), spare(bits(false)));
        let dropping = (64..=self.bits.saturating_sub(64)).contains(&(drop_a + drop_b));
        let (drop_a, drop_b) = if dropping { (drop_a, drop_b) } else { (0, 0) };
        for (a, b) in &mut factors {
            for (factor, bits) in [(a, drop_a), (b, drop_b)] {
                if bits > 0 {
                    *factor = factor.shifted_right(bits);
                }
            }
        }
        let [a, b] = factors.first().map_or([1, 1], |(a, b)| [a.len(), b.len()]);
        let whole = (a + b).max(2) - 1;
        let size = size_for(len.min(whole).max(whole - range.start.min(whole)));
        let extent = |(a, b): &(Fixed, Fixed)| self.extent(a).times(self.extent(b));
        let extent = factors.iter().map(extent).fold(Extent::default(), Extent::or);
        let extent = extent.plus(a.min(b).max(1).ilog2() + terms.len().ilog2() + 8);
        let count = groups_for(extent.bits()).min(self.primes.len());
        let transform = |series: &Fixed| self.transform(series, size, count);
        let factors: Vec<_> = factors.iter().map(|(a, b)| (transform(a), transform(b))).collect();
        let terms: Vec<_> =
            terms.iter().zip(&factors).map(|(&(weight, ..), (a, b))| (weight, a, b)).collect();
        self.settle_range(self.sum(&terms), range.start..len.min(size), self.bits - drop_a - drop_b)
    }

    /// Groups of primes that suffice for a product of any two series of this precision.
    pub fn all_primes(&self) -> usize {
        self.primes.len()
    }
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
