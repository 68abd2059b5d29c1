//! Integers to residues modulo many primes and back, rounded by a power of two on the way.

use super::fixed::{effective, is_negative, negate};
use super::prime::Prime;
use rug::Integer;
use rug::integer::Order;
use std::sync::{Mutex, OnceLock};

/// Bits of every prime, at least.
pub(super) const BITS: u32 = 61;

/// The first `count` primes of the project, found once in a process.
pub(super) fn primes(count: usize) -> Vec<Prime> {
    static FOUND: OnceLock<Mutex<Vec<Prime>>> = OnceLock::new();
    let found = FOUND.get_or_init(|| Mutex::new(Vec::new()));
    let mut found = found.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    if found.len() < count {
        let known = found.last().map_or(u64::MAX, |prime| prime.p);
        let missing = count - found.len();
        found.extend(Prime::falling_below(known).take(missing));
    }
    found[..count].to_vec()
}

/// How many primes hold integers of absolute value below `2^bits`, with two bits to spare.
pub(super) fn primes_for(bits: u32) -> usize {
    (bits / BITS + 1) as usize + 1
}

/// The bits that so many primes hold, as [`primes_for`] counts.
pub(super) fn capacity(primes: usize) -> u32 {
    BITS * (primes.max(2) as u32 - 1) - 1
}

/// `2^(64 k)` modulo one prime, as plain residues: what carries words to residues.
pub(super) struct Radix {
    prime: Prime,
    powers: Vec<u64>,
    /// `2^128` and `2^192`.
    low: u64,
    high: u64,
}

impl Radix {
    pub fn new(prime: Prime, words: usize) -> Self {
        let step = prime.one;
        let mut power = 1;
        let powers = (0..=words).map(|_| {
            let this = power;
            power = prime.mul(power, prime.mul(step, prime.square()));
            this
        });
        let powers = powers.collect();
        let low = prime.square();
        Self { prime, powers, low, high: prime.mul(low, low) }
    }

    /// The residue of a two's complement integer, below `p`.
    pub fn residue(&self, words: &[u64]) -> u64 {
        let count = effective(words);
        let (low, high) = dot(&words[..count], &self.powers[..count]);
        let prime = &self.prime;
        let residue =
            prime.add(prime.mul(prime.reduced(low), self.low), prime.mul(prime.reduced(high), self.high));
        if is_negative(words) { prime.sub(residue, self.powers[count]) } else { residue }
    }
}

/// What turns residues modulo the first `n` primes into the integer, divided by `2^shift` and rounded.
///
/// With `P` the product of the primes and `t_i = r_i (P/p_i)^(-1) mod p_i` the integer `x` has
/// `x/P = sum t_i/p_i mod 1`; only as many bits of the fraction are found as the rounded `x/2^shift` needs.
pub(super) struct Level {
    count: usize,
    /// Words of the fraction.
    words: usize,
    /// The form of `(P/p_i)^(-1)` modulo `p_i`.
    inverses: Vec<u64>,
    /// `floor(2^(64 words)/p_i)`: for each word those of all primes.
    fractions: Vec<u64>,
    /// `floor(P/2^(shift - 64))`.
    product: Vec<u64>,
}

impl Level {
    /// For `shift >= 64`.
    pub fn new(primes: &[Prime], shift: u32) -> Self {
        let product = primes.iter().fold(Integer::from(1), |product, prime| product * prime.p);
        let count = primes.len();
        // n primes leave an error of n 2^62 in the fraction: 2^-24 of the result's unit.
        let bits = product.significant_bits().saturating_sub(shift) + 62 + 24 + count.ilog2() + 1;
        let words = bits.div_ceil(64) as usize;
        let one = Integer::from(1) << (64 * words as u32);
        let mut fractions = vec![0; count * words];
        for (i, prime) in primes.iter().enumerate() {
            let digits = Integer::from(&one / prime.p).to_digits::<u64>(Order::Lsf);
            for (w, digit) in digits.into_iter().enumerate() {
                fractions[w * count + i] = digit;
            }
        }
        let inverse = |i: usize| {
            let prime = &primes[i];
            let others = (0..count).filter(|&k| k != i);
            prime.inverse(
                others.fold(prime.one, |product, k| prime.mul(product, prime.form(primes[k].p as i64))),
            )
        };
        let inverses = (0..count).map(inverse).collect();
        let product = (product >> (shift - 64)).to_digits::<u64>(Order::Lsf);
        Self { count, words, inverses, fractions, product }
    }

