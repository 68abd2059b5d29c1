//! Closed forms against the general engine, reference digits and themselves at other precisions.

use crate::numbers::{law, ratio};
use crate::support::{cases, generator};
use num_rational::{BigRational, Ratio};
use proptest::prelude::*;
use restitution_closed::{ClosedError, Family, beta, low_orders};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{Quantity, coefficients};

/// Both ways to the coefficients of a law, to so many digits.
fn assert_agree(family: Family, law: &ForceLaw, order: usize, digits: usize) {
    let quantity = match family {
        Family::Restitution => Quantity::Restitution,
        Family::Scaled => Quantity::ScaledRestitution,
        _ => Quantity::DelayedRecovery,
    };
    let closed = low_orders(family, law, order, digits).expect("low orders");
    let general = coefficients(quantity, law, order, digits).expect("an expansion");
    for (k, (closed, general)) in closed.iter().zip(&general).enumerate() {
        assert!(closed.overlaps(general), "{family:?} {law}, k = {k}: {closed:?} {general:?}");
        let shown = closed.to_digits(digits);
        assert_eq!(shown, general.to_digits(digits), "{family:?} {law}, k = {k}");
        assert!(shown.is_some());
    }
}

/// Laws large, small and near the edges: `0 < a <= 20`, `-1 < gamma <= 20`.
fn laws() -> impl Strategy<Value = ForceLaw> {
    let fraction = |n: std::ops::Range<i64>| (n, prop::sample::select(vec![1i64, 2, 3, 4, 7, 12, 100]));
    let moderate = (fraction(1..60), fraction(1..60))
        .prop_map(|((n, d), (m, e))| (ratio(n, d), ratio(m, e) - ratio(1, 1)));
    // gamma = (a-1)/2 and a bit beside, where p nearly vanishes; a tiny; gamma nearly -1.
    let beside = (1i64..40, -1i64..=1).prop_map(|(n, off)| {
        let a = ratio(n, 8);
        (a.clone(), (a - ratio(1, 1)) / ratio(2, 1) + ratio(off, 1000))
    });
    let tiny = (1i64..20, 1i64..20).prop_map(|(n, m)| (ratio(n, 1000), ratio(m, 4) - ratio(1, 1)));
    let edge = (1i64..20, 1i64..20).prop_map(|(n, m)| (ratio(n, 4), ratio(m, 300) - ratio(1, 1)));
    prop_oneof![4 => moderate, 1 => beside, 1 => tiny, 1 => edge].prop_filter_map(
        "at most 20",
        |(a, gamma): (BigRational, BigRational)| {
            (a <= ratio(20, 1) && gamma <= ratio(20, 1)).then(|| ForceLaw::new(a, gamma).ok()).flatten()
        },
    )
}

#[test]
fn random_laws_agree_to_60_digits() {
    use proptest::strategy::ValueTree;
    let mut source = generator(1312, 1);
    for _ in 0..cases(8) {
        let law = laws().new_tree(&mut source).expect("a law").current();
        assert_agree(Family::Scaled, &law, 4, 60);
    }
}

#[test]
fn spheres_agree_to_1000_digits() {
    assert_agree(Family::Restitution, &ForceLaw::viscoelastic_spheres(), 4, 1000);
}

/// The last ten of 100,000 digits are those of a run at another precision; the first 250 are the general engine's.
#[test]
fn a_hundred_thousand_digits_end_as_they_should() {
    let spheres = ForceLaw::viscoelastic_spheres();
    let [c, more] = [100_000, 100_100].map(|digits| {
        let c = low_orders(Family::Restitution, &spheres, 4, digits).expect("low orders");
        c.iter().skip(1).map(|c| c.to_digits(digits).expect("proved digits")).collect::<Vec<_>>()
    });
    let general = coefficients(Quantity::Restitution, &spheres, 4, 250).expect("an expansion");
    for (k, (c, more)) in c.iter().zip(&more).enumerate() {
        // The last digit may be rounded up; those before are cut from the same number.
        assert_eq!(c[..c.len() - 1], more[..c.len() - 1], "C_{}", k + 1);
        let general = general[k + 1].to_digits(250).expect("proved digits");
        assert_eq!(c[..general.len() - 1], general[..general.len() - 1], "C_{}", k + 1);
    }
}

#[test]
fn the_zero_force_end_agrees() {
    for text in ["3/2,1/2", "1,0", "2,1", "5/2,1/3"] {
        let law = law(text);
        let order = Family::DelayedRecovery.largest_index(&law).expect("a > gamma").min(19);
        assert_agree(Family::DelayedRecovery, &law, order, 40);
    }
}

#[test]
fn coefficients_that_vanish_are_zero() {
    // s = 1/4: a_4 = (4s-1) (a_3 - s (5s-1)/6).
    let a = low_orders(Family::Scaled, &law("3,0"), 4, 30).expect("low orders");
    assert_eq!(a[4].to_digits_and_radius(30), Some(("0".to_owned(), "0".to_owned())));
}

#[test]
fn more_digits_begin_with_fewer() {
    use proptest::strategy::ValueTree;
    let mut source = generator(77, 1);
    for _ in 0..cases(20) {
        let law = laws().new_tree(&mut source).expect("a law").current();
        let digits = (1usize..900).new_tree(&mut source).expect("digits").current();
        let [few, many] =
            [digits, digits + 300].map(|d| low_orders(Family::Restitution, &law, 4, d).expect("orders"));
        for (few, many) in few.iter().zip(&many) {
            assert!(few.overlaps(many), "{law}");
            let (value, radius) = few.to_digits_and_radius(digits).expect("proved");
            assert_eq!(Some(&value), many.to_digits(digits).as_ref(), "{law} {digits}");
            // The true value is within the radius that is printed.
            let (value, _) = crate::numbers::decimal(&value);
            let (radius, _) = crate::numbers::decimal(&radius);
            let slack = Ball::from_rational(&radius, 64).abs_up();
            assert!(
                Ball::from_rational(&value, many.prec() + 64).widened(&slack).overlaps(many),
                "{law} {digits}"
            );
        }
    }
}

#[test]
fn beta_values_are_those_of_gamma_functions() {
    use proptest::strategy::ValueTree;
    let mut source = generator(3, 1);
    let three_halves = ratio(3, 2);
    for _ in 0..cases(200) {
        let pair = (1i64..400, prop::sample::select(vec![1i64, 2, 3, 5, 8, 40, 399, 100_003]));
        let (n, d) = pair.new_tree(&mut source).expect("a fraction").current();
        let (found, expected) = (beta(Ratio::new(n, d), 300), Ball::beta(&three_halves, &ratio(n, d), 300));
        assert!(found.overlaps(&expected), "B(3/2, {n}/{d}): {found:?} {expected:?}");
        assert!(found.relative_bits().is_none_or(|bits| bits >= 290), "B(3/2, {n}/{d}): {found:?}");
    }
}

#[test]
fn what_beta_values_do_not_give_is_an_error() {
    let spheres = ForceLaw::viscoelastic_spheres();
    for (family, order, largest) in [(Family::Scaled, 5, 4), (Family::DelayedRecovery, 10, 9)] {
        assert_eq!(
            low_orders(family, &spheres, order, 10).err(),
            Some(ClosedError::BeyondBeta { order, largest })
        );
    }
    assert!(matches!(low_orders(Family::DelayedRecovery, &law("1,2"), 1, 10), Err(ClosedError::Series(_))));
}
