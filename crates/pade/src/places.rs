use crate::{Interval, PadeError, polynomial, zeros};
use num_rational::BigRational;
use restitution_real::OrderedField;
use std::cmp::Ordering;

/// How often the first end of the search may double.
const DOUBLINGS: u32 = 1000;
/// How often an interval may be halved until each holds one zero: closer ones are not told apart.
const HALVINGS: u32 = 400;

/// Encloses every real zero `x >= 0` of a polynomial between two rationals, to a relative width of `10^-digits`.
///
/// Sturm's theorem counts ([`zeros`]) and tells the zeros apart; then the sign halves the intervals. A zero at 0 comes as `(0, 0)`. For balls the enclosures hold for every polynomial in them.
///
/// # Errors
///
/// As [`zeros`]: undecided for multiple zeros among balls, and where the balls are too wide for the digits.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_pade::{PadeError, places};
/// use restitution_real::Rationals;
///
/// let ints = |p: &[i64]| p.iter().map(|&c| BigRational::from_integer(c.into())).collect::<Vec<_>>();
/// let found = places(&Rationals, &ints(&[6, -5, -2, 1]), 12)?; // (x - 1)(x + 2)(x - 3)
/// let within = |k: usize, x: i64| found[k].0 <= ints(&[x])[0] && ints(&[x])[0] <= found[k].1;
/// assert!(found.len() == 2 && within(0, 1) && within(1, 3));
/// assert!(places(&Rationals, &ints(&[1, 0, 1]), 12)?.is_empty());
/// # Ok::<(), PadeError>(())
/// ```
pub fn places<F: OrderedField>(
    field: &F,
    p: &[F::Number],
    digits: usize,
) -> Result<Vec<(BigRational, BigRational)>, PadeError> {
    let all = zeros(field, p, &Interval::HalfLine)?.unwrap_or(0);
    let count = |x: &BigRational| Ok(zeros(field, p, &Interval::UpTo(field.rational(x)))?.unwrap_or(0));
    let origin = BigRational::from_integer(0.into());
    let mut found = Vec::new();
    if all == 0 {
        return Ok(found);
    }
    let at_zero = usize::from(p.first().is_some_and(|c| field.sign(c) == Some(Ordering::Equal)));
    if at_zero > 0 {
        found.push((origin.clone(), origin.clone()));
    }
    // no power of two and no short decimal, where polynomials of interest may vanish
    let mut end = BigRational::new(8.into(), 7.into());
    for _ in 0..DOUBLINGS {
        if count(&end)? == all {
            break;
        }
        end *= BigRational::from_integer(2.into());
    }
    let mut open = vec![(origin, at_zero, end, all, 0)];
    while let Some((low, below, high, up_to, depth)) = open.pop() {
        let inside = up_to - below;
        if inside == 0 {
            continue;
        }
        if inside == 1 {
            found.push(narrow(field, p, (low, high), digits)?);
            continue;
        }
        if depth == HALVINGS {
            return Err(PadeError::Undecided { what: "whether two zeros are one" });
        }
        let middle = half(&low, &high);
        let left = count(&middle)?;
        open.push((middle.clone(), left, high, up_to, depth + 1));
        open.push((low, below, middle, left, depth + 1));
    }
    Ok(found)
}

/// Halves an interval with one zero by the sign of the polynomial, or by counts if the zero has even multiplicity.
fn narrow<F: OrderedField>(
    field: &F,
    p: &[F::Number],
    (mut low, mut high): (BigRational, BigRational),
    digits: usize,
) -> Result<(BigRational, BigRational), PadeError> {
    let sign = |x: &BigRational| sign_at(field, p, x);
    let after = sign(&high)?;
    if after == Ordering::Equal {
        return Ok((high.clone(), high));
    }
    let beyond = zeros(field, p, &Interval::UpTo(field.rational(&high)))?.unwrap_or(0);
    let odd = sign_right_of(field, p, &low)? != after;
    let ten = BigRational::from_integer(10.into());
    let scale = (0..digits).fold(BigRational::from_integer(1.into()), |scale, _| scale * &ten);
    while (&high - &low) * &scale > low {
        let middle = half(&low, &high);
        let right = match sign(&middle)? {
            Ordering::Equal => return Ok((middle.clone(), middle)),
            at_middle if odd => at_middle == after,
            _ => zeros(field, p, &Interval::UpTo(field.rational(&middle)))?.unwrap_or(0) == beyond,
        };
        if right { high = middle } else { low = middle }
    }
    Ok((low, high))
}

fn sign_at<F: OrderedField>(field: &F, p: &[F::Number], x: &BigRational) -> Result<Ordering, PadeError> {
    let value = polynomial::evaluate(field, p, &field.rational(x));
    field.sign(&value).ok_or(PadeError::Undecided { what: "the place of a zero" })
}

/// The sign just right of a point, which may be a zero: that of the first derivative that does not vanish there.
fn sign_right_of<F: OrderedField>(
    field: &F,
    p: &[F::Number],
    x: &BigRational,
) -> Result<Ordering, PadeError> {
    let mut p = p.to_vec();
    loop {
        match sign_at(field, &p, x)? {
            Ordering::Equal if p.len() > 1 => p = polynomial::derivative(field, &p),
            sign => return Ok(sign),
        }
    }
}

fn half(low: &BigRational, high: &BigRational) -> BigRational {
    (low + high) / BigRational::from_integer(2.into())
}

#[cfg(test)]
mod tests;
