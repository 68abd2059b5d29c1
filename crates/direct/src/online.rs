//! Products of power series whose coefficients become known one after the other.
//!
//! Coefficient `k` of a product is wanted as soon as those before `k` of its factors are known. Blocks
//! of known coefficients are multiplied as whole integers (Kronecker substitution) the moment they are
//! complete, block `[m - s, m)` with `s` the largest power of two that divides `m`, and what they give to
//! the coefficients from `m` to `m + s` waits there: `log n` products of whole series instead of `n^2/2`
//! products of numbers. All sums are exact, so nothing of a proof depends on the order in which they are made.

use rug::Integer;
use rug::integer::Order;

/// Length of the blocks inside of which numbers are multiplied one by one.
const SMALL: usize = 32;
/// Bits of a digit of GMP's.
const DIGIT: usize = 64;

/// `Sum_(0<i<k) x_i y_(k-i)` for `k = 1, 2, …` in turn.
pub(crate) struct Online {
    /// What complete blocks gave to the coefficients that are still to come.
    waiting: Vec<Integer>,
}

impl Online {
    /// For coefficients up to `order`.
    pub(crate) fn new(order: usize) -> Self {
        Self { waiting: vec![Integer::new(); order + 1] }
    }

    /// Coefficient `k` of the square of a series whose coefficients `c_0…c_(k-1)` are given.
    pub(crate) fn square(&mut self, c: &[Integer]) -> Integer {
        let k = c.len();
        if let Some(block) = self.completed(k) {
            let factor = if block.first == 0 { c } else { &c[..block.width()] };
            self.add(&block, &c[block.first..], factor, u32::from(block.first > 0));
        }
        let first = k / SMALL * SMALL;
        let mut sum = Integer::new();
        if first == 0 {
            for i in 1..k.div_ceil(2) {
                sum += &c[i] * &c[k - i];
            }
        } else {
            for i in first..k {
                sum += &c[i] * &c[k - i];
            }
        }
        sum *= 2;
        if first == 0 && k.is_multiple_of(2) {
            sum += c[k / 2].square_ref();
        }
        sum + std::mem::take(&mut self.waiting[k])
    }

    /// Coefficient `k` of the product of two series whose coefficients up to `k - 1` are given.
    pub(crate) fn product(&mut self, x: &[Integer], y: &[Integer]) -> Integer {
        let k = x.len().min(y.len());
        if let Some(block) = self.completed(k) {
            if block.first == 0 {
                self.add(&block, &x[..k], &y[..k], 0);
            } else {
                self.add(&block, &x[block.first..k], &y[..block.width()], 0);
                self.add(&block, &y[block.first..k], &x[..block.width()], 0);
            }
        }
        let first = k / SMALL * SMALL;
        let mut sum = std::mem::take(&mut self.waiting[k]);
        for i in first.max(1)..k {
            sum += &x[i] * &y[k - i];
            if first > 0 {
                sum += &y[i] * &x[k - i];
            }
        }
        sum
    }

    /// `Sum_(0<=i<k) x_i y_(k-i)` for a series known up to `k - 1` and one that is known altogether.
    pub(crate) fn product_with_known(&mut self, x: &[Integer], known: &[Integer]) -> Integer {
        let k = x.len();
        if let Some(block) = self.completed(k) {
            let factor = &known[..block.width().min(known.len())];
            self.add(&block, &x[block.first..], factor, 0);
        }
        let first = k / SMALL * SMALL;
        let mut sum = std::mem::take(&mut self.waiting[k]);
        for i in first..k {
            if let Some(other) = known.get(k - i) {
                sum += &x[i] * other;
            }
        }
        sum
    }

    /// The block that is complete when `k` coefficients are known, if its length is worth it.
    fn completed(&self, k: usize) -> Option<Block> {
        let length = 1 << k.trailing_zeros();
        (length >= SMALL && k < self.waiting.len()).then(|| Block {
            first: k - length,
            next: k,
            end: (k + length).min(self.waiting.len()),
        })
    }

    /// Adds `2^shift x y` to what waits between the block and its end; `x` starts where the block does.
    fn add(&mut self, block: &Block, x: &[Integer], y: &[Integer], shift: u32) {
        let target = &mut self.waiting[block.next..block.end];
        for (sum, part) in target.iter_mut().zip(middle_product(x, y, block.next - block.first)) {
            *sum += part << shift;
        }
    }
}

