//! `epsilon` and `one_minus_epsilon`: range, NaN, order and sum.

use super::limits::{RISE_ULP, SUM, is_damping, steps};
use crate::Tally;
use restitution::{End, epsilon, one_minus_epsilon};

pub(super) fn attack(arguments: &[f64], end: End, tally: &mut Tally) {
    let mut values: Vec<f64> = arguments.iter().map(|u| epsilon(*u, end)).collect();
    for (u, value) in arguments.iter().zip(&values) {
        one(*u, *value, end, tally);
    }
    let mut sorted: Vec<f64> = arguments.iter().copied().filter(|u| *u >= 0.0).collect();
    sorted.sort_by(f64::total_cmp);
    values.clear();
    values.extend(sorted.iter().map(|u| epsilon(*u, end)));
    order(&sorted, &values, "epsilon", end, tally);
    neighbours(arguments, end, tally);
}

fn one(u: f64, value: f64, end: End, tally: &mut Tally) {
    let say = |what: &str, seen: f64| format!("{what}({u:e} = {:#018x}, {end:?}) = {seen:e}", u.to_bits());
    let lost = one_minus_epsilon(u, end);
    if !is_damping(u) {
        tally.expect(value.is_nan(), "NaN below zero and for NaN", || say("epsilon", value));
        tally.expect(lost.is_nan(), "NaN below zero and for NaN", || say("one_minus_epsilon", lost));
        return;
    }
    tally.expect((0.0..=1.0).contains(&value), "0 <= epsilon <= 1", || say("epsilon", value));
    tally.expect((0.0..=1.0).contains(&lost), "0 <= 1 - epsilon <= 1", || say("one_minus_epsilon", lost));
    let sum = value + lost;
    tally.expect((sum - 1.0).abs() <= SUM, "epsilon + (1 - epsilon) = 1", || say("the sum", sum));
    let positive_zero = value != 0.0 || value.is_sign_positive();
    tally.expect(positive_zero, "no -0", || say("epsilon", value));
}

/// Values at arguments in order may not rise by more than rounding.
pub(super) fn order(sorted: &[f64], values: &[f64], name: &str, end: End, tally: &mut Tally) {
    for (u, value) in sorted.windows(2).zip(values.windows(2)) {
        if value[1] > value[0] {
            let rise = steps(value[0], value[1]) as f64;
            tally.measure(&format!("rise of {name} with its argument, steps"), rise);
            tally.count(&format!("pairs where {name} rises"), 1);
            tally.expect(rise <= RISE_ULP, "monotone", || {
                format!("{name}, {end:?}, from {:e} to {:e}: {:e} to {:e}", u[0], u[1], value[0], value[1])
            });
        }
    }
}

/// The same of the next number after each argument.
fn neighbours(arguments: &[f64], end: End, tally: &mut Tally) {
    for u in arguments.iter().filter(|u| **u >= 0.0 && u.is_finite()) {
        let pair = [*u, u.next_up()];
        order(&pair, &pair.map(|u| epsilon(u, end)), "epsilon", end, tally);
    }
}
