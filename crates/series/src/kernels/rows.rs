//! Sums over `k + l = n` of rows that become known one after the other.
//!
//! Blocks of rows are transformed once more, along the rows: of the products that a row needs, all but those with
//! the block under way are then found for a whole block of results at once (van der Hoeven's relaxed products,
//! with one size of blocks). All of it is exact modulo every prime.

use super::lanes::{Lanes, turn, vectorised};
use super::prime::Primes;
use super::workshop::{Extent, Sum, Term, Transformed, Workshop, extent_of};
use rayon::prelude::*;

/// Results below which blocks don't pay.
const FEW: usize = 64;
/// More rows than there can be.
const NEVER: usize = 1 << 32;

/// The rows of a block where so many rows are wanted; without limit where blocks don't pay.
pub(crate) fn block_for(rows: usize) -> usize {
    match rows {
        0..FEW => NEVER,
        FEW..400 => 16,
        _ => 32,
    }
}

/// Rows of transformed series: those of the first and of the last block one by one, and whole blocks.
pub(crate) struct Rows {
    block: usize,
    single: Vec<Option<Transformed>>,
    /// Terms and extent of every row.
    sizes: Vec<(usize, Extent)>,
    blocks: Vec<Transformed>,
}

impl Rows {
    pub fn new(block: usize) -> Self {
        Self { block, single: Vec::new(), sizes: Vec::new(), blocks: Vec::new() }
    }

    pub fn len(&self) -> usize {
        self.single.len()
    }

    /// Adds the next row. Completes a block with its last row; forgets that block's rows with the next one.
    pub fn push(&mut self, shop: &Workshop, row: Transformed) {
        let block = self.block;
        if self.len() >= 2 * block && self.len().is_multiple_of(block) {
            let start = self.len() - block;
            self.single[start..].fill(None);
        }
        self.sizes.push((row.len, row.extent));
        self.single.push(Some(row));
        if self.len().is_multiple_of(block) {
            let start = self.len() - block;
            let rows: Vec<&Transformed> = self.single[start..].iter().flatten().collect();
            self.blocks.push(shop.along(&rows));
        }
    }

    /// A row of the first or of the last block.
    pub fn row(&self, k: usize) -> &Transformed {
        self.single[k].as_ref().expect("a row of the first or of the last block")
    }

    /// The rows in a block.
    pub fn block(&self) -> usize {
        self.block
    }

    /// The extent of `weight a_k b_l` for any rows there are.
    pub fn extent_of_any(&self, weight: i64, other: &Self) -> Extent {
        let largest = |rows: &[(usize, Extent)]| {
            let join = |(len, extent): (usize, Extent), &(l, e): &(usize, Extent)| (len.max(l), extent.or(e));
            rows.iter().fold((1, Extent::default()), join)
        };
        extent_of(weight, largest(&self.sizes), largest(&other.sizes))
    }

    /// The extent of `weight a_k b_l`.
    pub fn extent_of_product(&self, k: usize, weight: i64, other: &Self, l: usize) -> Extent {
        extent_of(weight, self.sizes[k], other.sizes[l])
    }
}

/// `sum_(k+l=n) a_k b_l` over the pairs of complete blocks, for all `n` of a block.
#[derive(Default)]
pub(crate) struct Convolution {
    known: Option<Known>,
}

struct Known {
    block: usize,
    /// The sum over pairs of later blocks, transformed.
    inner: Sum,
    /// For each group of primes the results of the block, row by row.
    rows: Vec<Lanes>,
}

impl Convolution {
    /// Finds the results of block `t >= 1`, for which blocks `0 .. t` of both factors are needed.
    ///
    /// Of the products of blocks `i + j = t` the first half counts, of `i + j = t - 1` the second. A shift by
    /// half the length changes the sign of the odd frequencies, which stand in the second half.
    pub fn prepare(&mut self, shop: &Workshop, a: &Rows, b: &Rows, t: usize) {
        if self.known.as_ref().is_some_and(|known| known.block == t) {
            return;
        }
        let pairs = |sum: usize, from: usize, to: usize| -> Vec<(&Transformed, &Transformed)> {
            (from..to).map(|i| (&a.blocks[i], &b.blocks[sum - i])).collect()
        };
        let before = self.known.take().filter(|known| known.block + 1 == t).map(|known| known.inner);
        let mut shifted = before.unwrap_or_else(|| shop.sum_of_all(&pairs(t - 1, 1, t - 1), &a.blocks[0]));
        let mut edges = pairs(t - 1, 0, 1);
        if t > 1 {
            edges.extend(pairs(t - 1, t - 1, t));
        }
        shop.add_all(&mut shifted, &edges);
        let inner = shop.sum_of_all(&pairs(t, 1, t), &a.blocks[0]);
        let rows = shop.rows_of(&inner, &shifted, a.block);
        self.known = Some(Known { block: t, inner, rows });
    }

