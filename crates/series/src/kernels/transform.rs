//! The number theoretic transform: products of polynomials modulo a word-size prime.

use super::prime::Prime;

/// Roots of unity for transforms of one size, `2^k` or `3 2^k`, in Montgomery's form.
///
/// The roots of a stage of half-length `h` stand at `h .. 2h`.
#[derive(Debug)]
pub(crate) struct Roots {
    prime: Prime,
    size: usize,
    /// The power of two in `size`.
    block: usize,
    forward: Vec<u64>,
    backward: Vec<u64>,
    /// For the factor 3: `g^i` and `g^2i`, `g` a root of order `size`, and both for `1/g`.
    thirds: Option<Thirds>,
    /// The form of `1/size`.
    scale: u64,
}

#[derive(Debug)]
struct Thirds {
    /// Primitive third root of unity and its square.
    omega: [u64; 2],
    twist: Vec<[u64; 2]>,
    untwist: Vec<[u64; 2]>,
}

/// The least size `2^k` or `3 2^k` that is at least `len`.
pub(crate) fn size_for(len: usize) -> usize {
    let power = len.next_power_of_two();
    if power >= 4 && power / 4 * 3 >= len { power / 4 * 3 } else { power }
}

impl Roots {
    /// The roots for a prime and a size that [`size_for`] gives.
    pub fn new(prime: Prime, size: usize) -> Self {
        let root = prime.root_of_unity(size);
        let has_thirds = size.is_multiple_of(3);
        let block = if has_thirds { size / 3 } else { size };
        let step = if has_thirds { prime.pow(root, 3) } else { root };
        let inverse = |x: u64| prime.inverse(x);
        let thirds = has_thirds.then(|| Thirds {
            omega: [prime.pow(root, block as u64), prime.pow(root, 2 * block as u64)],
            twist: twists(prime, root, block),
            untwist: twists(prime, inverse(root), block),
        });
        Self {
            prime,
            size,
            block,
            forward: table(prime, step, block),
            backward: table(prime, inverse(step), block),
            thirds,
            scale: inverse(prime.form(size as i64)),
        }
    }

    /// Transforms residues below `2p` to values at the roots of unity below `p`, in some fixed order.
    ///
    /// Butterflies with lazy reduction (Harvey 2014): all values stay below `2p`.
    pub fn forward(&self, values: &mut [u64]) {
        debug_assert_eq!(values.len(), self.size);
        if let Some(thirds) = &self.thirds {
            self.split(thirds, values);
        }
        for block in values.chunks_exact_mut(self.block) {
            self.forward_block(block);
        }
        let p = self.prime.p;
        for value in values {
            *value = if *value >= p { *value - p } else { *value };
        }
    }

    /// Transforms values below `2p` back to coefficients below `p`.
    pub fn backward(&self, values: &mut [u64]) {
        debug_assert_eq!(values.len(), self.size);
        for block in values.chunks_exact_mut(self.block) {
            self.backward_block(block);
        }
        if let Some(thirds) = &self.thirds {
            self.join(thirds, values);
        }
        for value in values {
            let scaled = self.prime.mul_lazy(*value, self.scale);
            *value = if scaled >= self.prime.p { scaled - self.prime.p } else { scaled };
        }
    }

    fn forward_block(&self, values: &mut [u64]) {
        let prime = &self.prime;
        let mut half = self.block / 2;
        while half > 0 {
            let roots = &self.forward[half..2 * half];
            for block in values.chunks_exact_mut(2 * half) {
                let (low, high) = block.split_at_mut(half);
                for ((x, y), &root) in low.iter_mut().zip(high).zip(roots) {
                    let difference = *x + 2 * prime.p - *y;
                    *x = below_two_p(*x + *y, prime.p);
                    *y = prime.mul_lazy(difference, root);
                }
            }
            half /= 2;
        }
    }

    fn backward_block(&self, values: &mut [u64]) {
        let prime = &self.prime;
        let mut half = 1;
        while half < self.block {
            let roots = &self.backward[half..2 * half];
            for block in values.chunks_exact_mut(2 * half) {
                let (low, high) = block.split_at_mut(half);
                for ((x, y), &root) in low.iter_mut().zip(high).zip(roots) {
                    let product = prime.mul_lazy(*y, root);
                    let sum = below_two_p(*x + product, prime.p);
                    *y = below_two_p(*x + 2 * prime.p - product, prime.p);
                    *x = sum;
                }
            }
            half *= 2;
        }
    }

