use crate::approximant::solve;
use crate::{Approximant, PadeError, PadeType};
use restitution_real::{Field, OrderedField};

/// The beginning of an expansion at infinity,
///
/// ```text
/// f(x) = x^(-decay) (b_0 + b_1/x + b_2/x^2 + ...)
/// ```
///
/// For spheres `eps(u) u^5 -> R^5`, and what is missing falls off faster than any power, so
/// `b_0 = R^5` and `b_1 = b_2 = ... = 0`.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_pade::AtInfinity;
/// use restitution_real::Rationals;
///
/// let limit = BigRational::new(515_838.into(), 100_000.into()); // R^5, to five digits
/// let two_conditions = AtInfinity::<Rationals>::new(5, vec![limit, BigRational::from_integer(0.into())]);
/// assert!(two_conditions != AtInfinity::new(5, Vec::new())); // no condition at all
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct AtInfinity<F: Field> {
    decay: usize,
    coefficients: Vec<F::Number>,
}

impl<F: Field> AtInfinity<F> {
    /// Returns the expansion with the given `b_0, b_1, ...`: as many conditions as coefficients.
    pub fn new(decay: usize, coefficients: Vec<F::Number>) -> Self {
        Self { decay, coefficients }
    }

    /// No condition at all.
    pub(crate) fn nothing() -> Self {
        Self { decay: 0, coefficients: Vec::new() }
    }

    /// The number of conditions.
    pub(crate) fn conditions(&self) -> usize {
        self.coefficients.len()
    }

    /// The condition that `x^(L-i)` in `P - (b_0 + b_1/x + ...) Q/x^decay` vanishes, as a row of the
    /// unknowns `q_0, ..., q_M`: `sum_j a_(L-i-j) q_j - sum_(l<=i) b_l q_(M-i+l) = 0`.
    pub(crate) fn row(&self, field: &F, series: &[F::Number], asked: PadeType, i: usize) -> Vec<F::Number> {
        let PadeType { numerator, denominator } = asked;
        let mut row = vec![field.zero(); denominator + 1];
        if let Some(top) = numerator.checked_sub(i) {
            for (entry, a) in row.iter_mut().zip(series[..=top].iter().rev()) {
                *entry = a.clone();
            }
        }
        for (entry, b) in row[denominator - i..].iter_mut().zip(&self.coefficients) {
            *entry = field.sub(entry, b);
        }
        row
    }
}

/// Returns the `[L/M]` two-point Padé approximant: contact with the series at 0 and with the
/// expansion at infinity.
///
/// ```text
/// A Q - P = O(x^(L+M+1-k)),   P/Q = x^(-decay) (b_0 + ... + b_(k-1) x^(1-k)) + O(x^(-decay-k))
/// ```
///
/// with `M = L + decay`. Two quotients that meet all `L + M + 1` conditions are equal, hence the answer
/// does not depend on how it is found; see [`approximant`](crate::approximant) for exactness,
/// degenerate cases and cost. With `k = 0` conditions it is the ordinary approximant.
///
/// # Errors
///
/// [`PadeError::WrongDecay`] unless `M = L + decay`; [`PadeError::TooManyConditions`] if `k > M`;
/// those of [`approximant`](crate::approximant).
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_pade::{AtInfinity, PadeError, PadeType, two_point};
/// use restitution_real::Rationals;
///
/// let ints = |p: &[i64]| p.iter().map(|&c| BigRational::from_integer(c.into())).collect::<Vec<_>>();
/// // 1 at 0 and 2/x at infinity: 1/(1 + x/2).
/// let f = two_point(&Rationals, &ints(&[1]), PadeType::new(0, 1), &AtInfinity::new(1, ints(&[2])))?;
/// assert_eq!(f.den()[1].to_string(), "1/2");
///
/// let wrong = two_point(&Rationals, &ints(&[1, 1]), PadeType::new(1, 1), &AtInfinity::new(1, ints(&[2])));
/// assert!(matches!(wrong, Err(PadeError::WrongDecay { decay: 1, .. })));
/// # Ok::<(), PadeError>(())
/// ```
pub fn two_point<F: OrderedField>(
    field: &F,
    series: &[F::Number],
    asked: PadeType,
    infinity: &AtInfinity<F>,
) -> Result<Approximant<F>, PadeError> {
    let (conditions, limit) = (infinity.conditions(), asked.denominator);
    if conditions > 0 && asked.numerator.checked_add(infinity.decay) != Some(asked.denominator) {
        return Err(PadeError::WrongDecay { asked, decay: infinity.decay });
    }
    if conditions > limit {
        return Err(PadeError::TooManyConditions { asked, conditions, limit });
    }
    solve(field, series, asked, infinity)
}

#[cfg(test)]
mod tests;