/// Coefficients `first…next-1`, whose products belong to the coefficients `next…end-1`.
struct Block {
    first: usize,
    next: usize,
    end: usize,
}

impl Block {
    /// How many coefficients of the other factor reach the block's targets.
    fn width(&self) -> usize {
        self.end - self.first
    }
}

/// The coefficients of `x y` from `from` on, by one product of two integers.
fn middle_product(x: &[Integer], y: &[Integer], from: usize) -> Vec<Integer> {
    let terms = x.len().min(y.len());
    let bits = largest(x) + largest(y) + terms.ilog2() as usize + 2;
    let slot = bits.div_ceil(DIGIT);
    let packed = pack(x, slot);
    let product = if std::ptr::eq(x, y) { packed.square() } else { packed * pack(y, slot) };
    unpack(product, slot, x.len() + y.len() - 1, from)
}

fn largest(x: &[Integer]) -> usize {
    x.iter().map(|c| c.significant_bits() as usize).max().unwrap_or(0)
}

/// `Sum x_i 2^(64 slot i)`.
fn pack(x: &[Integer], slot: usize) -> Integer {
    let side = |wanted: bool| {
        let mut digits = vec![0_u64; slot * x.len()];
        for (c, place) in x.iter().zip(digits.chunks_exact_mut(slot)) {
            if c.is_negative() == wanted {
                c.write_digits(place, Order::Lsf);
            }
        }
        Integer::from_digits(&digits, Order::Lsf)
    };
    side(false) - side(true)
}

/// The coefficients `x_i`, `|x_i| < 2^(64 slot - 1)`, of `Sum_(i<terms) x_i 2^(64 slot i)` from `from` on.
fn unpack(packed: Integer, slot: usize, terms: usize, from: usize) -> Vec<Integer> {
    let half = Integer::from(1) << u32::try_from(DIGIT * slot - 1).unwrap_or(u32::MAX);
    let mut halves = vec![0_u64; slot * terms];
    for place in halves.chunks_exact_mut(slot) {
        place[slot - 1] = 1 << (DIGIT - 1);
    }
    let raised = packed + Integer::from_digits(&halves, Order::Lsf);
    raised.write_digits(&mut halves, Order::Lsf);
    halves.chunks_exact(slot).skip(from).map(|d| Integer::from_digits(d, Order::Lsf) - &half).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Integers of both signs and many sizes.
    fn series(n: usize, seed: u64) -> Vec<Integer> {
        let mut state = seed;
        (0..n)
            .map(|i| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let sign = if state >> 63 == 0 { 1 } else { -1 };
                (Integer::from(state >> 8) << u32::try_from(400_usize.saturating_sub(i)).unwrap()) * sign
            })
            .collect()
    }

    fn plain(x: &[Integer], y: &[Integer], first: usize, k: usize) -> Integer {
        let term = |i: usize| y.get(k - i).map(|y| Integer::from(&x[i] * y));
        (first..k).filter_map(term).sum()
    }

    #[test]
    fn sums_are_those_of_the_definition() {
        for order in [1, 31, 32, 33, 100, 257] {
            let (x, y) = (series(order + 1, 1), series(order + 1, 2));
            let (mut square, mut product) = (Online::new(order), Online::new(order));
            let (mut with_all, mut with_few) = (Online::new(order), Online::new(order));
            for k in 1..=order {
                assert_eq!(square.square(&x[..k]), plain(&x, &x, 1, k), "{order} {k}");
                assert_eq!(product.product(&x[..k], &y[..k]), plain(&x, &y, 1, k), "{order} {k}");
                assert_eq!(with_all.product_with_known(&x[..k], &y), plain(&x, &y, 0, k), "{order} {k}");
                let few = &y[..y.len().min(20)];
                assert_eq!(with_few.product_with_known(&x[..k], few), plain(&x, few, 0, k), "{order} {k}");
            }
        }
    }

    #[test]
    fn the_largest_coefficients_fit_their_slots() {
        let most = -((Integer::from(1) << 64_u32) - 1_u32);
        let x = vec![most; 64];
        for (k, c) in middle_product(&x, &x, 0).into_iter().enumerate() {
            let count = (k + 1).min(127 - k) as u64;
            assert_eq!(c, Integer::from(x[0].square_ref()) * count);
        }
    }
}
