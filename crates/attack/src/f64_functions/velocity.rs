//! `Restitution`: coefficients from velocities.

use super::arguments::{quantity, special};
use super::curve;
use super::limits::{SUM, is_damping};
use crate::Tally;
use crate::random::{Source, bits};
use rand::{Rng, RngExt};
use restitution::{End, Restitution, epsilon};

/// Relative distance of `epsilon(g)` from `epsilon(u(g))`: `u` is rounded to an f64, `|d ln epsilon/d ln u| <= 5`.
const THROUGH_U: f64 = 9.0 * f64::EPSILON;

pub(super) fn attack(arguments: &[f64], end: End, random: &mut Source, tally: &mut Tally) {
    let curve = random_curve(random, end);
    let dead = curve.epsilon(1.0).is_nan();
    let arguments = &arguments[..arguments.len() / 4];
    let mut values: Vec<f64> = arguments.iter().map(|g| curve.epsilon(*g)).collect();
    for (g, value) in arguments.iter().zip(&values) {
        one(&curve, *g, *value, dead, tally);
    }
    if !dead {
        let mut sorted: Vec<f64> = arguments.iter().copied().filter(|g| *g >= 0.0).collect();
        sorted.sort_by(f64::total_cmp);
        values.clear();
        values.extend(sorted.iter().map(|g| curve.epsilon(*g)));
        curve::order(&sorted, &values, "epsilon of a velocity", end, tally);
    }
}

pub(super) fn random_curve(random: &mut Source, end: End) -> Restitution {
    let scale = match random.next_u32() % 8 {
        0 => bits(random),
        1 => special(random),
        2 => quantity(random, 1e-60, 1e60),
        3 => 2f64.powi(random.random_range(-200..200)),
        _ => quantity(random, 1e-9, 1e6),
    };
    if random.random_bool(0.5) {
        Restitution::from_g_star(scale, end)
    } else {
        Restitution::from_u_at_unit_velocity(scale, end)
    }
}

fn one(curve: &Restitution, g: f64, value: f64, dead: bool, tally: &mut Tally) {
    let say = |what: &str, seen: f64| format!("{curve:?}.{what}({g:e} = {:#018x}) = {seen:e}", g.to_bits());
    let lost = curve.one_minus_epsilon(g);
    let back = curve.velocity(g);
    if dead || !is_damping(g) {
        tally.expect(value.is_nan(), "NaN below zero, for NaN and without a scale", || say("epsilon", value));
        tally.expect(lost.is_nan(), "NaN below zero, for NaN and without a scale", || {
            say("one_minus_epsilon", lost)
        });
        return;
    }
    tally.expect(back >= 0.0, "a velocity belongs to every u", || say("velocity", back));
    tally.expect((0.0..=1.0).contains(&value), "0 <= epsilon <= 1", || say("epsilon", value));
    tally.expect((0.0..=1.0).contains(&lost), "0 <= 1 - epsilon <= 1", || say("one_minus_epsilon", lost));
    let sum = value + lost;
    tally.expect((sum - 1.0).abs() <= 2.0 * SUM, "epsilon + (1 - epsilon) = 1", || say("the sum", sum));
    let through_u = epsilon(curve.u(g), curve.end());
    if through_u.is_normal() {
        let off = (value / through_u - 1.0).abs();
        tally.measure("relative distance of epsilon(g) from epsilon(u(g))", off);
        tally.expect(off <= THROUGH_U, "epsilon(g) = epsilon(u(g))", || say("epsilon", value));
    }
}
