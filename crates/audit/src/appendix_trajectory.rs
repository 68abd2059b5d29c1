//! The appendix of \[RPBS1999\], (A6) to (A14): the trajectory.

use crate::AuditError;
use crate::claim::{Claim, Finding, Slip, Verdict, identity, number};
use crate::formula::Scope;
use crate::free_series::{collected_orders, residual};
use crate::printed_number::Known;
use crate::samples::Samples;
use crate::true_values::TrueValues;
use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{One, Zero};
use restitution_real::Rationals;

const COMMAND: &str = "restitution trajectory --damping-order 3 --time-order 11";

/// The claims.
pub fn claims() -> Vec<Claim> {
    let mut claims = vec![
        Claim::new(
            "A6",
            "the orders of t in (A1)",
            "o1 = 15/4 b5 + alpha g^(1/5); o2 = 6 b6; o3 = 35/4 b7 + 1; o4 = 12 b8 + 3 alpha g^(1/5) b5; \
             o5 = 63/4 b9 + 7/2 alpha g^(1/5) b6",
            "restitution audit A6",
            |printed, _| in_either_unit(printed, orders),
        ),
        coefficient("A7", "b_5", "b5 = -4/15 alpha g^(1/5)"),
        coefficient("A8", "b_6", "b6 = 0"),
        coefficient("A9", "b_7", "b7 = -4/35"),
        coefficient("A10", "b_8", "b8 = 1/15 alpha^2 g^(2/5)"),
        coefficient("A11", "b_9", "b9 = 0"),
        Claim::new(
            "A12",
            "the trajectory up to t^4",
            "x = g^(4/5) t - 4/15 alpha g t^(5/2) - 4/35 g^(4/5) t^(7/2) + 1/15 alpha^2 g^(6/5) t^4",
            "restitution audit A12",
            |printed, _| identity(printed, "random rational points, exactly", trajectory),
        ),
    ];
    claims.extend(table());
    claims
}

/// (A14), one claim for each coefficient.
fn table() -> Vec<Claim> {
    let claim = |id, statement, printed, check| Claim::new(id, statement, printed, COMMAND, check);
    vec![
        claim("A14.x0.t1", "coefficient of t in x_0", "1", |p, f| entry(p, f, 0, 0)),
        claim("A14.x0.t7/2", "coefficient of t^(7/2) in x_0", "-4/35", |p, f| entry(p, f, 0, 1)),
        claim("A14.x0.t6", "coefficient of t^6 in x_0", "1/175", |p, f| entry(p, f, 0, 2)),
        claim("A14.x0.t17/2", "coefficient of t^(17/2) in x_0", "-22/104125", |p, f| entry(p, f, 0, 3)),
        claim("A14.x0.t11", "coefficient of t^11 in x_0", "52/8017625", |p, f| entry(p, f, 0, 4)),
        claim("A14.x1.t5/2", "coefficient of t^(5/2) in x_1", "-4/15", |p, f| entry(p, f, 1, 0)),
        claim("A14.x1.t5", "coefficient of t^5 in x_1", "3/70", |p, f| entry(p, f, 1, 1)),
        claim("A14.x1.t15/2", "coefficient of t^(15/2) in x_1", "-713/238875", |p, f| entry(p, f, 1, 2)),
        claim("A14.x1.t10", "coefficient of t^10 in x_1", "61216/42639187", |p, f| entry(p, f, 1, 3)),
        claim("A14.x2.t4", "coefficient of t^4 in x_2", "1/15", |p, f| entry(p, f, 2, 0)),
        claim("A14.x2.t13/2", "coefficient of t^(13/2) in x_2", "-937/75075", |p, f| entry(p, f, 2, 1)),
        claim("A14.x2.t9", "coefficient of t^9 in x_2", "871/808500", |p, f| entry(p, f, 2, 2)),
        claim("A14.x3.t11/2", "coefficient of t^(11/2) in x_3", "-38/2475", |p, f| entry(p, f, 3, 0)),
        claim("A14.x3.t8", "coefficient of t^8 in x_3", "43943/13513500", |p, f| entry(p, f, 3, 1)),
        claim("A14.x3.t21/2", "coefficient of t^(21/2) in x_3", "-1184627/3594591000", |p, f| {
            entry(p, f, 3, 2)
        }),
    ]
}

