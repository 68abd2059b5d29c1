//! The number theoretic transform: products of polynomials modulo eight primes at once.

use super::lanes::{Lanes, turn, vectorised};
use super::prime::Primes;
use std::ops::Range;

/// Lanes that are transformed to the end at once, to stay in the first cache.
const NEAR: usize = 256;

/// Roots of unity for transforms of one size, `2^k` or `3 2^k`.
///
/// A block of a transform is a polynomial modulo `x^h - c`; it splits into those modulo `x^(h/2) - w` and
/// `x^(h/2) + w`, `w^2 = c`. The root of block `b` stands at place `b` for every `h`: `W_0 = 1`,
/// `W_(2b)^2 = W_b`, `W_(2b+1) = i W_(2b)`. In each of the three thirds of a size `3 2^k` it has a third root of unity
/// as a further factor. For `2^k <= b < 2^(k+1)` is `1/W_b = -W_(3 2^k - 1 - b)`.
#[derive(Debug)]
pub(crate) struct Roots {
    primes: Primes,
    size: usize,
    /// The power of two in `size`.
    block: usize,
    /// The roots times each third root of unity; for sizes `2^k` those times 1 alone. Reduced.
    tables: Vec<Vec<Lanes>>,
    /// `1/size`.
    scale: Lanes,
}

/// The least size `2^k` or `3 2^k` that is at least `len`.
pub(crate) fn size_for(len: usize) -> usize {
    let power = len.next_power_of_two();
    if power >= 4 && power / 4 * 3 >= len { power / 4 * 3 } else { power }
}

/// The least length of a transform from which some coefficients of a product of so many terms can be read: what is folded over
/// ends below the range.
pub(crate) fn least_length(first: usize, second: usize, range: &Range<usize>) -> usize {
    let whole = (first + second).max(2) - 1;
    range.end.min(whole).max(whole - range.start.min(whole))
}

impl Roots {
    /// The roots for eight primes and a size that [`size_for`] gives.
    pub fn new(primes: Primes, size: usize) -> Self {
        let thirds = if size.is_multiple_of(3) { 3 } else { 1 };
        let block = size / thirds;
        let mut roots = Self {
            primes,
            size,
            block,
            tables: vec![vec![Lanes::ONE; (block / 2).max(2)]; thirds],
            scale: Lanes::ONE,
        };
        fill(&mut roots);
        roots
    }

    /// `1/size`, by which the way back has to be multiplied.
    pub fn scale(&self) -> Lanes {
        self.scale
    }

    /// Transforms residues of at most `p` to values at the roots of unity, reduced, in some fixed order.
    pub fn forward(&self, values: &mut [Lanes]) {
        debug_assert_eq!(values.len(), self.size);
        forward(self, values);
    }

    /// Transforms values of at most `2p` to `size` times the coefficients, of at most `6p`.
    pub fn backward(&self, values: &mut [Lanes]) {
        debug_assert_eq!(values.len(), self.size);
        backward(self, values);
    }

    /// `w` of a block, times a third root of unity.
    #[inline(always)]
    fn root(&self, third: usize, b: usize) -> Lanes {
        self.tables[third][b]
    }

    /// `1/w` of a block whose `w` is times a third root of unity.
    #[inline(always)]
    fn inverse(&self, third: usize, b: usize) -> Lanes {
        let table = &self.tables[(3 - third) % 3];
        if b == 0 { table[0] } else { -table[(3 << b.ilog2()) - 1 - b] }
    }

    /// Two splits at once: all values stay at most `3p`.
    ///
    /// In units of `p`, products with a reduced root grow to `1/2 + 3/16` of the other factor: `x_2 w^2` from 3 to 1.07,
    /// `y_1 w` from 4.07 to 1.27; sums with the reduced `x_0` are at most `0.5 + 1.07 + 1.27`.
    #[inline(always)]
    fn split(&self, values: &mut [Lanes], len: usize, first: usize, third: usize) {
        let primes = self.primes;
        let quarter = len / 4;
        for (block, b) in values.chunks_exact_mut(len).zip(first..) {
            let w2 = self.root(2 * third % 3, b);
            let (w, iw) = (self.root(third, 2 * b), self.root(third, 2 * b + 1));
            let (low, high) = block.split_at_mut(2 * quarter);
            let ((x0, x1), (x2, x3)) = (low.split_at_mut(quarter), high.split_at_mut(quarter));
            for (((x0, x1), x2), x3) in x0.iter_mut().zip(x1).zip(x2).zip(x3) {
                turn();
                let (a, c, d) = (primes.reduce(*x0), primes.mul(*x2, w2), primes.mul(*x3, w2));
                let (y0, y2) = (a + c, a - c);
                let (y1, y3) = (primes.mul(*x1 + d, w), primes.mul(*x1 - d, iw));
                (*x0, *x1, *x2, *x3) = (y0 + y1, y0 - y1, y2 + y3, y2 - y3);
            }
        }
    }

