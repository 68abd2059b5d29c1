//! Section III of \[RPBS1999\] up to (32): the approximate theory.

use crate::AuditError;
use crate::claim::{Claim, Finding, enclosed, equality, identity, number, right_side};
use crate::formula::Scope;
use crate::printed_number::{Known, SHOWN_DIGITS, digits};
use crate::samples::Samples;
use crate::sections_1_and_2::statement;
use crate::true_values::{TrueValues, ball, one};
use num_rational::BigRational;
use num_traits::One;
use restitution_law::ForceLaw;
use restitution_real::{Ball, Balls, Rationals};
use restitution_series::{ApproximateTheory, FractionalSeries};

const C: &str = "restitution table --quantity C --order 1 --digits 20";
const A: &str = "restitution table --quantity a --order 4 --digits 20";

/// The printed right side of (30), without `(3/2) A (rho/m)^(2/5)`.
const PREFACTOR: &str = "sqrt(pi)/(2^(1/5) 5^(2/5)) Gamma(3/5)/Gamma(21/10)";

/// The claims.
pub fn claims() -> Vec<Claim> {
    vec![
        Claim::new(
            "21",
            "the energy lost on the way in, by (18) and (20)",
            "1/2 xi0^(5/2) - 1/2 = -d delta xi0^(3/2)",
            "restitution audit 21",
            |printed, _| identity(printed, "random rational points, exactly", energy_lost),
        ),
        Claim::new(
            "22",
            "the integral d of x^(1/2) sqrt(1 - x^(5/2)) from 0 to 1",
            "d = sqrt(pi) Gamma(3/5)/(5 Gamma(21/10))",
            "restitution audit 22",
            |printed, truth| {
                let found = equality(printed, &with_integral(truth))?;
                Ok(found.noting("computed from C_1 = -2 d (5/4)^(3/5) with C_1 as the appendix gives it"))
            },
        ),
        Claim::new(
            "25",
            "the energy gained in the inverse collision, by (23) and (24)",
            "1/2 xi0^(5/2) - 1/2 eps^2 = eps d delta xi0^(3/2)",
            "restitution audit 25",
            |printed, _| identity(printed, "random rational points, exactly", energy_gained),
        ),
        Claim::new(
            "26",
            "(21) and (25) combined",
            "eps = xi0^(5/2)",
            "restitution audit 26",
            |printed, _| combined(printed),
        ),
        Claim::new(
            "27",
            "(26) put into (21)",
            "eps + 2 d delta eps^(3/5) = 1",
            "restitution audit 27",
            |printed, _| identity(printed, "random rational points, exactly", solved),
        ),
        Claim::new(
            "28",
            "(27) as a continued fraction, one step of it",
            "1/eps = 1 + 2 d delta (1/eps)^(2/5)",
            "restitution audit 28",
            |printed, _| identity(printed, "random rational points, exactly", solved),
        ),
        Claim::new(
            "28.limit",
            "the continued fraction does not diverge for g to infinity",
            "0 < eps < 1",
            "restitution audit 28.limit",
            |_, _| no_divergence(),
        ),
        Claim::new(
            "29",
            "g* by (29) and (30) gives back (14)",
            &format!("2 d (5/4)^(3/5) = {PREFACTOR}"),
            "restitution audit 29",
            |printed, truth| equality(printed, &with_integral(truth)),
        ),
        Claim::new(
            "30",
            "the numerical factor of g*^(-1/5)",
            &format!("factor = {PREFACTOR}"),
            "restitution audit 30",
            |printed, truth| {
                let found = equality(printed, &truth.scope().with("factor", -&truth.c[1]))?;
                Ok(found
                    .noting("factor is -C_1 as the appendix gives it, by trajectories and inverse collision"))
            },
        ),
        Claim::new("31", "the same as a number", "1.15344", C, |printed, truth| {
            enclosed(printed, &-&truth.c[1])
        }),
        Claim::new(
            "31.C1",
            "the constant of (31) has to be equal to C_1 in (6)",
            &format!("C1 = {PREFACTOR}"),
            "restitution audit 31.C1",
            |printed, truth| equality(printed, &truth.scope().with("C1", -&truth.c[1])),
        ),
        theory("32.a1", "a_1 of the approximate theory", "1", |printed, _| coefficient(printed, 1)),
        theory("32.a2", "a_2 of the approximate theory", "3/5", |printed, _| coefficient(printed, 2)),
        theory("32.a3", "a_3 of the approximate theory", "6/25", |printed, _| coefficient(printed, 3)),
        theory("32.a3.decimal", "the same as a decimal", "0.24", |printed, _| coefficient(printed, 3)),
        theory("32.a4", "a_4 of the approximate theory", "7/125", |printed, _| coefficient(printed, 4)),
        theory("32.a4.decimal", "the same as a decimal", "0.056", |printed, _| coefficient(printed, 4)),
        Claim::new("32.exact", "its a_2 is the exact value", "a2 = 3/5", A, |printed, truth| {
            equality(printed, &truth.scope().with("a2", truth.a[2].clone()))
        }),
        Claim::new(
            "32.deviate",
            "its a_3 and a_4 deviate from the correct ones",
            "a_3, a_4",
            A,
            |_, truth| {
                let theory = spheres();
                let deviates = |k: usize| !truth.a[k].contains_rational(&theory.coefficient(k));
                let shown = |k: usize| digits(&truth.a[k], SHOWN_DIGITS);
                Ok(statement(format!("{}, {}", shown(3)?, shown(4)?), deviates(3) && deviates(4)))
            },
        ),
    ]
}

