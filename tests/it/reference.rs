//! The engine against reference digits: tests/data/spheres.csv, whose header says where they are from.

use crate::numbers::{decimal, law, ratio, within_a_unit};
use num_rational::{BigRational, Ratio};
use restitution_direct::{Collision, End};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{Quantity, Trajectories, coefficients, turning_time};

/// The index and value of every row of a quantity.
fn rows(quantity: &str) -> Vec<(String, String)> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/spheres.csv");
    let data = std::fs::read_to_string(path).expect("the data are read");
    let fields = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
    let own = data.lines().map(fields).filter(|row| row[0] == quantity);
    let rows: Vec<_> = own.map(|row| (row[1].clone(), row[2].clone())).collect();
    assert!(!rows.is_empty(), "{quantity}");
    rows
}

fn spheres() -> ForceLaw {
    ForceLaw::viscoelastic_spheres()
}

/// Whether a ball agrees with a reference whose last digit or two may be rounded away: to 2 units.
fn assert_agrees(ball: &Ball, text: &str, name: &str) {
    let (value, unit) = decimal(text);
    let prec = ball.prec() + 64;
    let difference = (ball.with_prec(prec) - Ball::from_rational(&value, prec)).abs();
    let allowed = Ball::from_rational(&(unit * ratio(2, 1)), prec);
    assert!((allowed - difference).is_positive(), "{name}: {text}, not {ball:?}");
}

#[test]
fn coefficients_of_spheres() {
    for (name, quantity, order) in [
        ("C", Quantity::Restitution, 12),
        ("a", Quantity::ScaledRestitution, 12),
        ("y", Quantity::Compression, 4),
        ("h", Quantity::DelayedRecovery, 12),
    ] {
        let found = coefficients(quantity, &spheres(), order, 32).expect("the expansion exists");
        for (k, text) in rows(name) {
            let k: usize = k.parse().expect("an order");
            // h_5 is the fraction 4/15, tested below.
            let text = if text.contains('/') { continue } else { text };
            assert_agrees(&found[k], &text, &format!("{name}_{k}"));
        }
    }
}

#[test]
fn the_turning_time_of_spheres() {
    let (_, text) = &rows("T")[0];
    assert_agrees(&turning_time(&spheres(), 200), text, "T");
}

#[test]
fn a_power_law_beside_spheres() {
    // x'' + u x x' + x^2 = 0; 20 digits, from where tests/data/spheres.csv is from.
    let c = coefficients(Quantity::Restitution, &law("2,1"), 4, 25).expect("the expansion exists");
    let expected = [
        "-0.96859215903243503173",
        "0.62544718035940927722",
        "-0.39778184245429004897",
        "0.26182934101995286428",
    ];
    for (c, text) in c[1..].iter().zip(expected) {
        assert!(within_a_unit(c, text), "{text}, not {c:?}");
    }
}

#[test]
fn trajectories_of_spheres() {
    let trajectories = Trajectories::exact(&spheres(), 3, 6);
    for n in 0..=3 {
        for (j, (exponent, coefficient)) in rows(&format!("x_{n}")).into_iter().enumerate() {
            let expected: BigRational = coefficient.parse().expect("a fraction");
            assert_eq!(trajectories.exponent(n, j), exponent.parse::<Ratio<i64>>().expect("an exponent"));
            assert_eq!(trajectories.coefficients(n).expect("derived")[j], expected, "x_{n}, t^{exponent}");
        }
    }
}

#[test]
fn the_factor_between_both_ends_is_exact() {
    let end = restitution_series::DelayedRecovery::new(&spheres()).expect("3/2 > 1/2");
    // From where tests/data/spheres.csv is from.
    let expected =
        [ratio(1, 1), ratio(4, 15), ratio(13, 150), ratio(4897, 160_875), ratio(453_263, 40_540_500)];
    assert_eq!(end.psi(4), expected);
    let h = coefficients(Quantity::DelayedRecovery, &spheres(), 5, 60).expect("the expansion exists");
    assert!(h[5].contains_rational(&ratio(4, 15)) && *h[5].rad() < 1e-60);
    for k in [1, 3] {
        assert_eq!(h[k].to_digits(60).as_deref(), Some("0"), "h_{k}");
    }
}

/// `sum C_k u^k` against direct integration, which shares no formula with the expansion.
///
/// The radius of convergence is R = 1.388, and `|C_k| R^k < 2` for the orders summed: what is left out at
/// u = 1/10 is about `(u/R)^41 = 1e-46`, as far as this decay goes on, far below the 30 digits compared.
#[test]
fn series_and_direct_integration_agree_to_30_digits() {
    let c = coefficients(Quantity::Restitution, &spheres(), 40, 40).expect("the expansion exists");
    for (k, c) in c.iter().enumerate().skip(5) {
        assert!(c.to_f64().abs() * 1.388_361_925_615_83_f64.powi(k as i32) < 2.0, "k = {k}");
    }
    let u = Ball::from_ratio(1, 10, 200);
    let sum = c.iter().rev().fold(Ball::from_integer(0, 200), |sum, c| sum * &u + c);
    let collision = Collision::new(&spheres(), End::ZeroCompression).expect("spheres");
    let direct = collision.epsilon(&ratio(1, 10), 32).expect("digits");
    assert_eq!(sum.to_digits(30), direct.to_digits(30));
    assert!((&sum - &direct).abs_up() < 1e-31);
    let (_, text) = rows("epsilon").into_iter().find(|(u, _)| u == "0.1").expect("a reference");
    assert_agrees(&sum, &text, "epsilon(1/10)");
}

#[test]
fn half_powers_and_direct_integration_agree_at_zero_force() {
    // At u = 1/100, h_k falls no slower than 1: 30 half powers leave out about u^(31/2) = 1e-31.
    let h = coefficients(Quantity::DelayedRecovery, &spheres(), 30, 40).expect("the expansion exists");
    let root = Ball::from_ratio(1, 10, 200);
    let sum = h.iter().rev().fold(Ball::from_integer(0, 200), |sum, h| sum * &root + h);
    let collision = Collision::new(&spheres(), End::ZeroForce).expect("3/2 > 1/2");
    let direct = collision.epsilon(&ratio(1, 100), 32).expect("digits");
    assert_eq!(sum.to_digits(28), direct.to_digits(28));
}
