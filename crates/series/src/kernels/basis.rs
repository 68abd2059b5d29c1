//! Integers to residues modulo many primes and back, rounded by a power of two on the way.
//!
//! Both ways are sums of products of 32-bit digits with 25-bit halves of residues, in 64-bit integers.

use super::digits::{DIGIT_MASK, Digits, HALF, HALF_MASK, ROWS};
use super::fixed::{effective, is_negative};
use super::lanes::{LANES, Lanes, each, turn, vectorised};
use super::prime::Primes;
use rug::Integer;
use rug::integer::Order;

/// Digits of a rounded result below its unit.
const GUARD: usize = 3;

/// `2^(32 k)` modulo groups of primes: what carries words to residues.
pub(crate) struct Radix {
    primes: Vec<Primes>,
    /// For each digit the lower and the upper halves for eight primes after the other.
    powers: Digits,
    /// `2^32`, `2^25`, `2^57` for each group.
    shifts: Vec<[Lanes; 3]>,
}

impl Radix {
    pub fn new(primes: &[Primes], words: usize) -> Self {
        let mut radix = Self {
            primes: primes.to_vec(),
            powers: Digits::zero(2 * words, 2 * LANES * primes.len()),
            shifts: vec![[Lanes::ONE; 3]; primes.len()],
        };
        fill(&mut radix);
        radix
    }

    /// Writes the reduced residues of two's complement integers of `width` words each modulo the first groups of
    /// primes, those of one integer side by side.
    pub fn residues(&self, words: &[u64], width: usize, count: usize, out: &mut [Lanes]) {
        residues(self, words, width, count, out);
    }
}

vectorised! {
    fn fill(radix: &'a mut Radix) {
        for (group, (primes, shifts)) in radix.primes.iter().zip(&mut radix.shifts).enumerate() {
            *shifts = [primes.integer(1 << 32), primes.integer(1 << HALF), primes.integer(1 << (32 + HALF))];
            let mut power = Lanes::ONE;
            for digit in 0..radix.powers.lines() {
                let residue = primes.least(power).integers();
                *radix.powers.block_mut(digit, 2 * group) = residue.map(|x| (x & HALF_MASK) as u32);
                *radix.powers.block_mut(digit, 2 * group + 1) = residue.map(|x| (x >> HALF) as u32);
                power = primes.reduce(primes.mul(power, shifts[0]));
            }
        }
    }
}

vectorised! {
    fn residues(radix: &'a Radix, words: &'a [u64], width: usize, count: usize, out: &'a mut [Lanes]) {
        let mut digits = Vec::with_capacity(2 * width);
        for (words, out) in words.chunks(ROWS * width).zip(out.chunks_mut(ROWS * count)) {
            // Of a negative number x, -1 - x.
            let mut signs = [0; ROWS];
            let mut used = 0;
            for (words, sign) in words.chunks_exact(width).zip(&mut signs) {
                *sign = if is_negative(words) { u64::MAX } else { 0 };
                used = used.max(effective(words));
            }
            digits.clear();
            digits.resize(2 * used, [0; ROWS]);
            for (r, words) in words.chunks_exact(width).enumerate() {
                for (pair, word) in digits.as_chunks_mut::<2>().0.iter_mut().zip(&words[..used]) {
                    let word = word ^ signs[r];
                    (pair[0][r], pair[1][r]) = (word & DIGIT_MASK, word >> 32);
                }
            }
            for (group, (&primes, shifts)) in radix.primes.iter().zip(&radix.shifts).take(count).enumerate() {
                let low = radix.powers.multiply(&digits, 2 * group);
                let high = radix.powers.multiply(&digits, 2 * group + 1);
                for (r, out) in out.chunks_exact_mut(count).enumerate() {
                    turn();
                    // Each part is below 2^32 for every 128 products: below 2^50 for 2^24 words.
                    let a = primes.mul(Lanes::of(&low.high[r]), shifts[0]);
                    let b = primes.mul(Lanes::of(&high.low[r]), shifts[1]);
                    let c = primes.mul(Lanes::of(&high.high[r]), shifts[2]);
                    let sum = Lanes::of(&low.low[r]) + a + b + c;
                    out[group] = primes.reduce(if signs[r] == 0 { sum } else { -sum - Lanes::ONE });
                }
            }
        }
    }
}

/// What turns residues modulo the first groups of primes into the integer, divided by `2^shift` and rounded.
///
/// With `P` the product of the primes and `t_i = r_i (P/p_i)^(-1) mod p_i` the integer is
/// `x = sum t_i P/p_i - q P`, `q` the integer next to `sum t_i/p_i`, since `|x| < P/4`.
pub(crate) struct Level {
    /// `(P/p_i)^(-1)` modulo `p_i`.
    inverses: Vec<Lanes>,
    /// The 32-bit digits of `floor(P/p_i 2^(32 guard - shift))` for every prime.
    digits: Digits,
    /// The digits of `floor(P 2^(32 guard - shift))`.
    product: Vec<u32>,
    guard: usize,
}

