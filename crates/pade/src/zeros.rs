use crate::polynomial::Polynomial;
use crate::{PadeError, polynomial};
use restitution_real::OrderedField;
use std::cmp::Ordering;

/// Where zeros are counted.
#[derive(Clone, Debug, PartialEq)]
pub enum Interval<N> {
    /// `0 <= x < infinity`.
    HalfLine,
    /// `0 <= x <= end`, with `end > 0`.
    UpTo(N),
}

/// Counts the distinct real zeros of a polynomial on the interval, by Sturm's theorem, or by Descartes'
/// rule of signs where that suffices.
///
/// ```text
/// p_0 = p,  p_1 = p',  p_(i+1) = -(p_(i-1) mod p_i),   #zeros in (0, b] = V(0) - V(b)
/// ```
///
/// with `V` the number of sign changes along the chain; zeros at 0 are split off first. `None` for
/// the zero polynomial. Exact for rationals; for balls the count holds for every polynomial in them.
/// Cost: about `d^2` multiplications for degree `d`.
///
/// # Errors
///
/// [`PadeError::Undecided`] if a sign is not certain; among balls that includes most multiple zeros.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_pade::{Interval, PadeError, zeros};
/// use restitution_real::Rationals;
///
/// let ints = |p: &[i64]| p.iter().map(|&c| BigRational::from_integer(c.into())).collect::<Vec<_>>();
/// let cubic = ints(&[6, -5, -2, 1]); // (x - 1)(x + 2)(x - 3)
/// assert_eq!(zeros(&Rationals, &cubic, &Interval::HalfLine)?, Some(2));
/// assert_eq!(zeros(&Rationals, &cubic, &Interval::UpTo(ints(&[2])[0].clone()))?, Some(1));
/// assert_eq!(zeros(&Rationals, &ints(&[0]), &Interval::HalfLine)?, None);
/// # Ok::<(), PadeError>(())
/// ```
pub fn zeros<F: OrderedField>(
    field: &F,
    p: &[F::Number],
    interval: &Interval<F::Number>,
) -> Result<Option<usize>, PadeError> {
    let Some((p, at_zero)) = split_zero(field, p)? else { return Ok(None) };
    let away = match by_descartes(field, &p, interval) {
        Some(count) => count,
        None => positive_zeros(field, &sturm_chain(field, &p)?, interval)?,
    };
    Ok(Some(away + usize::from(at_zero > 0)))
}

/// Counts the points `x > 0` of the interval where a polynomial changes its sign: the zeros of odd
/// multiplicity. `None` for the zero polynomial.
///
/// ```text
/// changes = n_1 - n_2 + n_3 - ...,   n_m = number of distinct zeros of multiplicity m or more
/// ```
///
/// where the zeros of `gcd(p, p')`, the last of Sturm's chain, are those of multiplicity 2 or more.
///
/// # Errors
///
/// As [`zeros`].
pub fn sign_changes<F: OrderedField>(
    field: &F,
    p: &[F::Number],
    interval: &Interval<F::Number>,
) -> Result<Option<usize>, PadeError> {
    let Some((mut p, _)) = split_zero(field, p)? else { return Ok(None) };
    if let Some(count) = by_descartes(field, &p, interval) {
        return Ok(Some(count));
    }
    let (mut odd, mut even) = (0, 0);
    while p.len() > 1 {
        let mut chain = sturm_chain(field, &p)?;
        odd += positive_zeros(field, &chain, interval)?;
        p = chain.pop().unwrap_or_default();
        std::mem::swap(&mut odd, &mut even);
    }
    Ok(Some(odd.abs_diff(even)))
}

/// The polynomial without its zeros at 0, trimmed, and how many they were.
fn split_zero<F: OrderedField>(
    field: &F,
    p: &[F::Number],
) -> Result<Option<(Polynomial<F>, usize)>, PadeError> {
    let mut p = p.to_vec();
    polynomial::trim(field, &mut p, "whether the leading coefficient of a polynomial is zero")?;
    let lowest = polynomial::lowest(field, &p, "whether the lowest coefficient of a polynomial is zero")?;
    Ok(lowest.map(|shift| (p.split_off(shift), shift)))
}

