use crate::{ApproximateError, Expansion, Request, ValidRange, error_on_range, first_bits, nearest};
use restitution_pade::{
    Approximant, Interval, PadeError, PadeType, Verdict, WorstError, verdict, with_precision,
};
use restitution_real::{Ball, Balls};
use std::collections::HashMap;

/// How often the precision may double for one entry.
const ATTEMPTS: u32 = 8;
/// Digits to begin with.
const DIGITS: usize = 20;

/// One place of the Padé table.
#[derive(Debug)]
pub struct Entry {
    /// The type asked for.
    pub asked: PadeType,
    /// What is there; `None` if the precision was raised eightfold and left something open.
    pub found: Option<Found>,
}

/// An approximant of the table.
#[derive(Debug)]
pub struct Found {
    /// The approximant.
    pub approximant: Approximant<Balls>,
    /// Its verdict on the half-line.
    pub verdict: Verdict,
    /// The largest relative error seen on the range; `None` if a pole lies on the half-line or too near a point of the grid.
    pub worst: Option<WorstError>,
}

/// Finds every approximant up to the type of the request, with its verdict and its largest error on the range.
///
/// The entries come row by row of the numerator. Only `asked` and `range` of the request count. `after_each` is called for every entry
/// that is done with. Cost: `(L+1)(M+1)` approximants and judgements, seconds for `[8/8]`.
///
/// # Errors
///
/// Those of [`ValidRange::new`] and [`Expansion::coefficients`].
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_approximate::{ApproximateError, Expansion, Request, map};
/// use restitution_direct::End;
/// use restitution_law::ForceLaw;
/// use restitution_pade::PadeType;
///
/// let number = |n: i64| BigRational::from_integer(n.into());
/// let dashpot = Expansion::new(&"1,0".parse::<ForceLaw>().expect("a law"), End::ZeroCompression, None)?;
/// let range = (number(0), number(1));
/// let request = Request { asked: PadeType::new(1, 1), at_infinity: 0, digits: 6, range, level: number(1) };
/// let entries = map(&dashpot, &request, || {})?;
/// assert_eq!(entries.len(), 4);
/// assert!(entries[3].found.as_ref().is_some_and(|found| found.verdict.poles == 0));
///
/// let nowhere = Request { range: (number(3), number(4)), ..request };
/// assert!(matches!(map(&dashpot, &nowhere, || {}), Err(ApproximateError::BeyondCriticalDamping { .. })));
/// # Ok::<(), ApproximateError>(())
/// ```
pub fn map(
    expansion: &Expansion,
    request: &Request,
    mut after_each: impl FnMut(),
) -> Result<Vec<Entry>, ApproximateError> {
    let range = ValidRange::new(expansion, &request.range)?.range;
    let mut known = Known { expansion, corner: request.asked, series: HashMap::new() };
    let mut entries = Vec::new();
    for numerator in 0..=request.asked.numerator {
        for denominator in 0..=request.asked.denominator {
            let asked = PadeType::new(numerator, denominator);
            let found = known.entry(asked)?.map(|(approximant, verdict)| {
                let worst = error_on_range(expansion, &approximant, &range).ok();
                Found { worst: worst.filter(|_| verdict.poles == 0), approximant, verdict }
            });
            entries.push(Entry { asked, found });
            after_each();
        }
    }
    Ok(entries)
}

/// The series at every precision that was needed.
struct Known<'a> {
    expansion: &'a Expansion,
    corner: PadeType,
    series: HashMap<u32, Vec<Ball>>,
}

impl Known<'_> {
    /// The approximant of a type, `None` if it remains undecided.
    fn entry(&mut self, asked: PadeType) -> Result<Option<(Approximant<Balls>, Verdict)>, ApproximateError> {
        let first = first_bits(self.corner, DIGITS);
        let found = with_precision(first, first * ATTEMPTS, |bits| {
            let known = match self.series.get(&bits) {
                Some(known) => known,
                None => {
                    let known = self.expansion.coefficients(self.corner.conditions() + 1, bits)?;
                    self.series.entry(bits).or_insert(known)
                }
            };
            let found = nearest(self.expansion, known, asked, bits)?;
            Ok(found.and_then(|entry| verdict(&entry, &Interval::HalfLine).map(|verdict| (entry, verdict))))
        });
        match found {
            Err(ApproximateError::Pade(PadeError::PrecisionExhausted { .. })) => Ok(None),
            found => found.map(Some),
        }
    }
}
