//! Every batch against single calls, to the bit, in slices of random lengths and offsets.

use super::limits::same;
use super::velocity::random_curve;
use crate::Tally;
use crate::random::Source;
use rand::RngExt;
use restitution::{
    End, epsilon, epsilon_batch, one_minus_epsilon, one_minus_epsilon_batch, u_of_epsilon,
    u_of_epsilon_batch, u_of_one_minus_epsilon, u_of_one_minus_epsilon_batch,
};

/// A name, a function, and its batch.
type Pair<'a> = (&'a str, &'a dyn Fn(f64) -> f64, &'a dyn Fn(&[f64], &mut [f64]));

pub(super) fn attack(arguments: &[f64], end: End, random: &mut Source, tally: &mut Tally) {
    let law = random_curve(random, end);
    let pairs: [Pair; 5] = [
        ("epsilon", &|u| epsilon(u, end), &|u, out| epsilon_batch(u, out, end)),
        ("one_minus_epsilon", &|u| one_minus_epsilon(u, end), &|u, out| one_minus_epsilon_batch(u, out, end)),
        ("Restitution::epsilon", &|g| law.epsilon(g), &|g, out| law.epsilon_batch(g, out)),
        ("Restitution::one_minus_epsilon", &|g| law.one_minus_epsilon(g), &|g, out| {
            law.one_minus_epsilon_batch(g, out);
        }),
        ("Restitution::u", &|g| law.u(g), &|g, out| law.u_batch(g, out)),
    ];
    let mut sorted = arguments.to_vec();
    sorted.sort_by(f64::total_cmp);
    for pair in pairs {
        compare(arguments, pair, random, tally);
        compare(&sorted, pair, random, tally);
    }
    let inverses: [Pair; 2] = [
        ("u_of_epsilon", &|e| u_of_epsilon(e, end), &|e, out| u_of_epsilon_batch(e, out, end)),
        ("u_of_one_minus_epsilon", &|lost| u_of_one_minus_epsilon(lost, end), &|lost, out| {
            u_of_one_minus_epsilon_batch(lost, out, end);
        }),
    ];
    let kept: Vec<f64> = sorted.iter().map(|u| epsilon(*u, end)).collect();
    let lost: Vec<f64> = sorted.iter().map(|u| one_minus_epsilon(*u, end)).collect();
    for (inverse, coefficients) in inverses.into_iter().zip([kept, lost]) {
        compare(arguments, inverse, random, tally);
        compare(&coefficients, inverse, random, tally);
    }
}

fn compare(arguments: &[f64], (name, single, batch): Pair, random: &mut Source, tally: &mut Tally) {
    let mut out = vec![f64::from_bits(0x7ff8_dead_beef_0000); arguments.len()];
    let mut start = 0;
    while start < arguments.len() {
        let stop = arguments.len().min(start + random.random_range(1..200));
        batch(&arguments[start..stop], &mut out[start..stop]);
        start = stop;
    }
    for (x, batch) in arguments.iter().zip(&out) {
        let single = single(*x);
        tally.expect(same(single, *batch), "a batch gives what single calls give", || {
            format!("{name} at {x:e} = {:#018x}: {batch:e}, single {single:e}", x.to_bits())
        });
    }
}
