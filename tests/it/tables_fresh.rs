//! The evaluator's tables are what its exporter writes today; `make tables` writes them.

use crate::certified::reference;
use restitution::End;
use restitution_export::{constants, tier_tables, zero_compression_tables, zero_force_tables};
use restitution_law::ForceLaw;
use restitution_series::{Quantity, coefficients, turning_time};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/crates/restitution/src/evaluator/tables");

fn compare(file: &str, fresh: &str) {
    let committed = std::fs::read_to_string(format!("{FOLDER}/{file}")).unwrap();
    let differing = committed.lines().zip(fresh.lines()).position(|(old, new)| old != new);
    assert!(
        committed == fresh,
        "{file} differs from what is exported, first in line {differing:?} (from 0): run `make tables`"
    );
}

#[test]
fn the_tables_of_the_evaluator() {
    compare("zero_compression.rs", &zero_compression_tables(reference(End::ZeroCompression)));
    compare("zero_force.rs", &zero_force_tables(reference(End::ZeroForce)));
}

#[test]
fn the_tables_of_the_tiers() {
    let references = [reference(End::ZeroCompression), reference(End::ZeroForce)];
    compare("tiers.rs", &tier_tables(references).unwrap());
}

#[test]
fn the_constants_of_the_undamped_collision() {
    compare("constants.rs", &constants());
}

/// The closed forms of the constants against what the engine finds without them.
#[test]
fn the_constants_are_those_of_the_engine() {
    let text = constants();
    let value = |name: &str| -> f64 {
        let (_, rest) = text.split_once(&format!("{name}: f64 = ")).unwrap();
        rest.split_once(';').unwrap().0.parse().unwrap()
    };
    let spheres = ForceLaw::viscoelastic_spheres();
    let engine = |quantity, k: usize| coefficients(quantity, &spheres, 1, 30).unwrap()[k].mid().to_f64();
    assert_eq!(value("SLOPE"), -engine(Quantity::Restitution, 1));
    assert_eq!(value("ELASTIC_COMPRESSION"), engine(Quantity::Compression, 0));
    assert_eq!(value("ELASTIC_DURATION"), 2.0 * turning_time(&spheres, 160).mid().to_f64());
}