/// The residues of integers modulo groups of primes.
pub(crate) struct Table<'v> {
    pub values: &'v [Lanes],
    /// From one group to the next.
    pub stride: usize,
    /// What residues are to be multiplied by first.
    pub scales: &'v [Lanes],
}

impl Level {
    /// For results in units of `2^shift`, of which 0 is exact.
    pub fn new(primes: &[Primes], shift: u32) -> Self {
        let guard = if shift == 0 { 0 } else { GUARD };
        let all: Vec<u64> = primes.iter().flat_map(|group| group.p.integers()).collect();
        let product = product_of(&all);
        // Whole words are copied; halves would be shifted out one byte at a time.
        let moved = |x: Integer| -> Vec<u32> {
            let words = ((x << (32 * guard as u32)) >> shift).to_digits::<u64>(Order::Lsf);
            words.into_iter().flat_map(|word| [word as u32, (word >> 32) as u32]).collect()
        };
        let mut whole = moved(product.clone());
        let mut digits = Digits::zero(all.len(), whole.len());
        for (i, &p) in all.iter().enumerate() {
            let part = moved(Integer::from(&product / p));
            for (block, part) in part.chunks(LANES).enumerate() {
                digits.block_mut(i, block)[..part.len()].copy_from_slice(part);
            }
        }
        whole.resize(digits.blocks() * LANES, 0);
        let mut inverses = vec![Lanes::ONE; primes.len()];
        invert(primes, &all, &mut inverses);
        Self { inverses, digits, product: whole, guard }
    }

    /// Writes `x/2^shift` of integers, `|x| < P/4`, from their residues at some places, as two's complement words.
    ///
    /// Each has an error of at most `1/2 + 2^-20` if it is rounded: fewer than `2^20` primes leave errors of less than
    /// `2^50 2^-96` each.
    pub fn write(&self, primes: &[Primes], table: &Table, places: &[usize], out: &mut [u64]) {
        if !places.is_empty() {
            write(self, primes, table, places, out);
        }
    }
}

/// The product of numbers, by halves.
pub(crate) fn product_of(numbers: &[u64]) -> Integer {
    match numbers {
        [] => Integer::from(1),
        [number] => Integer::from(*number),
        _ => {
            let (low, high) = numbers.split_at(numbers.len() / 2);
            product_of(low) * product_of(high)
        }
    }
}

vectorised! {
    /// `1/(P/p_i)` modulo every prime.
    fn invert(primes: &'a [Primes], all: &'a [u64], inverses: &'a mut [Lanes]) {
        for (group, (primes, inverse)) in primes.iter().zip(inverses).enumerate() {
            let mut product = Lanes::ONE;
            for (k, &p) in all.iter().enumerate() {
                // In its own lane the prime is left out.
                let factor = each!(|l| if group * LANES + l == k { 1.0 } else { p as f64 - primes.p.0[l] });
                product = primes.reduce(primes.mul(product, factor));
            }
            *inverse = primes.reciprocal(product);
        }
    }
}

vectorised! {
    fn write(level: &'a Level, primes: &'a [Primes], table: &'a Table<'a>, places: &'a [usize], out: &'a mut [u64]) {
        let width = out.len() / places.len();
        let mut halves = Vec::with_capacity(primes.len() * LANES);
        for (places, out) in places.chunks(2).zip(out.chunks_mut(2 * width)) {
            halves.clear();
            let mut shares = [Lanes::ZERO; 2];
            for ((group, primes), inverse) in primes.iter().enumerate().zip(&level.inverses) {
                let mut eight = [[0; ROWS]; LANES];
                for (i, &place) in places.iter().enumerate() {
                    let scaled = primes.mul(table.values[group * table.stride + place], table.scales[group]);
                    let t = primes.least(primes.mul(scaled, *inverse));
                    shares[i] = shares[i] + primes.share(t);
                    let t = t.integers();
                    for l in 0..LANES {
                        eight[l][2 * i] = t[l] & HALF_MASK;
                        eight[l][2 * i + 1] = t[l] >> HALF;
                    }
                }
                halves.extend_from_slice(&eight);
            }
            let mut writers: [Option<Writer>; 2] = [None, None];
            for (i, out) in out.chunks_exact_mut(width).enumerate() {
                let quotient = shares[i].0.iter().sum::<f64>().round_ties_even() as i128;
                writers[i] = Some(Writer { out, quotient, carry: 0, place: 0, guard: level.guard });
            }
            for (block, product) in level.product.as_chunks::<LANES>().0.iter().enumerate() {
                let sums = level.digits.multiply(&halves, block);
                for (i, writer) in writers.iter_mut().flatten().enumerate() {
                    for (l, &product) in product.iter().enumerate() {
                        let part = |k: usize| i128::from(sums.low[k][l]) + (i128::from(sums.high[k][l]) << 32);
                        writer.push(part(2 * i) + (part(2 * i + 1) << HALF), product);
                    }
                }
            }
            writers.into_iter().flatten().for_each(Writer::finish);
        }
    }
}

