use crate::{Approximant, Interval, PadeError, sign_changes, zeros};
use restitution_real::OrderedField;
use std::cmp::Ordering;
use std::fmt;

/// Which way an approximant goes on an interval.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Trend {
    /// It is constant.
    Constant,
    /// It decreases all the way.
    Decreasing,
    /// It increases all the way.
    Increasing,
    /// It turns, as often as said.
    Turning(usize),
    /// A pole breaks it.
    Broken,
}

impl fmt::Display for Trend {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Constant => f.write_str("constant"),
            Self::Decreasing => f.write_str("decreasing"),
            Self::Increasing => f.write_str("increasing"),
            Self::Turning(times) => write!(f, "not monotone, {times} turning points"),
            Self::Broken => f.write_str("broken by a pole"),
        }
    }
}

/// Whether the values can be restitution coefficients, `0 < P/Q <= 1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Bounds {
    /// `0 < P/Q <= 1` on the whole interval.
    Within,
    /// Positive, but somewhere above 1.
    AboveOne,
    /// Somewhere zero or negative.
    NotPositive,
    /// A pole lies in the interval.
    Unbounded,
}

impl fmt::Display for Bounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Within => "within (0, 1]",
            Self::AboveOne => "positive, exceeds 1",
            Self::NotPositive => "not positive everywhere",
            Self::Unbounded => "unbounded",
        })
    }
}

/// What can be proved about the graph of an approximant on an interval.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Verdict {
    /// Distinct real poles.
    pub poles: usize,
    /// Distinct real zeros; `None` if the approximant vanishes identically.
    pub zeros: Option<usize>,
    /// Monotone or not.
    pub trend: Trend,
    /// Within `(0, 1]` or not.
    pub bounds: Bounds,
}

impl Verdict {
    /// Whether the approximant has no pole and is positive on the interval.
    pub fn is_sound(&self) -> bool {
        matches!(self.bounds, Bounds::Within | Bounds::AboveOne)
    }
}

/// Judges an approximant on an interval from 0: poles, zeros, trend and bounds.
///
/// Poles and zeros are those of `Q` and `P`, the trend follows from the sign changes of `P'Q - P Q'`
/// and the upper bound from those of `Q - P`, all counted by Sturm's theorem ([`zeros`]). Below the
/// order of contact both differences are taken from the series, where zeros are exact. Exact for
/// rationals; for balls the verdict holds for every approximant in them.
///
/// # Errors
///
/// [`PadeError::Undecided`] if the precision does not suffice.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_pade::{Bounds, Interval, PadeError, PadeType, Trend, approximant, verdict};
/// use restitution_real::Rationals;
///
/// let ints = |p: &[i64]| p.iter().map(|&c| BigRational::from_integer(c.into())).collect::<Vec<_>>();
/// let geometric = ints(&[1, -1, 1, -1]);
/// let good = verdict(&approximant(&Rationals, &geometric, PadeType::new(0, 1))?, &Interval::HalfLine)?; // 1/(1 + x)
/// assert_eq!((good.poles, good.zeros, good.trend), (0, Some(0), Trend::Decreasing));
/// assert_eq!(good.bounds, Bounds::Within);
/// assert!(good.is_sound());
///
/// let bad = verdict(&approximant(&Rationals, &geometric, PadeType::new(1, 0))?, &Interval::HalfLine)?; // 1 - x
/// assert_eq!(bad.bounds, Bounds::NotPositive);
/// # Ok::<(), PadeError>(())
/// ```
pub fn verdict<F: OrderedField>(
    approximant: &Approximant<F>,
    interval: &Interval<F::Number>,
) -> Result<Verdict, PadeError> {
    let field = approximant.field();
    let poles = zeros(field, approximant.den(), interval)?.unwrap_or(0);
    let zeros = zeros(field, approximant.num(), interval)?;
    if poles > 0 {
        return Ok(Verdict { poles, zeros, trend: Trend::Broken, bounds: Bounds::Unbounded });
    }
    let slope = approximant.slope();
    let trend = match sign_changes(field, &slope, interval)? {
        None => Trend::Constant,
        Some(0) if sign_after_zero(field, &slope) == Some(Ordering::Less) => Trend::Decreasing,
        Some(0) => Trend::Increasing,
        Some(turns) => Trend::Turning(turns),
    };
    let positive = zeros == Some(0) && sign_after_zero(field, approximant.num()) == Some(Ordering::Greater);
    let bounds = if !positive { Bounds::NotPositive } else { upper_bound(approximant, interval)? };
    Ok(Verdict { poles, zeros, trend, bounds })
}

/// The sign of a polynomial just right of 0, that of its lowest coefficient.
fn sign_after_zero<F: OrderedField>(field: &F, p: &[F::Number]) -> Option<Ordering> {
    p.iter().map(|c| field.sign(c)).find(|sign| *sign != Some(Ordering::Equal)).flatten()
}

/// Whether `P - Q <= 0` on the interval.
fn upper_bound<F: OrderedField>(
    approximant: &Approximant<F>,
    interval: &Interval<F::Number>,
) -> Result<Bounds, PadeError> {
    let field = approximant.field();
    let excess = approximant.minus(&field.one());
    let below = match sign_changes(field, &excess, interval)? {
        None => true,
        Some(0) => sign_after_zero(field, &excess) == Some(Ordering::Less),
        Some(_) => false,
    };
    Ok(if below { Bounds::Within } else { Bounds::AboveOne })
}

#[cfg(test)]
mod tests;
