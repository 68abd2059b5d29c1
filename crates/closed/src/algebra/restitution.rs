//! The coefficients of the restitution in the algebra of iterated integrals.

use super::forms::{Forms, Function, Reduction, add};
use super::polynomial::Polynomial;
use super::relations::Relations;
use super::word::Word;
use rug::Rational;

/// The expansion `eps = 1 + e_1 t + e_2 t^2 + ...`, `t = u ((a+1)/2)^(s-1)`, of every law with the same `s`.
pub(crate) struct Restitution {
    s: Rational,
    forms: Forms,
    relations: Relations,
}

impl Restitution {
    pub(crate) fn new(s: &Rational, reduction: Reduction) -> Self {
        Self { s: s.clone(), forms: Forms::new(s, reduction), relations: Relations::default() }
    }

    /// `e_k` as a polynomial in the constants that remain.
    ///
    /// With `p = 2s-1` and `E_alpha = eps^alpha` as a function of `v`,
    ///
    /// ```text
    /// dE_alpha = -alpha sum_(m>=1) t^m E_(alpha+pm) z^(ms-1) v^(m+1) dv,       E_alpha(-1) = 1
    /// ```
    ///
    /// so the coefficient of `t^n` in the power `1 + p (k-n)` follows from those of lower order in the same chain,
    /// whose end, `n = k`, is `e_k`.
    pub(crate) fn coefficient(&mut self, k: u32) -> Polynomial {
        let p = Rational::from(&self.s * 2) - 1;
        let mut chain = vec![Function::from([((0, 0, Word::new()), Rational::from(1))])];
        for n in 1..=k {
            let factor = Rational::from(-1) - Rational::from(&p * (k - n));
            let mut next = Function::new();
            for m in 1..=n {
                let integral = self.forms.integral_of(&chain[(n - m) as usize], m, m + 1);
                add(&mut next, &integral, &factor);
            }
            next.retain(|_, c| !c.is_zero());
            chain.push(next);
        }
        let mut sum = Polynomial::default();
        for (word, c) in Forms::at_exit(&chain[k as usize]) {
            sum.add(&self.relations.value(&word), &c);
        }
        sum
    }
}
