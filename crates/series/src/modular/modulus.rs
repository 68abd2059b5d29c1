//! Power series modulo one word-size prime.

use crate::kernels::{Prime, Roots, size_for};
use std::cell::RefCell;
use std::rc::Rc;

/// Length up to which products are taken term by term.
const SHORT: usize = 24;

/// A prime with what series modulo it need. It must not divide a denominator.
///
/// All numbers are in Montgomery's form.
pub(super) struct Modulus {
    pub prime: Prime,
    /// The roots of the latest size.
    roots: RefCell<Option<(usize, Rc<Roots>)>>,
}

/// A series and, if it is long, its transform.
#[derive(Clone, Debug)]
pub(super) struct Transformed {
    forms: Vec<u64>,
    values: Vec<u64>,
}

impl Modulus {
    pub fn new(prime: Prime) -> Self {
        Self { prime, roots: RefCell::new(None) }
    }

    /// `x numerator/denominator`.
    pub fn scaled(&self, x: u64, numerator: i64, denominator: i64) -> u64 {
        let prime = &self.prime;
        prime.mul(prime.mul(x, prime.form(numerator)), prime.inverse(prime.form(denominator)))
    }

    pub fn negated(&self, x: u64) -> u64 {
        self.prime.sub(0, x)
    }

    pub fn sum(&self, x: &[u64], y: &[u64]) -> Vec<u64> {
        x.iter().zip(y).map(|(&x, &y)| self.prime.add(x, y)).collect()
    }

    /// Prepares the first `len` coefficients for products.
    pub fn transform(&self, series: &[u64], len: usize) -> Transformed {
        let forms = series[..series.len().min(len)].to_vec();
        let values = if len > SHORT { self.transformed(&forms, size_for(2 * len)) } else { Vec::new() };
        Transformed { forms, values }
    }

    /// The first `len` coefficients of `sum_t weight_t a_t b_t`.
    pub fn sum_of_products(&self, terms: &[(i64, &Transformed, &Transformed)], len: usize) -> Vec<u64> {
        if len > SHORT { self.long_sum(terms, len) } else { self.short_sum(terms, len) }
    }

    /// The first `len` coefficients of a product.
    pub fn product(&self, a: &[u64], b: &[u64], len: usize) -> Vec<u64> {
        self.sum_of_products(&[(1, &self.transform(a, len), &self.transform(b, len))], len)
    }

    /// Multiplies coefficient `j` by the fraction `weights(j)`.
    ///
    /// All denominators are inverted together: `1/x = y/(x y)` (Montgomery's trick).
    pub fn scale_each(&self, series: &[u64], weights: impl Fn(usize) -> (i64, i64)) -> Vec<u64> {
        let prime = &self.prime;
        let weights: Vec<(u64, u64)> =
            (0..series.len()).map(weights).map(|(n, d)| (prime.form(n), prime.form(d))).collect();
        let mut before = Vec::with_capacity(series.len());
        let all = weights.iter().fold(prime.one, |product, (_, d)| {
            before.push(product);
            prime.mul(product, *d)
        });
        let mut after = prime.inverse(all);
        let mut scaled = series.to_vec();
        for (i, x) in scaled.iter_mut().enumerate().rev() {
            let (numerator, denominator) = weights[i];
            let inverse = prime.mul(after, before[i]);
            after = prime.mul(after, denominator);
            *x = prime.mul(*x, prime.mul(numerator, inverse));
        }
        scaled
    }

    fn roots(&self, size: usize) -> Rc<Roots> {
        let mut latest = self.roots.borrow_mut();
        match latest.as_ref() {
            Some((known, roots)) if *known == size => Rc::clone(roots),
            _ => {
                let roots = Rc::new(Roots::new(self.prime, size));
                *latest = Some((size, Rc::clone(&roots)));
                roots
            }
        }
    }

    fn transformed(&self, forms: &[u64], size: usize) -> Vec<u64> {
        let mut values = forms.to_vec();
        values.resize(size, 0);
        self.roots(size).forward(&mut values);
        values
    }

    fn long_sum(&self, terms: &[(i64, &Transformed, &Transformed)], len: usize) -> Vec<u64> {
        let prime = &self.prime;
        let size = size_for(2 * len);
        let mut sum = vec![0; size];
        for (weight, a, b) in terms {
            let weight = prime.form(*weight);
            let fresh = |x: &Transformed| self.transformed(&x.forms[..x.forms.len().min(len)], size);
            let (fresh_a, fresh_b);
            let a = if a.values.len() == size {
                &a.values
            } else {
                fresh_a = fresh(a);
                &fresh_a
            };
            let b = if b.values.len() == size {
                &b.values
            } else {
                fresh_b = fresh(b);
                &fresh_b
            };
            for ((s, &x), &y) in sum.iter_mut().zip(a).zip(b) {
                *s = prime.add(*s, prime.mul(prime.mul(x, y), weight));
            }
        }
        self.roots(size).backward(&mut sum);
        sum.truncate(len);
        sum
    }

    fn short_sum(&self, terms: &[(i64, &Transformed, &Transformed)], len: usize) -> Vec<u64> {
        let prime = &self.prime;
        let mut sum = vec![0; len];
        for (weight, a, b) in terms {
            let weight = prime.form(*weight);
            for (i, &x) in a.forms.iter().enumerate().take(len) {
                let x = prime.mul(x, weight);
                for (s, &y) in sum[i..].iter_mut().zip(&b.forms) {
                    *s = prime.add(*s, prime.mul(x, y));
                }
            }
        }
        sum
    }
}
