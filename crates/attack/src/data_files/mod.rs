//! Data files for `fit` from a grammar, with mutations: a file is understood or refused, never misread.

mod mutation;
mod table;

pub use mutation::mutate;
pub use table::Written;

use crate::commands::{judge, quoted};
use crate::random::{Source, choose};
use crate::sandbox::{Limits, Outcome, Sandbox};
use crate::{Part, Size, Tally};
use rand::RngExt;
use restitution::End;
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::Stdio;
use std::time::Duration;

/// By how much a fitted `g*` may differ from the true one: cells have five digits, and `g*` is the fifth power of a slope.
const TOLERANCE: f64 = 0.02;

/// Fits random files.
#[derive(Debug)]
pub struct DataFiles {
    command: PathBuf,
}

impl DataFiles {
    /// Attacks the executable `command`.
    pub fn new(command: PathBuf) -> Self {
        Self { command }
    }
}

impl Part for DataFiles {
    fn name(&self) -> &'static str {
        "data"
    }

    fn about(&self) -> &'static str {
        "a table of measurements in some way of writing, mutated or not: read rightly or refused in one line"
    }

    fn cases(&self, size: Size) -> u64 {
        match size {
            Size::Slice => 150,
            Size::Minutes => 3_000,
            Size::Full => 10_000,
        }
    }

    fn attack(&self, random: &mut Source, tally: &mut Tally) {
        tally.count("data files", 1);
        let written = Written::new(random);
        let mut bytes = written.bytes.clone();
        let mutations = *choose(random, &[0, 0, 1, 1, 2, 6]);
        for _ in 0..mutations {
            mutate(&mut bytes, random);
        }
        let sandbox = match Sandbox::new() {
            Ok(sandbox) => sandbox,
            Err(error) => return tally.fault("the harness works", error),
        };
        let from_stdin = random.random_bool(0.2);
        let name = sandbox.outside("data");
        if let Err(error) = std::fs::write(&name, &bytes) {
            return tally.fault("the harness works", error);
        }
        let end = if written.end == End::ZeroForce { "zero-force" } else { "zero-compression" };
        let file: OsString = if from_stdin { "-".into() } else { name.clone().into() };
        let mut line: Vec<OsString> = vec!["fit".into(), file, "--end".into(), end.into(), "--format".into()];
        line.push(if random.random_bool(0.8) { "csv" } else { "json" }.into());
        if random.random_bool(0.1) {
            line.extend(["--table".into(), "residuals".into()]);
        }
        let stdin = match std::fs::File::open(&name) {
            Ok(file) if from_stdin => file.into(),
            _ => Stdio::null(),
        };
        let limits = Limits { time: Duration::from_secs(10), ..Limits::default() };
        match sandbox.run(&self.command, &line, stdin, &limits) {
            Ok(outcome) => {
                judge(&line, &outcome, &sandbox, tally);
                if mutations == 0 {
                    read_rightly(&written, &outcome, tally);
                }
            }
            Err(error) => tally.fault("the command ends", format!("{}: {error}", quoted(&line))),
        }
    }
}

/// A file without mutations gives its own `g*`, or is refused.
fn read_rightly(written: &Written, outcome: &Outcome, tally: &mut Tally) {
    let beginning: String = String::from_utf8_lossy(&written.bytes).chars().take(160).collect();
    if outcome.code() != 0 {
        let kind = outcome.stderr.split('\'').next_back().unwrap_or_default().trim();
        let kind: String = kind.chars().filter(|c| !c.is_ascii_digit()).take(80).collect();
        return tally.example(&format!("sound files refused: {kind}"), format!("{beginning:?}"));
    }
    let text = String::from_utf8_lossy(&outcome.stdout);
    let Some((value, unit)) = characteristic_velocity(&text) else { return };
    let Some(unit) = table::metres_per_second(&unit) else {
        return tally.fault("a unit that was given or m/s", format!("{unit:?} for {beginning:?}"));
    };
    tally.count("files read", 1);
    let off = (value * unit / written.g_star).ln().abs();
    tally.measure("relative error of a fitted g*", off);
    tally.expect(off <= TOLERANCE, "a file is read rightly or refused", || {
        format!("g* = {} m/s, not {}: {beginning:?}", value * unit, written.g_star)
    });
}

/// The row of `g*` in a table that was printed as CSV.
fn characteristic_velocity(text: &str) -> Option<(f64, String)> {
    let row = text.lines().find(|line| line.starts_with("characteristic velocity,"))?;
    let cells: Vec<&str> = row.split(',').collect();
    Some((cells.get(2)?.parse().ok()?, cells.get(3)?.to_string()))
}
