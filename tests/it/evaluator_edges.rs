//! The f64 evaluator at its edges: breakpoints, neighbours, bit patterns; batches against single calls.

use proptest::prelude::Rng;
use restitution::{
    End, Restitution, epsilon, epsilon_batch, one_minus_epsilon, one_minus_epsilon_batch, u_of_epsilon,
    u_of_epsilon_batch, u_of_one_minus_epsilon, u_of_one_minus_epsilon_batch,
};

const ENDS: [End; 2] = [End::ZeroCompression, End::ZeroForce];

/// Every place where a form or a piece ends.
fn breakpoints() -> Vec<f64> {
    let compression = (0..=450).map(|i| f64::from(i) / 64.0);
    let force = (0..12 * 64).map(|i| (0.5 + f64::from(i % 64) / 128.0) * 2.0_f64.powi(i / 64) - 0.5);
    let powers = (-1074..1024).step_by(9).map(|e| 2.0_f64.powi(e));
    let roots = (0..=17).map(|i| (f64::from(i) / 64.0).powi(2));
    let beyond = (0..=256).map(|i| 8.0 + f64::from(i) / 32.0);
    compression
        .chain(force)
        .chain(roots)
        .chain(beyond)
        .chain(powers)
        .chain([f64::MAX, f64::MIN_POSITIVE])
        .collect()
}

/// The arguments within three units of the last place of `u`, and `u` with its sign turned.
fn around(u: f64) -> impl Iterator<Item = f64> + Clone {
    let down = u.next_down().next_down().next_down();
    std::iter::successors(Some(down), |u| Some(u.next_up())).take(7).chain([-u])
}

fn not_numbers() -> [f64; 6] {
    let pattern = |bits: u64| f64::from_bits(bits);
    let quiet = [pattern(0x7ff8 << 48), pattern(0xfff8 << 48), pattern(u64::MAX)];
    [quiet[0], quiet[1], quiet[2], pattern((0x7ff0 << 48) | 1), pattern((0xfff0 << 48) | 1), -f64::NAN]
}

/// Every batch against the single calls, to the bit.
fn compare(arguments: &[f64], end: End) {
    let law = Restitution::from_u_at_unit_velocity(1.0, end);
    let mut out = vec![0.0; arguments.len()];
    let mut check = |batch: &dyn Fn(&[f64], &mut [f64]), single: &dyn Fn(f64) -> f64, what: &str| {
        batch(arguments, &mut out);
        for (u, value) in arguments.iter().zip(&out) {
            let alone = single(*u);
            let same = value.to_bits() == alone.to_bits() || value.is_nan() && alone.is_nan();
            assert!(same, "{what}, {end:?}, {u:e} ({:#x}): {value:e}, alone {alone:e}", u.to_bits());
        }
    };
    check(&|u, out| epsilon_batch(u, out, end), &|u| epsilon(u, end), "epsilon");
    check(&|u, out| one_minus_epsilon_batch(u, out, end), &|u| one_minus_epsilon(u, end), "1 - epsilon");
    check(&|g, out| law.epsilon_batch(g, out), &|g| law.epsilon(g), "epsilon of velocities");
    check(
        &|g, out| law.one_minus_epsilon_batch(g, out),
        &|g| law.one_minus_epsilon(g),
        "1 - epsilon of velocities",
    );
    check(&|g, out| law.u_batch(g, out), &|g| law.u(g), "u of velocities");
    check(&|e, out| u_of_epsilon_batch(e, out, end), &|e| u_of_epsilon(e, end), "u of epsilon");
    check(
        &|e, out| u_of_one_minus_epsilon_batch(e, out, end),
        &|e| u_of_one_minus_epsilon(e, end),
        "u of 1 - epsilon",
    );
}

#[test]
fn batches_at_every_breakpoint_and_its_neighbours() {
    for end in ENDS {
        for u in breakpoints() {
            // Alone, among small, among middling and among large ones: the form is chosen by block.
            for others in [&[][..], &[0.01, 0.02], &[0.5, 3.0], &[500.0, 30.0], &[1e9, f64::NAN]] {
                let others = others.iter().copied().cycle().take(if others.is_empty() { 0 } else { 30 });
                let block: Vec<f64> = around(u).chain(others).collect();
                compare(&block, end);
            }
            let filled: Vec<f64> = around(u).cycle().take(64).collect(); // two blocks of nothing else
            compare(&filled, end);
            let from_velocity: Vec<f64> = filled.iter().map(|u| u.powi(5)).collect();
            compare(&from_velocity, end);
            let (kept, lost) = (epsilon(u.abs(), end), one_minus_epsilon(u.abs(), end));
            for coefficient in [kept, lost] {
                compare(&around(coefficient).cycle().take(64).collect::<Vec<_>>(), end);
            }
        }
    }
}

#[test]
fn batches_of_random_bit_patterns() {
    let mut random = crate::support::generator(16, 3);
    let patterns: Vec<f64> = (0..crate::support::cases(200_000))
        .map(|_| {
            f64::from_bits(u64::from(random.rng().next_u32()) << 32 | u64::from(random.rng().next_u32()))
        })
        .collect();
    for end in ENDS {
        compare(&patterns, end);
        for u in &patterns {
            let (kept, lost) = (epsilon(*u, end), one_minus_epsilon(*u, end));
            assert_eq!(kept.is_nan(), u.is_nan() || *u < 0.0, "{u:e}");
            assert_eq!(lost.is_nan(), u.is_nan() || *u < 0.0, "{u:e}");
            assert!(kept.is_nan() || (0.0..=1.0).contains(&kept) && (0.0..=1.0).contains(&lost), "{u:e}");
        }
    }
}

/// With overflow checks on, as in this profile: nothing that is no number makes a panic.
#[test]
fn what_is_no_number_stays_none() {
    for end in ENDS {
        let laws = [1e-300, 1.0, 1e300, f64::NAN].map(|g_star| Restitution::from_g_star(g_star, end));
        for nan in not_numbers() {
            assert!(epsilon(nan, end).is_nan() && one_minus_epsilon(nan, end).is_nan());
            assert!(u_of_epsilon(nan, end).is_nan() && restitution::fifth_root(nan).is_nan());
            compare(&[nan; 40], end);
            for law in laws {
                assert!(law.epsilon(nan).is_nan() && law.one_minus_epsilon(nan).is_nan());
                assert!(law.u(nan).is_nan() && law.velocity(nan).is_nan());
                let mut out = [0.0; 3];
                law.epsilon_batch(&[nan, 1.0, -1.0], &mut out);
                assert!(out[0].is_nan() && out[2].is_nan());
            }
        }
    }
}

/// `epsilon` falls but for rounding.
#[test]
fn between_neighbours_epsilon_rises_by_an_ulp_at_most() {
    let mut random = crate::support::generator(16, 5);
    for end in ENDS {
        let mut rises = 0;
        for _ in 0..crate::support::cases(1000) {
            let spread = f64::from(random.rng().next_u32()) / f64::from(u32::MAX);
            let start = 1e-3 * 1e6_f64.powf(spread);
            let values = std::iter::successors(Some(start), |u| Some(u.next_up())).take(200);
            let values: Vec<f64> = values.map(|u| epsilon(u, end)).collect();
            for pair in values.windows(2) {
                let limit = restitution::bounds::STEP_UP.size;
                assert!(
                    (pair[1] - pair[0]) / (pair[0].next_up() - pair[0]) <= limit,
                    "{end:?} after {start:e}"
                );
                rises += usize::from(pair[1] > pair[0]);
            }
        }
        println!("{end:?}: {rises} rises");
    }
}
