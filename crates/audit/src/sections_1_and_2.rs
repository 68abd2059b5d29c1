//! Sections I and II of \[RPBS1999\]: the expansion as quoted, and the dimensional analysis.

use crate::AuditError;
use crate::PowerForces;
use crate::claim::{Claim, Finding, Verdict, enclosed, identity, number, right_side, sides};
use crate::formula::Scope;
use crate::printed_number::{Known, SHOWN_DIGITS, digits};
use crate::samples::Samples;
use crate::true_values::{FIELD, TrueValues, ball, fraction};
use num_rational::BigRational;
use num_traits::One;
use restitution_closed::{Family, Language, Reduction, closed_form, low_orders};
use restitution_law::ForceLaw;
use restitution_real::{Ball, Balls, Rationals};
use restitution_series::FractionalSeries;
use std::ops::RangeInclusive;

const TABLE: &str = "restitution table --quantity C --order 2 --digits 20";

const CLOSED: &str = "restitution closed-form --quantity C --order 4";

/// The claims.
pub fn claims() -> Vec<Claim> {
    vec![
        Claim::new("6.C1", "C_1 where (6) has an explicit minus", "1.15344", TABLE, |printed, truth| {
            enclosed(printed, &-&truth.c[1])
        }),
        Claim::new("6.C2", "C_2", "0.79826", TABLE, |printed, truth| enclosed(printed, &truth.c[2])),
        Claim::new(
            "6.closed",
            "the method of the appendix gives the coefficients of (6) as convergent series, not in closed form",
            "no closed form of C_3 and C_4",
            CLOSED,
            |_, truth| closed_forms(truth, 3..=4),
        ),
        Claim::new(
            "8",
            "the largest compression takes up the energy m g^2/2 of the impact",
            "xi0 = ((alpha + 1)/(2 D1))^(1/(1 + alpha)) g^(2/(1 + alpha))",
            "restitution audit 8",
            |printed, _| largest_compression(printed),
        ),
        Claim::new(
            "11",
            "the one parameter of the scaled equation of motion (10)",
            "delta = D2 ((1 + alpha)/(2 D1))^((1 + gamma)/(1 + alpha)) g^(2 (gamma - alpha)/(1 + alpha) + beta)",
            "restitution audit 11",
            |printed, _| {
                identity(printed, "random forces, to 35 digits", |samples| Ok(Forces::new(samples)?.scope()))
            },
        ),
        Claim::new(
            "12",
            "when the exponent of g in (11) vanishes",
            "0 = 2 (gamma - alpha) + beta (1 + alpha)",
            "restitution audit 12",
            |printed, _| condition(printed),
        ),
        Claim::new(
            "12.i",
            "gamma for a linear elastic force, beta = 1",
            "0",
            "restitution audit 12",
            |printed, _| number(printed, &Known::Exactly(constant_restitution(1, 1)), None),
        ),
        Claim::new(
            "12.ii",
            "gamma for the Hertz law, beta = 1",
            "1/4",
            "restitution audit 12",
            |printed, _| number(printed, &Known::Exactly(constant_restitution(3, 2)), None),
        ),
        Claim::new(
            "13",
            "the relation of the forces (2) and (3)",
            "3/2 A rho sqrt(xi) = A dF",
            "restitution audit 13",
            |printed, _| identity(printed, "random rational points, exactly", forces_of_spheres),
        ),
        Claim::new(
            "13.cubes",
            "alpha of the only viscoelastic bodies with constant restitution",
            "1",
            "restitution audit 13",
            |printed, _| number(printed, &Known::Exactly(constant_viscoelastic()), None),
        ),
        Claim::new(
            "14",
            "delta of spheres",
            "delta = 3/2 (5/4)^(3/5) A (rho/m)^(2/5) g^(1/5)",
            "restitution audit 14",
            |printed, _| identity(printed, "random spheres, to 35 digits", damping_of_spheres),
        ),
        Claim::new(
            "15",
            "the exponent of g in the one argument that the restitution of spheres has",
            "1/5",
            "restitution audit 15",
            |printed, _| {
                number(printed, &Known::Exactly(ForceLaw::viscoelastic_spheres().velocity_exponent()), None)
            },
        ),
    ]
}

/// Forces drawn at random, and the lengths and dampings that belong to them.
struct Forces {
    forces: PowerForces,
    stiffness: Ball,
    damping: Ball,
    velocity: Ball,
}

impl Forces {
    fn new(samples: &mut Samples) -> Result<Self, AuditError> {
        let mut draw = || samples.positive();
        let forces = PowerForces::new(draw(), draw(), draw())?;
        Ok(Self {
            forces,
            stiffness: fraction(&draw()),
            damping: fraction(&draw()),
            velocity: fraction(&draw()),
        })
    }

    /// The names of (8) to (11), `delta` by scaling (7) directly: `D2 xi0^(gamma+1) g^(beta-2)`.
    fn scope(&self) -> Scope<Balls> {
        let (_, beta, gamma) = self.forces.exponents();
        let length = self.forces.elastic_compression(&self.stiffness, &self.velocity);
        let two = BigRational::from_integer(2.into());
        let scaled = length.pow(&(gamma + BigRational::one())) * self.velocity.pow(&(beta - two));
        self.names().with("delta", scaled * &self.damping)
    }

