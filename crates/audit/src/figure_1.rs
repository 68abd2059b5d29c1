//! Fig. 1 of \[RPBS1999\]: ice.

use crate::AuditError;
use crate::claim::{Claim, Finding, Slip, Verdict, number};
use crate::printed_number::{Known, SHOWN_DIGITS, digits, exact};
use crate::section_3_series::as_printed;
use crate::sections_1_and_2::statement;
use crate::true_values::{FIELD, TrueValues, fraction, one};
use num_rational::BigRational;
use restitution_pade::RationalFunction;
use restitution_real::{Ball, Rationals};

/// Where the curves are compared: impact velocities in cm/s.
const VELOCITIES: [&str; 5] = ["0.3", "1", "2", "5", "10"];

/// The claims.
pub fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "Fig1.solid",
            "the experimental law 0.32 g^-0.234 (g in cm/s) diverges for g to 0 and exceeds 1",
            "0.32/g^0.234",
            "restitution audit Fig1.solid",
            |printed, _| bridges_above_one(printed),
        ),
        Claim::new(
            "Fig1.dashed",
            "(35) with g* = 0.32 cm/s follows that law up to high velocities",
            "0.32",
            "restitution epsilon --velocity 1cm/s --g-star 0.42157667165199632210cm/s",
            ice,
        ),
    ]
}

/// Bridges' law, `prefactor g^-exponent`, with the numbers as printed.
fn bridges(printed: &str) -> Result<(BigRational, BigRational), AuditError> {
    let parts =
        printed.split_once("/g^").and_then(|(prefactor, exponent)| exact(prefactor).zip(exact(exponent)));
    parts.ok_or_else(|| AuditError::failure(format!("'{printed}' is not a power of g")))
}

fn bridges_above_one(printed: &str) -> Result<Finding, AuditError> {
    let (prefactor, exponent) = bridges(printed)?;
    let limit = fraction(&prefactor).pow(&exponent.recip());
    let holds = limit.is_positive() && (fraction(&exponent)).is_positive();
    Ok(statement(format!("above 1 for g < {} cm/s", digits(&limit, SHOWN_DIGITS)?), holds))
}

/// How far each curve is from Bridges' law, and which `g*` fits at 1 cm/s.
fn ice(printed: &str, truth: &TrueValues) -> Result<Finding, AuditError> {
    let characteristic = fraction(&exact(printed).ok_or_else(|| AuditError::failure("g* is a number"))?);
    let formula = as_printed()?;
    let (mut by_formula, mut by_theory) = (Vec::new(), Vec::new());
    for velocity in VELOCITIES {
        let g = fraction(&exact(velocity).ok_or_else(|| AuditError::failure("velocities are numbers"))?);
        let law = fraction(&BigRational::new(8.into(), 25.into()))
            * g.pow(&BigRational::new((-117).into(), 500.into()));
        let s = (g / &characteristic).fifth_root();
        by_formula.push(value(&formula, &s)? / &law - one());
        by_theory.push(epsilon(truth, &s)? / law - one());
    }
    let fit = |curve: &dyn Fn(&Ball) -> Result<Ball, AuditError>| fitted(curve);
    let (theory, table) = (fit(&|s| epsilon(truth, s))?, fit(&|s| value(&formula, s))?);
    let slip = Slip { mistake: "fitting (35) with the printed Table I", gives: Known::Within(table.clone()) };
    let found = number(printed, &Known::Within(theory.clone()), Some(slip))?;
    // A fitted constant is no error of the fit: it belongs to the formula that was fitted.
    let verdict = match found.verdict {
        Verdict::Wrong(Some(_)) => Verdict::Imprecise,
        verdict => verdict,
    };
    let list = |deviations: &[Ball]| {
        let percent = |x: &Ball| format!("{:+.1} %", 100.0 * x.to_f64());
        deviations.iter().map(percent).collect::<Vec<_>>().join(", ")
    };
    Ok(Finding { verdict, ..found }
        .noting(format!(
            "computed: the g* with which the exact eps meets the law at 1 cm/s; (35) with the printed table meets it \
             there with g* = {} cm/s",
            digits(&table, 10)?
        ))
        .noting(format!("g* = {printed} cm/s, deviations from the law at g = {} cm/s:", VELOCITIES.join(", ")))
        .noting(format!("(35) as printed {}; exact eps {}", list(&by_formula), list(&by_theory)))
        .noting("the agreement of the figure is that of the wrong Table I: refit g*"))
}

fn value(formula: &RationalFunction<Rationals>, s: &Ball) -> Result<Ball, AuditError> {
    let enclose = |p: &[BigRational]| p.iter().map(fraction).collect();
    let formula = RationalFunction::new(&FIELD, enclose(formula.num()), enclose(formula.den()))
        .map_err(AuditError::failure)?;
    formula.value(s).map_err(AuditError::failure)
}

/// The exact restitution at `s = -C_1 u`.
fn epsilon(truth: &TrueValues, s: &Ball) -> Result<Ball, AuditError> {
    let u = -(s / &truth.c[1]);
    truth.collision.enclose(&u, 160).map_err(AuditError::failure)
}

/// The `g*` (in cm/s) with which a falling curve takes Bridges' value 0.32 at `g = 1 cm/s`.
///
/// The secant method proposes `s = g*^(-1/5)`, certified values on both sides prove it to 25 digits.
fn fitted(curve: &dyn Fn(&Ball) -> Result<Ball, AuditError>) -> Result<Ball, AuditError> {
    let wanted = Ball::from_ratio(8, 25, 200);
    let excess = |s: &Ball| Ok::<_, AuditError>(curve(s)? - &wanted);
    let point = |ball: Ball| Ball::exact(ball.mid().clone());
    let (mut last, mut s) = (Ball::from_ratio(6, 5, 200), Ball::from_ratio(5, 4, 200));
    let mut last_excess = excess(&last)?;
    let close = Ball::from_integer(10, 200).powi(-27);
    for _ in 0..12 {
        let here = excess(&s)?;
        let next = point(&s - &here * (&s - &last) / (&here - &last_excess));
        (last, last_excess, s) = (s, here, next);
        if (&close - (&s - &last).abs()).is_positive() {
            break;
        }
    }
    let (low, high) = (point(&s - &close), point(&s + &close));
    if !excess(&low)?.is_positive() || !excess(&high)?.is_negative() {
        return Err(AuditError::failure("the fit of g* could not be proved"));
    }
    Ok(low.union(&high).powi(-5))
}
