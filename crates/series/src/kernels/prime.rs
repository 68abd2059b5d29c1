//! Arithmetic modulo primes of one machine word, in Montgomery's form.

use rug::Integer;
use rug::integer::IsPrime;

/// Every prime has roots of unity of the orders that divide `3 * 2^24`.
const ORDER: u64 = 3 << 24;

/// An odd prime `p < 2^62` with `p = 1 mod 3 2^24`, and the constants of Montgomery's multiplication.
///
/// (Montgomery 1985.) A residue `x` is held as `x 2^64 mod p`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Prime {
    pub p: u64,
    /// `-1/p mod 2^64`.
    negated_inverse: u64,
    /// `2^64 mod p`, the form of 1.
    pub one: u64,
    /// `2^128 mod p`.
    square: u64,
}

impl Prime {
    /// The primes below `2^62` in falling order.
    pub fn falling() -> impl Iterator<Item = Self> {
        Self::falling_below(u64::MAX)
    }

    /// The primes below `2^62` and below a limit in falling order.
    pub fn falling_below(limit: u64) -> impl Iterator<Item = Self> {
        // Primality of 64-bit numbers: GMP's test is Baillie-PSW, which has no exception below 2^64.
        let is_prime = |p: &u64| Integer::from(*p).is_probably_prime(25) != IsPrime::No;
        let largest = ((1u64 << 62) - 1).min(limit - 2) / ORDER;
        (1..=largest).rev().map(|c| c * ORDER + 1).filter(is_prime).map(Self::new)
    }

    fn new(p: u64) -> Self {
        // Newton's iteration for 1/p mod 2^64: each step doubles the right bits, of which p itself has 3.
        let inverse = (0..5).fold(p, |x, _| x.wrapping_mul(2u64.wrapping_sub(p.wrapping_mul(x))));
        let one = (u64::MAX % p + 1) % p;
        let square = (u128::from(one) * u128::from(one) % u128::from(p)) as u64;
        Self { p, negated_inverse: inverse.wrapping_neg(), one, square }
    }

    /// `x y / 2^64 mod p`.
    #[inline]
    pub fn mul(&self, x: u64, y: u64) -> u64 {
        let t = u128::from(x) * u128::from(y);
        let m = (t as u64).wrapping_mul(self.negated_inverse);
        let reduced = ((t + u128::from(m) * u128::from(self.p)) >> 64) as u64;
        if reduced >= self.p { reduced - self.p } else { reduced }
    }

    #[inline]
    pub fn add(&self, x: u64, y: u64) -> u64 {
        let sum = x + y;
        if sum >= self.p { sum - self.p } else { sum }
    }

    #[inline]
    pub fn sub(&self, x: u64, y: u64) -> u64 {
        if x >= y { x - y } else { x + self.p - y }
    }

    /// The form of an integer.
    pub fn form(&self, n: i64) -> u64 {
        let residue = self.mul(n.unsigned_abs() % self.p, self.square);
        if n < 0 { self.sub(0, residue) } else { residue }
    }

    /// The residue in `0 .. p` that a form stands for.
    pub fn value(&self, form: u64) -> u64 {
        self.mul(form, 1)
    }

    pub fn pow(&self, base: u64, mut exponent: u64) -> u64 {
        let (mut result, mut base) = (self.one, base);
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = self.mul(result, base);
            }
            base = self.mul(base, base);
            exponent >>= 1;
        }
        result
    }

    /// `1/x` for `x != 0`, by Fermat.
    pub fn inverse(&self, x: u64) -> u64 {
        self.pow(x, self.p - 2)
    }

    /// `x y / 2^64 mod p`, below `2p`, for `x y < 2^64 p`.
    #[inline]
    pub fn mul_lazy(&self, x: u64, y: u64) -> u64 {
        self.reduce(u128::from(x) * u128::from(y))
    }

    /// `x / 2^64` modulo `p`: below `2p` if `x < 2^64 p`, below `2^63 + p` if `x < 2^127`.
    #[inline]
    pub fn reduce(&self, x: u128) -> u64 {
        let m = (x as u64).wrapping_mul(self.negated_inverse.wrapping_neg());
        let low = ((u128::from(m) * u128::from(self.p)) >> 64) as u64;
        ((x >> 64) as u64) + self.p - low
    }

    /// As [`Prime::reduce`], for any `x < 2^127`, below `p`.
    #[inline]
    pub fn reduced(&self, x: u128) -> u64 {
        let mut reduced = self.reduce(x);
        while reduced >= self.p {
            reduced -= self.p;
        }
        reduced
    }

    /// `2^128 mod p`.
    pub fn square(&self) -> u64 {
        self.square
    }

    /// A primitive root of unity of an order that divides `3 2^24`, as a form.
    pub fn root_of_unity(&self, order: usize) -> u64 {
        let has_order = |root: u64| {
            let proper = |prime: usize| {
                !order.is_multiple_of(prime) || self.pow(root, (order / prime) as u64) != self.one
            };
            proper(2) && proper(3)
        };
        let candidates = (2..).map(|candidate| self.pow(self.form(candidate), (self.p - 1) / order as u64));
        candidates.into_iter().find(|&root| has_order(root)).unwrap_or(self.one)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::ops::RemRounding;

    #[test]
    fn arithmetic_agrees_with_big_integers() {
        let prime = Prime::falling().next().unwrap();
        let (x, y) = (prime.form(-123_456_789_012_345), prime.form(987_654_321_987_654));
        let expected = Integer::from(-123_456_789_012_345i64) * 987_654_321_987_654i64;
        let expected = expected.rem_euc(Integer::from(prime.p));
        assert_eq!(prime.value(prime.mul(x, y)), expected);
        assert_eq!(prime.mul(x, prime.inverse(x)), prime.one);
        let root = prime.root_of_unity(3072);
        assert_eq!(prime.pow(root, 3072), prime.one);
        assert_ne!(prime.pow(root, 1536), prime.one);
        assert_ne!(prime.pow(root, 1024), prime.one);
    }
}