    /// One step of three: afterwards each third is a transform of its own.
    fn split(&self, thirds: &Thirds, values: &mut [u64]) {
        let prime = &self.prime;
        let [omega, omega2] = thirds.omega;
        let (a, rest) = values.split_at_mut(self.block);
        let (b, c) = rest.split_at_mut(self.block);
        for (((a, b), c), [g, g2]) in a.iter_mut().zip(b).zip(c).zip(&thirds.twist) {
            let (x, y, z) = (*a, *b, *c);
            let sum = below_two_p(y + z, prime.p);
            let first = below_two_p(prime.mul_lazy(y, omega) + prime.mul_lazy(z, omega2), prime.p);
            let second = below_two_p(prime.mul_lazy(y, omega2) + prime.mul_lazy(z, omega), prime.p);
            *a = below_two_p(x + sum, prime.p);
            *b = prime.mul_lazy(x + first, *g);
            *c = prime.mul_lazy(x + second, *g2);
        }
    }

    fn join(&self, thirds: &Thirds, values: &mut [u64]) {
        let prime = &self.prime;
        let [omega, omega2] = thirds.omega;
        let (a, rest) = values.split_at_mut(self.block);
        let (b, c) = rest.split_at_mut(self.block);
        for (((a, b), c), [g, g2]) in a.iter_mut().zip(b).zip(c).zip(&thirds.untwist) {
            let (x, y, z) = (*a, prime.mul_lazy(*b, *g), prime.mul_lazy(*c, *g2));
            let sum = below_two_p(y + z, prime.p);
            let first = below_two_p(prime.mul_lazy(y, omega2) + prime.mul_lazy(z, omega), prime.p);
            let second = below_two_p(prime.mul_lazy(y, omega) + prime.mul_lazy(z, omega2), prime.p);
            *a = below_two_p(x + sum, prime.p);
            *b = below_two_p(x + first, prime.p);
            *c = below_two_p(x + second, prime.p);
        }
    }
}

fn table(prime: Prime, root: u64, size: usize) -> Vec<u64> {
    let mut table = vec![0; size.max(2)];
    let mut half = size / 2;
    let mut step = root;
    while half > 0 {
        let mut power = prime.one;
        for entry in &mut table[half..2 * half] {
            *entry = power;
            power = prime.mul(power, step);
        }
        step = prime.mul(step, step);
        half /= 2;
    }
    table
}

fn twists(prime: Prime, root: u64, len: usize) -> Vec<[u64; 2]> {
    let mut power = prime.one;
    let next = |_| {
        let this = power;
        power = prime.mul(power, root);
        [this, prime.mul(this, this)]
    };
    (0..len).map(next).collect()
}

#[inline]
fn below_two_p(x: u64, p: u64) -> u64 {
    if x >= 2 * p { x - 2 * p } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_of_transforms_are_cyclic_convolutions() {
        let prime = Prime::falling().nth(1).unwrap();
        for size in [1, 2, 3, 6, 64, 96] {
            let roots = Roots::new(prime, size);
            let a: Vec<u64> = (0..size as i64).map(|n| prime.form(n * n - 7)).collect();
            let b: Vec<u64> = (0..size as i64).map(|n| prime.form(3 * n * n * n - n + 2)).collect();
            let mut cyclic = vec![0; size];
            for (i, x) in a.iter().enumerate() {
                for (j, y) in b.iter().enumerate() {
                    let place = &mut cyclic[(i + j) % size];
                    *place = prime.add(*place, prime.mul(*x, *y));
                }
            }
            let (mut x, mut y) = (a.clone(), b);
            roots.forward(&mut x);
            let mut copy = x.clone();
            roots.backward(&mut copy);
            assert_eq!(copy, a);
            roots.forward(&mut y);
            let mut product: Vec<u64> = x.iter().zip(&y).map(|(x, y)| prime.mul(*x, *y)).collect();
            roots.backward(&mut product);
            assert_eq!(product, cyclic, "{size}");
        }
    }

    #[test]
    fn sizes_are_powers_of_two_or_three_times_as_much() {
        assert_eq!([1, 2, 3, 4, 5, 7, 9, 13, 97].map(size_for), [1, 2, 3, 4, 6, 8, 12, 16, 128]);
    }
}
