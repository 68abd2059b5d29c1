//! The stated errors of the evaluator, proved for every argument; the whole of it takes minutes, a slice a few seconds.

use restitution::{End, bounds, tiers};
use restitution_export::proof::{Group, Proof, groups, saturated, tier_near_zero};

/// Of so many intervals one is proved in the quick test.
const SLICE: usize = 60;

/// Every `every`-th interval of one end of contact.
fn some(end: End, every: usize) -> impl Iterator<Item = Group> {
    groups(end).into_iter().skip(every / 2).step_by(every)
}

/// The interval that holds `u`.
fn at(end: End, u: f64) -> Group {
    groups(end).into_iter().find(|group| group.low() <= u && u < group.high()).unwrap()
}

/// Proves the bounds that are stated.
fn prove(every: usize) {
    for end in [End::ZeroCompression, End::ZeroForce] {
        let all = some(end, every).map(|group| group.prove().unwrap()).reduce(Proof::and).unwrap();
        println!("{end:?}: {all:?}");
        assert!(all.epsilon.bound <= bounds::EPSILON.size, "{end:?}");
        assert!(all.one_minus_epsilon.bound <= bounds::ONE_MINUS_EPSILON.size, "{end:?}");
        assert!(all.of_velocity.bound <= bounds::EPSILON_OF_VELOCITY.size, "{end:?}");
    }
}

#[test]
fn the_stated_errors_on_some_intervals() {
    prove((SLICE / crate::support::cases(1)).max(1));
}

#[test]
#[ignore = "slow: every interval, ten minutes"]
fn the_stated_errors_on_every_interval() {
    prove(1);
}

/// From the end of the table on `epsilon u^5` is bounded by its value there and its limit.
#[test]
fn the_stated_error_beyond_the_table() {
    let proved = saturated().unwrap();
    assert!(proved.epsilon.bound <= bounds::EPSILON.size, "{proved:?}");
    assert!(proved.of_velocity.bound <= bounds::EPSILON_OF_VELOCITY.size, "{proved:?}");
    assert!(proved.approximation.bound < 1e-17, "{proved:?}");
}

#[test]
fn the_tolerances_of_tiers_on_some_intervals() {
    let (compression, force) = (at(End::ZeroCompression, 1.2), at(End::ZeroForce, 0.02));
    for (group, proved, near, tolerance) in [
        (
            &compression,
            compression.prove_tier(&tiers::ZERO_COMPRESSION_1E3),
            tier_near_zero(&tiers::ZERO_COMPRESSION_1E3),
            1e-3,
        ),
        (
            &compression,
            compression.prove_tier(&tiers::ZERO_COMPRESSION_1E9),
            tier_near_zero(&tiers::ZERO_COMPRESSION_1E9),
            1e-9,
        ),
        (&force, force.prove_tier(&tiers::ZERO_FORCE_1E6), tier_near_zero(&tiers::ZERO_FORCE_1E6), 1e-6),
    ] {
        let proved = proved.unwrap();
        assert!(
            proved > 0.0 && proved <= tolerance && near <= tolerance,
            "{}: {proved:e} {near:e}",
            group.low()
        );
    }
    assert_eq!(compression.prove_tier(&tiers::ZERO_FORCE_1E3).unwrap(), 0.0);
    // Intervals that are narrower than what a place is rounded by.
    for proved in [
        at(End::ZeroCompression, 2e-17).prove_tier(&tiers::ZERO_COMPRESSION_1E6),
        at(End::ZeroForce, 2e-17).prove_tier(&tiers::ZERO_FORCE_1E3),
    ] {
        assert!(proved.unwrap() < 1e-3);
    }
}

/// One number of a row larger, each so that the value is off by two units in the last place at least.
#[test]
fn a_mistake_in_any_coefficient_is_noticed() {
    let group = at(End::ZeroCompression, 1.2);
    // c_0 to c_5 in units of their words; c_6 and c_7 stand at the low ends of the words of c_5 and c_4.
    let own = (0..6).map(|k| (k, k, 4 << (8 * k)));
    for (k, word, units) in own.chain([(6, 5, 1 << 14), (7, 4, 1 << 11)]) {
        let mistaken = group.clone().map(|form| form.with_mistake(word, units));
        assert!(mistaken.prove().unwrap().epsilon.bound > bounds::EPSILON.size, "c_{k}");
    }
    let mistaken = group.map(|form| form.with_mistake(6, 4));
    assert!(mistaken.prove().unwrap().one_minus_epsilon.bound > bounds::ONE_MINUS_EPSILON.size);
}
