//! Power series modulo eight primes at once.

use crate::kernels::{Lanes, Primes, Roots, least_length, size_for, turn, vectorised};
use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::Range;
use std::rc::Rc;

/// Reciprocals that are found side by side, since each waits for the one before.
const CHAINS: usize = 4;

/// Eight prime fields with what products of series need. Residues are reduced.
pub(super) struct Residues {
    pub primes: Primes,
    roots: RefCell<HashMap<usize, Rc<Roots>>>,
}

/// Terms `weight a b` of a sum of products.
pub(super) type Terms<'t> = [(i64, &'t [Lanes], &'t [Lanes])];

impl Residues {
    pub fn new(primes: Primes) -> Self {
        Self { primes, roots: RefCell::default() }
    }

    fn roots(&self, size: usize) -> Rc<Roots> {
        let mut roots = self.roots.borrow_mut();
        Rc::clone(roots.entry(size).or_insert_with(|| Rc::new(Roots::new(self.primes, size))))
    }

    /// The transform of a series.
    pub fn transform(&self, series: &[Lanes], size: usize) -> Vec<Lanes> {
        let mut values = vec![Lanes::ZERO; size];
        values[..series.len()].copy_from_slice(series);
        self.roots(size).forward(&mut values);
        values
    }

    /// The first `len` coefficients of a sum of products of transforms, over a number.
    pub fn sum(&self, terms: &Terms, len: usize, divisor: i64) -> Vec<Lanes> {
        let size = terms[0].1.len();
        let mut sum = vec![Lanes::ZERO; size];
        for &(weight, a, b) in terms {
            add_product(&self.primes, &mut sum, weight, a, b);
        }
        let roots = self.roots(size);
        roots.backward(&mut sum);
        sum.truncate(len);
        scale(&self.primes, &mut sum, roots.scale(), divisor);
        sum
    }

    /// Some coefficients of a sum of products of series whose first factors have one length, and whose second have one.
    ///
    /// The transforms are so long that what is folded over falls below the range, and no longer.
    pub fn products(&self, terms: &Terms, range: Range<usize>) -> Vec<Lanes> {
        let cut = |series: &'_ [Lanes]| series.len().min(range.end);
        let size = size_for(least_length(cut(terms[0].1), cut(terms[0].2), &range));
        let transform = |series: &[Lanes]| self.transform(&series[..cut(series)], size);
        let factors: Vec<_> = terms.iter().map(|(_, a, b)| (transform(a), transform(b))).collect();
        let transformed: Vec<_> = terms
            .iter()
            .zip(&factors)
            .map(|((weight, ..), (a, b))| (*weight, a.as_slice(), b.as_slice()))
            .collect();
        let mut product = self.sum(&transformed, size.min(range.end), 1);
        product.resize(range.end, Lanes::ZERO);
        product.split_off(range.start)
    }

    /// The first `len` coefficients of a product.
    pub fn product(&self, a: &[Lanes], b: &[Lanes], len: usize) -> Vec<Lanes> {
        self.products(&[(1, a, b)], 0..len)
    }

    /// The series with coefficient `j` times the integer `weight(j)`.
    pub fn weighted(&self, series: &[Lanes], weight: impl Fn(usize) -> i64) -> Vec<Lanes> {
        let weights: Vec<i64> = (0..series.len()).map(weight).collect();
        let mut out = series.to_vec();
        multiply_by_integers(&self.primes, &mut out, &weights);
        out
    }

    /// The series with coefficient `j` times a number.
    pub fn scaled(&self, mut series: Vec<Lanes>, numbers: &[Lanes]) -> Vec<Lanes> {
        multiply(&self.primes, &mut series, numbers);
        series
    }

    /// The series over an integer that no prime divides.
    pub fn over(&self, mut series: Vec<Lanes>, divisor: i64) -> Vec<Lanes> {
        scale(&self.primes, &mut series, Lanes::ONE, divisor);
        series
    }

