//! Partial integration of `z^(js-1) v^m` times iterated integrals, along a collision.

use super::word::Word;
use rug::{Integer, Rational};
use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;

/// A function `sum c z^(js) v^m W(v)` with `z = 1 - v^2`, by `(j, m, W)`.
pub(crate) type Function = BTreeMap<(u32, u32, Word), Rational>;

/// The functions of one law, `s = (gamma+1)/(a+1)`, with what has been integrated so far.
///
/// `W = j_1 ... j_r` stands for the iterated integral from the impact, `v = -1`, on:
///
/// ```text
/// W(v) = int_(-1)^v omega_(j_1) (j_2 ... j_r)(v'),      omega_j = z^(js-1) v'^2 dv'
/// ```
pub(crate) struct Forms {
    s: Rational,
    /// Whether letters that differ by a whole power of `z`, or are exact, are reduced.
    reduction: Reduction,
    known: HashMap<(u32, u32, Word), Rc<Function>>,
}

/// What is done with letters whose exponents `js` are whole or differ by whole numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reduction {
    /// They are kept: the formulas are those of a law in general position.
    General,
    /// They are integrated out or reduced to the smallest one: fewer constants.
    Special,
}

impl Forms {
    pub(crate) fn new(s: &Rational, reduction: Reduction) -> Self {
        Self { s: s.clone(), reduction, known: HashMap::new() }
    }

    /// `f(v) -> int_(-1)^v z^(is-1) v'^n f dv'`
    pub(crate) fn integral_of(&mut self, f: &Function, i: u32, n: u32) -> Function {
        let mut sum = Function::new();
        for ((j, m, word), c) in f {
            add(&mut sum, &self.integral(i + j, m + n, word), c);
        }
        sum
    }

    /// `J(j, m, W) = int_(-1)^v z^(js-1) v'^m W dv'`, `j, m >= 1`, by the exact forms
    ///
    /// ```text
    /// d(z^(js) v^(m-1)) = -(2js+m-1) z^(js-1) v^m dv + (m-1) z^(js-1) v^(m-2) dv
    /// (2js+m-1) J(j, m, W) = (m-1) J(j, m-2, W) - z^(js) v^(m-1) W + J(i+j, m+1, W'),    W = i W'
    /// ```
    ///
    /// down to `m = 2`, a letter, or `m = 1`, where the first term on the right is gone. No denominator vanishes.
    fn integral(&mut self, j: u32, m: u32, word: &Word) -> Rc<Function> {
        let key = (j, m, word.clone());
        if let Some(known) = self.known.get(&key) {
            return Rc::clone(known);
        }
        let found = Rc::new(if m == 2 { self.letter(j, word) } else { self.lowered(j, m, word) });
        self.known.insert(key, Rc::clone(&found));
        found
    }

    fn lowered(&mut self, j: u32, m: u32, word: &Word) -> Function {
        let scale = (Rational::from(&self.s * (2 * j)) + (m - 1)).recip();
        let mut sum = Function::new();
        if m > 2 {
            add(&mut sum, &self.integral(j, m - 2, word), &Rational::from(&scale * (m - 1)));
        }
        add_term(&mut sum, (j, m - 1, word.clone()), Rational::from(-&scale));
        if let Some((&first, rest)) = word.split_first() {
            add(&mut sum, &self.integral(j + first, m + 1, &rest.to_vec()), &scale);
        }
        sum
    }

    /// `J(j, 2, W)`: the word `jW`, unless `z^(js)` is a whole power of `z` times that of a smaller letter.
    fn letter(&mut self, j: u32, word: &Word) -> Function {
        let denominator = self.s.denom().to_u32().filter(|&q| self.reduction == Reduction::Special && q <= j);
        let Some(q) = denominator else {
            let mut longer = vec![j];
            longer.extend(word);
            return Function::from([((0, 0, longer), Rational::from(1))]);
        };
        let smallest = j % q;
        let power = Rational::from(&self.s * (j - smallest));
        let power = power.numer().to_u32().expect("whole, and small as every exponent here");
        if smallest == 0 {
            return self.exact_letter(power, word);
        }
        let mut sum = Function::new();
        for (k, c) in binomials(power).into_iter().enumerate() {
            add(&mut sum, &self.integral(smallest, 2 + 2 * k as u32, word), &c);
        }
        sum
    }

    /// `int z^(n-1) v^2 W dv` for whole `n`: `Q W - int Q dW`, `Q` the antiderivative, a polynomial.
    fn exact_letter(&mut self, n: u32, word: &Word) -> Function {
        let mut sum = Function::new();
        for (k, c) in binomials(n - 1).into_iter().enumerate() {
            let power = 3 + 2 * k as u32;
            let q = c / power;
            match word.split_first() {
                None => add_term(&mut sum, (0, 0, Word::new()), q.clone()), // -Q(-1) = Q(1)
                Some((&first, rest)) => {
                    let inner = self.integral(first, power + 2, &rest.to_vec());
                    add(&mut sum, &inner, &Rational::from(-&q));
                }
            }
            add_term(&mut sum, (0, power, word.clone()), q);
        }
        sum
    }

    /// The value at the exit, `v = 1`, where `z = 0`: what has no factor `z`.
    pub(crate) fn at_exit(f: &Function) -> BTreeMap<Word, Rational> {
        let mut values = BTreeMap::new();
        for ((j, _, word), c) in f {
            if *j == 0 {
                *values.entry(word.clone()).or_insert_with(Rational::new) += c;
            }
        }
        values.retain(|_, c| !c.is_zero());
        values
    }
}

/// `(1 - x)^n` by powers of `x`.
fn binomials(n: u32) -> Vec<Rational> {
    let sign = |k: u32| if k.is_multiple_of(2) { 1 } else { -1 };
    (0..=n).map(|k| Rational::from(Integer::from(n).binomial(k) * sign(k))).collect()
}

/// `sum += factor f`
pub(crate) fn add(sum: &mut Function, f: &Function, factor: &Rational) {
    for (key, c) in f {
        add_term(sum, key.clone(), Rational::from(c * factor));
    }
}

fn add_term(sum: &mut Function, key: (u32, u32, Word), c: Rational) {
    let place = sum.entry(key).or_default();
    *place += c;
}
