use crate::{PadeError, RationalFunction};
use restitution_real::Ball;

/// The largest relative error seen.
#[derive(Clone, Debug)]
pub struct WorstError {
    /// Where it was seen.
    pub at: Ball,
    /// An enclosure of `|P/Q / f - 1|` there.
    pub error: Ball,
}

/// How far an approximant stays within a given relative error.
#[derive(Clone, Debug)]
pub enum Reach {
    /// On every sample of the range.
    Everywhere,
    /// Up to this sample; on the next one the error is or may be larger.
    UpTo(Ball),
}

/// Returns the largest relative error of `P/Q` against certified samples `(x, f(x))`.
///
/// ```text
/// max over the samples of |P(x)/(Q(x) f(x)) - 1|
/// ```
///
/// # Error bound
///
/// At each sample the error is enclosed. Between samples nothing is proved: a finer grid is the
/// remedy. `None` without samples.
///
/// # Errors
///
/// [`PadeError::Undecided`] if an enclosure of `Q(x)` contains zero.
pub fn largest_error(
    function: &RationalFunction<Ball>,
    samples: &[(Ball, Ball)],
) -> Result<Option<WorstError>, PadeError> {
    let mut worst: Option<WorstError> = None;
    for (x, value) in samples {
        let error = relative_error(function, x, value)?;
        if worst.as_ref().is_none_or(|w| error.upper() > w.error.upper()) {
            worst = Some(WorstError { at: x.clone(), error });
        }
    }
    Ok(worst)
}

/// Returns how far along the samples, in ascending order, the relative error stays at or below
/// `level`.
///
/// # Errors
///
/// As [`largest_error`].
pub fn largest_reach(
    function: &RationalFunction<Ball>,
    samples: &[(Ball, Ball)],
    level: &Ball,
) -> Result<Reach, PadeError> {
    let mut reached = Ball::from_integer(0, level.prec());
    for (x, value) in samples {
        if relative_error(function, x, value)?.upper() > level.lower() {
            return Ok(Reach::UpTo(reached));
        }
        reached = x.clone();
    }
    Ok(Reach::Everywhere)
}

/// `|P/Q / f - 1|` at one sample.
fn relative_error(function: &RationalFunction<Ball>, x: &Ball, value: &Ball) -> Result<Ball, PadeError> {
    Ok((function.value(x)? / value - Ball::from_integer(1, x.prec())).abs())
}
