use crate::{ApproximateError, Expansion, Request, error_on_range, error_reach};
use num_rational::BigRational;
use restitution_pade::{Approximant, Reach, WorstError};
use restitution_real::Balls;

/// The largest damping up to which an error level is followed.
pub const FARTHEST: i64 = 20;

/// A range of dampings as far as the bodies separate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ValidRange {
    /// The range, which ends where the values end.
    pub range: (BigRational, BigRational),
    /// Whether it ends earlier than asked, a little below the critical damping.
    pub is_cut: bool,
}

impl ValidRange {
    /// Returns the range as far as there are values to compare with.
    ///
    /// # Errors
    ///
    /// [`ApproximateError::BeyondCriticalDamping`] if there is none; those of [`Expansion::reach`].
    ///
    /// # Examples
    ///
    /// ```
    /// use num_rational::BigRational;
    /// use restitution_approximate::{ApproximateError, Expansion, ValidRange};
    /// use restitution_direct::End;
    /// use restitution_law::ForceLaw;
    ///
    /// let number = |n: i64| BigRational::from_integer(n.into());
    /// let dashpot = Expansion::new(&"1,0".parse::<ForceLaw>().expect("a law"), End::ZeroCompression, None)?;
    /// assert!(!ValidRange::new(&dashpot, &(number(0), number(1)))?.is_cut);
    /// assert!(ValidRange::new(&dashpot, &(number(0), number(3)))?.is_cut); // critical at u = 2
    ///
    /// let beyond = ValidRange::new(&dashpot, &(number(3), number(4)));
    /// assert!(matches!(beyond, Err(ApproximateError::BeyondCriticalDamping { .. })));
    /// # Ok::<(), ApproximateError>(())
    /// ```
    pub fn new(
        expansion: &Expansion,
        (low, high): &(BigRational, BigRational),
    ) -> Result<Self, ApproximateError> {
        let end = expansion.reach(high)?;
        if end <= *low {
            return Err(ApproximateError::BeyondCriticalDamping { end: Box::new(end) });
        }
        Ok(Self { is_cut: end < *high, range: (low.clone(), end) })
    }
}

/// How good an approximant is, by certified values.
#[derive(Clone, Debug)]
pub struct Quality {
    /// The range on which the largest error was looked for.
    pub range: ValidRange,
    /// The largest relative error seen there.
    pub worst: WorstError,
    /// How far the error stays at or below the level of the request.
    pub reach: Reach,
    /// How far that was followed: [`FARTHEST`], or to the critical damping.
    pub followed: ValidRange,
}

/// Measures the largest relative error of an approximant on a range, and how far its error stays within a level.
///
/// ```text
/// max over a grid of |P/(Q eps) - 1|
/// ```
///
/// At each point the error is enclosed; between the points nothing is proved. Cost: some 150 certified values, seconds.
///
/// # Errors
///
/// Those of [`ValidRange::new`], [`error_on_range`] and [`error_reach`].
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_approximate::{ApproximateError, Expansion, Request, judge, quality};
/// use restitution_direct::End;
/// use restitution_law::ForceLaw;
/// use restitution_pade::{PadeType, Reach};
///
/// let number = |n: i64, d: i64| BigRational::new(n.into(), d.into());
/// let dashpot = Expansion::new(&"1,0".parse::<ForceLaw>().expect("a law"), End::ZeroCompression, None)?;
/// let range = (number(0, 1), number(1, 1));
/// let request = Request { asked: PadeType::new(1, 2), at_infinity: 0, digits: 6, range, level: number(1, 1000) };
/// let found = judge(&dashpot, &request)?.approximant;
/// let good = quality(&dashpot, &found, &request)?;
/// assert!(good.worst.error.upper() < 0.06 && good.followed.is_cut);
/// assert!(matches!(good.reach, Reach::UpTo(u) if u < number(1, 2)));
///
/// let nowhere = Request { range: (number(3, 1), number(4, 1)), ..request };
/// assert!(quality(&dashpot, &found, &nowhere).is_err());
/// # Ok::<(), ApproximateError>(())
/// ```
pub fn quality(
    expansion: &Expansion,
    approximant: &Approximant<Balls>,
    request: &Request,
) -> Result<Quality, ApproximateError> {
    let whole = |n: i64| BigRational::from_integer(n.into());
    let range = ValidRange::new(expansion, &request.range)?;
    let worst = error_on_range(expansion, approximant, &range.range)?;
    let followed = ValidRange::new(expansion, &(whole(0), whole(FARTHEST)))?;
    let reach = error_reach(expansion, approximant, &request.level, &followed.range.1)?;
    Ok(Quality { range, worst, reach, followed })
}
