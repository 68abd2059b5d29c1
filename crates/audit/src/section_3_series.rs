//! Section III of \[RPBS1999\] from (32) on: divergence, the Padé formula (35) and its Table I.

use crate::AuditError;
use crate::claim::{Claim, Finding, Slip, Verdict, identity, number};
use crate::formula::Scope;
use crate::printed_number::{Known, SHOWN_DIGITS, digits, exact};
use crate::samples::Samples;
use crate::sections_1_and_2::statement;
use crate::true_values::{TrueValues, ball, one};
use num_rational::BigRational;
use num_traits::{One, Zero};
use restitution_direct::saturation_radius;
use restitution_pade::{
    Bounds, Interval, PadeType, RationalFunction, Trend, approximant, table_one, verdict, zeros,
};
use restitution_real::{Ball, OrderedField, Rationals};
use restitution_series::{Quantity, coefficients};

/// Table I with `d_1` of the numerator first, as printed.
pub const TABLE: [&str; 5] = ["2.5839", "3.5839", "2.9839", "1.1487", "0.3265"];

/// The claims.
pub fn claims() -> Vec<Claim> {
    let mut claims = vec![
        Claim::new(
            "32.divergence",
            "the series diverges for high velocities",
            "divergence for g to infinity",
            "restitution epsilon --saturation",
            |_, truth| divergence(truth),
        ),
        Claim::new(
            "TableI",
            "the closed formulas of Table I",
            "d0 = a4 - 2 a3 - a2^2 + 3 a2 - 1; \
             d1 d0 = 1 - a2 + a3 - 2 a4 + (a2 - 1) (3 a2 - 2 a3); \
             d2 d0 = (a3 - a2) (1 - 2 a2) - a4; \
             d3 d0 = a3 + a2^2 (a2 - 1) - a4 (a2 + 1); \
             d4 d0 = a4 (a3 - 1) + (a3 - a2) (a2^2 - 2 a3); \
             d5 d0 = 2 (a3 - a2) (a4 - a2 a3) - (a4 - a2^2)^2 - a3 (a3 - a2^2)",
            "restitution audit TableI",
            |printed, _| identity(printed, "random coefficients with a_5 = 0, exactly", general_algorithm),
        ),
        Claim::new(
            "35.standard",
            "(35) is the [1/4] approximant in terms of the a_k",
            "d_1 .. d_5 from a_2, a_3, a_4",
            "restitution pade 1 4 --variable s --digits 20",
            |_, truth| unknown_fifth(truth),
        ),
        Claim::new(
            "35.zero",
            "eps(0) = 1, of (35) and of the collision",
            "1",
            "restitution epsilon --u 0",
            |printed, truth| {
                let exact = truth
                    .collision
                    .epsilon(&BigRational::zero(), SHOWN_DIGITS)
                    .map_err(AuditError::failure)?;
                let formula = as_printed()?.value(&BigRational::zero()).map_err(AuditError::failure)?;
                let found = number(printed, &Known::Exactly(formula), None)?;
                Ok(if exact.contains(&one()) {
                    found
                } else {
                    Finding { verdict: Verdict::Wrong(None), ..found }
                })
            },
        ),
        Claim::new(
            "35.infinity",
            "eps(infinity) = 0, of (35) and of the collision",
            "0",
            "restitution epsilon --u 10,100,1000 --digits 6",
            at_infinity,
        ),
        Claim::new(
            "35.monotone",
            "(35) is smooth and falls monotonically, as eps is expected to",
            "smooth, monotonically decreasing",
            "restitution audit 35.monotone",
            |_, _| smooth(),
        ),
    ];
    claims.extend(constants());
    claims
}

fn constants() -> Vec<Claim> {
    const COMMAND: &str = "restitution pade --list literature --digits 20";
    let claim = |id, statement, k: usize, check| Claim::new(id, statement, TABLE[k - 1], COMMAND, check);
    vec![
        claim("TableI.d1", "d_1", 1, |printed, truth| constant(printed, truth, 1)),
        claim("TableI.d2", "d_2", 2, |printed, truth| constant(printed, truth, 2)),
        claim("TableI.d3", "d_3", 3, |printed, truth| constant(printed, truth, 3)),
        claim("TableI.d4", "d_4", 4, |printed, truth| constant(printed, truth, 4)),
        claim("TableI.d5", "d_5", 5, |printed, truth| constant(printed, truth, 5)),
    ]
}

