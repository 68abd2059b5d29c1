//! Numbers as they are printed, against numbers that are known.

use crate::AuditError;
use num_rational::BigRational;
use num_traits::Signed;
use restitution_law::exact::Exact;
use restitution_real::Ball;
use restitution_real::convert::rug_rational;
use rug::Rational;

/// Proved digits of every number that is shown.
pub const SHOWN_DIGITS: usize = 20;

/// A number that is known exactly or enclosed.
#[derive(Clone, Debug)]
pub enum Known {
    /// It is this fraction.
    Exactly(BigRational),
    /// It lies in this ball.
    Within(Ball),
}

/// How a printed number agrees with the true one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Agreement {
    /// They are equal.
    Equal,
    /// The printed one is the true one, rounded to its last digit.
    Rounded,
    /// The printed one is the true one, cut off after its last digit.
    CutOff,
    /// The printed one is neither.
    None,
}

impl Known {
    /// Returns the number as it is shown: a fraction, or [`SHOWN_DIGITS`] proved digits.
    pub fn shown(&self) -> Result<String, AuditError> {
        match self {
            Self::Exactly(value) => Ok(value.to_string()),
            Self::Within(ball) => digits(ball, SHOWN_DIGITS),
        }
    }

    /// Bounds that hold exactly.
    fn bounds(&self) -> Result<(Rational, Rational), AuditError> {
        match self {
            Self::Exactly(value) => Ok((rug_rational(value), rug_rational(value))),
            Self::Within(ball) => {
                let bounds = ball.lower().to_rational().zip(ball.upper().to_rational());
                bounds
                    .filter(|_| ball.is_finite())
                    .ok_or_else(|| AuditError::failure("a number is not known"))
            }
        }
    }
}

impl Agreement {
    /// Compares a printed decimal or fraction with a number.
    ///
    /// A ball that leaves the answer open is an error: the verdict must be certain.
    pub fn of(printed: &str, known: &Known) -> Result<Self, AuditError> {
        let value =
            exact(printed).ok_or_else(|| AuditError::failure(format!("'{printed}' is not a number")))?;
        let bounds = known.bounds()?;
        let printed_exactly = rug_rational(&value);
        if bounds.0 == printed_exactly && bounds.1 == printed_exactly {
            return Ok(Self::Equal);
        }
        if printed.contains('/') {
            return Ok(Self::None);
        }
        let places = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let unit = BigRational::new(
            1.into(),
            num_bigint::BigInt::from(10).pow(u32::try_from(places).unwrap_or(u32::MAX)),
        );
        let half = &unit / BigRational::from_integer(2.into());
        let away = if value.is_negative() { &value - &unit } else { &value + &unit };
        if inside(&bounds, &(&value - &half), &(&value + &half), printed)? {
            Ok(Self::Rounded)
        } else if inside(&bounds, (&value).min(&away), (&value).max(&away), printed)? {
            Ok(Self::CutOff)
        } else {
            Ok(Self::None)
        }
    }
}

/// Whether a number lies between two others, if its bounds tell.
fn inside(
    (low, high): &(Rational, Rational),
    from: &BigRational,
    to: &BigRational,
    printed: &str,
) -> Result<bool, AuditError> {
    let (from, to) = (rug_rational(from), rug_rational(to));
    if from <= *low && *high <= to {
        Ok(true)
    } else if *high < from || to < *low {
        Ok(false)
    } else {
        Err(AuditError::failure(format!("the precision does not tell whether {printed} is right")))
    }
}

/// Reads a decimal or a fraction exactly.
pub fn exact(text: &str) -> Option<BigRational> {
    text.parse::<Exact>().ok().map(|number| number.value().clone())
}

/// Returns a ball's value with this many proved digits.
pub fn digits(ball: &Ball, digits: usize) -> Result<String, AuditError> {
    ball.to_digits(digits).ok_or_else(|| AuditError::failure(format!("{digits} digits could not be proved")))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn agreement(printed: &str, n: i64, d: i64) -> Agreement {
        let enclosed = Agreement::of(printed, &Known::Within(Ball::from_ratio(n, d, 100))).unwrap();
        let exact = Agreement::of(printed, &Known::Exactly(BigRational::new(n.into(), d.into()))).unwrap();
        assert!(exact == enclosed || exact == Agreement::Equal);
        exact
    }

    #[test]
    fn printed_digits_are_rounded_cut_off_or_neither() {
        assert_eq!(agreement("0.667", 2, 3), Agreement::Rounded);
        assert_eq!(agreement("0.666", 2, 3), Agreement::CutOff);
        assert_eq!(agreement("-0.666", -2, 3), Agreement::CutOff);
        assert_eq!(agreement("-0.668", -2, 3), Agreement::None);
        assert_eq!(agreement("0.668", 2, 3), Agreement::None);
        assert_eq!(agreement("0.665", 2, 3), Agreement::None);
        assert_eq!(agreement("-0.667", 2, 3), Agreement::None);
        assert_eq!(agreement("2/3", 2, 3), Agreement::Equal);
        assert_eq!(agreement("0.5", 1, 2), Agreement::Equal);
        assert_eq!(agreement("2/3", 2, 5), Agreement::None);
    }

    #[test]
    fn a_wide_ball_gives_no_verdict() {
        let wide = Ball::from_ratio(2, 3, 64).widened(&rug::Float::with_val(32, 0.0003));
        assert!(Agreement::of("0.667", &Known::Within(wide)).is_err());
    }
}
