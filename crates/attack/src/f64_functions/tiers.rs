//! Tiers: cheaper, but bounded, monotone and 1 at 0 all the same.

use super::limits::{RISE_ULP, is_damping, steps};
use crate::Tally;
use crate::random::Source;
use rand::RngExt;
use restitution::{End, epsilon, tiers};

/// A tier without its sizes.
struct Tier {
    name: &'static str,
    end: End,
    tolerance: f64,
    /// Where its own table ends and the full evaluator begins.
    far: f64,
    epsilon: fn(f64) -> f64,
    batch: fn(&[f64], &mut [f64]),
}

macro_rules! tiers {
    ($($name:ident),*) => {
        [$(Tier {
            name: stringify!($name),
            end: tiers::$name.end(),
            tolerance: tiers::$name.tolerance(),
            far: tiers::$name.far(),
            epsilon: |u| tiers::$name.epsilon(u),
            batch: |u, out| tiers::$name.epsilon_batch(u, out),
        }),*]
    };
}

pub(super) fn attack(arguments: &[f64], random: &mut Source, tally: &mut Tally) {
    let all = tiers!(
        ZERO_COMPRESSION_1E3,
        ZERO_COMPRESSION_1E6,
        ZERO_COMPRESSION_1E9,
        ZERO_FORCE_1E3,
        ZERO_FORCE_1E6,
        ZERO_FORCE_1E9
    );
    // Most of the arguments lie beyond every table; half of these do not.
    let within =
        arguments.iter().map(|u| if random.random_bool(0.5) { 9.0 * random.random::<f64>() } else { *u });
    let mut arguments: Vec<f64> = within.collect();
    for tier in &all {
        values(tier, &arguments, tally);
    }
    arguments.retain(|u| *u >= 0.0);
    arguments.sort_by(f64::total_cmp);
    for tier in &all {
        monotone(tier, &arguments, tally);
    }
}

fn values(tier: &Tier, arguments: &[f64], tally: &mut Tally) {
    let mut out = vec![-1.0; arguments.len()];
    (tier.batch)(arguments, &mut out);
    for (u, batch) in arguments.iter().zip(&out) {
        let value = (tier.epsilon)(*u);
        let say = || format!("{}.epsilon({u:e} = {:#018x}) = {value:e}", tier.name, u.to_bits());
        if !is_damping(*u) {
            tally.expect(value.is_nan() && batch.is_nan(), "NaN below zero and for NaN", say);
            continue;
        }
        tally.expect(value.to_bits() == batch.to_bits(), "a batch gives what single calls give", || {
            format!("{}, in a batch {batch:e}", say())
        });
        tally.expect((0.0..=1.0).contains(&value), "0 <= epsilon <= 1", say);
        tally.expect(*u != 0.0 || value == 1.0, "epsilon(0) = 1", say);
        let full = epsilon(*u, tier.end);
        if full.is_normal() {
            let off = (value / full - 1.0).abs() / tier.tolerance;
            tally.measure(&format!("error of {} over its tolerance", tier.name), off);
            tally.expect(off <= 1.0 + 1e-6, "a tier keeps its tolerance", say);
        }
    }
}

fn monotone(tier: &Tier, sorted: &[f64], tally: &mut Tally) {
    let mut last = (0.0, 1.0);
    for u in sorted {
        for u in [*u, u.next_up()] {
            let value = (tier.epsilon)(u);
            if value > last.1 && u >= last.0 {
                tally.measure(&format!("rise of {}", tier.name), value - last.1);
                tally.count(&format!("pairs where {} rises", tier.name), 1);
                // Beyond its table it is the full evaluator, which may rise by rounding.
                let rounding = if u > tier.far { RISE_ULP } else { 0.0 };
                tally.expect(steps(last.1, value) as f64 <= rounding, "monotone", || {
                    format!("{}, from {:e} to {u:e}: {:e} to {value:e}", tier.name, last.0, last.1)
                });
            }
            last = (u, value);
        }
    }
}
