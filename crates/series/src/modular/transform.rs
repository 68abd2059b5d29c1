//! The number theoretic transform: products of polynomials modulo a word-size prime.

use super::prime::Prime;
use std::cell::RefCell;
use std::rc::Rc;

/// Roots of unity for transforms of one size, each with Shoup's quotient `floor(w 2^64/p)`.
///
/// The roots of a stage of half-length `h` stand at `h .. 2h`.
pub(super) struct Roots {
    prime: Prime,
    size: usize,
    forward: Vec<(u64, u64)>,
    backward: Vec<(u64, u64)>,
    /// The form of `1/size`.
    scale: u64,
}

thread_local! {
    static LATEST: RefCell<Option<Rc<Roots>>> = const { RefCell::new(None) };
}

impl Roots {
    /// The roots for a prime and a power of two, kept for the next call of the thread.
    pub fn get(prime: Prime, size: usize) -> Rc<Self> {
        LATEST.with(|latest| {
            let mut latest = latest.borrow_mut();
            match latest.as_ref() {
                Some(roots) if roots.prime == prime && roots.size == size => Rc::clone(roots),
                _ => {
                    let roots = Rc::new(Self::new(prime, size));
                    *latest = Some(Rc::clone(&roots));
                    roots
                }
            }
        })
    }

    fn new(prime: Prime, size: usize) -> Self {
        let root = prime.root_of_unity(size.trailing_zeros());
        let table = |root: u64| {
            let mut table = vec![(0, 0); size.max(2)];
            let mut half = size / 2;
            let mut step = root;
            while half > 0 {
                let mut power = prime.one;
                for entry in &mut table[half..2 * half] {
                    let w = prime.value(power);
                    *entry = (w, ((u128::from(w) << 64) / u128::from(prime.p)) as u64);
                    power = prime.mul(power, step);
                }
                step = prime.mul(step, step);
                half /= 2;
            }
            table
        };
        let scale = prime.inverse(prime.form(size as i64));
        Self { prime, size, forward: table(root), backward: table(prime.inverse(root)), scale }
    }

    /// Transforms in place to values at the roots of unity, in bit-reversed order.
    ///
    /// Butterflies with lazy reduction (Harvey 2014): all values stay below `2p`.
    pub fn forward(&self, values: &mut [u64]) {
        let p = self.prime.p;
        let mut half = self.size / 2;
        while half > 0 {
            let roots = &self.forward[half..2 * half];
            for block in values.chunks_exact_mut(2 * half) {
                let (low, high) = block.split_at_mut(half);
                for ((x, y), root) in low.iter_mut().zip(high).zip(roots) {
                    let difference = *x + 2 * p - *y;
                    *x = below_two_p(*x + *y, p);
                    *y = times(difference, *root, p);
                }
            }
            half /= 2;
        }
    }

    /// Transforms values in bit-reversed order back to coefficients below `p`.
    pub fn backward(&self, values: &mut [u64]) {
        let p = self.prime.p;
        let mut half = 1;
        while half < self.size {
            let roots = &self.backward[half..2 * half];
            for block in values.chunks_exact_mut(2 * half) {
                let (low, high) = block.split_at_mut(half);
                for ((x, y), root) in low.iter_mut().zip(high).zip(roots) {
                    let product = times(*y, *root, p);
                    let sum = below_two_p(*x + product, p);
                    *y = below_two_p(*x + 2 * p - product, p);
                    *x = sum;
                }
            }
            half *= 2;
        }
        for value in values {
            *value = self.prime.mul(below_two_p(*value, p), self.scale);
        }
    }
}

#[inline]
fn below_two_p(x: u64, p: u64) -> u64 {
    if x >= 2 * p { x - 2 * p } else { x }
}

/// `x w mod p`, below `2p`, for any `x` and a root with its quotient (Shoup).
#[inline]
fn times(x: u64, (w, quotient): (u64, u64), p: u64) -> u64 {
    let q = ((u128::from(x) * u128::from(quotient)) >> 64) as u64;
    x.wrapping_mul(w).wrapping_sub(q.wrapping_mul(p))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_transform_and_back_is_the_identity() {
        let prime = Prime::falling().nth(1).unwrap();
        for size in [1, 2, 64] {
            let roots = Roots::new(prime, size);
            let values: Vec<u64> = (0..size as i64).map(|n| prime.form(n * n - 7)).collect();
            let mut copy = values.clone();
            roots.forward(&mut copy);
            roots.backward(&mut copy);
            assert_eq!(copy, values);
        }
    }
}
