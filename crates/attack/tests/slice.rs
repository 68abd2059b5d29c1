//! A fixed slice of every part; `make attack` does the rest.

use restitution_attack::state::State;
use restitution_attack::{Size, campaign, parts};
use std::path::PathBuf;

/// The seed of the slice.
const SEED: u64 = 1999;

fn slice_of(name: &str) {
    let command = PathBuf::from(env!("CARGO_BIN_EXE_restitution-attacked"));
    let part = parts::all(command).into_iter().find(|part| part.name() == name).expect("a part of this name");
    let multiplier =
        std::env::var("RESTITUTION_TEST_MULTIPLIER").map_or(1, |n| n.parse().expect("a whole number"));
    let mut state = State { seed: SEED, ..State::default() };
    campaign::run(part.as_ref(), part.cases(Size::Slice) * multiplier, &mut state, None)
        .expect("nothing to write");
    let tally = &state.parts[name].tally;
    println!("{}", tally.lines());
    assert_eq!(tally.faults_found(), 0, "{name}\n{}", tally.lines());
}

#[test]
fn f64_functions() {
    slice_of("f64");
}

#[test]
fn certified() {
    slice_of("certified");
}

#[test]
fn data_files() {
    slice_of("data");
}

#[test]
fn violent_ends() {
    slice_of("ends");
}

#[test]
fn exports() {
    slice_of("exports");
}

#[test]
fn commands() {
    slice_of("commands");
}

#[test]
fn parsers() {
    slice_of("parsers");
}