fn theory(
    id: &'static str,
    statement: &'static str,
    printed: &str,
    check: fn(&str, &TrueValues) -> Result<Finding, AuditError>,
) -> Claim {
    Claim::new(id, statement, printed, "restitution audit 32", check)
}

fn spheres() -> ApproximateTheory {
    ApproximateTheory::new(&ForceLaw::viscoelastic_spheres())
}

/// The terms of `sqrt(1 - z)` that stand for the whole series in the exact test of (21).
const TERMS: usize = 12;

/// (18) for the first terms of (20), integrated exactly; `delta` is such that it holds.
fn energy_lost(samples: &mut Samples) -> Result<Scope<Rationals>, AuditError> {
    energy(samples.positive(), BigRational::one(), -BigRational::one())
}

/// The same for (23) and (24): the speed has the factor `eps`, the damping the other sign.
fn energy_gained(samples: &mut Samples) -> Result<Scope<Rationals>, AuditError> {
    energy(samples.positive(), samples.positive(), BigRational::one())
}

/// The change of energy of a motion that starts with `speed`, and the work that makes it.
fn energy(root: BigRational, speed: BigRational, sign: BigRational) -> Result<Scope<Rationals>, AuditError> {
    let (d, work) = (integrated(&BigRational::one())?, integrated(&root)? * &speed);
    let two = BigRational::from_integer(2.into());
    let delta = (root.pow(5) - speed.pow(2)) / two / work * sign;
    let names = ["xi0", "eps", "d", "delta"];
    Ok(Scope::new(Rationals).with_all(&names, [root.pow(2), speed, d, delta]))
}

/// The integral of `sqrt(xi) sqrt(1 - (xi/xi0)^(5/2))` from 0 to `xi0 = root^2`, term by term.
fn integrated(root: &BigRational) -> Result<BigRational, AuditError> {
    let mut base = vec![0; 5 * TERMS];
    (base[0], base[5]) = (1, -1);
    let half = BigRational::new(1.into(), 2.into());
    let velocity = FractionalSeries::from_integers(2, &base).power(&half)?;
    let scaled = velocity.coefficients().iter().zip(0..).map(|(c, k)| c * root.pow(-k));
    let scaled = FractionalSeries::new(2, scaled.collect());
    let mut weight = vec![0; 5 * TERMS];
    weight[1] = 1;
    let weighted = scaled.multiply(&FractionalSeries::from_integers(2, &weight))?;
    let integral = weighted.integral();
    Ok(integral.coefficients().iter().zip(0..).map(|(c, k)| c * root.pow(k)).sum())
}

/// `d` as the appendix implies it: `C_1 = -2 d (5/4)^(3/5)`, with `C_1` from the trajectories.
fn with_integral(truth: &TrueValues) -> Scope<Balls> {
    let exponent = BigRational::new(3.into(), 5.into());
    let scale = Ball::from_ratio(5, 4, truth.c[1].prec()).pow(&exponent);
    truth.scope().with("d", -(&truth.c[1] / scale).shifted(-1))
}

/// Numbers that solve (21) and (26): `xi0 = h^2`, `eps = h^5`, `d delta = (1 - h^5)/(2 h^3)`.
fn solved(samples: &mut Samples) -> Result<Scope<Rationals>, AuditError> {
    let (h, d) = (samples.positive(), samples.positive());
    let two = BigRational::from_integer(2.into());
    let delta = (BigRational::one() - h.pow(5)) / (two * h.pow(3)) / &d;
    Ok(Scope::new(Rationals).with_all(&["xi0", "eps", "d", "delta"], [h.pow(2), h.pow(5), d, delta]))
}

/// The printed `eps` put into (25), with `d delta` from (21).
///
/// What (25) then leaves is `(1 + eps)(xi0^(5/2) - eps)/2`, so that no other positive `eps` passes.
fn combined(printed: &str) -> Result<Finding, AuditError> {
    let right = right_side(printed)?;
    let equation = "1/2 xi0^(5/2) - 1/2 eps^2 = eps (1/2 - 1/2 xi0^(5/2))/xi0^(3/2) xi0^(3/2)";
    identity(equation, "random rational points, exactly", |samples| {
        let scope = Scope::new(Rationals).with("xi0", samples.positive().pow(2));
        let eps = right.value(&scope)?;
        Ok(scope.with("eps", eps))
    })
}

/// The solution of (27), and the fraction broken off, at `s = 1, 10^3, 10^6, 10^9`.
fn no_divergence() -> Result<Finding, AuditError> {
    let theory = spheres();
    let mut holds = true;
    let mut shown = Vec::new();
    for power in [0, 3, 6, 9] {
        let s = ball(10).powi(power);
        let eps = theory.restitution(&s);
        let level = theory.continued_fraction(&s, 60);
        holds &= eps.is_positive() && (one() - &eps).is_positive() && level.is_positive();
        shown.push(format!("s = 1e{power}: {}", digits(&eps, 6)?));
    }
    Ok(statement(format!("eps at {}", shown.join(", ")), holds))
}

/// `a_k` of (27), checked by putting the series into the equation.
fn coefficient(printed: &str, k: usize) -> Result<Finding, AuditError> {
    let theory = spheres();
    let found = number(printed, &Known::Exactly(theory.coefficient(k)), None)?;
    let signed = theory.coefficients(8).into_iter().zip(0..).map(|(a, k)| if k % 2 == 1 { -a } else { a });
    let eps = FractionalSeries::new(1, signed.collect());
    let raised = eps.power(theory.exponent())?;
    for k in 1..=8 {
        if eps.coefficient(k)? + raised.coefficient(k - 1)? != BigRational::from_integer(0.into()) {
            return Err(AuditError::failure("the coefficients of the approximate theory do not solve (27)"));
        }
    }
    Ok(found)
}
