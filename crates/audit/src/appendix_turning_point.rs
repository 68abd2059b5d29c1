//! The appendix of \[RPBS1999\], (A16) to (A27): the turning point and the largest compression.

use crate::AuditError;
use crate::claim::{Claim, Finding, Slip, equality, identity, number};
use crate::formula::{Formula, Scope};
use crate::free_series::FreeMotion;
use crate::printed_number::{Agreement, Known, digits};
use crate::samples::Samples;
use crate::true_values::{self, TrueValues};
use num_rational::BigRational;
use num_traits::Zero;
use restitution_real::{Ball, Rationals};

const COMMAND: &str = "restitution table --quantity y --order 3 --digits 20";

/// The claims.
pub fn claims() -> Vec<Claim> {
    let y2 = format!("y2 = {}", true_values::Y2);
    let y3 = format!("y3 = {}", true_values::Y3);
    vec![
        Claim::new(
            "A16",
            "half the duration of the undamped collision",
            "T = (4/5)^(3/5) Gamma(2/5) Gamma(1/2)/(2 Gamma(9/10))",
            "restitution audit A16",
            half_duration,
        ),
        Claim::new(
            "A16.x0",
            "the largest compression of the undamped collision",
            "x0 = (5/4)^(2/5)",
            COMMAND,
            |printed, truth| equality(printed, &truth.turning.scope()),
        ),
        Claim::new(
            "A20",
            "the orders of x'(T + dt) = 0",
            "Y1 = t1 x0'' + g^(1/5) x1'; \
             Y2 = t2 x0'' + 1/2 t1^2 x0''' + g^(1/5) t1 x1'' + g^(2/5) x2'; \
             Y3 = t3 x0'' + t1 t2 x0''' + 1/6 t1^3 x0'''' + g^(1/5) t2 x1'' + g^(1/5) 1/2 t1^2 x1''' \
             + g^(2/5) t1 x2'' + g^(3/5) x3'",
            "restitution audit A20",
            |printed, _| identity(printed, "random motions, exactly", orders),
        ),
        Claim::new(
            "A21",
            "the shift of the turning point",
            "t1 = -g^(1/5) x1'/x0''; \
             t2 = g^(2/5) (-x1'^2 x0'''/(2 x0''^3) + x1' x1''/x0''^2 - x2'/x0'')",
            "restitution audit A21",
            |printed, _| identity(printed, "random motions, exactly", shift),
        ),
        Claim::new("A24", "y_0", "1.093362", COMMAND, |printed, truth| compression(printed, truth, 0)),
        Claim::new("A25", "y_1", "-0.504455", COMMAND, |printed, truth| compression(printed, truth, 1)),
        Claim::new(
            "A26.formula",
            "y_2 by derivatives at T",
            &y2,
            "restitution audit A26.formula",
            |printed, _| identity(printed, "random motions, exactly", compressed),
        ),
        Claim::new("A26", "y_2", "0.260542", COMMAND, |printed, truth| {
            halved(printed, truth, 2, true_values::Y2, &truth.halved.y2)
        }),
        Claim::new(
            "A27.formula",
            "y_3 by derivatives at T",
            &y3,
            "restitution audit A27.formula",
            |printed, truth| readings(identity(printed, "random motions, exactly", compressed)?, truth),
        ),
        Claim::new("A27", "y_3", "-0.136769", COMMAND, |printed, truth| {
            halved(printed, truth, 3, true_values::Y3, &truth.halved.y3)
        }),
    ]
}

/// `x_0'` vanishes at the printed `T`, summed from the exact series with a proved tail.
fn half_duration(printed: &str, truth: &TrueValues) -> Result<Finding, AuditError> {
    let turning = &truth.turning;
    if !turning.velocity[0].contains_zero() {
        return Err(AuditError::failure("x_0' does not vanish at T"));
    }
    let found = equality(printed, &truth.scope().with("T", turning.time.clone()))?;
    Ok(found.noting(format!("x_0'(T) = 0 +/- {} from the exact series", turning.velocity[0].radius_text())))
}

/// `y_0` and `y_1`, which are also `x_0(T)` and `x_1(T)` (A24), (A25).
fn compression(printed: &str, truth: &TrueValues, k: usize) -> Result<Finding, AuditError> {
    if !truth.y[k].overlaps(&truth.turning.position[k]) {
        return Err(AuditError::failure(format!("y_{k} is not x_{k}(T)")));
    }
    number(printed, &Known::Within(truth.y[k].clone()), None)
}