    /// Adds the result of row `r` of the block times a weight.
    pub fn add_row(&self, shop: &Workshop, sum: &mut Sum, r: usize, weight: i64) {
        let Some(known) = &self.known else { return };
        let size = sum.size;
        let rows = known.rows.len() / (size * shop.all_primes());
        let add = |(i, values): (usize, &mut [Lanes])| {
            let start = (i * rows + r) * size;
            add_weighted(&shop.primes[i], values, &known.rows[start..start + size], weight);
        };
        sum.values.par_chunks_mut(size).enumerate().for_each(add);
    }
}

impl Workshop {
    /// A block of rows, zeros behind, transformed along the rows: twice as many values at every point.
    fn along(&self, rows: &[&Transformed]) -> Transformed {
        let (size, block) = (rows[0].size, rows.len());
        let count = rows.iter().map(|row| row.count).min().unwrap_or(0);
        let roots = self.roots(2 * block);
        let mut values = vec![Lanes::ZERO; 2 * block * size * count];
        let fill = |(i, out): (usize, &mut [Lanes])| {
            for (point, out) in out.chunks_exact_mut(2 * block).enumerate() {
                for (value, row) in out.iter_mut().zip(rows) {
                    *value = row.values[i * size + point];
                }
                roots[i].forward(out);
            }
        };
        values.par_chunks_mut(2 * block * size).enumerate().for_each(fill);
        Transformed { size: 2 * block * size, count, len: 0, extent: Extent::default(), values }
    }

    /// The sum of products modulo all primes; extents are the caller's.
    fn sum_of_all(&self, pairs: &[(&Transformed, &Transformed)], like: &Transformed) -> Sum {
        let values = vec![Lanes::ZERO; like.values.len()];
        let mut sum = Sum { size: like.size, count: like.count, extent: Extent::default(), values };
        self.add_all(&mut sum, pairs);
        sum
    }

    fn add_all(&self, sum: &mut Sum, pairs: &[(&Transformed, &Transformed)]) {
        if pairs.is_empty() {
            return;
        }
        let terms: Vec<Term> = pairs.iter().map(|&(a, b)| (1, a, b)).collect();
        self.add_terms(&terms, sum.size, &mut sum.values);
    }

    /// Transforms back along the rows: the first half of one sum and the second half of another.
    fn rows_of(&self, first: &Sum, second: &Sum, block: usize) -> Vec<Lanes> {
        let size = first.size / (2 * block);
        let roots = self.roots(2 * block);
        let mut rows = vec![Lanes::ZERO; block * size * first.count];
        let fill = |(i, out): (usize, &mut [Lanes])| {
            let mut column = vec![Lanes::ZERO; 2 * block];
            for point in 0..size {
                let start = i * first.size + point * 2 * block;
                let (x, y) =
                    (&first.values[start..start + 2 * block], &second.values[start..start + 2 * block]);
                join(&self.primes[i], x, y, &mut column);
                roots[i].backward(&mut column);
                for (row, &value) in out.chunks_exact_mut(size).zip(&column) {
                    row[point] = value;
                }
            }
            scale(&self.primes[i], out, roots[i].scale());
        };
        rows.par_chunks_mut(block * size).enumerate().for_each(fill);
        rows
    }
}

vectorised! {
    /// `x` plus the shifted `y`.
    fn join(primes: &'a Primes, x: &'a [Lanes], y: &'a [Lanes], out: &'a mut [Lanes]) {
        let half = out.len() / 2;
        for (q, value) in out.iter_mut().enumerate() {
            turn();
            *value = primes.reduce(if q < half { x[q] + y[q] } else { x[q] - y[q] });
        }
    }
}

vectorised! {
    fn scale(primes: &'a Primes, values: &'a mut [Lanes], scale: Lanes) {
        for value in values {
            turn();
            *value = primes.reduce(primes.mul(*value, scale));
        }
    }
}