    /// The reciprocals of integers that no prime divides.
    pub fn reciprocals(&self, integers: impl Iterator<Item = i64>) -> Vec<Lanes> {
        let mut values: Vec<i64> = integers.collect();
        let len = values.len();
        values.resize(len.next_multiple_of(CHAINS), 1);
        let mut out = vec![Lanes::ONE; values.len()];
        reciprocals(&self.primes, &values, &mut out);
        out.truncate(len);
        out
    }

    /// Beyond the shorter of the two nothing is added.
    pub fn add(&self, mut a: Vec<Lanes>, b: &[Lanes]) -> Vec<Lanes> {
        add(&self.primes, &mut a, b);
        a
    }

    /// Newton's iteration `z <- z (2 - z s)` for the reciprocal of a series.
    pub fn reciprocal(&self, mut z: Vec<Lanes>, series: &[Lanes], terms: usize) -> Vec<Lanes> {
        while z.len() < terms {
            let known = z.len();
            let next = (2 * known).min(terms);
            let defect = self.products(&[(-1, &series[..next.min(series.len())], &z)], known..next);
            z.extend(self.product(&defect, &z, next - known));
        }
        z
    }
}

vectorised! {
    fn add_product(primes: &'a Primes, sum: &'a mut [Lanes], weight: i64, a: &'a [Lanes], b: &'a [Lanes]) {
        let primes = *primes;
        let weight = primes.integer(weight);
        for ((sum, &a), &b) in sum.iter_mut().zip(a).zip(b) {
            turn();
            *sum = primes.reduce(*sum + primes.mul(primes.mul(a, b), weight));
        }
    }
}

vectorised! {
    /// Values of at most `6p` times a factor over an integer.
    fn scale(primes: &'a Primes, values: &'a mut [Lanes], factor: Lanes, divisor: i64) {
        let primes = *primes;
        let factor = if divisor == 1 { factor } else { primes.reduce(primes.mul(factor, primes.reciprocal(primes.integer(divisor)))) };
        for value in values {
            turn();
            *value = primes.reduce(primes.mul(*value, factor));
        }
    }
}

vectorised! {
    fn multiply_by_integers(primes: &'a Primes, values: &'a mut [Lanes], integers: &'a [i64]) {
        let primes = *primes;
        for (value, &integer) in values.iter_mut().zip(integers) {
            turn();
            *value = primes.reduce(primes.mul(*value, primes.integer(integer)));
        }
    }
}

vectorised! {
    fn multiply(primes: &'a Primes, values: &'a mut [Lanes], by: &'a [Lanes]) {
        let primes = *primes;
        for (value, &by) in values.iter_mut().zip(by) {
            turn();
            *value = primes.reduce(primes.mul(*value, by));
        }
    }
}

vectorised! {
    fn add(primes: &'a Primes, values: &'a mut [Lanes], others: &'a [Lanes]) {
        let primes = *primes;
        for (value, &other) in values.iter_mut().zip(others) {
            turn();
            *value = primes.reduce(*value + other);
        }
    }
}

vectorised! {
    /// `1/x = y/(x y)`: one reciprocal for all (Montgomery's trick). Products of products of at most `0.8 p` are as small.
    fn reciprocals(primes: &'a Primes, integers: &'a [i64], out: &'a mut [Lanes]) {
        let primes = *primes;
        let mut products = [Lanes::ONE; CHAINS];
        for (integers, out) in integers.chunks_exact(CHAINS).zip(out.chunks_exact_mut(CHAINS)) {
            for c in 0..CHAINS {
                turn();
                out[c] = products[c];
                products[c] = primes.mul(products[c], primes.integer(integers[c]));
            }
        }
        let mut inverses = products;
        for inverse in &mut inverses {
            *inverse = primes.reciprocal(*inverse);
        }
        for (integers, out) in integers.chunks_exact(CHAINS).zip(out.chunks_exact_mut(CHAINS)).rev() {
            for c in 0..CHAINS {
                turn();
                out[c] = primes.reduce(primes.mul(out[c], inverses[c]));
                inverses[c] = primes.mul(inverses[c], primes.integer(integers[c]));
            }
        }
    }
}