/// `y_k` beside the printed formula at the certified derivatives, its corrections whole and halved.
fn halved(
    printed: &str,
    truth: &TrueValues,
    k: usize,
    formula: &str,
    slip: &Ball,
) -> Result<Finding, AuditError> {
    let right = Formula::read(formula)?.value(&truth.turning.scope())?;
    if !right.overlaps(&truth.y[k]) {
        return Err(AuditError::failure(format!(
            "the formula of y_{k} does not give the y_{k} of the engine"
        )));
    }
    let mistake = "taking everything after the first term of the formula with half its weight";
    let slip = Slip { mistake, gives: Known::Within(slip.clone()) };
    let found = number(printed, &Known::Within(truth.y[k].clone()), Some(slip))?;
    let first = &truth.turning.position[k];
    let rest = right - first;
    let line = |weight: &str, rest: &Ball| {
        let sum = digits(&(first + rest), 12)?;
        Ok::<_, AuditError>(format!("{weight}: {} + ({}) = {sum}", digits(first, 12)?, digits(rest, 12)?))
    };
    Ok(found
        .noting(line(&format!("x_{k}(T) and the other terms"), &rest)?)
        .noting(line("with half of the other terms", &rest.shifted(-1))?))
}

/// What the scan of (A27) leaves open, and what the numbers say about it.
fn readings(found: Finding, truth: &TrueValues) -> Result<Finding, AuditError> {
    let scope = truth.turning.scope();
    let right = Formula::read(true_values::Y3)?.value(&scope)?;
    let plain = Formula::read(&true_values::Y3.replace("x1''/x0''^2", "x1''/x0''"))?.value(&scope)?;
    let x3 = &truth.turning.position[3];
    let halved = |y: &Ball| x3 + (y - x3).shifted(-1);
    let printed_by = |y: &Ball| Agreement::of("-0.136769", &Known::Within(y.clone()));
    let squared = printed_by(&halved(&right))? != Agreement::None;
    let unsquared = printed_by(&halved(&plain))? != Agreement::None || printed_by(&plain)? != Agreement::None;
    if !squared || unsquared {
        return Err(AuditError::failure("the readings of (A27) are not as its notes say"));
    }
    Ok(found
        .noting(format!(
            "the copy at hand shows no square on x0'' under x1'' and no factor 1/6; without the square y_3 would be {} \
             and neither it nor its halved form rounds to the printed number: the square was used",
            digits(&plain, 12)?
        ))
        .noting("the last term does not count for spheres, because x0'''(T) = -(3/2) sqrt(x0) x0' = 0"))
}

const NAMES: [[&str; 5]; 4] = [
    ["x0", "x0'", "x0''", "x0'''", "x0''''"],
    ["x1", "x1'", "x1''", "x1'''", "x1''''"],
    ["x2", "x2'", "x2''", "x2'''", "x2''''"],
    ["x3", "x3'", "x3''", "x3'''", "x3''''"],
];

fn derivatives(motion: &FreeMotion) -> Scope<Rationals> {
    let rows = NAMES.iter().zip(&motion.0);
    rows.fold(Scope::new(Rationals), |scope, (names, row)| scope.with_all(names, row.iter().cloned()))
}

/// A motion whose order `n` carries `g^(n/5)`, with the names of its derivatives and `g`.
fn motion(samples: &mut Samples) -> (FreeMotion, Scope<Rationals>) {
    let (motion, root) = (FreeMotion::draw(samples), samples.positive());
    let scope = derivatives(&motion).with("g", root.pow(5));
    let rows = motion.0.iter().zip(0..);
    let scaled = rows.map(|(row, n)| row.iter().map(|x| x * root.pow(n)).collect());
    (FreeMotion(scaled.collect()), scope)
}

fn orders(samples: &mut Samples) -> Result<Scope<Rationals>, AuditError> {
    let (motion, scope) = motion(samples);
    let mut shift = vec![BigRational::zero()];
    shift.extend(samples.fractions(3));
    let velocity = motion.at(&shift, 1);
    let scope = scope.with_all(&["t1", "t2", "t3"], shift.split_off(1));
    Ok(scope.with_all(&["Y0", "Y1", "Y2", "Y3"], velocity))
}

fn shift(samples: &mut Samples) -> Result<Scope<Rationals>, AuditError> {
    let (motion, scope) = motion(samples);
    Ok(scope.with_all(&["t0", "t1", "t2", "t3"], motion.turning_point()))
}

fn compressed(samples: &mut Samples) -> Result<Scope<Rationals>, AuditError> {
    let motion = FreeMotion::draw(samples);
    let compression = motion.at(&motion.turning_point(), 0);
    Ok(derivatives(&motion).with_all(&["y0", "y1", "y2", "y3"], compression))
}