vectorised! {
    /// Adds the reduced `x` times a weight.
    fn add_weighted(primes: &'a Primes, sum: &'a mut [Lanes], x: &'a [Lanes], weight: i64) {
        let weight = primes.integer(weight);
        for (sum, &x) in sum.iter_mut().zip(x) {
            turn();
            *sum = primes.reduce(*sum + primes.mul(x, weight));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Fixed;
    use super::*;
    use rug::Integer;

    /// Rows found block by block are those of the sum of all products, at every place.
    #[test]
    fn blocks_give_the_sum_of_all_products() {
        for bits in [64, 400] {
            blocks_give_sums(&Workshop::new(bits, 40, (0, 1)));
        }
    }

    fn blocks_give_sums(shop: &Workshop) {
        let (block, size, rows) = (4, 12, 23);
        let row = |k: usize, seed: i64| -> Fixed {
            let value = |j: usize| {
                Integer::from((k as i64 * 7919 + j as i64 * 104_729 + seed) % 1000 - 500)
                    << (shop.bits() - 14)
            };
            Fixed::from_integers(&(0..5).map(value).collect::<Vec<_>>(), shop.width())
        };
        let (mut a, mut b) = (Rows::new(block), Rows::new(block));
        let mut all: Vec<(Transformed, Transformed)> = Vec::new();
        let mut sums = Convolution::default();
        for n in 0..rows {
            let (t, r) = (n / block, n % block);
            if t > 0 {
                sums.prepare(shop, &a, &b, t);
                let zero = |values: Vec<Lanes>| Sum {
                    size,
                    count: shop.all_primes(),
                    extent: Extent::default(),
                    values,
                };
                let mut found = zero(vec![Lanes::ZERO; size * shop.all_primes()]);
                sums.add_row(shop, &mut found, r, -3);
                // Pairs of two complete blocks.
                let pairs = (0..=n).filter(|&k| k / block < t && (n - k) / block < t);
                let terms: Vec<_> = pairs.map(|k| (-3, &all[k].0, &all[n - k].1)).collect();
                let expected = if terms.is_empty() {
                    zero(vec![Lanes::ZERO; found.values.len()])
                } else {
                    shop.sum(&terms)
                };
                let count = expected.count;
                assert_eq!(found.values[..size * count], expected.values, "row {n}");
            }
            let transform = |row: &Fixed| shop.transform(row, size, shop.all_primes());
            let (x, y) = (transform(&row(n, 17)), transform(&row(n, 91)));
            all.push((x.clone(), y.clone()));
            a.push(shop, x);
            b.push(shop, y);
        }
        // Blocks in any order are those of their own.
        let found = |sums: &mut Convolution, t: usize| {
            sums.prepare(shop, &a, &b, t);
            let mut row = Sum {
                size,
                count: shop.all_primes(),
                extent: Extent::default(),
                values: vec![Lanes::ZERO; size * shop.all_primes()],
            };
            sums.add_row(shop, &mut row, 1, 5);
            row.values
        };
        for t in [4, 2, 3, 1, 4] {
            assert_eq!(found(&mut sums, t), found(&mut Convolution::default(), t), "block {t}");
        }
    }

    #[test]
    fn blocks_grow_with_the_rows_that_are_wanted() {
        assert_eq!([0, 63, 64, 399, 400, 5000].map(block_for), [NEVER, NEVER, 16, 16, 32, 32]);
    }

    #[test]
    fn extents_of_products_are_those_of_their_rows() {
        let shop = Workshop::new(64, 40, (0, 1));
        let mut rows = Rows::new(8);
        for bits in [3, 40, 21] {
            let row = Fixed::from_integers(&[Integer::from(1) << (bits - 1), Integer::from(1)], shop.width());
            rows.push(&shop, shop.transform(&row, 4, 1));
        }
        let extent = |bits: u32| Extent { peak: bits, reach: bits };
        // 8 has four bits, two terms one, and two to spare.
        assert_eq!(rows.extent_of_product(0, 8, &rows, 2), extent(3 + 21 + 4 + 1 + 2));
        assert_eq!(rows.extent_of_product(1, -1, &rows, 1), extent(40 + 40 + 1 + 1 + 2));
        assert_eq!(rows.extent_of_any(8, &rows), extent(40 + 40 + 4 + 1 + 2));
    }
}