    /// The inverse of [`Self::split`]: all values stay at most `2p`.
    ///
    /// Differences of sums are at most `8p < 2^53`, and their products at most `(1/2 + 3/2) p`.
    #[inline(always)]
    fn join(&self, values: &mut [Lanes], len: usize, third: usize) {
        let primes = self.primes;
        let quarter = len / 4;
        for (b, block) in values.chunks_exact_mut(len).enumerate() {
            let w2 = self.inverse(2 * third % 3, b);
            let (w, iw) = (self.inverse(third, 2 * b), self.inverse(third, 2 * b + 1));
            let (low, high) = block.split_at_mut(2 * quarter);
            let ((x0, x1), (x2, x3)) = (low.split_at_mut(quarter), high.split_at_mut(quarter));
            for (((x0, x1), x2), x3) in x0.iter_mut().zip(x1).zip(x2).zip(x3) {
                turn();
                let (s, t) = (*x0 + *x1, *x2 + *x3);
                let (d, e) = (primes.mul(*x0 - *x1, w), primes.mul(*x2 - *x3, iw));
                *x0 = primes.reduce(s + t);
                *x1 = primes.reduce(d + e);
                *x2 = primes.mul(s - t, w2);
                *x3 = primes.mul(d - e, w2);
            }
        }
    }
}

vectorised! {
    fn fill(roots: &'a mut Roots) {
        let primes = roots.primes;
        roots.scale = primes.reciprocal(Lanes::splat(roots.size as f64));
        let table = &mut roots.tables[0];
        let mut half = 1;
        while half < table.len() {
            let step = primes.root_of_unity(4 * half);
            for b in half..2 * half {
                table[b] = primes.reduce(primes.mul(table[b - half], step));
            }
            half *= 2;
        }
        let omega = primes.root_of_unity(3);
        for third in 1..roots.tables.len() {
            for b in 0..roots.tables[0].len() {
                roots.tables[third][b] = primes.reduce(primes.mul(roots.tables[third - 1][b], omega));
            }
        }
    }
}

vectorised! {
    fn forward(roots: &'a Roots, values: &'a mut [Lanes]) {
        let primes = roots.primes;
        if roots.tables.len() == 3 {
            // Modulo x^h - 1, x^h - omega, x^h - omega^2, with 1 + omega + omega^2 = 0: at most 3p.
            let omega = roots.tables[1][0];
            let (x, rest) = values.split_at_mut(roots.block);
            let (y, z) = rest.split_at_mut(roots.block);
            for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
                turn();
                let turned = primes.mul(*y - *z, omega);
                (*x, *y, *z) = (*x + *y + *z, *x - *z + turned, *x - *y - turned);
            }
        }
        for (third, values) in values.chunks_exact_mut(roots.block).enumerate() {
            let mut len = values.len();
            while len > NEAR {
                roots.split(values, len, 0, third);
                len /= 4;
            }
            for (b, values) in values.chunks_exact_mut(len).enumerate() {
                let (mut len, mut first) = (len, b);
                while len >= 4 {
                    roots.split(values, len, first, third);
                    (len, first) = (len / 4, 4 * first);
                }
                if len == 2 {
                    for (pair, b) in values.as_chunks_mut::<2>().0.iter_mut().zip(first..) {
                        turn();
                        let (x, y) = (primes.reduce(pair[0]), primes.mul(pair[1], roots.root(2 * third % 3, b)));
                        *pair = [x + y, x - y];
                    }
                }
                for value in values {
                    turn();
                    *value = primes.reduce(*value);
                }
            }
        }
    }
}

