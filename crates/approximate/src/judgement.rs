use crate::{ApproximateError, Expansion};
use num_rational::BigRational;
use restitution_pade::{
    Approximant, Interval, PadeError, PadeType, RationalFunction, Reach, Verdict, WorstError, approximant,
    grid, largest_error, largest_reach, places, two_point, verdict, with_precision,
};
use restitution_real::{Ball, Balls, OrderedField};

/// Intervals of the grid on which errors are looked for.
pub const GRID: u32 = 40;
/// Precision above which no further attempt is made, in multiples of the first.
const ATTEMPTS: u32 = 32;

/// What is asked about an approximant.
#[derive(Clone, Debug)]
pub struct Request {
    /// The degrees.
    pub asked: PadeType,
    /// How many conditions it meets at infinity.
    pub at_infinity: usize,
    /// Digits of its constants.
    pub digits: usize,
    /// The range of `u` on which its error is looked for.
    pub range: (BigRational, BigRational),
    /// The relative error whose reach is wanted.
    pub level: BigRational,
}

/// An approximant with its verdict.
#[derive(Debug)]
pub struct Judged {
    /// The approximant.
    pub approximant: Approximant<Balls>,
    /// Its verdict on the half-line.
    pub verdict: Verdict,
    /// The places of its poles and of its zeros there, with proved digits.
    pub places: [Vec<String>; 2],
}

/// The most digits of a place.
const PLACE_DIGITS: usize = 10;

/// The places of the zeros of a polynomial on the half-line, with proved digits.
///
/// # Errors
///
/// [`PadeError::Undecided`].
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_approximate::shown_places;
/// use restitution_pade::PadeError;
/// use restitution_real::Rationals;
///
/// let ints = |p: &[i64]| p.iter().map(|&c| BigRational::from_integer(c.into())).collect::<Vec<_>>();
/// assert_eq!(shown_places(&Rationals, &ints(&[-2, 0, 1]), 6)?, ["1.41421"]); // x^2 - 2 on [0, inf)
/// assert!(shown_places(&Rationals, &ints(&[2, 0, 1]), 6)?.is_empty());
/// # Ok::<(), PadeError>(())
/// ```
pub fn shown_places<F: OrderedField>(
    field: &F,
    p: &[F::Number],
    digits: usize,
) -> Result<Vec<String>, PadeError> {
    const GUARD: usize = 10;
    let digits = digits.min(PLACE_DIGITS);
    let bits = u32::try_from(4 * (digits + GUARD)).unwrap_or(u32::MAX);
    let text = |(low, high): (BigRational, BigRational)| {
        let ball = if low == high {
            Ball::from_rational(&low, bits)
        } else {
            let ends = [&low, &high].map(|end| Ball::from_rational(end, 2 * bits));
            Ball::between(&ends[0].lower(), &ends[1].upper(), 2 * bits)
        };
        let fewer = (1..digits).rev().find_map(|digits| ball.to_digits(digits));
        shown(&ball, digits).or(fewer).ok_or(PadeError::Undecided { what: "the place of a zero" })
    };
    places(field, p, digits + GUARD)?.into_iter().map(text).collect()
}

/// Bits to begin with: the digits wanted and what the elimination is likely to lose.
pub(crate) fn first_bits(asked: PadeType, digits: usize) -> u32 {
    let degree = asked.numerator.saturating_add(asked.denominator);
    u32::try_from(64 + digits.saturating_mul(10) / 3 + degree.saturating_mul(10)).unwrap_or(u32::MAX / 64)
}

