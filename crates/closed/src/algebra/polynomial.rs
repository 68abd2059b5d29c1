//! Polynomials in constants, each named by its word.

use super::word::Word;
use rug::Rational;
use std::collections::BTreeMap;

/// A product of powers of constants; the power of a constant may be negative.
pub(crate) type Monomial = BTreeMap<Word, i32>;

/// A sum of rational multiples of monomials.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Polynomial(pub(crate) BTreeMap<Monomial, Rational>);

impl Polynomial {
    pub(crate) fn constant(c: Rational) -> Self {
        let mut sum = Self::default();
        sum.add_term(Monomial::new(), c);
        sum
    }

    /// The constant named by a word; the empty word is 1.
    pub(crate) fn of_word(word: &Word) -> Self {
        let monomial = if word.is_empty() { Monomial::new() } else { Monomial::from([(word.clone(), 1)]) };
        Self(BTreeMap::from([(monomial, Rational::from(1))]))
    }

    pub(crate) fn add_term(&mut self, monomial: Monomial, c: Rational) {
        use std::collections::btree_map::Entry;
        match self.0.entry(monomial) {
            Entry::Vacant(place) if !c.is_zero() => drop(place.insert(c)),
            Entry::Vacant(_) => {}
            Entry::Occupied(mut place) => {
                *place.get_mut() += c;
                if place.get().is_zero() {
                    place.remove();
                }
            }
        }
    }

    /// `self += factor other`
    pub(crate) fn add(&mut self, other: &Self, factor: &Rational) {
        for (monomial, c) in &other.0 {
            self.add_term(monomial.clone(), Rational::from(c * factor));
        }
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        let mut product = Self::default();
        for (left, c) in &self.0 {
            for (right, d) in &other.0 {
                product.add_term(times(left, right), Rational::from(c * d));
            }
        }
        product
    }
}

/// The product of two monomials.
pub(crate) fn times(left: &Monomial, right: &Monomial) -> Monomial {
    let mut product = left.clone();
    for (word, power) in right {
        *product.entry(word.clone()).or_insert(0) += power;
    }
    product.retain(|_, power| *power != 0);
    product
}