/// Digits that become two's complement words, rounded behind the guard digits.
struct Writer<'o> {
    out: &'o mut [u64],
    /// How often the product of the primes is taken away.
    quotient: i128,
    carry: i128,
    place: usize,
    guard: usize,
}

impl Writer<'_> {
    /// The next digit, not yet carried, and that of the product.
    #[inline(always)]
    fn push(&mut self, digit: i128, product: u32) {
        self.carry += digit - self.quotient * i128::from(product);
        if self.place + 1 == self.guard {
            self.carry += 1 << 31;
        }
        if self.place >= self.guard {
            self.put();
        }
        self.place += 1;
        self.carry >>= 32;
    }

    #[inline(always)]
    fn put(&mut self) {
        let place = self.place - self.guard;
        let digit = self.carry as u64 & DIGIT_MASK;
        if let Some(word) = self.out.get_mut(place / 2) {
            *word = if place.is_multiple_of(2) { digit } else { *word | digit << 32 };
        }
    }

    /// What is carried beyond the last digit is the sign.
    #[inline(always)]
    fn finish(mut self) {
        while self.place - self.guard < 2 * self.out.len() {
            self.put();
            self.place += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Fixed;
    use super::super::prime::primes;
    use super::*;
    use rug::ops::RemRounding;

    /// Residues of integers, as a table with one place for each.
    fn residues_of(primes: &[Primes], integers: &[Integer], width: usize) -> Vec<Lanes> {
        let source = Fixed::from_integers(integers, width);
        let words: Vec<u64> = (0..source.len()).flat_map(|j| source.words(j).to_vec()).collect();
        let mut found = vec![Lanes::ZERO; primes.len() * integers.len()];
        Radix::new(primes, width).residues(&words, width, primes.len(), &mut found);
        let first = primes.len().min(2);
        let mut fewer = vec![Lanes::ZERO; first * integers.len()];
        Radix::new(primes, width).residues(&words, width, first, &mut fewer);
        for (fewer, found) in fewer.chunks(first).zip(found.chunks(primes.len())) {
            assert_eq!(fewer, &found[..first]);
        }
        (0..primes.len()).flat_map(|group| found.iter().skip(group).step_by(primes.len()).copied()).collect()
    }

    fn check(groups: usize, integers: &[Integer], width: usize, shifts: &[u32]) {
        let primes = primes(groups);
        let table = residues_of(&primes, integers, width);
        for (group, row) in primes.iter().zip(table.chunks(integers.len())) {
            for (value, residue) in integers.iter().zip(row) {
                for (p, found) in group.p.integers().into_iter().zip(group.least(*residue).integers()) {
                    assert_eq!(value.clone().rem_euc(Integer::from(p)), found, "{value} mod {p}");
                }
            }
        }
        // A factor 3 that was taken out before.
        let tripled: Vec<Lanes> = primes
            .iter()
            .zip(table.chunks(integers.len()))
            .flat_map(|(group, row)| row.iter().map(|&x| group.mul(x, Lanes::splat(3.0))).collect::<Vec<_>>())
            .collect();
        let scales: Vec<Lanes> = primes.iter().map(|group| group.reciprocal(Lanes::splat(3.0))).collect();
        let residues = Table { values: &tripled, stride: integers.len(), scales: &scales };
        for &shift in shifts {
            let level = Level::new(&primes, shift);
            let places: Vec<usize> = (0..integers.len()).rev().collect();
            let mut words = vec![7; width * places.len()];
            level.write(&primes, &residues, &places, &mut words);
            let found = Fixed::from_words(words, width);
            for (i, value) in integers.iter().rev().enumerate() {
                let error = (found.integer(i) << shift) - value;
                assert!(error.significant_bits() <= shift, "{value} {shift}: {error}");
            }
        }
    }

    #[test]
    fn integers_come_back_rounded() {
        let mut values = vec![Integer::from(0), Integer::from(1), Integer::from(-1)];
        let mut value = Integer::from(-1);
        for step in 0..60u32 {
            value = (value * 1_000_003 + step) * if step % 3 == 0 { -1 } else { 1 };
            if value.significant_bits() > 2 * 399 - 10 {
                value >>= 300;
            }
            values.push(value.clone());
        }
        check(2, &values, 13, &[0, 64, 100, 256]);
    }

    /// Integers next to the largest that the primes hold, and so many primes that sums are taken in parts.
    #[test]
    fn the_largest_integers_come_back() {
        for groups in [1, 17, 35] {
            let all: Vec<u64> = primes(groups).iter().flat_map(|group| group.p.integers()).collect();
            let most: Integer = (product_of(&all) >> 2u32) - 1;
            let ones: Integer = (Integer::from(1) << (most.significant_bits() - 1)) - 1;
            let values = [most.clone(), -most, ones.clone(), -ones, Integer::from(-1)];
            check(groups, &values, groups * 399 / 64 + 2, &[0, 64, 65, 399]);
        }
    }

    #[test]
    fn the_product_of_no_number_is_one() {
        assert_eq!([&[][..], &[7], &[2, 3, 5]].map(product_of), [1, 7, 30]);
    }
}
