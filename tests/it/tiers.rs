//! The cheaper tiers keep their tolerance, start at 1 and never rise.

use crate::certified::{exact, reference};
use crate::support::{cases, generator};
use proptest::prelude::Rng;
use restitution::{epsilon, tiers};
use rug::Float;

macro_rules! for_every_tier {
    ($check:ident) => {
        $check!(tiers::ZERO_COMPRESSION_1E3);
        $check!(tiers::ZERO_COMPRESSION_1E6);
        $check!(tiers::ZERO_COMPRESSION_1E9);
        $check!(tiers::ZERO_FORCE_1E3);
        $check!(tiers::ZERO_FORCE_1E6);
        $check!(tiers::ZERO_FORCE_1E9);
    };
}

macro_rules! keeps_its_tolerance {
    ($tier:expr) => {{
        let tier = &$tier;
        let reference = reference(tier.end());
        let mut worst = 0.0_f64;
        let even = (0..12_000).map(|i| f64::from(i) / 12_000.0 * tier.far());
        let breakpoints =
            (0..4096).map(|i| f64::from(i) / 512.0).flat_map(|u| [u.next_down(), u, u.next_up()]);
        let points: Vec<f64> = even.chain(breakpoints).filter(|u| *u >= 0.0).chain([tier.far()]).collect();
        let mut batch = vec![0.0; points.len()];
        tier.epsilon_batch(&points, &mut batch);
        for (u, batch) in points.iter().zip(&batch) {
            let (_, kept) = exact(reference, *u);
            assert_eq!(tier.epsilon(*u).to_bits(), batch.to_bits());
            worst = worst.max((Float::with_val(112, batch - &kept) / kept).to_f64().abs());
        }
        println!("{}: {worst:.2e} of {:e}", stringify!($tier), tier.tolerance());
        assert!(worst <= tier.tolerance());
        assert!(worst >= tier.tolerance() / 1000.0, "a tier that keeps so much more costs too much");
        assert_eq!(tier.epsilon(100.0), epsilon(100.0, tier.end()));
        assert!(tier.epsilon(-1e-9).is_nan() && tier.epsilon(f64::NAN).is_nan());
    }};
}

#[test]
fn every_tier_keeps_its_tolerance() {
    for_every_tier!(keeps_its_tolerance);
}

/// Neighbouring f64s around every breakpoint, around random points, and around the end of the table.
macro_rules! never_rises {
    ($tier:expr) => {{
        let tier = &$tier;
        assert_eq!((tier.epsilon(0.0), tier.epsilon(-0.0), tier.epsilon(5e-324)), (1.0, 1.0, 1.0));
        let mut random = generator(11, 1);
        let breakpoints = (0..=8192).map(|i| f64::from(i) / 1024.0);
        let mut draw = || f64::from(random.rng().next_u32()) / f64::from(u32::MAX);
        let others: Vec<f64> = (0..cases(4000)).map(|_| draw().powi(3) * tier.far()).collect();
        for (u, spacing) in breakpoints.chain(others).flat_map(|u| [(u, 0.0_f64), (u, 2e-16), (u, 1e-12)]) {
            let mut x = (u - 16.0 * spacing.max(u * 1.2e-16)).max(0.0);
            let mut last = tier.epsilon(x);
            assert!((0.0..=1.0).contains(&last));
            for _ in 0..32 {
                let next = x.next_up().max(x + spacing);
                let value = tier.epsilon(next);
                assert!(value <= last, "{}: {x:e} {last:e}, {next:e} {value:e}", stringify!($tier));
                (x, last) = (next, value);
            }
        }
    }};
}

#[test]
fn no_tier_creates_energy_or_rises() {
    for_every_tier!(never_rises);
}
