//! Section II: the dimensional analysis, against what it must not depend on.

use crate::support::{cases, generator};
use num_rational::BigRational;
use num_traits::{One, Zero};
use proptest::prelude::*;
use restitution_audit::PowerForces;
use restitution_law::{ForceLaw, LawError};
use restitution_real::Ball;

const BITS: u32 = 200;

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

fn ball(n: i64, d: i64) -> Ball {
    Ball::from_ratio(n, d, BITS)
}

/// Whether two enclosures agree to 150 bits.
fn agree(x: &Ball, y: &Ball) -> bool {
    x.overlaps(y) && x.relative_bits().is_none_or(|bits| bits > 150)
}

#[test]
fn spheres_are_as_printed() {
    let spheres = PowerForces::from(ForceLaw::viscoelastic_spheres());
    assert_eq!(spheres.velocity_exponent(), ratio(1, 5));
    assert_eq!(spheres.length_exponent(), ratio(4, 5));
    // (14): delta = (3/2) (5/4)^(3/5) A (rho/m)^(2/5) g^(1/5)
    let (a, stiffness, g) = (ball(7, 1000), ball(13, 2), ball(3, 100));
    let printed =
        ball(3, 2) * ball(5, 4).pow(&ratio(3, 5)) * &a * stiffness.pow(&ratio(2, 5)) * g.pow(&ratio(1, 5));
    let damping = ball(3, 2) * &a * &stiffness;
    assert!(agree(&spheres.damping_number(&stiffness, &damping, &g), &printed));
}

#[test]
fn constant_restitution_needs_the_printed_exponents() {
    let one = BigRational::one();
    let gamma = |alpha: BigRational| PowerForces::velocity_independent_gamma(&alpha, &one);
    assert_eq!(gamma(ratio(1, 1)), ratio(0, 1));
    assert_eq!(gamma(ratio(3, 2)), ratio(1, 4));
    // Viscoelastic bodies (13) have it for a linear spring alone: cubes that meet face to face.
    for (n, d) in [(1, 1), (3, 2), (2, 1), (5, 2)] {
        let alpha = ratio(n, d);
        let forces = PowerForces::new(alpha.clone(), one.clone(), &alpha - &one).expect("forces");
        assert!(forces.is_viscoelastic());
        assert_eq!(forces.is_velocity_independent(), alpha.is_one());
        assert_eq!(forces.velocity_exponent(), (&alpha - &one) / (&alpha + &one));
    }
}

#[test]
fn impossible_exponents_are_named() {
    let make = |a: i64, b: i64, c: i64| PowerForces::new(ratio(a, 2), ratio(b, 2), ratio(c, 2));
    assert!(matches!(make(0, 2, 0), Err(LawError::ElasticExponent { .. })));
    assert!(matches!(make(2, 2, -2), Err(LawError::DampingExponent { .. })));
    let error = make(2, 0, 0).expect_err("beta = 0");
    insta::assert_snapshot!(error.to_string(), @"the exponent of the rate must be positive, not 0: give beta > 0, such as 1");
}

/// Exponents `alpha`, `beta`, `gamma`.
fn exponents() -> impl Strategy<Value = (BigRational, BigRational, BigRational)> {
    let quarter = |n: i64| ratio(n, 4);
    (1i64..20, 1i64..12, -3i64..16).prop_map(move |(a, b, c)| (quarter(a), quarter(b), quarter(c)))
}

#[test]
fn equation_12_says_when_the_exponent_of_11_vanishes() {
    let test = |(alpha, beta, gamma): (BigRational, BigRational, BigRational)| {
        let forces = PowerForces::new(alpha.clone(), beta.clone(), gamma.clone()).expect("forces");
        prop_assert_eq!(forces.is_velocity_independent(), forces.velocity_exponent().is_zero());
        if beta.is_one() {
            let law = ForceLaw::new(alpha.clone(), gamma).expect("a law");
            prop_assert_eq!(forces.velocity_exponent(), law.velocity_exponent());
        }
        let gamma = PowerForces::velocity_independent_gamma(&alpha, &beta);
        if gamma > -BigRational::one() {
            let forces = PowerForces::new(alpha, beta, gamma).expect("forces");
            prop_assert!(forces.is_velocity_independent());
        }
        Ok(())
    };
    generator(12, cases(200)).run(&exponents(), test).expect("eq. (12)");
}

/// In other units of length and time, `D_1`, `D_2` and `g` change, `delta` doesn't, and the largest
/// compression changes like a length.
#[test]
fn the_damping_number_does_not_depend_on_units() {
    let input = (exponents(), 1i64..50, 1i64..50, 1i64..50);
    let test = |((alpha, beta, gamma), length, time, speed): (_, i64, i64, i64)| {
        let (stiffness, damping, g) = (ball(speed, 7), ball(3, length), ball(speed, 11));
        let (l, t) = (ball(length, 3), ball(5, time));
        let forces = PowerForces::new(alpha, beta, gamma).expect("forces");
        let factors = Factors::new(&forces, &l, &t);
        let delta = forces.damping_number(&stiffness, &damping, &g);
        let reach = forces.elastic_compression(&stiffness, &g);
        let (stiffness, damping, g) = (stiffness * factors.stiffness, damping * factors.damping, g * t / &l);
        prop_assert!(agree(&delta, &forces.damping_number(&stiffness, &damping, &g)));
        prop_assert!(agree(&reach, &(forces.elastic_compression(&stiffness, &g) * l)));
        Ok(())
    };
    generator(11, cases(100)).run(&input, test).expect("eq. (11)");
}

/// The factors of `D_1` and `D_2` when length and time are counted in other units: the terms of eq. (7)
/// must stay accelerations.
struct Factors {
    stiffness: Ball,
    damping: Ball,
}

impl Factors {
    fn new(forces: &PowerForces, length: &Ball, time: &Ball) -> Self {
        let one = BigRational::one();
        let two = &one + &one;
        let (alpha, beta, gamma) = forces.exponents();
        Self {
            stiffness: length.pow(&(alpha - &one)) * time.pow(&two),
            damping: length.pow(&(gamma + beta - &one)) * time.pow(&(two - beta)),
        }
    }
}

#[test]
fn the_largest_compression_takes_up_the_energy() {
    for (a, beta, gamma) in [(3, 2, 1), (2, 3, 0), (5, 2, 3)] {
        let forces = PowerForces::new(ratio(a, 2), ratio(beta, 2), ratio(gamma, 2)).expect("forces");
        let (stiffness, g) = (ball(17, 3), ball(2, 7));
        let reach = forces.elastic_compression(&stiffness, &g);
        let step = ratio(a, 2) + BigRational::one();
        let stored = stiffness * reach.pow(&step) / Ball::from_rational(&step, BITS);
        assert!(agree(&stored, &(&g * &g).shifted(-1)));
    }
}
