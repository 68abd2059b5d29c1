//! Integers from their residues, by mixed radix digits.

use crate::kernels::Prime;
use rug::Integer;

/// The primes of a reconstruction with the constants of Garner's algorithm.
///
/// (Garner 1959; Knuth, *TAOCP* vol. 2, sec. 4.3.2.) A prefix of the primes serves for smaller integers.
pub(super) struct Basis {
    primes: Vec<Prime>,
    /// The form of `1/(p_0 ... p_(i-1))` modulo `p_i`.
    inverses: Vec<u64>,
    /// `p_0 ... p_(i-1)`.
    products: Vec<Integer>,
}

impl Basis {
    pub fn new(primes: Vec<Prime>) -> Self {
        let mut products = vec![Integer::from(1)];
        let mut inverses = Vec::with_capacity(primes.len());
        for (i, prime) in primes.iter().enumerate() {
            let product =
                primes[..i].iter().fold(prime.one, |product, other| prime.mul(product, radix(prime, other)));
            inverses.push(prime.inverse(product));
            products.push(Integer::from(&products[i] * prime.p));
        }
        Self { primes, inverses, products }
    }

    /// The integer `n`, `|n| < 2^bits`, with the given residues.
    pub fn integer(&self, residues: impl Iterator<Item = u64>, bits: u32) -> Integer {
        let enough = |product: &Integer| product.significant_bits() > bits + 1;
        let count = self.products.iter().position(enough).unwrap_or(self.primes.len());
        let mut digits: Vec<u64> = Vec::with_capacity(count);
        for (i, residue) in residues.take(count).enumerate() {
            let prime = &self.primes[i];
            // What the digits so far amount to modulo p_i, by Horner's scheme; digits are below 2^62.
            let sum = digits.iter().zip(&self.primes).rev().fold(0, |sum, (&digit, other)| {
                let digit = if digit >= prime.p { digit - prime.p } else { digit };
                prime.add(prime.mul(sum, radix(prime, other)), digit)
            });
            // The sum is a plain residue; multiplying it by a form leaves a plain residue.
            digits.push(prime.mul(prime.sub(residue, sum), self.inverses[i]));
        }
        let value = digits
            .iter()
            .zip(&self.primes)
            .rev()
            .fold(Integer::new(), |value, (digit, prime)| value * prime.p + digit);
        let product = &self.products[count];
        if Integer::from(&value * 2u32) > *product { value - product } else { value }
    }
}

/// The form of another prime of the basis modulo `prime`.
fn radix(prime: &Prime, other: &Prime) -> u64 {
    prime.form(other.p as i64)
}