/// Finds the approximant and its verdict, with all digits of its constants proved.
///
/// Whether the degrees suit the law at infinity is checked before any work. Cost: the coefficients, and an elimination for each
/// precision that is tried.
///
/// # Errors
///
/// [`PadeError::WrongDecay`] and [`PadeError::TooManyConditions`] for degrees that cannot meet what is asked at infinity,
/// [`PadeError::PrecisionExhausted`]; what the expansion says.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_approximate::{ApproximateError, Expansion, Request, constants, judge};
/// use restitution_direct::End;
/// use restitution_law::ForceLaw;
/// use restitution_pade::{PadeError, PadeType};
///
/// let number = |n: i64| BigRational::from_integer(n.into());
/// let spheres = Expansion::new(&ForceLaw::viscoelastic_spheres(), End::ZeroCompression, None)?;
/// let range = (number(0), number(1));
/// let asked = Request { asked: PadeType::new(1, 6), at_infinity: 1, digits: 8, range, level: number(1) };
/// let found = judge(&spheres, &asked)?;
/// assert_eq!((found.verdict.poles, found.approximant.met_at_infinity()), (0, 1));
///
/// let falls_too_slowly = Request { asked: PadeType::new(3, 6), ..asked };
/// let refused = judge(&spheres, &falls_too_slowly);
/// assert!(matches!(refused, Err(ApproximateError::Pade(PadeError::WrongDecay { decay: 5, .. }))));
/// # Ok::<(), ApproximateError>(())
/// ```
pub fn judge(expansion: &Expansion, request: &Request) -> Result<Judged, ApproximateError> {
    if request.at_infinity > 0 {
        fits_infinity(expansion, request)?;
    }
    let count = request.asked.conditions() - request.at_infinity.min(request.asked.conditions() - 1) + 2;
    let first = first_bits(request.asked, request.digits);
    with_precision(first, first.saturating_mul(ATTEMPTS), |bits| {
        let series = expansion.coefficients(count, bits)?;
        let found = if request.at_infinity > 0 {
            let infinity = expansion.at_infinity(request.at_infinity, bits)?;
            two_point(&Balls::new(bits), &series, request.asked, &infinity)
        } else {
            nearest(expansion, &series, request.asked, bits)?
        };
        Ok(found.and_then(|approximant| {
            constants(approximant.function(), request.digits)?;
            let verdict = verdict(&approximant, &Interval::HalfLine)?;
            let function = approximant.function();
            let place = |p: &[Ball]| shown_places(function.field(), p, request.digits);
            let places = [place(function.den())?, place(function.num())?];
            Ok(Judged { approximant, verdict, places })
        }))
    })
}

fn fits_infinity(expansion: &Expansion, request: &Request) -> Result<(), ApproximateError> {
    let (asked, decay) = (request.asked, expansion.decay()?);
    if asked.numerator + decay != asked.denominator {
        return Err(PadeError::WrongDecay { asked, decay }.into());
    }
    let (conditions, limit) = (request.at_infinity, asked.denominator);
    if conditions > limit {
        return Err(PadeError::TooManyConditions { asked, conditions, limit }.into());
    }
    Ok(())
}

/// The approximant with contact at 0 alone, by the reciprocal series where that knows more.
///
/// # Errors
///
/// Those of [`Expansion::reciprocal`]; the inner ones are those of [`approximant`].
pub(crate) fn nearest(
    expansion: &Expansion,
    series: &[Ball],
    asked: PadeType,
    bits: u32,
) -> Result<Result<Approximant<Balls>, PadeError>, ApproximateError> {
    let field = Balls::new(bits);
    let turned = PadeType::new(asked.denominator, asked.numerator);
    Ok(match expansion.reciprocal(series, bits)? {
        Some(reciprocal) => approximant(&field, &reciprocal, turned).and_then(|found| found.reciprocal()),
        None => approximant(&field, series, asked),
    })
}

