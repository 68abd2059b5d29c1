//! Identities of time reversal, true to all orders and for every law.

use crate::numbers::{law, ratio};
use num_rational::BigRational;
use num_traits::{One, Zero};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{Quantity, coefficients};
use rug::Float;

/// `eps(u) eps(-u eps(u)^p)` to the order of the coefficients.
fn product_of_both_halves(law: &ForceLaw, order: usize, digits: usize) -> Vec<Ball> {
    product_from(&coefficients(Quantity::Restitution, law, order, digits).expect("the expansion exists"), law)
}

fn product_from(epsilon: &[Ball], law: &ForceLaw) -> Vec<Ball> {
    let power = power(epsilon, &law.velocity_exponent());
    let image = std::iter::once(Ball::zero()).chain(power[..epsilon.len() - 1].iter().map(|c| -c));
    multiply(epsilon, &compose(epsilon, &image.collect::<Vec<_>>()))
}

/// The product of two series of one length.
fn multiply(x: &[Ball], y: &[Ball]) -> Vec<Ball> {
    let coefficient = |k: usize| (0..=k).fold(Ball::zero(), |sum, i| sum + &x[i] * &y[k - i]);
    (0..x.len()).map(coefficient).collect()
}

/// `s^p` for a series that begins with 1: `k g_k = sum (p i - (k-i)) s_i g_(k-i)` (Miller).
fn power(series: &[Ball], exponent: &BigRational) -> Vec<Ball> {
    let mut power = vec![Ball::one()];
    for k in 1..series.len() {
        let term = |i: usize| {
            let weight = exponent * ratio(i as i64, 1) - ratio((k - i) as i64, 1);
            Ball::from_rational(&weight, series[i].prec()) * &series[i] * &power[k - i]
        };
        let sum = (1..=k).fold(Ball::zero(), |sum, i| sum + term(i));
        power.push(sum / Ball::from_integer(k as i64, 64));
    }
    power
}

/// `outer(inner)` by Horner's scheme, for an inner series without constant term.
fn compose(outer: &[Ball], inner: &[Ball]) -> Vec<Ball> {
    let mut sum = vec![Ball::zero(); outer.len()];
    for c in outer.iter().rev() {
        sum = multiply(&sum, inner);
        sum[0] += c;
    }
    sum
}

/// Whether the coefficients enclose `1, 0, 0, ...`, each within `radius`.
fn is_one(coefficients: &[Ball], radius: f64) -> bool {
    let expected = |k| Ball::from_integer(i64::from(k == 0), 64);
    let mut coefficients = coefficients.iter().enumerate();
    coefficients.all(|(k, c)| c.contains(&expected(k)) && *c.rad() <= Float::with_val(53, radius))
}

/// Fails unless the product for spheres encloses `1, 0, 0, ...` within `radius`.
pub fn assert_time_reversal(coefficients: Vec<Ball>, radius: f64) {
    let product = product_from(&coefficients, &ForceLaw::viscoelastic_spheres());
    assert!(is_one(&product, radius), "{product:?}");
}

#[test]
fn time_reversal_of_spheres_to_order_30() {
    let product = product_of_both_halves(&ForceLaw::viscoelastic_spheres(), 30, 40);
    assert!(is_one(&product, 1e-30), "{product:?}");
}

#[test]
fn time_reversal_of_spheres_to_order_40_with_60_digits() {
    let product = product_of_both_halves(&ForceLaw::viscoelastic_spheres(), 40, 60);
    assert!(is_one(&product, 1e-45), "{product:?}");
}

#[test]
fn time_reversal_of_other_laws() {
    for text in ["2,1", "5/2,1", "1,1/2", "3,1/2", "3/2,0"] {
        let product = product_of_both_halves(&law(text), 12, 40);
        assert!(is_one(&product, 1e-25), "{text} {product:?}");
    }
}

#[test]
fn a_wrong_coefficient_breaks_time_reversal() {
    let mut c = coefficients(Quantity::Restitution, &law("3/2,1/2"), 4, 20).expect("coefficients");
    c[4] = &c[4] + Ball::from_ratio(1, 1_000_000, 64);
    assert!(!is_one(&product_from(&c, &law("3/2,1/2")), 1.0));
}

#[test]
fn even_coefficients_follow_from_odd_ones() {
    let a = coefficients(Quantity::ScaledRestitution, &law("3/2,1/2"), 4, 40).expect("coefficients");
    assert!(a[2].contains_rational(&ratio(3, 5)) && *a[2].rad() < 1e-40);
    let a_4 = &a[3] * Ball::from_ratio(7, 5, 200) - Ball::from_ratio(7, 25, 200);
    assert!(a[4].overlaps(&a_4) && *a_4.rad() < 1e-38);
    // Any law: a_2 = (1 + p)/2.
    for text in ["2,1", "5/2,1", "3,1/2"] {
        let law = law(text);
        let a = coefficients(Quantity::ScaledRestitution, &law, 2, 30).expect("coefficients");
        let half = (ratio(1, 1) + law.velocity_exponent()) / ratio(2, 1);
        assert!(a[2].contains_rational(&half) && *a[2].rad() < 1e-30, "{text}");
    }
}
