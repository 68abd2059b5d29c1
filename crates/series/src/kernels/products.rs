//! From sums of products back to series, and products that are needed once: modulo one group of primes after the other.

use super::basis::Table;
use super::fixed::Fixed;
use super::lanes::{Lanes, turn, vectorised};
use super::prime::{Primes, groups_for};
use super::transform::{Roots, least_length, size_for};
use super::workshop::{
    Extent, Sum, TOGETHER, Workshop, extent_of, fill_and_transform, for_each_piece, is_costly,
};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::Ordering;

/// Steps by which fewer primes are used for coefficients that are known to be smaller.
const LEVELS: usize = 8;

/// Residues of a series of products, group by group, of which some coefficients are kept.
struct Kept {
    values: Vec<Lanes>,
    count: usize,
    extent: Extent,
    range: Range<usize>,
    /// Of the transforms.
    size: usize,
}

impl Workshop {
    /// Transforms back and returns the first `len` coefficients divided by `2^shift`, `shift >= 64`.
    ///
    /// Each has an error of at most 1/2 and `2^-20` of its unit.
    pub fn settle(&self, mut sum: Sum, len: usize, shift: u32) -> Fixed {
        let (size, count) = (sum.size, sum.count);
        let roots = self.roots(size);
        let back = |(i, row): (usize, &mut [Lanes])| roots[i].backward(row);
        for_each_piece(&mut sum.values, size, self.effort(), back);
        let kept = Kept { values: sum.values, count, extent: sum.extent, range: 0..size, size };
        self.rounded(kept, len, shift)
    }

    /// The first `len` of the coefficients that were kept, divided by `2^shift`, `shift >= 64`.
    fn rounded(&self, kept: Kept, len: usize, shift: u32) -> Fixed {
        let Kept { values, count, extent, range, size } = kept;
        if extent.bits() > shift + 64 * self.width as u32 - 2 {
            self.overflow.store(true, Ordering::Relaxed);
        }
        let step = count.div_ceil(LEVELS);
        let needed = |place: usize| {
            let bits = extent.reach.saturating_sub(self.fall(range.start + place)).min(extent.peak);
            groups_for(bits.max(shift)).next_multiple_of(step).min(count)
        };
        let scales: Vec<Lanes> = self.roots(size)[..count].iter().map(Roots::scale).collect();
        let table = Table { values: &values, stride: range.len(), scales: &scales };
        let mut words = vec![0; len * self.width];
        let write = |(chunk, words): (usize, &mut [u64])| {
            let first = chunk * TOGETHER;
            let places: Vec<usize> = (first..first + words.len() / self.width).collect();
            let mut rest = words;
            for places in places.chunk_by(|&i, &j| needed(i) == needed(j)) {
                let (words, after) = std::mem::take(&mut rest).split_at_mut(places.len() * self.width);
                let count = needed(places[0]);
                self.level(count, shift).write(&self.primes[..count], &table, places, words);
                rest = after;
            }
        };
        for_each_piece(&mut words, self.width * TOGETHER, self.effort(), write);
        self.give_back(values);
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
        let mut factors: Vec<(i64, Fixed, Fixed)> =
            terms.iter().map(|(weight, a, b)| (*weight, a.truncated(len), b.truncated(len))).collect();
        let dropped = self.drop_worthless(&mut factors);
        let [a, b] = factors.first().map_or([1, 1], |(_, a, b)| [a.len(), b.len()]);
        let size = size_for(least_length(a, b, &range));
        let range = range.start..len.min(size);
        let len = range.len();
        self.rounded(self.kept(&factors, size, range), len, self.bits - dropped)
    }

    /// Drops digits of each factor that the smallness of the others makes worthless, and says how many bits of a product.
    fn drop_worthless(&self, factors: &mut [(i64, Fixed, Fixed)]) -> u32 {
        let bits = |second: bool| {
            factors.iter().map(|(_, a, b)| if second { b.bits() } else { a.bits() }).max().unwrap_or(0)
        };
        let spare = |other: u32| self.bits.saturating_sub(other + 16);
        let (drop_a, drop_b) = (spare(bits(true)), spare(bits(false)));
        if !(64..=self.bits.saturating_sub(64)).contains(&(drop_a + drop_b)) {
            return 0;
        }
        for (_, a, b) in factors {
            for (factor, bits) in [(a, drop_a), (b, drop_b)] {
                if bits > 0 {
                    *factor = factor.shifted_right(bits);
                }
            }
        }
        drop_a + drop_b
    }

