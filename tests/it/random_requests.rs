//! Requests at random: what a run prints is confirmed by a second one at 40 more digits.

use crate::numbers::{decimal, ratio, within_a_unit};
use crate::support::{cases, generator};
use num_rational::BigRational;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use restitution_direct::{Collision, End};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{Quantity, coefficients};

/// Digits of the second run beyond those of the first.
const MORE: usize = 40;

#[derive(Clone, Copy, Debug)]
enum Asked {
    Coefficients(Quantity, usize),
    /// An end of contact and the damping in hundredths.
    Epsilon(End, i64),
}

/// What is printed, or the line that says why nothing is.
fn answer(law: &ForceLaw, asked: Asked, digits: usize) -> Result<Vec<Ball>, String> {
    match asked {
        Asked::Coefficients(quantity, order) => {
            coefficients(quantity, law, order, digits).map_err(|error| error.to_string())
        }
        Asked::Epsilon(end, u) => {
            let collision = Collision::new(law, end).map_err(|error| error.to_string())?;
            collision.epsilon(&ratio(u, 100), digits).map(|e| vec![e]).map_err(|error| error.to_string())
        }
    }
}

fn requests() -> impl Strategy<Value = (ForceLaw, Asked, usize)> {
    // Exponents with denominators up to 4: 1/2 <= a <= 4, -3/4 <= gamma <= 3.
    let exponent = |range: std::ops::Range<f64>| {
        (1i64..=4).prop_flat_map(move |d| {
            let end = |x: f64| (x * d as f64).round() as i64;
            (end(range.start)..=end(range.end)).prop_map(move |n| ratio(n, d))
        })
    };
    let law = (exponent(0.5..4.0), exponent(-0.75..3.0)).prop_filter_map("a > 0, gamma > -1", force_law);
    let law = prop_oneof![1 => Just(ForceLaw::viscoelastic_spheres()), 3 => law];
    let quantity = prop::sample::select(vec![
        Quantity::Restitution,
        Quantity::ScaledRestitution,
        Quantity::Compression,
        Quantity::DelayedRecovery,
    ]);
    let order = prop_oneof![9 => 1usize..9, 1 => 9usize..20];
    let end = prop::sample::select(vec![End::ZeroCompression, End::ZeroForce]);
    let asked = prop_oneof![
        4 => (quantity, order).prop_map(|(quantity, order)| Asked::Coefficients(quantity, order)),
        1 => (end, 1i64..300).prop_map(|(end, u)| Asked::Epsilon(end, u)),
    ];
    let digits = prop_oneof![9 => 1usize..30, 1 => 30usize..80];
    (law, asked, digits)
}

fn force_law((a, gamma): (BigRational, BigRational)) -> Option<ForceLaw> {
    ForceLaw::new(a, gamma).ok()
}

/// Whether the ball holds the middle between two decimals, as that of `a_2 = 9/8` to three digits does.
fn is_tie(ball: &Ball, one: &str, other: &str) -> bool {
    ball.contains_rational(&((decimal(one).0 + decimal(other).0) / ratio(2, 1)))
}

#[test]
fn digits_of_random_requests_are_confirmed() {
    let mut refused = 0;
    let mut source = generator(2024, 1);
    let total = cases(100);
    for _ in 0..total {
        let (law, asked, digits) = requests().new_tree(&mut source).expect("a request").current();
        let (first, second) = (answer(&law, asked, digits), answer(&law, asked, digits + MORE));
        let (first, second) = match (first, second) {
            (Ok(first), Ok(second)) => (first, second),
            (first, second) => {
                refused += 1;
                assert_eq!(first.err(), second.err(), "{law} {asked:?} {digits}");
                continue;
            }
        };
        assert_eq!(first.len(), second.len());
        for (k, (first, second)) in first.iter().zip(&second).enumerate() {
            let shown = first.to_digits(digits).unwrap_or_else(|| panic!("{law} {asked:?} {digits}, {k}"));
            assert!(within_a_unit(second, &shown), "{law} {asked:?}, {k}: {shown}, but {second:?}");
            assert!(first.overlaps(second), "{law} {asked:?} {digits}, {k}: {first:?}, but {second:?}");
            let again = second.to_digits(digits).unwrap_or_else(|| panic!("{law} {asked:?} {digits}, {k}"));
            assert!(
                again == shown || is_tie(second, &again, &shown),
                "{law} {asked:?}, {k}: {again} {shown}"
            );
        }
    }
    println!("{total} requests, {refused} of them refused by a message");
    assert!(refused < total / 2, "{refused} of {total} requests were refused");
}