/// `d_k` of Table I's own formulas, beside the genuine approximant's.
fn constant(printed: &str, truth: &TrueValues, k: usize) -> Result<Finding, AuditError> {
    let (right, genuine) = (truth.table_with_right_coefficients()?, truth.genuine()?);
    let slip = Slip {
        mistake: "feeding the table's formulas with the a_3 and a_4 of the halved corrections",
        gives: Known::Within(entry(&truth.halved.table, k).clone()),
    };
    let found = number(printed, &Known::Within(entry(&right, k).clone()), Some(slip))?;
    let genuine = digits(entry(&genuine, k), SHOWN_DIGITS)?;
    Ok(found.noting(format!(
        "computed by the table's formulas, that is with a_5 = 0; with the right a_5 it is {genuine}"
    )))
}

/// `d_1` is in the numerator, the others in the denominator.
fn entry<F: OrderedField>(function: &RationalFunction<F>, k: usize) -> &F::Number {
    if k == 1 { &function.num()[1] } else { &function.den()[k - 1] }
}

/// Formula (35) with the printed Table I, exactly.
pub fn as_printed() -> Result<RationalFunction<Rationals>, AuditError> {
    let read =
        |text: &&str| exact(text).ok_or_else(|| AuditError::failure(format!("'{text}' is not a number")));
    let d = TABLE.iter().map(read).collect::<Result<Vec<_>, _>>()?;
    let den = std::iter::once(BigRational::one()).chain(d[1..].iter().cloned()).collect();
    RationalFunction::new(&Rationals, vec![BigRational::one(), d[0].clone()], den)
        .map_err(AuditError::failure)
}

fn series(a: &[BigRational; 3], a5: BigRational) -> Vec<BigRational> {
    let one = BigRational::one;
    vec![one(), -one(), a[0].clone(), -&a[1], a[2].clone(), -a5]
}

/// The general algorithm's approximant of `1 - s + a_2 s^2 - a_3 s^3 + a_4 s^4 + 0 s^5`.
fn general_algorithm(samples: &mut Samples) -> Result<Scope<Rationals>, AuditError> {
    let a = [samples.fraction(), samples.fraction(), samples.fraction()];
    let found = approximant(&Rationals, &series(&a, BigRational::zero()), PadeType::new(1, 4))
        .map_err(AuditError::failure)?;
    let [a2, a3, a4] = &a;
    let two = BigRational::from_integer(2.into());
    let d0 = a4 - &two * a3 - a2 * a2 + (&two + BigRational::one()) * a2 - BigRational::one();
    let d = (1..6).map(|k| entry(found.function(), k).clone());
    let scope = Scope::new(Rationals).with_all(&["d1", "d2", "d3", "d4", "d5"], d);
    Ok(scope.with("d0", d0).with_all(&["a2", "a3", "a4"], a))
}

/// Five unknowns, four coefficients: the closed formulas meet the fifth condition only for `a_5 = 0`.
fn unknown_fifth(truth: &TrueValues) -> Result<Finding, AuditError> {
    const POINTS: usize = 20;
    let mut samples = Samples::new();
    let (mut four, mut five) = (0, 0);
    for _ in 0..POINTS {
        let a = [samples.fraction(), samples.fraction(), samples.fraction()];
        let closed = table_one(&Rationals, &a[0], &a[1], &a[2]).map_err(AuditError::failure)?;
        let wanted = series(&a, samples.fraction());
        let met = closed.series(6);
        four += usize::from(met[..5] == wanted[..5]);
        five += usize::from(met == wanted);
    }
    let genuine = truth.genuine()?;
    let zero = -(one() / entry(&genuine, 1));
    let zeros = zeros(genuine.field(), genuine.num(), &Interval::HalfLine).map_err(AuditError::failure)?;
    let found = statement(
        format!("4 coefficients met at {four} of {POINTS} random points, the fifth at {five}"),
        four == POINTS,
    );
    let found = if five == POINTS { found } else { found.imprecise() };
    let genuine = (1..6).map(|k| digits(entry(&genuine, k), SHOWN_DIGITS)).collect::<Result<Vec<_>, _>>()?;
    Ok(found
        .noting("five unknowns come from four coefficients: the formulas set a_5 = 0 without saying so")
        .noting(format!(
            "the genuine [1/4] approximant has d_1 .. d_5 = {}; its numerator has {} positive zero, at s = {}, beyond \
             which it is negative",
            genuine.join(", "),
            zeros.unwrap_or(0),
            digits(&zero, 10)?
        )))
}

