use crate::{ApproximateError, Constant, Expansion, Request, Variable, constants, judge};
use num_rational::BigRational;
use restitution_direct::End;
use restitution_law::ForceLaw;
use restitution_pade::{PadeType, RationalFunction, table_one, with_precision};
use restitution_real::{Ball, Balls, Rationals};

/// Table I of \[RPBS1999\]: 1 and d_1, then 1 and d_2 to d_5.
const TABLE_ONE: Printed = [&["1", "2.5839"], &["1", "3.5839", "2.9839", "1.1487", "0.3265"]];
/// a_3 and a_4 as printed in (A35) and (A36), in millionths.
const PRINTED_A3: i64 = 315_119;
const PRINTED_A4: i64 = 161_167;
/// \[MP2011\], in v* = sqrt(u).
const ONE_FOUR: Printed = [&["1", "0.501086"], &["1", "0.501086", "1.15345", "0.577977", "0.532178"]];
const THREE_SIX: Printed = [
    &["1", "1.07232", "0.574198", "0.141552"],
    &["1", "1.07232", "1.72765", "1.37842", "1.19449", "0.467273", "0.235585"],
];
const NOTHING: Printed = [&[], &[]];

/// Constants of numerator and denominator as they were printed.
type Printed = [&'static [&'static str]; 2];

/// An approximant of the literature, or what it should have been.
#[derive(Clone, Debug)]
pub struct Published {
    /// Where it was published.
    pub work: &'static str,
    /// Which approximant it is.
    pub what: &'static str,
    /// Its constants with proved digits.
    pub constants: Vec<Constant>,
    printed: Printed,
}

impl Published {
    /// The constant as it was printed, by part and power; `None` where nothing was.
    pub fn printed(&self, part: &str, power: usize) -> Option<&'static str> {
        self.printed[usize::from(part == "den")].get(power).copied()
    }
}

/// Returns every published approximant, as printed and regenerated to `digits` digits.
///
/// Table I of \[RPBS1999\] is there three times: from the coefficients the paper prints, from the right ones with `a_5 = 0`
/// as its formulas have it, and as the `[1/4]` approximant that it should be. Cost: milliseconds at 17 digits.
///
/// # Errors
///
/// Those of [`judge`].
///
/// # Examples
///
/// ```
/// use restitution_approximate::{ApproximateError, published};
///
/// let all = published(6)?;
/// let table_one = &all[0];
/// assert_eq!((table_one.work, table_one.printed("num", 1)), ("[RPBS1999] Table I", Some("2.5839")));
/// assert_eq!(table_one.constants[1].2, "2.58401");
/// assert_eq!(table_one.printed("num", 2), None); // the numerator is linear
/// # Ok::<(), ApproximateError>(())
/// ```
pub fn published(digits: usize) -> Result<Vec<Published>, ApproximateError> {
    let spheres = ForceLaw::viscoelastic_spheres();
    let in_s = Expansion::new(&spheres, End::ZeroCompression, Some(Variable::S))?;
    let in_root = Expansion::new(&spheres, End::ZeroForce, Some(Variable::SqrtU))?;
    let paper = |what, printed, constants| Published { work: "[RPBS1999] Table I", what, constants, printed };
    let codes = |what, printed, constants| Published { work: "[MP2011]", what, constants, printed };
    Ok(vec![
        paper("[1/4] in s, printed a_3, a_4, a_5 = 0", TABLE_ONE, as_printed(digits)?),
        paper("[1/4] in s, exact a_3, a_4, a_5 = 0", NOTHING, without_a5(&in_s, digits)?),
        paper("[1/4] in s", NOTHING, regenerated(&in_s, 1, 4, digits)?),
        codes("[1/4] in sqrt(u), zero force", ONE_FOUR, regenerated(&in_root, 1, 4, digits)?),
        codes("[3/6] in sqrt(u), zero force", THREE_SIX, regenerated(&in_root, 3, 6, digits)?),
    ])
}

/// Table I from the coefficients as printed: exact fractions, shown rounded.
fn as_printed(digits: usize) -> Result<Vec<Constant>, ApproximateError> {
    let millionths = |n: i64| BigRational::new(n.into(), 1_000_000.into());
    let three_fifths = BigRational::new(3.into(), 5.into());
    let closed = table_one(&Rationals, &three_fifths, &millionths(PRINTED_A3), &millionths(PRINTED_A4))?;
    let bits = first_bits(digits);
    let enclose = |p: &[BigRational]| p.iter().map(|c| Ball::from_rational(c, bits)).collect();
    let enclosed = RationalFunction::new(&Balls::new(bits), enclose(closed.num()), enclose(closed.den()))?;
    Ok(constants(&enclosed, digits)?)
}

/// Table I with the right a_3 and a_4, and a_5 = 0 as before.
fn without_a5(in_s: &Expansion, digits: usize) -> Result<Vec<Constant>, ApproximateError> {
    let first = first_bits(digits);
    with_precision(first, first.saturating_mul(8), |bits| {
        let series = in_s.coefficients(5, bits)?;
        let (a3, a4) = (-series[3].clone(), &series[4]);
        let three_fifths = Ball::from_ratio(3, 5, bits);
        Ok(table_one(&Balls::new(bits), &three_fifths, &a3, a4).and_then(|closed| constants(&closed, digits)))
    })
}

fn first_bits(digits: usize) -> u32 {
    u32::try_from(digits.saturating_mul(4)).unwrap_or(u32::MAX / 64).saturating_add(64)
}

fn regenerated(
    expansion: &Expansion,
    l: usize,
    m: usize,
    digits: usize,
) -> Result<Vec<Constant>, ApproximateError> {
    let number = |n: i64| BigRational::from_integer(n.into());
    let asked = PadeType::new(l, m);
    let range = (number(0), number(1));
    let request = Request { asked, at_infinity: 0, digits, range, level: number(1) };
    Ok(constants(judge(expansion, &request)?.approximant.function(), digits)?)
}
