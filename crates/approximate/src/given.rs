use crate::shown_places;
use num_rational::BigRational;
use restitution_pade::{Approximant, Interval, PadeError, PadeType, Verdict, approximant, verdict};
use restitution_real::Rationals;

/// An approximant of exact numbers, with its verdict.
#[derive(Debug)]
pub struct JudgedSeries {
    /// The approximant.
    pub approximant: Approximant<Rationals>,
    /// Its verdict on the half-line.
    pub verdict: Verdict,
    /// The places of its poles and of its zeros there, with proved digits.
    pub places: [Vec<String>; 2],
}

/// Returns the approximant of a series that is given as numbers, constant term first, and its verdict; all of it exact.
///
/// # Errors
///
/// Those of [`approximant`], such as [`PadeError::NotEnoughCoefficients`]; [`PadeError::Undecided`] for a place that ten digits do not tell.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_approximate::judge_series;
/// use restitution_pade::{PadeError, PadeType};
///
/// let logarithm = [(1, 1), (-1, 2), (1, 3)].map(|(n, d): (i64, i64)| BigRational::new(n.into(), d.into()));
/// let judged = judge_series(&logarithm, PadeType::new(1, 1), 6)?; // ln(1+x)/x
/// assert_eq!((judged.verdict.poles, judged.places[1].len()), (0, 0));
///
/// let short = judge_series(&logarithm[..2], PadeType::new(1, 1), 6);
/// assert!(matches!(short, Err(PadeError::NotEnoughCoefficients { .. })));
/// # Ok::<(), PadeError>(())
/// ```
pub fn judge_series(
    series: &[BigRational],
    asked: PadeType,
    digits: usize,
) -> Result<JudgedSeries, PadeError> {
    let approximant = approximant(&Rationals, series, asked)?;
    let verdict = verdict(&approximant, &Interval::HalfLine)?;
    let place = |p: &[BigRational]| shown_places(&Rationals, p, digits);
    let places = [place(approximant.den())?, place(approximant.num())?];
    Ok(JudgedSeries { approximant, verdict, places })
}
