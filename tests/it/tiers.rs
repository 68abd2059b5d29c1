//! The cheaper tiers keep their tolerance.

use crate::certified::{exact, reference};
use restitution::{epsilon, tiers};
use rug::Float;

macro_rules! check {
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
    check!(tiers::ZERO_COMPRESSION_1E3);
    check!(tiers::ZERO_COMPRESSION_1E6);
    check!(tiers::ZERO_COMPRESSION_1E9);
    check!(tiers::ZERO_FORCE_1E3);
    check!(tiers::ZERO_FORCE_1E6);
    check!(tiers::ZERO_FORCE_1E9);
}
