//! Radii against true errors: what is proved of a coefficient, and how far it really is from a run at 100 digits more.

use crate::numbers::ratio;
use crate::support::{cases, generator};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{Quantity, coefficients};

/// Digits of the second run beyond those of the first.
const MORE: usize = 100;

fn requests() -> impl Strategy<Value = (ForceLaw, Quantity, usize, usize)> {
    // Exponents with denominators up to 6: 1/6 <= a <= 5, -5/6 <= gamma <= 4; every third law is that of spheres.
    let exponent = |low: f64, high: f64| {
        (1i64..=6).prop_flat_map(move |d| {
            let end = |x: f64| (x * d as f64).round() as i64;
            (end(low)..=end(high)).prop_map(move |n| ratio(n, d))
        })
    };
    let law = (exponent(0.17, 5.0), exponent(-0.83, 4.0));
    let law = law.prop_filter_map("a > 0, gamma > -1", |(a, gamma)| ForceLaw::new(a, gamma).ok());
    let law = prop_oneof![1 => Just(ForceLaw::viscoelastic_spheres()), 2 => law];
    let quantity = prop::sample::select(vec![Quantity::Restitution, Quantity::Compression]);
    let order = prop_oneof![3 => 1usize..9, 1 => 9usize..30];
    let digits = prop_oneof![3 => 1usize..40, 1 => 40usize..150];
    (law, quantity, order, digits)
}

/// By how many bits each radius exceeds the true error; fails if one does not.
fn given_away(first: &[Ball], second: &[Ball], case: &str) -> Vec<f64> {
    let mut bits = Vec::new();
    for (k, (x, better)) in first.iter().zip(second).enumerate().filter(|(_, (x, _))| !x.is_exact()) {
        let error =
            (Ball::exact(x.mid().clone()) - Ball::exact(better.mid().clone())).abs_up() + better.rad();
        assert!(*x.rad() >= error, "{case}, {k}: {x:?} is off by {error}");
        bits.push((x.rad() / error).to_f64().log2());
    }
    bits
}

#[test]
fn radii_exceed_the_true_errors_of_random_laws() {
    let mut source = generator(12, 3);
    let mut all = Vec::new();
    let mut refused = 0;
    for _ in 0..cases(8) {
        let (law, quantity, order, digits) = requests().new_tree(&mut source).expect("a request").current();
        let case = format!("{law} {quantity:?} {order} {digits}");
        let (first, second) =
            (coefficients(quantity, &law, order, digits), coefficients(quantity, &law, order, digits + MORE));
        let (Ok(first), Ok(second)) = (first, second) else {
            refused += 1;
            continue;
        };
        let bits = given_away(&first, &second, &case);
        let last = bits.last().copied().unwrap_or(0.0);
        println!("{case}: {last:.0} bits are given away at the last order");
        all.extend(bits);
    }
    all.sort_by(f64::total_cmp);
    let quantile = |share: f64| all[((all.len() - 1) as f64 * share) as usize];
    println!(
        "{} coefficients, {refused} requests refused: {:.0} bits are given away at least, {:.0} by half, {:.0} by nine in ten, {:.0} at most",
        all.len(),
        quantile(0.0),
        quantile(0.5),
        quantile(0.9),
        quantile(1.0)
    );
    assert!(refused == 0 && !all.is_empty());
}
