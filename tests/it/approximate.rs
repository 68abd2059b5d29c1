//! The approximate theory of section III: its equation, its expansion, and how far it is from the truth.

use crate::support::in_snapshots;
use num_rational::BigRational;
use num_traits::One;
use restitution_direct::{Collision, End};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{ApproximateTheory, FractionalSeries, Quantity, coefficients};
use std::fmt::Write;

const BITS: u32 = 200;

fn law(text: &str) -> ForceLaw {
    text.parse().expect("a force law")
}

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

#[test]
fn the_printed_coefficients_are_those_of_the_equation() {
    let theory = ApproximateTheory::new(&ForceLaw::viscoelastic_spheres());
    assert_eq!(theory.coefficients(4), [ratio(1, 1), ratio(1, 1), ratio(3, 5), ratio(6, 25), ratio(7, 125)]);
}

#[test]
fn the_expansion_solves_the_equation_exactly() {
    const ORDER: usize = 40;
    for text in ["3/2,1/2", "1,0", "2,1", "1/2,3/4", "5/3,-1/7"] {
        let theory = ApproximateTheory::new(&law(text));
        let sign = |k: usize| if k.is_multiple_of(2) { BigRational::one() } else { -BigRational::one() };
        let signed = (0..=ORDER).map(|k| theory.coefficient(k) * sign(k)).collect();
        let epsilon = FractionalSeries::new(1, signed);
        let power = epsilon.power(theory.exponent()).expect("a power of a series that begins with 1");
        // eps + s eps^q - 1, coefficient by coefficient.
        for k in 1..=ORDER {
            let residual = epsilon.coefficient(k).expect("known") + power.coefficient(k - 1).expect("known");
            assert_eq!(residual, ratio(0, 1), "{text}, order {k}");
        }
    }
}

#[test]
fn closed_forms_are_met() {
    let s = Ball::from_ratio(7, 3, BITS);
    let one = Ball::from_integer(1, BITS);
    // q = 1/2 is a quadratic equation for sqrt(eps), q = 1 a linear one for eps.
    let root = ((&s * &s + Ball::from_integer(4, BITS)).sqrt() - &s).shifted(-1);
    let checks = [("1,0", &root * &root), ("2,2", &one / (&one + &s))];
    for (text, exact) in checks {
        let solved = ApproximateTheory::new(&law(text)).restitution(&s);
        assert!(solved.overlaps(&exact), "{text}");
        assert!(solved.relative_bits().is_none_or(|bits| bits > 180), "{text} {solved:?}");
    }
}

#[test]
fn solutions_satisfy_the_equation_for_any_damping() {
    let exponents = [-30, -9, -3, -1, 0, 1, 2, 5, 12, 40];
    for text in ["3/2,1/2", "3,-1/2", "1/2,5"] {
        let theory = ApproximateTheory::new(&law(text));
        for exponent in exponents {
            let s = Ball::from_integer(10, BITS).powi(exponent).with_prec(BITS);
            let epsilon = theory.restitution(&s);
            assert!(
                epsilon.relative_bits().is_some_and(|bits| bits > 150),
                "{text} 1e{exponent} {epsilon:?}"
            );
            let left = &epsilon + &s * epsilon.pow(theory.exponent());
            assert!(left.contains(&Ball::from_integer(1, BITS)), "{text} 1e{exponent} {left:?}");
        }
    }
}

#[test]
fn the_continued_fraction_falls_to_the_solution() {
    let theory = ApproximateTheory::new(&ForceLaw::viscoelastic_spheres());
    for numerator in [1, 10, 100] {
        let s = Ball::from_ratio(numerator, 10, BITS);
        let epsilon = theory.restitution(&s);
        let mut last = theory.continued_fraction(&s, 0);
        for depth in 1..=30 {
            let next = theory.continued_fraction(&s, depth);
            assert!((&last - &next).is_positive() && (&next - &epsilon).is_positive());
            last = next;
        }
        // (2/5)^30 is 1.2e-12.
        assert!((last - epsilon).abs_up() < 1e-11);
    }
}

#[test]
fn the_first_two_coefficients_are_exact_for_every_law() {
    for text in ["3/2,1/2", "2,1", "5/2,3/4", "1/2,1/3"] {
        let law = law(text);
        let exact = coefficients(Quantity::ScaledRestitution, &law, 3, 25).expect("coefficients");
        let theory = ApproximateTheory::new(&law);
        assert!(exact[2].contains_rational(&theory.coefficient(2)), "{text}");
        assert!(!exact[3].contains_rational(&theory.coefficient(3)), "{text}");
    }
}

/// What `docs/approximate-theory.md` shows.
#[test]
fn distance_from_the_exact_theory() {
    let spheres = ForceLaw::viscoelastic_spheres();
    let theory = ApproximateTheory::new(&spheres);
    let exact = coefficients(Quantity::ScaledRestitution, &spheres, 8, 12).expect("coefficients");
    let mut text = String::from("k  a_k of (27)           exact          approximate/exact - 1\n");
    for (k, a) in exact.iter().enumerate().skip(1) {
        let approximate = theory.coefficient(k);
        let deviation = Ball::from_rational(&approximate, 64) / a - Ball::one();
        let deviation = if k < 3 { "0".to_owned() } else { deviation.to_digits(4).expect("digits") };
        let a = a.to_digits(10).expect("digits");
        writeln!(text, "{k}  {:20}  {a:13}  {deviation}", approximate.to_string()).expect("text");
    }
    text.push_str("\nu     exact epsilon    epsilon of (27)  approximate/exact - 1\n");
    let collision = Collision::new(&spheres, End::ZeroCompression).expect("spheres");
    let first = &coefficients(Quantity::Restitution, &spheres, 1, 30).expect("C_1")[1];
    for (n, d) in [(1, 100), (1, 10), (1, 2), (1, 1), (2, 1), (5, 1), (8, 1), (20, 1)] {
        let u = ratio(n, d);
        let epsilon = collision.epsilon(&u, 20).expect("epsilon");
        let approximate = theory.restitution(&-(first * Ball::from_rational(&u, 100)));
        let deviation = &approximate / &epsilon - Ball::one();
        let show = |x: &Ball, digits| x.to_digits(digits).expect("digits");
        let (epsilon, approximate) = (show(&epsilon, 10), show(&approximate, 10));
        writeln!(text, "{:4}  {epsilon:15}  {approximate:15}  {}", u.to_string(), show(&deviation, 4))
            .expect("text");
    }
    in_snapshots("approximate", || insta::assert_snapshot!("distance", text));
}
