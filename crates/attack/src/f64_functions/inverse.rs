//! `u_of_epsilon`: range, NaN, order, and the way back.

use super::arguments::special;
use super::limits::{EPSILON_ULP, INVERSE, LOSS_ULP, steps};
use crate::Tally;
use crate::random::{Source, bits, by_ratio, near};
use rand::{Rng, RngExt};
use restitution::{End, epsilon, one_minus_epsilon, u_of_epsilon};

/// The least coefficient for which the bound of the inverse is stated.
const LEAST: f64 = 1e-290;

pub(super) fn attack(random: &mut Source, end: End, count: usize, tally: &mut Tally) {
    tally.count("inverted coefficients", count as u64);
    let mut wanted: Vec<f64> = (0..count).map(|_| coefficient(random, end)).collect();
    for value in &wanted {
        one(*value, end, tally);
    }
    wanted.retain(|value| (0.0..=1.0).contains(value));
    wanted.sort_by(|one, other| other.total_cmp(one));
    for pair in wanted.windows(2) {
        let (low, high) = (u_of_epsilon(pair[0], end), u_of_epsilon(pair[1], end));
        if high < low {
            // Steps of the coefficient that is asked for are larger than what the inverse may be off.
            tally
                .measure("fall of the inverse between coefficients in order, steps", steps(low, high) as f64);
        }
    }
}

fn coefficient(random: &mut Source, end: End) -> f64 {
    match random.next_u32() % 8 {
        0 => bits(random),
        1 => special(random),
        2 => 1.0 - by_ratio(random, 1e-17, 1.0),
        3 => {
            let u = f64::from(random.random_range(0..1024)) / 64.0;
            near(random, epsilon(u, end), 2)
        }
        4 => by_ratio(random, 5e-324, 1.0),
        5 => by_ratio(random, 1e-13, 1e-9),
        _ => random.random::<f64>(),
    }
}

fn one(wanted: f64, end: End, tally: &mut Tally) {
    let u = u_of_epsilon(wanted, end);
    let say = || format!("u_of_epsilon({wanted:e} = {:#018x}, {end:?}) = {u:e}", wanted.to_bits());
    if !(0.0..=1.0).contains(&wanted) {
        return tally.expect(u.is_nan(), "NaN outside [0, 1]", say);
    }
    let sound = u >= 0.0 && (u.is_infinite() == (wanted == 0.0)) && ((u == 0.0) == (wanted == 1.0));
    tally.expect(sound, "0 for 1, infinite for 0, between them otherwise", say);
    if !sound || wanted < LEAST || wanted == 1.0 {
        return;
    }
    let off = (epsilon(u, end) / wanted - 1.0).abs();
    tally.measure("relative distance of the coefficient at the inverse", off);
    // What `epsilon` is off itself comes on top here; certified.rs judges the bound alone.
    tally.expect(
        off <= INVERSE + EPSILON_ULP * f64::EPSILON,
        "the coefficient at the inverse is the one asked for",
        || format!("{}, off by {off:e}", say()),
    );
    let lost = 1.0 - wanted;
    if wanted > 0.5 {
        let off = (one_minus_epsilon(u, end) / lost - 1.0).abs();
        tally.measure("relative distance of the loss at the inverse", off);
        tally.expect(
            off <= INVERSE + LOSS_ULP * f64::EPSILON,
            "the loss at the inverse is the one asked for",
            || format!("{}, off by {off:e}", say()),
        );
    }
}