    fn names(&self) -> Scope<Balls> {
        let (alpha, beta, gamma) = self.forces.exponents();
        Scope::new(FIELD)
            .with("D1", self.stiffness.clone())
            .with("D2", self.damping.clone())
            .with("g", self.velocity.clone())
            .with_exponent("alpha", alpha)
            .with_exponent("beta", beta)
            .with_exponent("gamma", gamma)
    }
}

/// (8) put into the balance of energy, `D1 xi0^(alpha+1)/(alpha+1) = g^2/2`.
fn largest_compression(printed: &str) -> Result<Finding, AuditError> {
    let formula = right_side(printed)?;
    identity("D1 xi0^(alpha + 1)/(alpha + 1) = g^2/2", "random forces, to 35 digits", |samples| {
        let names = Forces::new(samples)?.names();
        let length = formula.value(&names)?;
        Ok(names.with("xi0", length))
    })
}

/// The right side of (12), less the left, is `1 + alpha` times the exponent of `g` in (11).
fn condition(printed: &str) -> Result<Finding, AuditError> {
    let (left, right) = sides(printed)?;
    identity("(1 + alpha) p = condition", "random exponents, exactly", |samples| {
        let (alpha, beta, gamma) = (samples.positive(), samples.positive(), samples.positive());
        let forces = PowerForces::new(alpha.clone(), beta.clone(), gamma.clone())?;
        let scope = Scope::new(Rationals).with("p", forces.velocity_exponent());
        let scope = scope.with_all(&["alpha", "beta", "gamma"], [alpha, beta, gamma]);
        let condition = right.value(&scope)? - left.value(&scope)?;
        Ok(scope.with("condition", condition))
    })
}

fn constant_restitution(numerator: i64, denominator: i64) -> BigRational {
    let alpha = BigRational::new(numerator.into(), denominator.into());
    PowerForces::velocity_independent_gamma(&alpha, &BigRational::one())
}

/// `rho xi^(3/2)` and its derivative by the exact series.
fn forces_of_spheres(samples: &mut Samples) -> Result<Scope<Rationals>, AuditError> {
    let (root, rho) = (samples.positive(), samples.fraction());
    let force = FractionalSeries::from_integers(2, &[0, 0, 0, 1]);
    let slope = force.derivative()?.coefficient(1)? * &rho * &root;
    let a = samples.fraction();
    let names = ["xi", "rho", "A", "dF"];
    Ok(Scope::new(Rationals).with_all(&names, [&root * &root, rho, a, slope]))
}

/// Where `2 (gamma - alpha) + beta (1 + alpha)`, a linear function of `alpha` for `gamma = alpha - 1`
/// and `beta = 1`, vanishes.
fn constant_viscoelastic() -> BigRational {
    let value = |alpha: i64| {
        let alpha = BigRational::from_integer(alpha.into());
        let gamma = &alpha - BigRational::one();
        let forces = PowerForces::new(alpha.clone(), BigRational::one(), gamma);
        forces.map_or_else(|_| BigRational::one(), |f| f.velocity_exponent() * (alpha + BigRational::one()))
    };
    let (low, high) = (value(2), value(5));
    let slope = (&high - &low) / BigRational::from_integer(3.into());
    BigRational::from_integer(2.into()) - low / slope
}

/// (14) with `D1 = rho/m` and `D2 = (3/2) A rho/m` put into (11).
fn damping_of_spheres(samples: &mut Samples) -> Result<Scope<Balls>, AuditError> {
    let mut draw = || fraction(&samples.positive());
    let (a, rho, mass, g) = (draw(), draw(), draw(), draw());
    let stiffness = &rho / &mass;
    let damping = &stiffness * &a * ball(3) / ball(2);
    let delta = PowerForces::from(ForceLaw::viscoelastic_spheres()).damping_number(&stiffness, &damping, &g);
    Ok(Scope::new(FIELD).with_all(&["A", "rho", "m", "g", "delta"], [a, rho, mass, g, delta]))
}

/// A remark that there is no closed form of `C_k`: true of the method, and imprecise if one gives the same numbers.
pub fn closed_forms(truth: &TrueValues, orders: RangeInclusive<usize>) -> Result<Finding, AuditError> {
    let law = truth.collision.law();
    let closed =
        low_orders(Family::Restitution, law, *orders.end(), SHOWN_DIGITS).map_err(AuditError::failure)?;
    let agree = |k: usize| {
        let (value, engine) = (digits(&closed[k], SHOWN_DIGITS)?, digits(&truth.c[k], SHOWN_DIGITS)?);
        Ok((closed[k].overlaps(&truth.c[k]) && value == engine, format!("C_{k} = {value}")))
    };
    let found = orders.clone().map(agree).collect::<Result<Vec<_>, AuditError>>()?;
    let shown = found.iter().map(|(_, text)| text.as_str()).collect::<Vec<_>>().join(", ");
    let exist = found.iter().all(|(agrees, _)| *agrees);
    let finding =
        statement(format!("closed forms and the method of the appendix agree: {shown}"), exist).imprecise();
    let forms = orders.map(|k| {
        let form =
            closed_form(Family::Restitution, law, k, Reduction::Special).map_err(AuditError::failure)?;
        Ok(format!("C_{k} = {}", form.expression(Language::Text)))
    });
    let forms = forms.collect::<Result<Vec<_>, AuditError>>()?.join("; ");
    Ok(finding.noting(format!("{forms}, derived in docs/closed-forms.md for every power law")))
}

/// The verdict on something that is true or not.
pub fn statement(computed: impl ToString, holds: bool) -> Finding {
    Finding::new(computed, if holds { Verdict::Holds } else { Verdict::Wrong(None) })
}
