//! What tests share: the place of snapshots, seeded random numbers, how deep to test.

use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// Runs `body` with its snapshots in `<workspace>/snapshots/<area>/`.
pub fn in_snapshots(area: &str, body: impl FnOnce()) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(format!("{}/snapshots/{area}", env!("CARGO_MANIFEST_DIR")));
    settings.set_prepend_module_to_snapshot(false); // file name = the name given, nothing else
    settings.set_omit_expression(true);
    settings.bind(body);
}

/// Returns `n` times `RESTITUTION_TEST_MULTIPLIER`, which is 1 unless it is set for a deeper run.
pub fn cases(n: usize) -> usize {
    let multiplier = std::env::var("RESTITUTION_TEST_MULTIPLIER").unwrap_or_else(|_| "1".to_owned());
    n * multiplier.parse::<usize>().expect("RESTITUTION_TEST_MULTIPLIER is a whole number")
}

/// Returns a source of random values that gives the same ones in every run.
///
/// Use it with proptest's strategies: `strategy.new_tree(&mut runner)?.current()`, or
/// `runner.run(&strategy, test)` for `cases` many.
pub fn generator(seed: u64, cases: usize) -> TestRunner {
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    let cases = u32::try_from(cases).unwrap_or(u32::MAX);
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &bytes))
}

#[test]
fn a_generator_repeats_itself() {
    use proptest::prelude::Rng;
    let draw = |seed| generator(seed, cases(1)).rng().next_u64();
    assert_eq!(draw(1), draw(1));
    assert_ne!(draw(1), draw(2));
}
