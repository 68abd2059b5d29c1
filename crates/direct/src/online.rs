//! Products of power series whose coefficients become known one after the other.
//!
//! Coefficient `k` of a product is wanted as soon as those before `k` of its factors are known. Blocks
//! of known coefficients are multiplied as whole integers (Kronecker substitution) the moment they are
//! complete, block `[m - s, m)` with `s` the largest power of two that divides `m`, and what they give to
//! the coefficients from `m` to `m + s` waits there: `log n` products of whole series instead of `n^2/2`
//! products of numbers. Sums are exact, or rounded by less than a stated unit where the factors are long.

use rug::Integer;
use rug::integer::Order;

/// Bits of a block below which its numbers are multiplied one by one, and its least length.
const SMALL: (usize, usize) = (110_000, 32);
/// Length of a block from which on both of its products are made at the same time.
const LONG: usize = 128;
/// Bits of a factor that are worth cutting off.
const LEAST_CUT: u32 = 64;
/// Bits of a digit of GMP's.
const DIGIT: usize = 64;

/// `Sum_(0<i<k) x_i y_(k-i)` for `k = 0, 1, 2, …` in turn.
pub(crate) struct Online {
    /// What complete blocks gave to the coefficients that are still to come.
    waiting: Vec<Integer>,
    /// Each sum may be off by less than two to this power.
    rounding: Option<u32>,
    /// Length of the blocks inside of which numbers are multiplied one by one.
    small: usize,
}

impl Online {
    /// For coefficients up to `order` of about `bits` bits, exactly.
    pub(crate) fn new(order: usize, bits: u32) -> Self {
        let small = (SMALL.0 / bits.max(1) as usize).max(SMALL.1).next_power_of_two();
        Self { waiting: vec![Integer::new(); order + 1], rounding: None, small }
    }

    /// For coefficients up to `order`, each off by less than `2^bits`.
    ///
    /// A block of small coefficients is multiplied with as many bits of the others as count: with `n` terms
    /// of `b` bits the others may lose `d = bits - b - log2(n) - 8`, which is `2^(bits-8)` at most. A sum
    /// gets two such products, one of them doubled, from each of less than 30 lengths of blocks.
    pub(crate) fn rounded(order: usize, bits: u32) -> Self {
        Self { rounding: Some(bits), ..Self::new(order, bits) }
    }

    /// Coefficient `k` of the square of a series whose coefficients `c_0…c_(k-1)` are given.
    pub(crate) fn square(&mut self, c: &[Integer]) -> Integer {
        let k = c.len();
        if let Some(block) = self.completed(k) {
            let factor = if block.first == 0 { c } else { &c[..block.width()] };
            self.add(&block, &c[block.first..], factor, u32::from(block.first > 0));
        }
        let first = k / self.small * self.small;
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
        if first == 0 && k > 0 && k.is_multiple_of(2) {
            sum += c[k / 2].square_ref();
        }
        sum + std::mem::take(&mut self.waiting[k])
    }

    /// Coefficient `k` of the product of two series whose coefficients up to `k - 1` are given.
    pub(crate) fn product(&mut self, x: &[Integer], y: &[Integer]) -> Integer {
        let k = x.len().min(y.len());
        match self.completed(k) {
            Some(block) if block.first == 0 => self.add(&block, &x[..k], &y[..k], 0),
            Some(block) => {
                let (in_x, in_y) = (&x[block.first..k], &y[block.first..k]);
                let (to_x, to_y) = (&x[..block.width()], &y[..block.width()]);
                let (one, other) = if !block.is_long() {
                    (self.contribution(&block, in_x, to_y, 0), self.contribution(&block, in_y, to_x, 0))
                } else {
                    let online = &*self;
                    std::thread::scope(|scope| {
                        let one = scope.spawn(|| online.contribution(&block, in_x, to_y, 0));
                        let other = online.contribution(&block, in_y, to_x, 0);
                        (one.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)), other)
                    })
                };
                self.take(&block, one);
                self.take(&block, other);
            }
            None => {}
        }
        let first = k / self.small * self.small;
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
        let first = k / self.small * self.small;
        let mut sum = std::mem::take(&mut self.waiting[k]);
        for (i, x) in x.iter().enumerate().skip(first) {
            if let Some(other) = known.get(k - i) {
                sum += x * other;
            }
        }
        sum
    }

    /// The block that is complete when `k` coefficients are known, if its length is worth it.
    fn completed(&self, k: usize) -> Option<Block> {
        let length = if k == 0 { 0 } else { 1 << k.trailing_zeros() };
        (length >= self.small && k < self.waiting.len()).then(|| Block {
            first: k - length,
            next: k,
            end: (k + length).min(self.waiting.len()),
        })
    }

    /// Adds `2^shift x y` to what waits between the block and its end; `x` starts where the block does.
    fn add(&mut self, block: &Block, x: &[Integer], y: &[Integer], shift: u32) {
        let parts = self.contribution(block, x, y, shift);
        self.take(block, parts);
    }

    fn take(&mut self, block: &Block, parts: Vec<Integer>) {
        for (sum, part) in self.waiting[block.next..block.end].iter_mut().zip(parts) {
            *sum += part;
        }
    }

    /// The coefficients of `2^shift x y` between a block and its end, with what may be lost cut off `y`.
    fn contribution(&self, block: &Block, x: &[Integer], y: &[Integer], shift: u32) -> Vec<Integer> {
        let (from, count) = (block.next - block.first, block.end - block.next);
        let lost = self.rounding.map_or(0, |bits| spare(bits, largest(x), x.len()));
        let mut parts = if lost == 0 {
            middle_product(x, y, from, count)
        } else {
            let cut: Vec<Integer> = y.iter().map(|c| Integer::from(c >> lost)).collect();
            middle_product(x, &cut, from, count)
        };
        for part in &mut parts {
            *part <<= shift + lost;
        }
        parts
    }
}

