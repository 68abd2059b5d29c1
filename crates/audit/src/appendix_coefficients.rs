//! The appendix of \[RPBS1999\], (A31) to (A36), and (33), (34): the coefficients.

use crate::AuditError;
use crate::claim::{Claim, Finding, Slip, enclosed, identity, number, right_side};
use crate::formula::Scope;
use crate::free_series::inverse_collision;
use crate::printed_number::{Known, digits};
use crate::samples::Samples;
use crate::sections_1_and_2::closed_forms;
use crate::true_values::{self, TrueValues};
use num_rational::BigRational;
use num_traits::Zero;
use restitution_real::{Ball, Rationals};

const C: &str = "restitution table --quantity C --order 4 --digits 20";
const A: &str = "restitution table --quantity a --order 4 --digits 20";

/// The brackets of (A31).
const BRACKETS: &str = "o1 = -4/5 y0 C1 + 2 y1; \
    o2 = (-4/5 C2 + 2/25 C1^2) y0 + y1 C1; \
    o3 = (-4/5 C3 + 4/25 C1 C2 - 4/125 C1^3) y0 + y1 C2 - 6/5 y2 C1 + 2 y3; \
    o4 = (-4/5 C4 + 2/25 (C2^2 + 2 C1 C3) - 12/125 C1^2 C2 + 11/625 C1^4) y0 + y1 C3 \
    + (-6/5 C2 - 3/25 C1^2) y2 + 7/5 y3 C1";

/// The claims.
pub fn claims() -> Vec<Claim> {
    let formulas =
        (1..).zip(true_values::C).map(|(k, formula)| format!("C{k} = {formula}")).collect::<Vec<_>>();
    vec![
        Claim::new(
            "A31",
            "the orders of the inverse collision (A29)",
            BRACKETS,
            "restitution audit A31",
            |printed, _| identity(printed, "random compressions and coefficients, exactly", orders),
        ),
        Claim::new(
            "A32",
            "the solution of (A31)",
            &formulas.join("; "),
            "restitution audit A32",
            |printed, truth| readings(solution(printed)?, truth),
        ),
        Claim::new("A32.C1", "C_1", "-1.153449", C, |printed, truth| enclosed(printed, &truth.c[1])),
        Claim::new(
            "A32.C2.equal",
            "C_2 in terms of C_1",
            "15/4 (y1/y0)^2 = 3/5 (5/2 y1/y0)^2",
            "restitution audit A32.C2.equal",
            |printed, _| identity(printed, "random rational points, exactly", compressions),
        ),
        Claim::new("A32.C2", "C_2", "0.798267", C, |printed, truth| enclosed(printed, &truth.c[2])),
        Claim::new("A32.C3", "C_3", "-0.483582", C, |printed, truth| c(printed, truth, 3)),
        Claim::new("A32.C4", "C_4", "0.285279", C, |printed, truth| c(printed, truth, 4)),
        Claim::new("34.C3", "C_3 in the main text", "-0.483582", C, |printed, truth| c(printed, truth, 3)),
        Claim::new("34.C4", "C_4 in the main text", "0.285279", C, |printed, truth| c(printed, truth, 4)),
        Claim::new("A33", "a_1", "1", A, |printed, truth| enclosed(printed, &truth.a[1])),
        Claim::new(
            "A34",
            "a_2 by (A32)",
            "15/4 (y1/y0)^2/(5/2 y1/y0)^2 = 3/5",
            "restitution audit A34",
            |printed, _| identity(printed, "random rational points, exactly", compressions),
        ),
        Claim::new("A35", "a_3", "0.315119", A, |printed, truth| a(printed, truth, 3)),
        Claim::new("A36", "a_4", "0.161167", A, |printed, truth| a(printed, truth, 4)),
        Claim::new(
            "A36.closed",
            "the method of the appendix does not give C_1 in closed form, the approximate theory does",
            "no closed form of C_1",
            "restitution closed-form --quantity C --order 1",
            |_, truth| closed_forms(truth, 1..=1),
        ),
        Claim::new("33.a3", "a_3 in the main text", "0.315119", A, |printed, truth| a(printed, truth, 3)),
        Claim::new("33.a4", "a_4 in the main text", "0.161167", A, |printed, truth| a(printed, truth, 4)),
    ]
}

const CHAIN: &str = "carrying the halved corrections of y_2 and y_3 on";

fn c(printed: &str, truth: &TrueValues, k: usize) -> Result<Finding, AuditError> {
    let slip = Slip { mistake: CHAIN, gives: Known::Within(truth.halved.c[k].clone()) };
    number(printed, &Known::Within(truth.c[k].clone()), Some(slip))
}

fn a(printed: &str, truth: &TrueValues, k: usize) -> Result<Finding, AuditError> {
    let slip = Slip { mistake: CHAIN, gives: Known::Within(truth.halved.a[k].clone()) };
    number(printed, &Known::Within(truth.a[k].clone()), Some(slip))
}

const NAMES: [&str; 4] = ["C1", "C2", "C3", "C4"];
const COMPRESSIONS: [&str; 4] = ["y0", "y1", "y2", "y3"];

fn compressions(samples: &mut Samples) -> Result<Scope<Rationals>, AuditError> {
    Ok(Scope::new(Rationals).with_all(&COMPRESSIONS, samples.fractions(4)))
}

/// (A29), its right side minus its left, expanded exactly for free `y_k` and `C_k`.
fn orders(samples: &mut Samples) -> Result<Scope<Rationals>, AuditError> {
    let (y, c) = (samples.fractions(4), samples.fractions(4));
    let orders = inverse_collision(&y, &c)?;
    let scope = Scope::new(Rationals).with_all(&COMPRESSIONS, y).with_all(&NAMES, c);
    Ok(scope.with_all(&["o1", "o2", "o3", "o4"], orders))
}

/// The printed `C_k`, put into (A29), make its first four orders vanish.
fn solution(printed: &str) -> Result<Finding, AuditError> {
    let formulas = printed.split(';').map(right_side).collect::<Result<Vec<_>, _>>()?;
    identity("o1 = 0; o2 = 0; o3 = 0; o4 = 0", "random compressions, exactly", |samples| {
        let y = samples.fractions(4);
        let scope = Scope::new(Rationals).with_all(&COMPRESSIONS, y.iter().cloned());
        let c = formulas.iter().map(|formula| formula.value(&scope)).collect::<Result<Vec<_>, _>>()?;
        let mut orders = inverse_collision(&y, &c)?;
        orders.resize(4, BigRational::zero());
        Ok(scope.with_all(&["o1", "o2", "o3", "o4"], orders))
    })
}

/// What the scan of (A32) shows instead, and what it would give.
fn readings(found: Finding, truth: &TrueValues) -> Result<Finding, AuditError> {
    let y = &truth.y;
    let read = (&y[1] / &y[2]) * Ball::from_ratio(5, 2, y[1].prec());
    Ok(found
        .noting("read with y_1/y_0; the copy at hand has y_1/y_2 in C_1, C_2 and the first terms of C_3, C_4, and y_0 in the others")
        .noting(format!(
            "y_1/y_2 does not solve (A31) and would make C_1 = {}; the printed C_1 was computed with y_1/y_0. Whether \
             the print or the copy is at fault cannot be told from the copy",
            digits(&read, 6)?
        )))
}
