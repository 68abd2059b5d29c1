//! A coefficient as an expression: rational numbers, a root, Beta values and iterated Beta integrals.

use crate::algebra::{Monomial, Polynomial, Restitution, Word, times};
use crate::root::rational_power;
use crate::{ClosedError, Family, Reduction, beta, iterated_beta};
use num_rational::{BigRational, Ratio};
use num_traits::{One, Zero};
use restitution_law::ForceLaw;
use restitution_real::{Ball, convert};
use restitution_series::DelayedRecovery;
use rug::Rational;
use std::collections::BTreeMap;

/// The largest order in whole powers of `u` for which closed forms are derived.
pub const LARGEST_ORDER: usize = 12;

/// An iterated Beta integral `M(p_1, ..., p_r)` by its exponents; `M(p)` is the Beta value `B(p, 3/2)`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Constant {
    /// `p_1 ... p_r`, those of the outermost integration first.
    pub exponents: Vec<Ratio<i64>>,
}

/// The number whose powers give back the units of `u`: `((a+1)/2)^(s-1)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Base {
    /// `(a+1)/2`
    pub number: Ratio<i64>,
    /// `s-1`
    pub exponent: Ratio<i64>,
}

/// A rational number times a power of the base times powers of constants.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// The rational number.
    pub coefficient: BigRational,
    /// The power of [`Base`].
    pub base_power: i64,
    /// The constants with their powers, which may be negative.
    pub factors: Vec<(Constant, i32)>,
}

/// A coefficient `C_k`, `a_k` or `h_k` of one law, exactly.
///
/// # Examples
///
/// ```
/// use restitution_closed::{ClosedError, Family, Reduction, closed_form};
/// use restitution_law::ForceLaw;
///
/// let spheres = ForceLaw::viscoelastic_spheres();
/// let fourth = closed_form(Family::Scaled, &spheres, 4, Reduction::Special)?;
/// assert_eq!((fourth.name(), fourth.terms.len(), fourth.constants().len()), ("a_4".into(), 2, 2));
/// assert_eq!((fourth.family.letter(), fourth.constants()[0].symbol()), ("a", "M_3_5".into()));
///
/// let beyond = closed_form(Family::Scaled, &spheres, 13, Reduction::Special);
/// assert!(matches!(beyond, Err(ClosedError::BeyondAlgebra { .. })));
/// # Ok::<(), ClosedError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedForm {
    /// Which family.
    pub family: Family,
    /// The index `k`.
    pub order: usize,
    /// `s = (gamma+1)/(a+1)`
    pub s: Ratio<i64>,
    /// What powers of [`Term::base_power`] stand for.
    pub base: Base,
    /// The terms of the sum; none if the coefficient is 0.
    pub terms: Vec<Term>,
}

/// Returns the closed form of the coefficient `order` of a family.
///
/// The derivation, which is one recursion and one kind of partial integration, is in `docs/closed-forms.md`,
/// sections 2 and 7. Exact. Cost: microseconds up to order 4, a second at order 12.
///
/// # Errors
///
/// [`ClosedError::BeyondAlgebra`] beyond [`LARGEST_ORDER`] in whole powers of `u`, [`ClosedError::Series`] for
/// `h_k` of a law without zero-force end.
///
/// # Examples
///
/// ```
/// use restitution_closed::{ClosedError, Family, Language, Reduction, closed_form};
/// use restitution_law::ForceLaw;
///
/// let spheres = ForceLaw::viscoelastic_spheres();
/// let third = closed_form(Family::Scaled, &spheres, 3, Reduction::Special)?;
/// assert_eq!(third.expression(Language::Text), "7/25 + 575/1452 B(9/5, 3/2)/B(3/5, 3/2)^3");
/// assert_eq!(third.value(12)?.to_digits(12).as_deref(), Some("0.340729027136"));
///
/// let far = closed_form(Family::Scaled, &spheres, 1000, Reduction::Special);
/// assert!(matches!(far, Err(ClosedError::BeyondAlgebra { .. })));
/// # Ok::<(), ClosedError>(())
/// ```
pub fn closed_form(
    family: Family,
    law: &ForceLaw,
    order: usize,
    reduction: Reduction,
) -> Result<ClosedForm, ClosedError> {
    let lattice = law.lattice();
    let s = Ratio::new(lattice.damping, lattice.elastic);
    let mut algebra = Restitution::new(&Rational::from((*s.numer(), *s.denom())), reduction);
    let by_power = match family {
        Family::Restitution => {
            BTreeMap::from([(power_of_u(order)?, algebra.coefficient(power_of_u(order)?))])
        }
        Family::Scaled => BTreeMap::from([(0, scaled(&mut algebra, power_of_u(order)?))]),
        Family::DelayedRecovery => delayed(&mut algebra, law, order)?,
    };
    let constant = |word: &Word| Constant { exponents: word.iter().map(|&j| s * i64::from(j)).collect() };
    let term = |power: u32, (monomial, c): (&Monomial, &Rational)| Term {
        coefficient: BigRational::new(convert::big_integer(c.numer()), convert::big_integer(c.denom())),
        base_power: i64::from(power),
        factors: monomial.iter().map(|(word, &n)| (constant(word), n)).collect(),
    };
    let terms = by_power.iter().flat_map(|(&power, sum)| sum.0.iter().map(move |entry| term(power, entry)));
    let base = Base { number: Ratio::new(lattice.elastic, 2 * lattice.unit), exponent: s - 1 };
    Ok(ClosedForm { family, order, s, base: base.clone(), terms: terms.map(|t| base.absorb(t)).collect() })
}

