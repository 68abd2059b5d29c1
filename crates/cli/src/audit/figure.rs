//! Fig. 1 of \[RPBS1999\]: ice.

use super::claim::{Claim, Finding, Slip, Verdict, number};
use super::dimensions::truth;
use super::facts::{Facts, fraction, one};
use super::number::{Known, SHOWN_DIGITS, digits, exact};
use super::quotient::as_printed;
use crate::CliError;
use num_rational::BigRational;
use restitution_pade::RationalFunction;
use restitution_real::Ball;

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
fn bridges(printed: &str) -> Result<(BigRational, BigRational), CliError> {
    let parts =
        printed.split_once("/g^").and_then(|(prefactor, exponent)| exact(prefactor).zip(exact(exponent)));
    parts.ok_or_else(|| CliError::failure(format!("'{printed}' is not a power of g")))
}

fn bridges_above_one(printed: &str) -> Result<Finding, CliError> {
    let (prefactor, exponent) = bridges(printed)?;
    let limit = fraction(&prefactor).pow(&exponent.recip());
    let holds = limit.is_positive() && (fraction(&exponent)).is_positive();
    Ok(truth(format!("above 1 for g < {} cm/s", digits(&limit, SHOWN_DIGITS)?), holds))
}

/// How far each curve is from Bridges' law, and which `g*` fits at 1 cm/s.
fn ice(printed: &str, facts: &Facts) -> Result<Finding, CliError> {
    let characteristic = fraction(&exact(printed).ok_or_else(|| CliError::failure("g* is a number"))?);
    let formula = as_printed()?;
    let (mut by_formula, mut by_theory) = (Vec::new(), Vec::new());
    for velocity in VELOCITIES {
        let g = fraction(&exact(velocity).ok_or_else(|| CliError::failure("velocities are numbers"))?);
        let law = fraction(&BigRational::new(8.into(), 25.into()))
            * g.pow(&BigRational::new((-117).into(), 500.into()));
        let s = (g / &characteristic).fifth_root();
        by_formula.push(value(&formula, &s)? / &law - one());
        by_theory.push(epsilon(facts, &s)? / law - one());
    }
    let fit = |curve: &dyn Fn(&Ball) -> Result<Ball, CliError>| fitted(curve);
    let (theory, table) = (fit(&|s| epsilon(facts, s))?, fit(&|s| value(&formula, s))?);
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

fn value(formula: &RationalFunction<BigRational>, s: &Ball) -> Result<Ball, CliError> {
    let enclose = |p: &[BigRational]| p.iter().map(fraction).collect();
    let formula =
        RationalFunction::new(enclose(formula.num()), enclose(formula.den())).map_err(CliError::failure)?;
    formula.value(s).map_err(CliError::failure)
}

/// The exact restitution at `s = -C_1 u`.
fn epsilon(facts: &Facts, s: &Ball) -> Result<Ball, CliError> {
    let u = -(s / &facts.c[1]);
    facts.collision.enclose(&u, 160).map_err(CliError::failure)
}

/// The `g*` (in cm/s) with which a falling curve takes Bridges' value 0.32 at `g = 1 cm/s`.
///
/// The secant method proposes `s = g*^(-1/5)`, certified values on both sides prove it to 25 digits.
fn fitted(curve: &dyn Fn(&Ball) -> Result<Ball, CliError>) -> Result<Ball, CliError> {
    let wanted = Ball::from_ratio(8, 25, 200);
    let excess = |s: &Ball| Ok::<_, CliError>(curve(s)? - &wanted);
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
        return Err(CliError::failure("the fit of g* could not be proved"));
    }
    Ok(low.union(&high).powi(-5))
}