/// A coefficient of (A14) against the exact one; the slip tried is a lost last digit.
fn entry(printed: &str, truth: &TrueValues, n: usize, j: usize) -> Result<Finding, AuditError> {
    let exact = truth.trajectories.coefficients(n)?[j].clone();
    let shortened = exact.denom() / BigInt::from(10);
    let gives =
        if shortened.is_zero() { exact.clone() } else { Ratio::new_raw(exact.numer().clone(), shortened) };
    let slip = Slip { mistake: "dropping the last digit of the denominator", gives: Known::Exactly(gives) };
    number(printed, &Known::Exactly(exact), Some(slip))
}

/// In what the coefficients `b_k` of (A3) are counted.
#[derive(Clone, Copy)]
enum Unit {
    /// As (A2) to (A5) define them: `x = g^(4/5) t + b_5 t^(5/2) + ...`.
    AsDefined,
    /// In units of `b_2 = g^(4/5)`.
    OfSpeed,
}

fn coefficient(id: &'static str, statement: &'static str, printed: &str) -> Claim {
    let command = match id {
        "A7" => "restitution audit A7",
        "A8" => "restitution audit A8",
        "A9" => "restitution audit A9",
        "A10" => "restitution audit A10",
        _ => "restitution audit A11",
    };
    Claim::new(id, statement, printed, command, |printed, _| {
        in_either_unit(printed, |samples, unit| {
            let (alpha, root) = (samples.fraction(), samples.positive());
            let mut b = collected_orders(&alpha, &root)?;
            count_in(unit, &mut b, &root);
            Ok(scope(&alpha, &root).with_all(&NAMES, b.split_off(5)))
        })
    })
}

const NAMES: [&str; 5] = ["b5", "b6", "b7", "b8", "b9"];

fn scope(alpha: &BigRational, root: &BigRational) -> Scope<Rationals> {
    Scope::new(Rationals).with("alpha", alpha.clone()).with("g", root.pow(5))
}

fn count_in(unit: Unit, b: &mut [BigRational], root: &BigRational) {
    if let Unit::OfSpeed = unit {
        b.iter_mut().for_each(|b| *b /= root.pow(4));
    }
}

/// Judges formulas for the `b_k` in the unit of (A3), and if they fail, in units of `b_2`.
fn in_either_unit(
    printed: &str,
    point: impl Fn(&mut Samples, Unit) -> Result<Scope<Rationals>, AuditError>,
) -> Result<Finding, AuditError> {
    let defined = identity(printed, "points", |samples| point(samples, Unit::AsDefined))?;
    if defined.verdict == Verdict::Holds {
        return identity(printed, "random rational points, exactly", |samples| {
            point(samples, Unit::AsDefined)
        });
    }
    let scaled = identity(printed, "points", |samples| point(samples, Unit::OfSpeed))?;
    if scaled.verdict != Verdict::Holds {
        return Ok(defined);
    }
    let computed = format!("b_k as in (A3): {}; b_k in units of b_2: {}", defined.computed, scaled.computed);
    Ok(Finding { computed, ..scaled }.imprecise().noting(
        "true if b_k is counted in units of b_2 = g^(4/5), which is nowhere said; by (A3), (A4) and (A5) a factor \
         g^(4/5) is missing. (A12) has it",
    ))
}

/// The orders of the left side of (A1) for `b_5 .. b_9` drawn at random.
///
/// Freely chosen `b_k` stand for the unknowns of (A6); counted in units of `b_2`, so is the equation.
fn orders(samples: &mut Samples, unit: Unit) -> Result<Scope<Rationals>, AuditError> {
    let (alpha, root) = (samples.fraction(), samples.positive());
    let speed = root.pow(4);
    let drawn = samples.fractions(5);
    let factor = if let Unit::OfSpeed = unit { speed.clone() } else { BigRational::one() };
    let mut b =
        vec![BigRational::zero(), BigRational::zero(), speed, BigRational::zero(), BigRational::zero()];
    b.extend(drawn.iter().map(|b| b * &factor));
    let residual = residual(&alpha, &root, &b)?;
    let orders = (1..6).map(|k| residual.coefficient(k).map(|c| c / &factor));
    let orders = orders.collect::<Result<Vec<_>, _>>()?;
    Ok(scope(&alpha, &root).with_all(&NAMES, drawn).with_all(&["o1", "o2", "o3", "o4", "o5"], orders))
}

/// The sum of the collected orders up to `t^4` at `t = w^2`.
fn trajectory(samples: &mut Samples) -> Result<Scope<Rationals>, AuditError> {
    let (alpha, root, w) = (samples.fraction(), samples.positive(), samples.positive());
    let b = collected_orders(&alpha, &root)?;
    let x = b.iter().take(9).zip(0..).map(|(b, k)| b * w.pow(k)).sum();
    Ok(scope(&alpha, &root).with("t", w.pow(2)).with("x", x))
}
