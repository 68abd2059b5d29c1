//! Sums over `k + l = n` of rows that become known one after the other.
//!
//! Blocks of rows are transformed once more, along the rows: of the products that a row needs, all but those with
//! the block under way are then found for a whole block of results at once (van der Hoeven's relaxed products,
//! with one size of blocks). All of it is exact modulo every prime.

use super::transform::Roots;
use super::workshop::{Extent, Sum, Transformed, Workshop, extent_of};
use rayon::prelude::*;

/// Results below which blocks don't pay.
const FEW: usize = 64;
/// More rows than there can be.
const NEVER: usize = 1 << 32;
/// Points that are transformed along the rows together: one line of the cache.
const POINTS: usize = 8;

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
    /// For each prime the results of the block, row by row.
    rows: Vec<u64>,
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
        let add = |(i, values): (usize, &mut [u64])| {
            let prime = &shop.primes[i];
            let weight = prime.form(weight);
            let start = (i * rows + r) * size;
            for (value, &x) in values.iter_mut().zip(&known.rows[start..start + size]) {
                *value = prime.add(*value, prime.mul(x, weight));
            }
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
        let mut values = vec![0; 2 * block * size * count];
        let fill = |(i, out): (usize, &mut [u64])| {
            for (tile, out) in out.chunks_mut(2 * block * POINTS).enumerate() {
                let start = i * size + tile * POINTS;
                let points = out.len() / (2 * block);
                for (k, row) in rows.iter().enumerate() {
                    for (point, &value) in row.values[start..start + points].iter().enumerate() {
                        out[point * 2 * block + k] = value;
                    }
                }
                out.chunks_exact_mut(2 * block).for_each(|values| roots[i].forward(values));
            }
        };
        values.par_chunks_mut(2 * block * size).enumerate().for_each(fill);
        Transformed { size: 2 * block * size, count, len: 0, extent: Extent::default(), values }
    }

    /// The sum of products modulo all primes; extents are the caller's.
    fn sum_of_all(&self, pairs: &[(&Transformed, &Transformed)], like: &Transformed) -> Sum {
        let values = vec![0; like.values.len()];
        let mut sum = Sum { size: like.size, count: like.count, extent: Extent::default(), values };
        self.add_all(&mut sum, pairs);
        sum
    }

    fn add_all(&self, sum: &mut Sum, pairs: &[(&Transformed, &Transformed)]) {
        if pairs.is_empty() {
            return;
        }
        let size = sum.size;
        let groups = [(1, pairs.to_vec())];
        let add = |(i, row): (usize, &mut [u64])| self.add_groups(i, size, &groups, row);
        sum.values.par_chunks_mut(size).enumerate().for_each(add);
    }

    /// Transforms back along the rows: the first half of one sum and the second half of another.
    fn rows_of(&self, first: &Sum, second: &Sum, block: usize) -> Vec<u64> {
        let size = first.size / (2 * block);
        let roots = self.roots(2 * block);
        let mut rows = vec![0; block * size * first.count];
        let fill = |(i, out): (usize, &mut [u64])| {
            let mut tile = vec![0; 2 * block * POINTS];
            for point in (0..size).step_by(POINTS) {
                let points = POINTS.min(size - point);
                for p in 0..points {
                    let start = i * first.size + (point + p) * 2 * block;
                    let (x, y) =
                        (&first.values[start..start + 2 * block], &second.values[start..start + 2 * block]);
                    self.join(&roots[i], i, (x, y), &mut tile[p * 2 * block..(p + 1) * 2 * block]);
                }
                for (r, row) in out.chunks_exact_mut(size).enumerate() {
                    for (p, value) in row[point..point + points].iter_mut().enumerate() {
                        *value = tile[p * 2 * block + r];
                    }
                }
            }
        };
        rows.par_chunks_mut(block * size).enumerate().for_each(fill);
        rows
    }

    /// Transforms `x` plus the shifted `y` back.
    fn join(&self, roots: &Roots, i: usize, (x, y): (&[u64], &[u64]), out: &mut [u64]) {
        let prime = &self.primes[i];
        let half = out.len() / 2;
        for (q, value) in out.iter_mut().enumerate() {
            *value = if q < half { prime.add(x[q], y[q]) } else { prime.sub(x[q], y[q]) };
        }
        roots.backward(out);
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
        let shop = Workshop::new(64, 40, (0, 1));
        let (block, size, rows) = (4, 12, 23);
        let row = |k: usize, seed: i64| -> Fixed {
            let value =
                |j: usize| Integer::from((k as i64 * 7919 + j as i64 * 104_729 + seed) % 1000 - 500) << 50;
            Fixed::from_integers(&(0..5).map(value).collect::<Vec<_>>(), shop.width())
        };
        let (mut a, mut b) = (Rows::new(block), Rows::new(block));
        let mut all: Vec<(Transformed, Transformed)> = Vec::new();
        let mut sums = Convolution::default();
        for n in 0..rows {
            let (t, r) = (n / block, n % block);
            if t > 0 {
                sums.prepare(&shop, &a, &b, t);
                let zero = |values: Vec<u64>| Sum {
                    size,
                    count: shop.all_primes(),
                    extent: Extent::default(),
                    values,
                };
                let mut found = zero(vec![0; size * shop.all_primes()]);
                sums.add_row(&shop, &mut found, r, -3);
                // Pairs of two complete blocks.
                let pairs = (0..=n).filter(|&k| k / block < t && (n - k) / block < t);
                let terms: Vec<_> = pairs.map(|k| (-3, &all[k].0, &all[n - k].1)).collect();
                let expected =
                    if terms.is_empty() { zero(vec![0; found.values.len()]) } else { shop.sum(&terms) };
                let count = expected.count;
                assert_eq!(found.values[..size * count], expected.values, "row {n}");
            }
            let transform = |row: &Fixed| shop.transform(row, size, shop.all_primes());
            let (x, y) = (transform(&row(n, 17)), transform(&row(n, 91)));
            all.push((x.clone(), y.clone()));
            a.push(&shop, x);
            b.push(&shop, y);
        }
    }
}