    /// Writes `x/2^shift` from the residues of `x`, `|x| < P/4`, with an error of at most `1/2 + 2^-20`.
    pub fn write(
        &self,
        primes: &[Prime],
        residue: impl Fn(usize) -> u64,
        scratch: &mut Vec<u64>,
        out: &mut [u64],
    ) {
        let words = self.words;
        let count = self.count;
        scratch.clear();
        scratch.extend((0..count).map(|i| primes[i].mul(residue(i), self.inverses[i])));
        scratch.resize(count + 2 * words + self.product.len() + 2, 0);
        let (multiples, scratch) = scratch.split_at_mut(count);
        let (fraction, rest) = scratch.split_at_mut(words);
        let mut carry = 0u128;
        for (digit, fractions) in fraction.iter_mut().zip(self.fractions.chunks_exact(count)) {
            let (low, high) = dot(fractions, multiples);
            // Less than 2^127, with fewer than 2^60 primes.
            carry += low;
            *digit = carry as u64;
            carry = (carry >> 64) + high;
        }
        let negative = is_negative(fraction);
        if negative {
            negate(fraction);
        }
        // Words of fraction times product below index words - 1 are left out: less than 2^-60 of the unit.
        let first = words - 1;
        for (i, &digit) in fraction.iter().enumerate() {
            let skipped = first.saturating_sub(i);
            if skipped < self.product.len() {
                add_multiple(&mut rest[i + skipped - first..], &self.product[skipped..], digit);
            }
        }
        // rest[0] has index words - 1; the unit of the result has index words + 1.
        let half = rest[1] >> 63 == 1;
        let value = &rest[2..];
        let len = value.len().min(out.len());
        out[..len].copy_from_slice(&value[..len]);
        out[len..].fill(0);
        let mut carry = half;
        for word in out.iter_mut() {
            (*word, carry) = word.overflowing_add(u64::from(carry));
        }
        if negative {
            negate(out);
        }
    }
}

/// `sum x_i y_i = low + 2^64 high` for `y_i < 2^62`: four products fit into 128 bits.
#[inline]
fn dot(x: &[u64], y: &[u64]) -> (u128, u128) {
    let product = |x: u64, y: u64| u128::from(x) * u128::from(y);
    let (mut low, mut high) = (0u128, 0u128);
    let (xs, x_rest) = x.as_chunks::<4>();
    let (ys, y_rest) = y.as_chunks::<4>();
    for (&[a, b, c, d], &[e, f, g, h]) in xs.iter().zip(ys) {
        let sum = (product(a, e) + product(b, f)).wrapping_add(product(c, g)).wrapping_add(product(d, h));
        low += u128::from(sum as u64);
        high += sum >> 64;
    }
    for (&x, &y) in x_rest.iter().zip(y_rest) {
        let product = product(x, y);
        low += u128::from(product as u64);
        high += product >> 64;
    }
    (low, high)
}

/// `sum += x digit`, modulo the words of `sum`.
#[inline]
fn add_multiple(sum: &mut [u64], x: &[u64], digit: u64) {
    let mut carry = 0u64;
    let (low, high) = sum.split_at_mut(x.len().min(sum.len()));
    for (s, &x) in low.iter_mut().zip(x) {
        let t = u128::from(x) * u128::from(digit) + u128::from(*s) + u128::from(carry);
        *s = t as u64;
        carry = (t >> 64) as u64;
    }
    for s in high {
        if carry == 0 {
            break;
        }
        let (sum, over) = s.overflowing_add(carry);
        *s = sum;
        carry = u64::from(over);
    }
}

#[cfg(test)]
mod tests {
    use super::super::Fixed;
    use super::*;
    use rug::ops::RemRounding;

    #[test]
    fn integers_come_back_rounded() {
        let primes = primes(9);
        let mut value = Integer::from(-1);
        for step in 0..200u32 {
            value = (value * 1_000_003 + step) * if step % 3 == 0 { -1 } else { 1 };
            if value.significant_bits() > 9 * 61 - 10 {
                value >>= 300;
            }
            let source = Fixed::from_integers(std::slice::from_ref(&value), 10);
            let residue = |i: usize| Radix::new(primes[i], 10).residue(source.words(0));
            for (i, prime) in primes.iter().enumerate() {
                let expected = value.clone().rem_euc(Integer::from(prime.p));
                assert_eq!(residue(i), expected, "{value} mod {}", prime.p);
            }
            for shift in [64, 100, 256] {
                let level = Level::new(&primes, shift);
                let mut out = vec![0; 10];
                level.write(&primes, residue, &mut Vec::new(), &mut out);
                let found = Fixed::from_words(out, 10).integer(0);
                let error = (found << shift) - &value;
                assert!(error.significant_bits() <= shift, "{value} {shift}: {error}");
            }
        }
    }
}
