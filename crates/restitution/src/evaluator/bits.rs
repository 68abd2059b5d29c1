//! The bits of every function, pinned: a value is the same on every machine and in every build that rounds products and sums apart.
//!
//! What the values are worth is tested elsewhere, against certified ones; here any change of a bit is noticed, and in which range.
//! Whoever changes a form or a table runs the proofs and the attack on it first, then puts what the failing test prints into `bits.txt`.

use super::tiers::{
    ZERO_COMPRESSION_1E3, ZERO_COMPRESSION_1E6, ZERO_COMPRESSION_1E9, ZERO_FORCE_1E3, ZERO_FORCE_1E6,
    ZERO_FORCE_1E9,
};
use super::{End, Restitution, epsilon, fifth_root, one_minus_epsilon, u_of_epsilon, u_of_one_minus_epsilon};

/// Arguments in each range.
const EACH: u64 = 8192;

/// SplitMix64 (Steele, Lea and Flood 2014).
fn random(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// The hash (FNV-1a) of the values at both ends of a range, at their neighbours and at random bits in between.
fn hash(low: f64, high: f64, function: &dyn Fn(f64) -> f64) -> u64 {
    let (first, last) = (low.to_bits(), high.to_bits());
    let mut state = first ^ last.rotate_left(32);
    let edges = [low, low.next_up(), high.next_down(), high];
    let inside = (0..EACH).map(|_| f64::from_bits(first + random(&mut state) % (last - first)));
    edges.into_iter().chain(inside).fold(0xcbf2_9ce4_8422_2325, |hash, x| {
        let value = function(x);
        let bits = if value.is_nan() { f64::NAN.to_bits() } else { value.to_bits() };
        bits.to_le_bytes()
            .iter()
            .fold(hash, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
    })
}

/// A line for each range between `edges`: the name of a function, the range, the hash.
fn lines(name: &str, edges: &[f64], function: &dyn Fn(f64) -> f64) -> Vec<String> {
    let line = |range: &[f64]| {
        let [low, high] = [range[0], range[1]];
        format!("{name}, {low:e} to {high:e}: {:016x}", hash(low, high, function))
    };
    edges.windows(2).map(line).collect()
}

/// From 0 over where nothing is lost, the forms near 0, the tables and the power laws to infinity.
const DAMPINGS: [f64; 16] = [
    0.0,
    f64::MIN_POSITIVE,
    1e-17,
    1e-12,
    0.002,
    0.25,
    1.0,
    8.0,
    256.0,
    1023.5,
    1e4,
    1e30,
    1e60,
    1e65,
    1e90,
    f64::INFINITY,
];
/// Through every power of the velocity's range, so that products with the factors leave it on both sides.
const VELOCITIES: [f64; 11] =
    [0.0, f64::MIN_POSITIVE, 1e-200, 1e-60, 1e-12, 1.0, 1e4, 1e15, 1e60, 1e200, f64::INFINITY];
/// What is kept, and what is lost.
const SHARES: [f64; 15] = [
    0.0,
    f64::MIN_POSITIVE,
    1e-300,
    1e-100,
    1e-30,
    1e-13,
    1e-9,
    1e-5,
    0.01,
    0.3,
    0.5,
    0.9,
    0.999,
    0.999_999_999,
    1.0,
];
const FACTORS: [f64; 3] = [3.7, 1e-300, 1e300];

#[test]
fn every_function_keeps_its_bits() {
    let mut found = lines("fifth root", &VELOCITIES[1..], &fifth_root);
    for end in [End::ZeroCompression, End::ZeroForce] {
        let mut add = |name: &str, edges: &[f64], function: &dyn Fn(f64) -> f64| {
            found.extend(lines(&format!("{name}, {end:?}"), edges, function));
        };
        add("epsilon", &DAMPINGS, &|u| epsilon(u, end));
        add("1 - epsilon", &DAMPINGS, &|u| one_minus_epsilon(u, end));
        add("u of epsilon", &SHARES, &|kept| u_of_epsilon(kept, end));
        add("u of 1 - epsilon", &SHARES, &|lost| u_of_one_minus_epsilon(lost, end));
        for factor in FACTORS {
            let law = Restitution::from_factor(factor, end);
            add(&format!("epsilon of velocities, {factor:e}"), &VELOCITIES, &|g| law.epsilon(g));
            add(&format!("1 - epsilon of velocities, {factor:e}"), &VELOCITIES, &|g| {
                law.one_minus_epsilon(g)
            });
        }
    }
    for factor in FACTORS {
        let law = Restitution::from_factor(factor, End::ZeroForce);
        found.extend(lines(&format!("u of velocities, {factor:e}"), &VELOCITIES, &|g| law.u(g)));
        found.extend(lines(&format!("velocity of u, {factor:e}"), &DAMPINGS, &|u| law.velocity(u)));
    }
    found.extend(lines("tier 1e-3, ZeroCompression", &DAMPINGS, &|u| ZERO_COMPRESSION_1E3.epsilon(u)));
    found.extend(lines("tier 1e-6, ZeroCompression", &DAMPINGS, &|u| ZERO_COMPRESSION_1E6.epsilon(u)));
    found.extend(lines("tier 1e-9, ZeroCompression", &DAMPINGS, &|u| ZERO_COMPRESSION_1E9.epsilon(u)));
    found.extend(lines("tier 1e-3, ZeroForce", &DAMPINGS, &|u| ZERO_FORCE_1E3.epsilon(u)));
    found.extend(lines("tier 1e-6, ZeroForce", &DAMPINGS, &|u| ZERO_FORCE_1E6.epsilon(u)));
    found.extend(lines("tier 1e-9, ZeroForce", &DAMPINGS, &|u| ZERO_FORCE_1E9.epsilon(u)));
    let known: Vec<&str> = include_str!("bits.txt").lines().collect();
    let changed: Vec<_> = found.iter().filter(|line| !known.contains(&line.as_str())).collect();
    assert!(
        known.len() == found.len() && changed.is_empty(),
        "changed: {changed:#?}\n\nall:\n{}",
        found.join("\n")
    );
}
