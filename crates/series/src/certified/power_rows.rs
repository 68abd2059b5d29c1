//! A power of a series in two variables, row by row, with the defect of what was found.

use crate::kernels::{Convolution, Extent, Fixed, Rows, Sum, Term, Workshop, block_for};

/// Rows of a series `X` as factors of products, with their multiples.
pub(crate) struct Base {
    pub plain: Rows,
    /// Row `k` times `k`, where rows are multiplied in blocks.
    pub weighted: Option<Rows>,
    size: usize,
}

impl Base {
    /// For transforms of a size, and so many rows.
    pub fn new(size: usize, rows: usize) -> Self {
        let block = block_for(rows);
        Self { plain: Rows::new(block), weighted: (block < rows).then(|| Rows::new(block)), size }
    }

    pub fn push(&mut self, shop: &Workshop, row: &Fixed) {
        let row = shop.transform(row, self.size, shop.all_primes());
        if let Some(weighted) = &mut self.weighted {
            weighted.push(shop, row.times(shop, u32::try_from(self.plain.len()).unwrap_or(u32::MAX)));
        }
        self.plain.push(shop, row);
    }
}

/// A power `P = c X^p` of `X = sum_k w^k X_k`, by Miller's formula over series:
///
/// ```text
/// n (X_0 P_n - p X_n P_0) = sum_(k=1..n-1) (p k - (n-k)) X_k P_(n-k)
/// ```
///
/// `p` is `steps/unit`; the constant `c` is that of the first row.
pub(crate) struct PowerRows {
    steps: i64,
    unit: i64,
    size: usize,
    pub rows: Rows,
    weighted: Convolution,
    plain: Convolution,
}

impl PowerRows {
    /// For transforms of a size, and so many rows.
    pub fn new(steps: i64, unit: i64, size: usize, rows: usize) -> Self {
        let rows = Rows::new(block_for(rows));
        Self { steps, unit, size, rows, weighted: Convolution::default(), plain: Convolution::default() }
    }

    pub fn push(&mut self, shop: &Workshop, row: &Fixed) {
        self.rows.push(shop, shop.transform(row, self.size, shop.all_primes()));
    }

    /// The part of row `n >= 1` that the rows below determine, times `unit n`.
    pub fn lower(&mut self, shop: &Workshop, x: &Base) -> Sum {
        let n = self.rows.len();
        let block = self.rows.block();
        let (t, r) = (n / block, n % block);
        let weights = [self.steps + self.unit, -self.unit * n as i64];
        let rows = &self.rows;
        let weight = |k: usize| weights[0] * k as i64 + weights[1];
        let product = |k: usize| x.plain.extent_of_product(k, weight(k), rows, n - k);
        let extent = (1..n).map(product).fold(Extent::default(), Extent::or).plus((2 * n).ilog2() + 2);
        let first = 1..if t == 0 { n } else { r + 1 };
        let last = (1..if t == 0 { 1 } else { r + 1 }).map(|l| n - l);
        let terms: Vec<Term> =
            first.chain(last).map(|k| (weight(k), x.plain.row(k), rows.row(n - k))).collect();
        // The defect has two more products, of rows that are hardly larger than those below.
        let weight = (self.steps.abs() + self.unit) * n as i64;
        let spare = extent.or(x.plain.extent_of_any(weight, rows)).plus(24);
        let mut sum = shop.sum_for(&terms, self.size, spare);
        if let (1.., Some(weighted)) = (t, &x.weighted) {
            for (sums, x, weight) in
                [(&mut self.weighted, weighted, weights[0]), (&mut self.plain, &x.plain, weights[1])]
            {
                sums.prepare(shop, x, &self.rows, t);
                sums.add_row(shop, &mut sum, r, weight);
            }
            shop.set_extent(&mut sum, extent);
        }
        sum
    }

    /// The defect of row `n`, the last one, times `unit n`: the whole sum over `k = 0..n`.
    pub fn defect(&self, shop: &Workshop, x: &Base, mut lower: Sum) -> Option<Sum> {
        let n = self.rows.len() - 1;
        let weight = self.unit * n as i64;
        let (first, last) = (self.rows.row(0), self.rows.row(n));
        let ends = [(-weight, x.plain.row(0), last), (self.steps * n as i64, x.plain.row(n), first)];
        shop.add(&mut lower, &ends)?;
        Some(lower)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Integer;

    /// `X = 1 + w` to the power 1, in steps of `1/10^18`: the defect of its first order weighs two products by
    /// `10^18`, for which no lower order makes room, and is what `P_1` is off by.
    #[test]
    fn defects_have_room_for_large_weights() {
        let (steps, size) = (1_000_000_000_000_000_000, 8);
        for (bits, off) in (128..256).step_by(8).zip([0, 1, -3].into_iter().cycle()) {
            let shop = Workshop::new(bits, 80, (2, 1));
            let row = |value: i64| Fixed::from_integers(&[Integer::from(value) << bits], shop.width());
            let (mut x, mut power) = (Base::new(size, 2), PowerRows::new(steps, steps, size, 2));
            x.push(&shop, &row(1));
            x.push(&shop, &row(1));
            power.push(&shop, &row(1));
            let lower = power.lower(&shop, &x);
            power.push(&shop, &row(1 + off));
            let defect = shop.settle(power.defect(&shop, &x, lower).unwrap(), 1, bits);
            assert_eq!(defect.integer(0), -(Integer::from(steps * off) << bits));
        }
    }
}