    /// Coefficients of a sum of products, group after group, so that little memory is needed.
    fn kept(&self, factors: &[(i64, Fixed, Fixed)], size: usize, range: Range<usize>) -> Kept {
        let scale = |series: &Fixed| (series.len(), self.extent(series));
        let extent = factors
            .iter()
            .map(|(weight, a, b)| extent_of(*weight, scale(a), scale(b)))
            .fold(Extent::default(), Extent::or)
            .plus(factors.len().max(1).ilog2() + 2);
        let count = groups_for(extent.bits());
        if count > self.primes.len() {
            self.overflow.store(true, Ordering::Relaxed);
        }
        let count = count.min(self.primes.len());
        let roots = self.roots(size);
        let residues: Vec<[Vec<Lanes>; 2]> =
            factors.iter().map(|(_, a, b)| [self.residues(a, count), self.residues(b, count)]).collect();
        let mut values = self.memory(range.len() * count);
        let multiply = |rows: &mut Vec<Lanes>, (i, out): (usize, &mut [Lanes])| {
            let (sum, rest) = rows.split_at_mut(size);
            let (x, y) = rest.split_at_mut(size);
            sum.fill(Lanes::ZERO);
            for ((weight, ..), [a, b]) in factors.iter().zip(&residues) {
                fill_and_transform(&roots[i], a, (i, count), x);
                fill_and_transform(&roots[i], b, (i, count), y);
                add_product(&self.primes[i], *weight, x, y, sum);
            }
            roots[i].backward(sum);
            out.copy_from_slice(&sum[range.clone()]);
        };
        let rows = || vec![Lanes::ZERO; 3 * size];
        let chunk = range.len().max(1);
        if is_costly(values.len(), self.effort()) {
            values.par_chunks_mut(chunk).enumerate().for_each_init(rows, multiply);
        } else {
            let mut rows = rows();
            values.chunks_mut(chunk).enumerate().for_each(|out| multiply(&mut rows, out));
        }
        residues.into_iter().flatten().for_each(|residues| self.give_back(residues));
        Kept { values, count, extent, range, size }
    }
}

vectorised! {
    /// Adds the weighted product of reduced values.
    fn add_product(primes: &'a Primes, weight: i64, x: &'a [Lanes], y: &'a [Lanes], sum: &'a mut [Lanes]) {
        let primes = *primes;
        let weight = primes.integer(weight);
        for ((sum, &x), &y) in sum.iter_mut().zip(x).zip(y) {
            turn();
            *sum = primes.reduce(*sum + primes.mul(primes.mul(x, y), weight));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Integer;

    /// Sums of products by integers, with what is folded over and with small factors of which digits are dropped.
    #[test]
    fn products_are_those_of_integers() {
        let bits = 192;
        let shop = Workshop::new(bits, 24, (0, 1));
        let series = |len: usize, seed: u64, fall: u32| -> Vec<Integer> {
            let value = |j: usize| {
                let mut value = Integer::from(seed + 3 * j as u64);
                for _ in 0..4 {
                    value = value * 0x9e37_79b9_7f4a_7c15u64 + 12345;
                }
                let value = (value >> (60 + fall)) % (Integer::from(1) << (bits + 2 - fall));
                if j.is_multiple_of(3) { -value } else { value }
            };
            (0..len).map(value).collect()
        };
        for (first, second, fall, range) in [
            (20, 20, 0, 0..20),
            (20, 13, 0, 10..26),
            (40, 40, 90, 20..40),
            (7, 30, 130, 7..30),
            (5, 5, 0, 5..5),
        ] {
            let a = [series(first, 1, 0), series(first, 2, 0)];
            let b = [series(second, 3, fall), series(second, 4, fall)];
            let fixed = |series: &Vec<Integer>| Fixed::from_integers(series, shop.width());
            let (x, y) = (a.each_ref().map(fixed), b.each_ref().map(fixed));
            let found = shop.products(&[(-1, &x[0], &y[0]), (1, &x[1], &y[1])], range.clone());
            assert_eq!(found.len(), range.len());
            for (i, k) in range.enumerate() {
                let term = |a: &[Integer], b: &[Integer]| {
                    (0..=k)
                        .filter(|&i| i < first && k - i < second)
                        .map(|i| Integer::from(&a[i] * &b[k - i]))
                        .sum()
                };
                let [minus, plus]: [Integer; 2] = [term(&a[0], &b[0]), term(&a[1], &b[1])];
                let exact = (plus - minus) >> bits;
                let error = found.integer(i) - exact;
                assert!(error.significant_bits() <= 2, "{first} {second} {fall} {k}: {error}");
            }
            assert!(!shop.overflowed());
        }
    }

    /// What a sum is known to be decides whether it fits its words, and how many primes it needs.
    #[test]
    fn extents_are_those_of_all_terms() {
        let shop = Workshop::new(192, 24, (0, 1));
        let series = Fixed::from_integers(&[Integer::from(1) << 150, Integer::from(5)], shop.width());
        // 151 bits twice, two terms each, and as many products.
        for (products, weight, peak) in
            [(1, 1, 302 + 1 + 1 + 2 + 2), (2, 1, 302 + 1 + 1 + 2 + 3), (9, -4, 302 + 3 + 1 + 2 + 5)]
        {
            let factors = vec![(weight, series.clone(), series.clone()); products];
            let kept = shop.kept(&factors, 4, 0..3);
            assert_eq!((kept.extent, kept.count), (Extent { peak, reach: peak }, groups_for(peak)));
        }
        let most = 128 + 64 * shop.width() as u32 - 2;
        let sum = |bits: u32| Sum {
            size: 4,
            count: 1,
            extent: Extent { peak: bits, reach: bits },
            values: vec![Lanes::ZERO; 4],
        };
        for (bits, overflows) in [(100, false), (most - 1, false), (most, false), (most + 1, true)] {
            let shop = Workshop::new(192, 24, (0, 1));
            assert_eq!(shop.settle(sum(bits), 3, 128), Fixed::zero(3, shop.width()));
            assert_eq!(shop.overflowed(), overflows, "{bits}");
        }
    }
}