/// A constant in decimals: part, index, digits.
pub type Constant = (&'static str, usize, String);

/// The constants of an approximant.
///
/// # Errors
///
/// [`PadeError::Undecided`] if a ball does not prove the digits.
///
/// # Examples
///
/// ```
/// use restitution_approximate::constants;
/// use restitution_pade::{PadeError, RationalFunction};
/// use restitution_real::{Ball, Balls};
///
/// let field = Balls::new(64);
/// let function = RationalFunction::new(&field, vec![Ball::from_integer(1, 64)], vec![Ball::from_ratio(3, 1, 64), Ball::from_ratio(1, 1, 64)])?;
/// assert_eq!(constants(&function, 5)?[0], ("num", 0, "0.33333".to_owned()));
///
/// assert!(matches!(constants(&function, 50), Err(PadeError::Undecided { .. })));
/// # Ok::<(), PadeError>(())
/// ```
pub fn constants(function: &RationalFunction<Balls>, digits: usize) -> Result<Vec<Constant>, PadeError> {
    let parts = [("num", function.num()), ("den", function.den())];
    let all = parts.into_iter().flat_map(|(part, p)| p.iter().enumerate().map(move |(k, c)| (part, k, c)));
    let undecided = PadeError::Undecided { what: "the last digit of a constant" };
    all.map(|(part, k, c)| Ok((part, k, shown(c, digits).ok_or(undecided.clone())?))).collect()
}

/// The links `c x^power` of the continued fraction of an approximant, its constant first, in decimals.
///
/// # Errors
///
/// [`PadeError::Undecided`] if a ball does not prove the digits, or whether it is zero.
///
/// # Examples
///
/// ```
/// use restitution_approximate::links;
/// use restitution_pade::{PadeError, PadeType, approximant};
/// use restitution_real::{Ball, Balls};
///
/// let exp = [1, 1, 2, 6].map(|n| Ball::from_ratio(1, n, 100));
/// let found = approximant(&Balls::new(100), &exp, PadeType::new(1, 2))?;
/// let text = |power, digits: &str| (power, digits.to_owned());
/// assert_eq!(links(&found, 4)?[2..4], [text(1, "-0.5000"), text(1, "0.1667")]);
///
/// assert!(matches!(links(&found, 100), Err(PadeError::Undecided { .. })));
/// # Ok::<(), PadeError>(())
/// ```
pub fn links(approximant: &Approximant<Balls>, digits: usize) -> Result<Vec<(usize, String)>, PadeError> {
    let fraction = approximant.continued_fraction()?;
    let links = fraction.links.iter().map(|link| (link.power, &link.coefficient));
    let undecided = PadeError::Undecided { what: "the last digit of a link" };
    let text = |(power, value): (usize, &Ball)| Ok((power, shown(value, digits).ok_or(undecided.clone())?));
    std::iter::once((0, &fraction.constant)).chain(links).map(text).collect()
}

/// The value in decimals, `None` if its digits are not proved; an exact integer has no tail of zeros.
fn shown(value: &Ball, digits: usize) -> Option<String> {
    match value.mid().to_integer() {
        Some(n) if value.is_exact() && value.mid().is_integer() => Some(n.to_string()),
        _ => value.to_digits(digits),
    }
}

/// The largest relative error on a range of dampings.
///
/// # Errors
///
/// Those of [`Expansion::sample`], and of a range that is none.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_approximate::{ApproximateError, Expansion, Request, error_on_range, judge};
/// use restitution_direct::End;
/// use restitution_law::ForceLaw;
/// use restitution_pade::PadeType;
///
/// let number = |n: i64| BigRational::from_integer(n.into());
/// let dashpot = Expansion::new(&"1,0".parse::<ForceLaw>().expect("a law"), End::ZeroCompression, None)?;
/// let range = (number(0), number(1));
/// let request = Request { asked: PadeType::new(1, 2), at_infinity: 0, digits: 6, range, level: number(1) };
/// let found = judge(&dashpot, &request)?.approximant;
/// let worst = error_on_range(&dashpot, &found, &request.range)?;
/// assert!(worst.at == number(1) && worst.error.upper() < 0.06);
///
/// let backwards = error_on_range(&dashpot, &found, &(number(1), number(0)));
/// assert!(matches!(backwards, Err(ApproximateError::Pade(_))));
/// # Ok::<(), ApproximateError>(())
/// ```
pub fn error_on_range(
    expansion: &Expansion,
    approximant: &Approximant<Balls>,
    range: &(BigRational, BigRational),
) -> Result<WorstError, ApproximateError> {
    let points = grid(&range.0, &range.1, GRID)?;
    largest_error(approximant.function(), &points, |u| expansion.sample(u))
}

/// How far the error stays at or below the level.
///
/// # Errors
///
/// Those of [`Expansion::sample`].
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_approximate::{ApproximateError, Expansion, Request, error_reach, judge};
/// use restitution_direct::End;
/// use restitution_law::ForceLaw;
/// use restitution_pade::PadeType;
///
/// let number = |n: i64| BigRational::from_integer(n.into());
/// let dashpot = Expansion::new(&"1,0".parse::<ForceLaw>().expect("a law"), End::ZeroCompression, None)?;
/// let range = (number(0), number(1));
/// let request = Request { asked: PadeType::new(1, 2), at_infinity: 0, digits: 6, range, level: number(1) };
/// let found = judge(&dashpot, &request)?.approximant;
/// let thousandth = BigRational::new(1.into(), 1000.into());
/// let reach = error_reach(&dashpot, &found, &thousandth, &number(1))?;
/// assert!(matches!(reach, restitution_pade::Reach::UpTo(u) if u > thousandth && u < number(1)));
///
/// assert!(error_reach(&dashpot, &found, &thousandth, &number(-1)).is_err());
/// # Ok::<(), ApproximateError>(())
/// ```
pub fn error_reach(
    expansion: &Expansion,
    approximant: &Approximant<Balls>,
    level: &BigRational,
    farthest: &BigRational,
) -> Result<Reach, ApproximateError> {
    let points = grid(&BigRational::from_integer(0.into()), farthest, 2 * GRID)?;
    largest_reach(approximant.function(), &points, level, |u| expansion.sample(u))
}
