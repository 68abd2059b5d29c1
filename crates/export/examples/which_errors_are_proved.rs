//! The errors of the evaluator and of its tiers, proved for every argument and not at points; takes some minutes.
//!
//! An argument n asks for every n-th interval alone.

use restitution::{End, tiers};
use restitution_direct::DirectError;
use restitution_export::proof::{Group, Proof, groups, saturated, tier_near_zero};

/// One tier: its name, its proof on an interval, and near 0.
type TierProof = (&'static str, fn(&Group) -> Result<f64, DirectError>, f64);

fn main() -> Result<(), DirectError> {
    let every = std::env::args().nth(1).and_then(|n| n.parse().ok()).unwrap_or(1);
    let mut tiers: [TierProof; 6] = [
        (
            "zero compression, 1e-3",
            |g| g.prove_tier(&tiers::ZERO_COMPRESSION_1E3),
            tier_near_zero(&tiers::ZERO_COMPRESSION_1E3),
        ),
        (
            "zero compression, 1e-6",
            |g| g.prove_tier(&tiers::ZERO_COMPRESSION_1E6),
            tier_near_zero(&tiers::ZERO_COMPRESSION_1E6),
        ),
        (
            "zero compression, 1e-9",
            |g| g.prove_tier(&tiers::ZERO_COMPRESSION_1E9),
            tier_near_zero(&tiers::ZERO_COMPRESSION_1E9),
        ),
        (
            "zero force, 1e-3",
            |g| g.prove_tier(&tiers::ZERO_FORCE_1E3),
            tier_near_zero(&tiers::ZERO_FORCE_1E3),
        ),
        (
            "zero force, 1e-6",
            |g| g.prove_tier(&tiers::ZERO_FORCE_1E6),
            tier_near_zero(&tiers::ZERO_FORCE_1E6),
        ),
        (
            "zero force, 1e-9",
            |g| g.prove_tier(&tiers::ZERO_FORCE_1E9),
            tier_near_zero(&tiers::ZERO_FORCE_1E9),
        ),
    ];
    for end in [End::ZeroCompression, End::ZeroForce] {
        let mut whole: Option<Proof> = None;
        for group in groups(end).into_iter().step_by(every) {
            let proved = group.prove()?;
            whole = Some(whole.map_or(proved, |whole| whole.and(proved)));
            for (_, prove, worst) in &mut tiers {
                *worst = worst.max(prove(&group)?);
            }
        }
        println!("{end:?}, up to the end of the table: {whole:#?}");
    }
    println!("ZeroCompression, from 8 on: {:#?}", saturated()?);
    for (name, _, worst) in tiers {
        println!("tier at {name}: {worst:.4e} relative");
    }
    Ok(())
}