/// How many bits the other factor of some terms of `size` bits may lose where a sum may be off by `2^bits`; 0 if it isn't worth it.
fn spare(bits: u32, size: usize, terms: usize) -> u32 {
    let needed = size + terms.ilog2() as usize + 9;
    let spare = u32::try_from((bits as usize).saturating_sub(needed)).unwrap_or(0);
    if spare < LEAST_CUT { 0 } else { spare }
}

/// Coefficients `first…next-1`, whose products belong to the coefficients `next…end-1`.
struct Block {
    first: usize,
    next: usize,
    end: usize,
}

impl Block {
    fn is_long(&self) -> bool {
        self.next - self.first >= LONG
    }

    /// How many coefficients of the other factor reach the block's targets.
    fn width(&self) -> usize {
        self.end - self.first
    }
}

/// The coefficients `from…from+count-1` of `x y`, by one product of two integers.
fn middle_product(x: &[Integer], y: &[Integer], from: usize, count: usize) -> Vec<Integer> {
    let slot = slot(largest(x), largest(y), x.len().min(y.len()));
    let packed = pack(x, slot);
    let product = if std::ptr::eq(x, y) { packed.square() } else { packed * pack(y, slot) };
    unpack(product, slot, x.len() + y.len() - 1, from, count)
}

/// Digits that hold a sum of products of numbers of so many bits, with its sign.
fn slot(in_x: usize, in_y: usize, terms: usize) -> usize {
    (in_x + in_y + terms.ilog2() as usize + 2).div_ceil(DIGIT)
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
fn unpack(packed: Integer, slot: usize, terms: usize, from: usize, count: usize) -> Vec<Integer> {
    let half = Integer::from(1) << u32::try_from(DIGIT * slot - 1).unwrap_or(u32::MAX);
    let mut halves = vec![0_u64; slot * terms];
    for place in halves.chunks_exact_mut(slot) {
        place[slot - 1] = 1 << (DIGIT - 1);
    }
    let raised = packed + Integer::from_digits(&halves, Order::Lsf);
    raised.write_digits(&mut halves, Order::Lsf);
    halves
        .chunks_exact(slot)
        .skip(from)
        .take(count)
        .map(|d| Integer::from_digits(d, Order::Lsf) - &half)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::ops::Pow;

    #[test]
    fn what_is_chosen_for_a_product() {
        let is_long = |first: usize, next: usize| Block { first, next, end: 2 * next }.is_long();
        assert!(!is_long(0, 127) && is_long(0, 128) && !is_long(128, 255) && is_long(128, 256));
        // 300 - 200 - 5 - 9 bits; less than 64 are not worth it.
        assert_eq!([300, 278, 277, 100].map(|bits| spare(bits, 200, 63)), [86, 64, 0, 0]);
        assert_eq!([(60, 61, 63), (60, 61, 64), (3, 2, 1)].map(|(x, y, n)| slot(x, y, n)), [2, 3, 1]);
        let two_and_three = [2, -3].map(Integer::from);
        assert_eq!(pack(&two_and_three, 1), 2 - (Integer::from(3) << 64));
    }

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
            let (mut square, mut product) = (Online::new(order, 4000), Online::new(order, 4000));
            let (mut with_all, mut with_few) = (Online::new(order, 4000), Online::new(order, 4000));
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
    fn rounded_sums_are_near() {
        let (order, bits) = (300, 460);
        // Powers have no zeros at their end, so that what is cut off counts.
        let falling = |seed| -> Vec<Integer> {
            series(order + 1, seed)
                .into_iter()
                .enumerate()
                .map(|(i, c)| {
                    let digits = c.significant_bits() - 50;
                    let dense: Integer = (c >> digits).pow(9_u32);
                    dense >> u32::try_from(i + i / 2).unwrap()
                })
                .collect()
        };
        let (x, y) = (falling(3), falling(4));
        let rounded = || Online { rounding: Some(bits), ..Online::new(order, 4000) };
        let (mut square, mut product) = (rounded(), rounded());
        let mut most = Integer::new();
        for k in 1..=order {
            let off = (square.square(&x[..k]) - plain(&x, &x, 1, k)).abs();
            most = most.max(off.max((product.product(&x[..k], &y[..k]) - plain(&x, &y, 1, k)).abs()));
        }
        let seen = most.significant_bits();
        assert!(bits - 16 < seen && seen < bits, "{seen}");
    }

    #[test]
    fn the_largest_coefficients_fit_their_slots() {
        let most = -((Integer::from(1) << 64_u32) - 1_u32);
        let x = vec![most; 64];
        for (k, c) in middle_product(&x, &x, 0, 127).into_iter().enumerate() {
            let count = (k + 1).min(127 - k) as u64;
            assert_eq!(c, Integer::from(x[0].square_ref()) * count);
        }
    }

    /// A hundred products of 121 bits are more than 2^127: they need a third word.
    #[test]
    fn a_slot_has_room_for_the_sum_and_its_sign() {
        let of = |bits: u32, sign: i32| vec![((Integer::from(1) << bits) - 1_u32) * sign; 100];
        for sign in [1, -1] {
            let (x, y) = (of(60, 1), of(61, sign));
            let wanted = Integer::from(&x[0] * &y[0]) * 100_u32;
            assert_eq!(middle_product(&x, &y, 99, 1), [wanted]);
        }
    }
}
