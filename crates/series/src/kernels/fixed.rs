//! Series whose coefficients are fixed-point numbers of one absolute precision.

use restitution_real::Magnitude;
use rug::Integer;
use rug::integer::Order;

/// A series of integers that stand for multiples of one power of two.
///
/// Two's complement, `width` words for each coefficient, least word first.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fixed {
    width: usize,
    words: Vec<u64>,
}

impl Fixed {
    pub fn zero(len: usize, width: usize) -> Self {
        Self { width, words: vec![0; len * width] }
    }

    pub fn from_integers(integers: &[Integer], width: usize) -> Self {
        let mut series = Self::zero(integers.len(), width);
        for (j, integer) in integers.iter().enumerate() {
            series.set(j, integer);
        }
        series
    }

    /// Takes the words as they are.
    pub fn from_words(words: Vec<u64>, width: usize) -> Self {
        Self { width, words }
    }

    pub fn len(&self) -> usize {
        self.words.len() / self.width
    }

    pub fn words(&self, j: usize) -> &[u64] {
        &self.words[j * self.width..(j + 1) * self.width]
    }

    /// The words of all coefficients.
    pub(super) fn all_words(&self) -> &[u64] {
        &self.words
    }

    /// The coefficient as an integer.
    pub fn integer(&self, j: usize) -> Integer {
        let words = self.words(j);
        let mut value = Integer::from_digits(words, Order::Lsf);
        if is_negative(words) {
            value -= Integer::from(1) << (64 * self.width as u32);
        }
        value
    }

    /// Sets a coefficient; what is too large becomes the largest number, which no proof lets pass.
    pub fn set(&mut self, j: usize, value: &Integer) {
        let width = self.width;
        let words = &mut self.words[j * width..(j + 1) * width];
        if value.significant_bits() < 64 * width as u32 {
            let count = value.significant_digits::<u64>();
            value.write_digits(&mut words[..count], Order::Lsf);
            words[count..].fill(0);
        } else {
            words.fill(u64::MAX);
            words[width - 1] >>= 1;
        }
        if value.is_negative() {
            negate(words);
        }
    }

    pub fn truncated(&self, len: usize) -> Self {
        Self { width: self.width, words: self.words[..len.min(self.len()) * self.width].to_vec() }
    }

    /// The coefficients from `first` on.
    pub fn beyond(&self, first: usize) -> Self {
        Self { width: self.width, words: self.words[first.min(self.len()) * self.width..].to_vec() }
    }

    pub fn extend(&mut self, other: &Self) {
        debug_assert_eq!(self.width, other.width);
        self.words.extend_from_slice(&other.words);
    }

    /// The same series with one more coefficient, 0, in front, and the last one dropped.
    pub fn stepped(&self) -> Self {
        let mut words = vec![0; self.width];
        words.extend_from_slice(&self.words[..self.words.len() - self.width]);
        Self { width: self.width, words }
    }

    pub fn add(&mut self, other: &Self) {
        for (x, y) in self.words.chunks_exact_mut(self.width).zip(other.words.chunks_exact(other.width)) {
            let mut carry = false;
            for (x, &y) in x.iter_mut().zip(y) {
                (*x, carry) = carrying_add(*x, y, carry);
            }
        }
    }

    pub fn negated(mut self) -> Self {
        self.words.chunks_exact_mut(self.width).for_each(negate);
        self
    }

    /// Multiplies coefficient `j` by the fraction `weights(j)`, rounded by less than one unit.
    pub fn scaled(&self, weights: impl Fn(usize) -> (i64, i64)) -> Self {
        let mut out = Self::zero(self.len(), self.width);
        for j in 0..self.len() {
            let (numerator, denominator) = weights(j);
            if self.words(j).iter().all(|&word| word == 0) {
                continue;
            }
            let mut value = self.integer(j);
            if numerator != 1 {
                value *= numerator;
            }
            if denominator != 1 {
                value /= denominator;
            }
            out.set(j, &value);
        }
        out
    }

    /// The bits of the largest coefficient.
    pub fn bits(&self) -> u32 {
        self.words.chunks_exact(self.width).map(significant_bits).max().unwrap_or(0)
    }

    /// The series divided by a power of two, rounded down.
    pub fn shifted_right(&self, bits: u32) -> Self {
        let shift = |j: usize| self.integer(j) >> bits;
        let integers: Vec<Integer> = (0..self.len()).map(shift).collect();
        Self::from_integers(&integers, self.width)
    }

    /// An upper bound of `sum_j |c_j| weight^j` in units of `2^unit`.
    pub fn norm(&self, unit: i64, weight: f64) -> Magnitude {
        let weight = Magnitude::exact(weight);
        let mut power = Magnitude::ONE;
        let mut sum = Magnitude::ZERO;
        for words in self.words.chunks_exact(self.width) {
            sum = sum + power * size(words, unit);
            power = power * weight;
        }
        sum
    }