/// The order as a power of `u`, if it is not too high.
fn power_of_u(order: usize) -> Result<u32, ClosedError> {
    let beyond = ClosedError::BeyondAlgebra { order, largest: LARGEST_ORDER };
    u32::try_from(order).ok().filter(|&k| k as usize <= LARGEST_ORDER).ok_or(beyond)
}

/// `a_k = e_k/e_1^k`
fn scaled(algebra: &mut Restitution, k: u32) -> Polynomial {
    let (e, first) = (algebra.coefficient(k), algebra.coefficient(1));
    let Some((monomial, c)) = first.0.iter().next() else { return e };
    let power = i32::try_from(k).unwrap_or(i32::MAX);
    let inverse: Monomial = monomial.iter().map(|(word, &n)| (word.clone(), -n * power)).collect();
    let factor = (0..k).fold(Rational::from(1), |product, _| product / c);
    let mut sum = Polynomial::default();
    for (monomial, c) in &e.0 {
        sum.add_term(times(monomial, &inverse), Rational::from(c * &factor));
    }
    sum
}

/// `h_k` by powers of `u`: `eps_d = sum_i psi_i u^(r i) eps^(1 + p r i)`.
fn delayed(
    algebra: &mut Restitution,
    law: &ForceLaw,
    order: usize,
) -> Result<BTreeMap<u32, Polynomial>, ClosedError> {
    let end = DelayedRecovery::new(law)?;
    let step = end.damping_exponent();
    let (stride, steps) = (usize::try_from(*step.numer()), usize::try_from(*step.denom()));
    let (stride, steps) = (stride.unwrap_or(usize::MAX), steps.unwrap_or(1));
    let most = power_of_u(order / steps)?;
    let e: Vec<Polynomial> = (1..=most).map(|k| algebra.coefficient(k)).collect();
    let exponent = BigRational::new((*step.numer()).into(), (*step.denom()).into());
    let mut sums = BTreeMap::new();
    for (i, psi) in end.psi(order / stride).iter().enumerate() {
        let left = order - i * stride;
        if !left.is_multiple_of(steps) {
            continue;
        }
        let power =
            BigRational::one() + law.velocity_exponent() * &exponent * BigRational::from_integer(i.into());
        let n = left / steps;
        let mut sum = Polynomial::default();
        sum.add(&power_coefficient(&e, &convert::rug_rational(&power), n), &convert::rug_rational(psi));
        sums.insert(u32::try_from(n).unwrap_or(u32::MAX), sum);
    }
    Ok(sums)
}

/// The coefficient `n` of `(1 + e_1 t + e_2 t^2 + ...)^power`, by J.C.P. Miller.
fn power_coefficient(e: &[Polynomial], power: &Rational, n: usize) -> Polynomial {
    let mut f = vec![Polynomial::constant(Rational::from(1))];
    for n in 1..=n {
        let mut sum = Polynomial::default();
        for i in 1..=n {
            let weight = (Rational::from(power * i as u64) - (n - i) as u64) / n as u64;
            sum.add(&e[i - 1].times(&f[n - i]), &weight);
        }
        f.push(sum);
    }
    f.swap_remove(n)
}

impl Base {
    /// Drops the power of 1, which the base is for `a = 1` and for `gamma = a`.
    fn absorb(&self, mut term: Term) -> Term {
        if self.number.is_one() || self.exponent.is_zero() {
            term.base_power = 0;
        }
        term
    }
}