/// The number of zeros in `(0, b]` where Descartes' rule of signs decides it: coefficients without a
/// change of sign have no positive zero, those with one change have one, a simple one.
fn by_descartes<F: OrderedField>(
    field: &F,
    p: &[F::Number],
    interval: &Interval<F::Number>,
) -> Option<usize> {
    let changes = variations(field, p).ok()?;
    match (changes, interval) {
        (0, _) => Some(0),
        (1, Interval::HalfLine) => Some(1),
        (1, Interval::UpTo(end)) => {
            let start = field.sign(p.first()?)?;
            let end = field.sign(&polynomial::evaluate(field, p, end))?;
            Some(usize::from(start != end))
        }
        _ => None,
    }
}

/// Sturm's chain, each remainder divided by the size of its leading coefficient.
fn sturm_chain<F: OrderedField>(field: &F, p: &[F::Number]) -> Result<Vec<Polynomial<F>>, PadeError> {
    let what = "whether a remainder of Sturm's chain is zero";
    let mut chain = vec![p.to_vec()];
    let mut next = polynomial::derivative(field, p);
    loop {
        polynomial::trim(field, &mut next, what)?;
        let Some(leading) = next.last() else { return Ok(chain) };
        let positive = field.sign(leading) == Some(Ordering::Greater);
        let size = if positive { leading.clone() } else { field.neg(leading) };
        next = next.iter().map(|c| field.div(c, &size)).collect();
        let rest = polynomial::divide(field, &chain[chain.len() - 1], &next).1;
        chain.push(next);
        next = rest.iter().map(|c| field.neg(c)).collect();
    }
}

/// `V(0) - V(b)`, the number of distinct zeros in `(0, b]`.
///
/// Dividing the chain by its last polynomial makes it a chain of simple zeros; that changes `V(0)`
/// and `V(b)` only where the last polynomial vanishes, which at 0 it does not.
fn positive_zeros<F: OrderedField>(
    field: &F,
    chain: &[Polynomial<F>],
    interval: &Interval<F::Number>,
) -> Result<usize, PadeError> {
    let at_zero: Vec<_> = chain.iter().map(|p| p[0].clone()).collect();
    let at_end: Vec<_> = match interval {
        Interval::HalfLine => chain.iter().map(|p| p[p.len() - 1].clone()).collect(),
        Interval::UpTo(end) => {
            let last = chain[chain.len() - 1].as_slice();
            let simple = chain.iter().map(|p| polynomial::divide(field, p, last).0);
            simple.map(|p| polynomial::evaluate(field, &p, end)).collect()
        }
    };
    Ok(variations(field, &at_zero)?.saturating_sub(variations(field, &at_end)?))
}

/// The number of sign changes, zeros left out.
///
/// Between a positive and a negative value lies one change whatever stands there, so a sign that is
/// open is needed only where its neighbours agree or at an end.
fn variations<F: OrderedField>(field: &F, values: &[F::Number]) -> Result<usize, PadeError> {
    let signs: Vec<_> = values.iter().map(|value| field.sign(value)).collect();
    let needed = |i: usize| {
        let neighbours =
            i.checked_sub(1).and_then(|before| signs[before]).zip(*signs.get(i + 1).unwrap_or(&None));
        !neighbours.is_some_and(|(before, after)| before == after.reverse() && before != Ordering::Equal)
    };
    if (0..signs.len()).any(|i| signs[i].is_none() && needed(i)) {
        return Err(PadeError::Undecided { what: "the sign of a value in Sturm's chain" });
    }
    let mut changes: Vec<_> = signs.into_iter().flatten().filter(|sign| sign.is_ne()).collect();
    changes.dedup();
    Ok(changes.len().saturating_sub(1))
}

#[cfg(test)]
mod tests;
