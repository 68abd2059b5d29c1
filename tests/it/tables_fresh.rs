//! The evaluator's tables are what its exporter writes today.

use crate::certified::reference;
use restitution::End;
use restitution_export::{tier_tables, zero_compression_tables, zero_force_tables};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/crates/restitution/src/tables");

fn compare(file: &str, fresh: &str) {
    let committed = std::fs::read_to_string(format!("{FOLDER}/{file}")).unwrap();
    let differing = committed.lines().zip(fresh.lines()).position(|(old, new)| old != new);
    assert!(committed == fresh, "{file} differs from what is exported, first in line {differing:?} (from 0)");
}

#[test]
fn the_tables_of_the_evaluator() {
    compare("zero_compression.rs", &zero_compression_tables(reference(End::ZeroCompression)).unwrap());
    compare("zero_force.rs", &zero_force_tables(reference(End::ZeroForce)).unwrap());
}

#[test]
fn the_tables_of_the_tiers() {
    let references = [reference(End::ZeroCompression), reference(End::ZeroForce)];
    compare("tiers.rs", &tier_tables(references).unwrap());
}