/// The limit of (35) by its degrees, that of the collision by values below `6/u^5`.
fn at_infinity(printed: &str, truth: &TrueValues) -> Result<Finding, AuditError> {
    let formula = as_printed()?;
    let falls = formula.num().len() < formula.den().len();
    let mut shown = Vec::new();
    let mut below = true;
    for u in [10, 100, 1000] {
        let epsilon =
            truth.collision.epsilon(&BigRational::from_integer(u.into()), 10).map_err(AuditError::failure)?;
        below &= epsilon.is_positive() && (ball(6) / ball(u).powi(5) - &epsilon).is_positive();
        shown.push(format!("{} at u = {u}", digits(&epsilon, 6)?));
    }
    let limit = if falls && below { BigRational::zero() } else { BigRational::one() };
    Ok(number(printed, &Known::Exactly(limit), None)?
        .noting(format!("eps is {}", shown.join(", ")))
        .noting("(35) falls off like s^-3, the exact eps like u^-5"))
}

/// Poles, zeros and slope of (35) with the printed constants, counted exactly.
fn smooth() -> Result<Finding, AuditError> {
    let printed = as_printed()?;
    let series = printed.series(6);
    let found = approximant(&Rationals, &series, PadeType::new(1, 4)).map_err(AuditError::failure)?;
    let found = verdict(&found, &Interval::HalfLine).map_err(AuditError::failure)?;
    let holds = found.poles == 0 && found.trend == Trend::Decreasing && found.bounds == Bounds::Within;
    Ok(statement(format!("{} poles on s >= 0, {}, {}", found.poles, found.trend, found.bounds), holds))
}

/// Orders at which partial sums are compared.
const ORDERS: [usize; 3] = [20, 40, 60];

/// Partial sums of (32) at a velocity inside and at one outside the disc of convergence.
fn divergence(truth: &TrueValues) -> Result<Finding, AuditError> {
    let law = truth.collision.law();
    let c = coefficients(Quantity::Restitution, law, ORDERS[2], 40)?;
    let inside = errors(truth, &c, 1)?;
    let outside = errors(truth, &c, 2)?;
    let rises = |errors: &[Ball]| errors.windows(2).all(|pair| (&pair[1] - &pair[0]).is_positive());
    let falls = |errors: &[Ball]| errors.windows(2).all(|pair| (&pair[0] - &pair[1]).is_positive());
    let radius = saturation_radius(law, SHOWN_DIGITS + 5).map_err(AuditError::failure)?;
    let s = -(&radius * &truth.c[1]);
    let verdict = match (falls(&inside), rises(&outside)) {
        (true, true) => Verdict::Imprecise,
        (false, true) => Verdict::Holds,
        _ => Verdict::Wrong(None),
    };
    let list = |errors: &[Ball]| {
        errors
            .iter()
            .map(|error| digits(error, 2))
            .collect::<Result<Vec<_>, _>>()
            .map(|errors| errors.join(", "))
    };
    Ok(Finding::new(format!("converges for u < R = {}", digits(&radius, SHOWN_DIGITS)?), verdict)
        .noting(format!(
            "R is s = {}, that is g = {} g*: below it the series converges, above it diverges",
            digits(&s, 10)?,
            digits(&s.powi(5), 10)?
        ))
        .noting(format!(
            "errors of the sums to orders 20, 40, 60: {} at u = 1; {} at u = 2",
            list(&inside)?,
            list(&outside)?
        )))
}

/// `|sum_(k <= order) C_k u^k - eps(u)|`.
fn errors(truth: &TrueValues, c: &[Ball], u: i64) -> Result<Vec<Ball>, AuditError> {
    let exact =
        truth.collision.epsilon(&BigRational::from_integer(u.into()), 30).map_err(AuditError::failure)?;
    let sum = |order: usize| c[..=order].iter().rev().fold(ball(0), |sum, c| sum * ball(u) + c);
    Ok(ORDERS.iter().map(|&order| (sum(order) - &exact).abs()).collect())
}
