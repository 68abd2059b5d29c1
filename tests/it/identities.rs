//! Identities of time reversal, true to all orders and for every law.

use crate::numbers::{is_one, law, ratio};
use num_traits::Zero;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{FractionalSeries, Quantity, coefficients};

type Series = FractionalSeries<Ball>;

/// `eps(u) eps(-u eps(u)^p)` to the order of the coefficients.
fn product_of_both_halves(law: &ForceLaw, order: usize, digits: usize) -> Series {
    product_from(coefficients(Quantity::Restitution, law, order, digits).expect("the expansion exists"), law)
}

fn product_from(coefficients: Vec<Ball>, law: &ForceLaw) -> Series {
    let epsilon = Series::new(1, coefficients);
    let power = epsilon.power(&law.velocity_exponent()).expect("eps begins with 1");
    let reversed = power.coefficients()[..epsilon.order() - 1].iter().map(|c| -c);
    let image = Series::new(1, std::iter::once(Ball::zero()).chain(reversed).collect());
    epsilon.multiply(&epsilon.compose(&image).expect("no constant term")).expect("one unit")
}

/// Fails unless the product for spheres encloses `1, 0, 0, ...` within `radius`.
pub fn assert_time_reversal(coefficients: Vec<Ball>, radius: f64) {
    let order = coefficients.len();
    let product = product_from(coefficients, &ForceLaw::viscoelastic_spheres());
    assert_eq!(product.order(), order);
    assert!(is_one(&product, radius), "{:?}", product.coefficients());
}

#[test]
fn time_reversal_of_spheres_to_order_30() {
    let product = product_of_both_halves(&ForceLaw::viscoelastic_spheres(), 30, 40);
    assert_eq!(product.order(), 31);
    assert!(is_one(&product, 1e-30), "{:?}", product.coefficients());
}

#[test]
fn time_reversal_of_spheres_to_order_40_with_60_digits() {
    let product = product_of_both_halves(&ForceLaw::viscoelastic_spheres(), 40, 60);
    assert_eq!(product.order(), 41);
    assert!(is_one(&product, 1e-45), "{:?}", product.coefficients());
}

#[test]
fn time_reversal_of_other_laws() {
    for text in ["2,1", "5/2,1", "1,1/2", "3,1/2", "3/2,0"] {
        let product = product_of_both_halves(&law(text), 12, 40);
        assert_eq!(product.order(), 13);
        assert!(is_one(&product, 1e-25), "{text} {:?}", product.coefficients());
    }
}

#[test]
fn a_wrong_coefficient_breaks_time_reversal() {
    let mut c = coefficients(Quantity::Restitution, &law("3/2,1/2"), 4, 20).expect("coefficients");
    c[4] = &c[4] + Ball::from_ratio(1, 1_000_000, 64);
    assert!(!is_one(&product_from(c, &law("3/2,1/2")), 1.0));
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