impl ClosedForm {
    /// The constants that occur, each once.
    pub fn constants(&self) -> Vec<Constant> {
        let mut constants: Vec<_> = self
            .terms
            .iter()
            .flat_map(|term| term.factors.iter().map(|(constant, _)| constant.clone()))
            .collect();
        constants.sort();
        constants.dedup();
        constants.sort_by_key(|constant| constant.exponents.len());
        constants
    }

    /// Returns the value, enclosed so narrowly that [`Ball::to_digits`] proves `digits` decimals.
    ///
    /// # Errors
    ///
    /// [`ClosedError::Precision`] if they cannot be proved, [`ClosedError::TooManyTerms`] of [`iterated_beta`].
    pub fn value(&self, digits: usize) -> Result<Ball, ClosedError> {
        if self.terms.is_empty() {
            return Ok(Ball::zero());
        }
        let wanted = u32::try_from(digits.saturating_mul(3322) / 1000).unwrap_or(u32::MAX / 8);
        let mut spare = 96;
        loop {
            let bits = wanted.saturating_add(spare);
            let value = self.value_at(bits)?;
            if value.relative_bits().is_none_or(|known| known >= i64::from(wanted) + 32) {
                return Ok(value);
            }
            spare *= 2;
            if spare > wanted.saturating_add(1 << 14) {
                return Err(ClosedError::Precision { digits, bits });
            }
        }
    }

    fn value_at(&self, bits: u32) -> Result<Ball, ClosedError> {
        let values = self.constants().into_iter().map(|constant| {
            let value = constant.value(bits)?;
            Ok((constant, value))
        });
        let values = values.collect::<Result<BTreeMap<Constant, Ball>, ClosedError>>()?;
        let number = BigRational::new((*self.base.number.numer()).into(), (*self.base.number.denom()).into());
        let mut sum = Ball::zero();
        for term in &self.terms {
            let mut product = Ball::from_rational(&term.coefficient, bits);
            if term.base_power != 0 {
                product *= rational_power(&number, self.base.exponent * term.base_power, bits);
            }
            for (constant, power) in &term.factors {
                product *= values[constant].powi(i64::from(*power));
            }
            sum += product;
        }
        Ok(sum)
    }
}

impl Constant {
    /// Returns the value in a ball of about `bits` bits.
    ///
    /// # Errors
    ///
    /// As [`iterated_beta`].
    pub fn value(&self, bits: u32) -> Result<Ball, ClosedError> {
        match self.exponents[..] {
            [p] => Ok(beta(p, bits)),
            _ => iterated_beta(&self.exponents, bits),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Language;

    #[test]
    fn the_fifth_order_of_spheres_has_the_integers_found_numerically() {
        // With T = P^2 Q - 4 M(s, 3s, s); 224007300000 a_5, found by integer relations before it was derived.
        let spheres = ForceLaw::viscoelastic_spheres();
        let fifth = closed_form(Family::Scaled, &spheres, 5, Reduction::General).expect("order 5");
        let coefficient = |names: &[&str]| {
            let is = |term: &&Term| {
                let found: Vec<String> =
                    term.factors.iter().map(|(c, n)| format!("{}^{n}", c.name())).collect();
                found == names
            };
            fifth.terms.iter().find(is).expect("a term").coefficient.clone()
                * BigRational::from_integer(224_007_300_000_i64.into())
        };
        let whole = |n: i64| BigRational::from_integer(n.into());
        let t = coefficient(&["B(3/5, 3/2)^-5", "M(3/5, 9/5, 3/5)^1"]) / whole(-4);
        assert_eq!(t, whole(2_661_243_750));
        assert_eq!(coefficient(&[]), whole(9_031_974_336));
        assert_eq!(coefficient(&["B(3/5, 3/2)^-5", "B(3, 3/2)^1"]), whole(29_458_671_875));
        assert_eq!(coefficient(&["B(3/5, 3/2)^-3", "B(9/5, 3/2)^1"]) - t, whole(98_466_018_750));
    }

    #[test]
    fn special_exponents_reduce_the_constants() {
        let third =
            |law: &str| closed_form(Family::Scaled, &law.parse().expect("a law"), 3, Reduction::Special);
        let text = |law: &str| third(law).expect("order 3").expression(Language::Text);
        assert_eq!(text("1,0"), "1/6 + 1/8/B(1/2, 3/2)^2"); // s = 1/2: rational in pi
        assert_eq!(text("1,1"), "11/10"); // s = 1: 1 + 7/36 (16/105)/(2/3)^3
        assert_eq!(text("3/2,1/2"), "7/25 + 575/1452 B(9/5, 3/2)/B(3/5, 3/2)^3");
    }
}