vectorised! {
    fn backward(roots: &'a Roots, values: &'a mut [Lanes]) {
        let primes = roots.primes;
        for (third, values) in values.chunks_exact_mut(roots.block).enumerate() {
            let odd = roots.block.ilog2() % 2 == 1;
            if odd {
                for (b, pair) in values.as_chunks_mut::<2>().0.iter_mut().enumerate() {
                    turn();
                    let inverse = roots.inverse(2 * third % 3, b);
                    *pair = [primes.reduce(pair[0] + pair[1]), primes.mul(pair[0] - pair[1], inverse)];
                }
            }
            let mut len = if odd { 8 } else { 4 };
            while len <= roots.block {
                roots.join(values, len, third);
                len *= 4;
            }
        }
        if roots.tables.len() == 3 {
            let omega = roots.tables[1][0];
            let (x, rest) = values.split_at_mut(roots.block);
            let (y, z) = rest.split_at_mut(roots.block);
            for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
                turn();
                let turned = primes.mul(*y - *z, omega);
                (*x, *y, *z) = (*x + *y + *z, *x - *y - turned, *x - *z + turned);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::lanes::each;
    use super::super::prime::primes;
    use super::*;

    /// Coefficients times `size` back to coefficients in `0 .. p`.
    fn settled(primes: &Primes, roots: &Roots, values: &[Lanes]) -> Vec<Lanes> {
        values.iter().map(|&value| primes.least(primes.mul(value, roots.scale()))).collect()
    }

    #[test]
    fn products_of_transforms_are_cyclic_convolutions() {
        let primes = primes(2)[1];
        for size in [1, 2, 3, 4, 6, 8, 12, 24, 48, 64, 96, 128] {
            let roots = Roots::new(primes, size);
            let a: Vec<Lanes> = (0..size as i64).map(|n| primes.integer(n * n - 7)).collect();
            let b: Vec<Lanes> = (0..size as i64).map(|n| primes.integer(3 * n * n * n - n + 2)).collect();
            let mut cyclic = vec![Lanes::ZERO; size];
            for (i, &x) in a.iter().enumerate() {
                for (j, &y) in b.iter().enumerate() {
                    let place = &mut cyclic[(i + j) % size];
                    *place = primes.least(*place + primes.mul(x, y));
                }
            }
            let (mut x, mut y) = (a.clone(), b);
            roots.forward(&mut x);
            let mut copy = x.clone();
            roots.backward(&mut copy);
            let least: Vec<Lanes> = a.iter().map(|&x| primes.least(x)).collect();
            assert_eq!(settled(&primes, &roots, &copy), least, "{size}");
            roots.forward(&mut y);
            let mut product: Vec<Lanes> =
                x.iter().zip(&y).map(|(&x, &y)| primes.reduce(primes.mul(x, y))).collect();
            roots.backward(&mut product);
            assert_eq!(settled(&primes, &roots, &product), cyclic, "{size}");
        }
    }

    /// Values at the ends of what is allowed come back, and no value on the way is larger than promised.
    #[test]
    fn extreme_values_come_back() {
        let primes = primes(1)[0];
        for size in [4, 6, 512, 768, 1024, 1536] {
            let roots = Roots::new(primes, size);
            for pattern in 0..5usize {
                let sign = |j: usize| match pattern {
                    0 => 1.0,
                    1 => -1.0,
                    2 => {
                        if j.is_multiple_of(2) {
                            1.0
                        } else {
                            -1.0
                        }
                    }
                    3 => {
                        if j / (size / 2) == 0 {
                            1.0
                        } else {
                            -1.0
                        }
                    }
                    _ => {
                        if (j * j / 3).is_multiple_of(2) {
                            1.0
                        } else {
                            -1.0
                        }
                    }
                };
                let values: Vec<Lanes> =
                    (0..size).map(|j| each!(|l| sign(j) * primes.p.0[l] - (j % 2) as f64)).collect();
                let mut there = values.clone();
                roots.forward(&mut there);
                let within = |values: &[Lanes], most: f64| {
                    values.iter().all(|x| (0..8).all(|l| x.0[l].abs() <= most * primes.p.0[l] + 2.0))
                };
                assert!(within(&there, 0.5));
                // Twice the prime more is the same residue.
                let mut back: Vec<Lanes> = there
                    .iter()
                    .map(|x| each!(|l| x.0[l] - (1.5 * x.0[l].signum()).trunc() * primes.p.0[l]))
                    .collect();
                roots.backward(&mut back);
                assert!(within(&back, 6.0));
                let least: Vec<Lanes> = values.iter().map(|&x| primes.least(x)).collect();
                assert_eq!(settled(&primes, &roots, &back), least, "{size} {pattern}");
            }
        }
    }

    /// A product of six and four terms has nine.
    #[test]
    fn transforms_are_as_long_as_a_range_needs() {
        let length = |range: Range<usize>| least_length(6, 4, &range);
        assert_eq!([0..9, 0..20, 0..3, 3..6, 4..8, 8..9, 12..15].map(length), [9, 9, 9, 6, 8, 9, 9]);
        assert_eq!([(0, 0), (1, 1)].map(|(first, second)| least_length(first, second, &(0..1))), [1, 1]);
    }

    #[test]
    fn sizes_are_powers_of_two_or_three_times_as_much() {
        assert_eq!([1, 2, 3, 4, 5, 7, 9, 13, 97].map(size_for), [1, 2, 3, 4, 6, 8, 12, 16, 128]);
    }
}
