use crate::{PadeError, RationalFunction};
use num_rational::BigRational;
use restitution_real::{Ball, Balls};
use std::cmp::Ordering;

/// A certified point of the function that is approximated.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The argument of the approximant.
    pub x: Ball,
    /// An enclosure of the value there.
    pub value: Ball,
}

/// The largest relative error seen.
#[derive(Clone, Debug)]
pub struct WorstError {
    /// Where it was seen.
    pub at: BigRational,
    /// An enclosure of `|P/Q / f - 1|` there.
    pub error: Ball,
}

/// How far an approximant stays within a given relative error.
#[derive(Clone, Debug, PartialEq)]
pub enum Reach {
    /// On the whole grid.
    Everywhere,
    /// Up to this point; a little beyond it the error is or may be larger.
    UpTo(BigRational),
}

/// Points of a grid on `[low, high]` that is denser at both ends.
///
/// ```text
/// low + (high - low) t^2 (3 - 2 t),    t = 0, 1/n, ..., 1
/// ```
///
/// # Errors
///
/// [`PadeError::EmptyRange`] unless `0 <= low < high`.
pub fn grid(low: &BigRational, high: &BigRational, intervals: u32) -> Result<Vec<BigRational>, PadeError> {
    let ratio = |n: u32, d: u32| BigRational::new(n.into(), d.into());
    if *low < ratio(0, 1) || low >= high {
        return Err(PadeError::EmptyRange { low: low.to_string(), high: high.to_string() });
    }
    let n = intervals.max(1);
    let step = |i: u32| {
        let t = ratio(i, n);
        low + (high - low) * &t * &t * (ratio(3, 1) - ratio(2, 1) * &t)
    };
    Ok((0..=n).map(step).collect())
}

/// Returns the relative error of `P/Q` at one certified sample.
///
/// # Errors
///
/// [`PadeError::Undecided`] if an enclosure of `Q(x)` contains zero.
///
/// # Examples
///
/// ```
/// use restitution_pade::{PadeError, RationalFunction, Sample, relative_error};
/// use restitution_real::{Ball, Balls};
///
/// let number = |n: i64| Ball::from_integer(n, 64);
/// let line = RationalFunction::new(&Balls::new(64), vec![number(1)], vec![number(1), number(-1)])?; // 1/(1 - x)
/// let at = |x: i64, value: i64| Sample { x: number(x), value: number(value) };
/// assert!(relative_error(&line, &at(2, -2))?.contains(&Ball::from_ratio(1, 2, 64))); // -1 for -2
///
/// assert!(matches!(relative_error(&line, &at(1, 1)), Err(PadeError::Undecided { .. }))); // the pole
/// # Ok::<(), PadeError>(())
/// ```
pub fn relative_error(function: &RationalFunction<Balls>, sample: &Sample) -> Result<Ball, PadeError> {
    Ok((function.value(&sample.x)? / &sample.value - Ball::from_integer(1, sample.x.prec())).abs())
}

/// How often the neighbourhood of the largest error is looked at more closely, and how closely.
const REFINEMENTS: usize = 2;
const FINER: u32 = 6;

/// Returns the largest relative error of `P/Q` seen on a grid and, twice, six times finer around it.
///
/// ```text
/// max over the points of |P(x)/(Q(x) f(x)) - 1|
/// ```
///
/// `sample` gives the certified value for a point of the grid.
///
/// # Error bound
///
/// At each point the error is enclosed. Between the points nothing is proved.
///
/// # Errors
///
/// [`PadeError::EmptyRange`] without points, those of [`relative_error`] and of `sample`.
pub fn largest_error<E: From<PadeError>>(
    function: &RationalFunction<Balls>,
    points: &[BigRational],
    mut sample: impl FnMut(&BigRational) -> Result<Sample, E>,
) -> Result<WorstError, E> {
    let mut points = points.to_vec();
    let mut worst: Option<WorstError> = None;
    for _ in 0..=REFINEMENTS {
        for at in &points {
            let error = relative_error(function, &sample(at)?)?;
            if worst.as_ref().is_none_or(|w| error.upper() > w.error.upper()) {
                worst = Some(WorstError { at: at.clone(), error });
            }
        }
        points = worst.as_ref().map(|w| around(&points, &w.at)).unwrap_or_default();
    }
    let nothing = || PadeError::EmptyRange { low: "no point".to_owned(), high: "no point".to_owned() };
    worst.ok_or_else(|| nothing().into())
}

/// Points between the neighbours of `at` in an ascending grid.
fn around(points: &[BigRational], at: &BigRational) -> Vec<BigRational> {
    let index = points.partition_point(|p| p < at);
    let low = &points[index.saturating_sub(1)];
    let high = &points[(index + 1).min(points.len() - 1)];
    let share = |i: u32| low + (high - low) * BigRational::new(i.into(), (2 * FINER).into());
    (0..=2 * FINER).map(share).collect()
}

/// How finely the point where the error is reached is located, in halvings.
const HALVINGS: usize = 12;

/// Returns how far along an ascending grid the relative error stays at or below `level`.
///
/// The first point of the grid where it is or may be larger is approached by bisection.
///
/// # Errors
///
/// As [`largest_error`].
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_pade::{PadeError, RationalFunction, Reach, Sample, grid, largest_reach};
/// use restitution_real::{Ball, Balls};
///
/// let number = |n: i64| BigRational::from_integer(n.into());
/// let ball = |n: i64| Ball::from_integer(n, 64);
/// let line = RationalFunction::new(&Balls::new(64), vec![ball(1), ball(1)], vec![ball(1)])?; // 1 + x for the function 1
/// let sample = |x: &BigRational| Ok::<_, PadeError>(Sample { x: Ball::from_rational(x, 64), value: ball(1) });
/// let points = grid(&number(0), &number(1), 8)?;
/// let tenth = BigRational::new(1.into(), 10.into());
/// assert!(matches!(largest_reach(&line, &points, &tenth, sample)?, Reach::UpTo(x) if x <= tenth));
/// assert_eq!(largest_reach(&line, &points, &number(2), sample)?, Reach::Everywhere);
///
/// let fails = |_: &BigRational| Err(PadeError::PoleAtZero);
/// assert!(largest_reach(&line, &points, &tenth, fails).is_err());
/// # Ok::<(), PadeError>(())
/// ```
pub fn largest_reach<E: From<PadeError>>(
    function: &RationalFunction<Balls>,
    points: &[BigRational],
    level: &BigRational,
    mut sample: impl FnMut(&BigRational) -> Result<Sample, E>,
) -> Result<Reach, E> {
    let mut within = |at: &BigRational| -> Result<bool, E> {
        let error = relative_error(function, &sample(at)?)?;
        let room = Ball::from_rational(level, error.prec()) - &error;
        Ok(room.is_positive() || (room.lower().cmp0() == Some(Ordering::Equal)))
    };
    let mut good = BigRational::new(0.into(), 1.into());
    for point in points {
        if within(point)? {
            good.clone_from(point);
            continue;
        }
        let mut bad = point.clone();
        for _ in 0..HALVINGS {
            let middle = (&good + &bad) / BigRational::from_integer(2.into());
            if within(&middle)? { good = middle } else { bad = middle }
        }
        return Ok(Reach::UpTo(good));
    }
    Ok(Reach::Everywhere)
}

#[cfg(test)]
mod tests;