    /// An upper bound of `sum_j |c_j| 2^(slope j)` in units of `2^unit`.
    pub fn rising_norm(&self, unit: i64, slope: f64) -> Magnitude {
        let term = |j: usize| size(self.words(j), unit - (slope * j as f64).ceil() as i64);
        (0..self.len()).map(term).sum()
    }

    /// An upper bound of `|c_j|` in units of `2^unit`.
    pub fn size(&self, j: usize, unit: i64) -> Magnitude {
        size(self.words(j), unit)
    }
}

pub(super) fn is_negative(words: &[u64]) -> bool {
    words.last().is_some_and(|&top| top >> 63 == 1)
}

/// The words that count: those above are copies of the sign.
pub(super) fn effective(words: &[u64]) -> usize {
    let sign = if is_negative(words) { u64::MAX } else { 0 };
    words.iter().rposition(|&word| word != sign).map_or(0, |top| top + 1)
}

#[inline]
pub(super) fn carrying_add(x: u64, y: u64, carry: bool) -> (u64, bool) {
    let (sum, first) = x.overflowing_add(y);
    let (sum, second) = sum.overflowing_add(u64::from(carry));
    (sum, first | second)
}

pub(super) fn negate(words: &mut [u64]) {
    let mut carry = true;
    for word in words {
        (*word, carry) = (!*word).overflowing_add(u64::from(carry));
    }
}

/// Bits of `|value|`, at most one too many.
pub(super) fn significant_bits(words: &[u64]) -> u32 {
    let count = effective(words);
    let sign = if is_negative(words) { u64::MAX } else { 0 };
    if count == 0 {
        return u32::from(sign != 0);
    }
    64 * count as u32 - (words[count - 1] ^ sign).leading_zeros() + u32::from(sign != 0)
}

fn size(words: &[u64], unit: i64) -> Magnitude {
    let count = effective(words);
    let sign = if is_negative(words) { u64::MAX } else { 0 };
    if count == 0 && sign == 0 {
        return Magnitude::ZERO;
    }
    // The absolute value of a negative number is one more than its complement.
    let top = if count == 0 { 0 } else { words[count - 1] ^ sign };
    let below = if count < 2 { sign } else { words[count - 2] ^ sign };
    let lead = (u128::from(top) << 64 | u128::from(below)).saturating_add(1);
    let exponent = 64 * (count.max(1) as i64 - 2) - unit;
    // The conversion rounds to nearest; one unit of the double more is above.
    Magnitude::exact((lead as f64).next_up()) * power_of_two(exponent)
}

/// `2^exponent` rounded up to the least positive double, or infinite.
pub(crate) fn power_of_two(exponent: i64) -> Magnitude {
    match exponent {
        ..=-1022 => Magnitude::exact(f64::MIN_POSITIVE),
        1024.. => Magnitude::exact(f64::INFINITY),
        _ => Magnitude::exact(f64::from_bits(((exponent + 1023) as u64) << 52)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_back_and_are_rounded_towards_zero() {
        let values = [0, 1, -1, 12345, -98765, i64::MAX, i64::MIN].map(Integer::from);
        let big: Vec<Integer> = values.iter().map(|x| Integer::from(x * x) * x).collect();
        let series = Fixed::from_integers(&big, 4);
        for (j, value) in big.iter().enumerate() {
            assert_eq!(series.integer(j), *value);
            let size = series.size(j, 0).to_f64();
            let exact = value.to_f64().abs();
            assert!(size >= exact && size <= exact * (1.0 + 1e-12) + 1.0, "{value} {size}");
            let bits = significant_bits(series.words(j));
            assert!((value.significant_bits()..=value.significant_bits() + 1).contains(&bits));
        }
        let third = series.scaled(|_| (2, -3));
        assert_eq!(third.integer(4), Integer::from(&big[4] * 2) / -3);
        let mut sum = series.clone();
        sum.add(&series.negated());
        assert_eq!(sum, Fixed::zero(7, 4));
    }

    /// Numbers of all bits but that of the sign are held, larger ones become the largest.
    #[test]
    fn numbers_that_are_too_large_become_the_largest() {
        for width in [1, 2, 3] {
            let limit = Integer::from(1) << (64 * width as u32 - 1);
            let largest = Integer::from(&limit - 1);
            let numbers = [&largest, &limit, &Integer::from(&limit << 1), &Integer::from(&limit << 70)];
            let (above, below) = (numbers.map(Integer::clone), numbers.map(|x| Integer::from(-x)));
            let held = Fixed::from_integers(&[above, below].concat(), width);
            for j in 0..8 {
                assert_eq!(held.integer(j), if j < 4 { largest.clone() } else { Integer::from(-&largest) });
            }
        }
    }

    #[test]
    fn powers_of_two_end_at_those_of_doubles() {
        let powers = [-5000, -1022, -1021, 0, 1023, 1024, 1025, 5000].map(|e| power_of_two(e).to_f64());
        let least = f64::MIN_POSITIVE;
        let infinite = f64::INFINITY;
        assert_eq!(powers, [least, least, 2.0 * least, 1.0, 2f64.powi(1023), infinite, infinite, infinite]);
    }
}
