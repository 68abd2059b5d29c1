//! Iterated integrals over a whole collision as polynomials in as few of them as there need be.

use super::polynomial::Polynomial;
use super::word::{Word, arrangements, reversed, shuffle};
use rug::Rational;
use std::collections::{BTreeMap, BTreeSet};

/// The relations `M(U) M(V) = sum of M over the shuffles of U and V` and `M(W) = M(W reversed)`, solved as they are needed.
///
/// The second holds because every `omega_j` is even in `v`: the collision without damping looks the same
/// backwards. Together they leave one new constant for each element of odd length of the free Lie algebra.
#[derive(Default)]
pub(crate) struct Relations {
    solved: BTreeMap<Word, Polynomial>,
}

/// One equation between the integrals over the arrangements of the same letters: `sum left = right`.
struct Equation {
    left: BTreeMap<usize, Rational>,
    right: Polynomial,
}

impl Relations {
    /// `M(W)` as a polynomial in the constants that remain.
    pub(crate) fn value(&mut self, word: &Word) -> Polynomial {
        if word.len() <= 1 {
            return Polynomial::of_word(word);
        }
        if !self.solved.contains_key(word) {
            let mut letters = word.clone();
            letters.sort_unstable();
            self.solve(&letters);
        }
        self.solved[word].clone()
    }

    /// Gauss's elimination over the arrangements of `letters`, those to be expressed first.
    fn solve(&mut self, letters: &[u32]) {
        let mut words = arrangements(letters);
        words.sort_by_key(|word| (*word == reversed(word), std::cmp::Reverse(word.clone())));
        let index: BTreeMap<Word, usize> = words.iter().cloned().enumerate().map(|(i, w)| (w, i)).collect();
        let mut echelon: BTreeMap<usize, Equation> = BTreeMap::new();
        for mut equation in self.equations(letters, &words, &index) {
            while let Some((&pivot, c)) = equation.left.iter().next() {
                let c = c.clone();
                match echelon.get(&pivot) {
                    Some(row) => equation.subtract(row, &c),
                    None => {
                        equation.scale(&c.recip());
                        echelon.insert(pivot, equation);
                        break;
                    }
                }
            }
        }
        // Back substitution: a word that leads no row is a constant of its own.
        for (i, word) in words.iter().enumerate().rev() {
            let value = match echelon.get(&i) {
                None => Polynomial::of_word(word),
                Some(row) => {
                    let mut value = row.right.clone();
                    for (&other, c) in row.left.iter().skip(1) {
                        value.add(&self.solved[&words[other]], &Rational::from(-c));
                    }
                    value
                }
            };
            self.solved.insert(word.clone(), value);
        }
    }

    fn equations(&mut self, letters: &[u32], words: &[Word], index: &BTreeMap<Word, usize>) -> Vec<Equation> {
        let mut equations = Vec::new();
        for word in words {
            let mirror = &index[&reversed(word)];
            if *mirror > index[word] {
                let left = BTreeMap::from([(index[word], Rational::from(1)), (*mirror, Rational::from(-1))]);
                equations.push(Equation { left, right: Polynomial::default() });
            }
        }
        for (part, rest) in divisions(letters) {
            for u in arrangements(&part) {
                for v in arrangements(&rest) {
                    let left =
                        shuffle(&u, &v).into_iter().map(|(w, n)| (index[&w], Rational::from(n))).collect();
                    let right = self.value(&u).times(&self.value(&v));
                    equations.push(Equation { left, right });
                }
            }
        }
        equations
    }
}

/// The ways to divide sorted letters into two parts, none empty, each pair once.
fn divisions(letters: &[u32]) -> BTreeSet<(Word, Word)> {
    let mut divisions = BTreeSet::new();
    for subset in 1..(1_u32 << letters.len()) - 1 {
        let (mut part, mut rest) = (Word::new(), Word::new());
        for (i, &letter) in letters.iter().enumerate() {
            if subset >> i & 1 == 1 { part.push(letter) } else { rest.push(letter) }
        }
        if (part.len(), &part) <= (rest.len(), &rest) {
            divisions.insert((part, rest));
        }
    }
    divisions
}

impl Equation {
    fn subtract(&mut self, other: &Self, factor: &Rational) {
        for (&i, c) in &other.left {
            let place = self.left.entry(i).or_default();
            *place -= Rational::from(c * factor);
        }
        self.left.retain(|_, c| !c.is_zero());
        self.right.add(&other.right, &Rational::from(-factor));
    }

    fn scale(&mut self, factor: &Rational) {
        self.left.values_mut().for_each(|c| *c *= factor);
        let right = std::mem::take(&mut self.right);
        self.right.add(&right, factor);
    }
}
