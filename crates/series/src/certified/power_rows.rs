//! A power of a series in two variables, row by row, with the defect of what was found.

use crate::kernels::{Extent, Fixed, Sum, Transformed, Workshop};

/// Rows of a series `X` as factors of products, with their multiples.
#[derive(Default)]
pub(crate) struct Rows {
    pub plain: Vec<Transformed>,
    /// Row `k` times `k`.
    pub weighted: Vec<Transformed>,
}

impl Rows {
    pub fn push(&mut self, shop: &Workshop, row: &Fixed, size: usize) {
        let row = shop.transform(row, size, shop.all_primes());
        let order = u32::try_from(self.plain.len()).unwrap_or(u32::MAX);
        self.weighted.push(row.times(shop, order));
        self.plain.push(row);
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
    rows: Vec<Transformed>,
}

impl PowerRows {
    pub fn new(steps: i64, unit: i64) -> Self {
        Self { steps, unit, rows: Vec::new() }
    }

    pub fn push(&mut self, shop: &Workshop, row: &Fixed, size: usize) {
        self.rows.push(shop.transform(row, size, shop.all_primes()));
    }

    pub fn row(&self, k: usize) -> &Transformed {
        &self.rows[k]
    }

    /// The part of row `n >= 2` that the rows below determine, times `unit n`.
    pub fn lower(&self, shop: &Workshop, x: &Rows) -> Sum {
        let n = self.rows.len();
        let weighted = (1..n).map(|k| (&x.weighted[k], &self.rows[n - k])).collect();
        let plain = (1..n).map(|k| (&x.plain[k], &self.rows[n - k])).collect();
        let weight = (self.steps.abs() + self.unit) * n as i64;
        // The defect has two more products, of rows that are hardly larger than those below.
        let largest =
            |rows: &[Transformed]| rows.iter().map(Transformed::extent).fold(Extent::default(), Extent::or);
        let sizes = x.plain[0].size().ilog2() + weight.ilog2() + n.ilog2() + 40;
        let extent = largest(&x.plain).times(largest(&self.rows)).plus(sizes);
        let groups = [(self.steps + self.unit, weighted), (-self.unit * n as i64, plain)];
        shop.sum_of_groups(&groups, self.rows[0].size(), extent)
    }

    /// The defect of row `n`, the last one, times `unit n`: the whole sum over `k = 0..n`.
    pub fn defect(&self, shop: &Workshop, x: &Rows, mut lower: Sum) -> Option<Sum> {
        let n = self.rows.len() - 1;
        let weight = self.unit * n as i64;
        let (first, last) = (&self.rows[0], &self.rows[n]);
        shop.add(&mut lower, &[(-weight, &x.plain[0], last), (self.steps * n as i64, &x.plain[n], first)])?;
        Some(lower)
    }
}
