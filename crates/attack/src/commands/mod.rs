//! Command lines from the grammar that the command itself declares, with mutations.

mod grammar;
mod judge;
mod mutation;
mod values;

pub use grammar::{Grammar, is_slow};
pub use judge::{judge, quoted};
pub use mutation::mutate;

use crate::random::{Source, choose};
use crate::sandbox::{Limits, Sandbox};
use crate::{Part, Size, Tally};
use rand::RngExt;
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::Stdio;
use std::time::Duration;

/// Runs the command with random arguments.
#[derive(Debug)]
pub struct Commands {
    command: PathBuf,
    grammar: Grammar,
}

impl Commands {
    /// Attacks the executable `command`.
    pub fn new(command: PathBuf) -> Self {
        Self { command, grammar: Grammar::of(restitution_cli::commands::command()) }
    }
}

impl Part for Commands {
    fn name(&self) -> &'static str {
        "commands"
    }

    fn about(&self) -> &'static str {
        "a command line from the grammar, mutated: exit code, one line on stderr, no file left, sound output"
    }

    fn cases(&self, size: Size) -> u64 {
        match size {
            Size::Slice => 150,
            Size::Minutes => 10_000,
            Size::Full => 100_000,
        }
    }

    fn attack(&self, random: &mut Source, tally: &mut Tally) {
        let mut line = self.grammar.line(random);
        let mutations = *choose(random, &[0, 0, 0, 1, 1, 2, 5]);
        for _ in 0..mutations {
            mutate(&mut line, random);
        }
        let line = harmless(line);
        tally.count("command lines", 1);
        let sandbox = match Sandbox::new() {
            Ok(sandbox) => sandbox,
            Err(error) => return tally.fault("the harness works", error),
        };
        let stdin = if random.random_bool(0.9) { Stdio::null() } else { data_on_stdin() };
        let slow = line.first().and_then(|word| word.to_str()).is_some_and(is_slow);
        let limits = Limits { time: Duration::from_secs(if slow { 30 } else { 2 }), ..Limits::default() };
        match sandbox.run(&self.command, &line, stdin, &limits) {
            Ok(outcome) => judge(&line, &outcome, &sandbox, tally),
            Err(error) => tally.fault("the command ends", format!("{}: {error}", quoted(&line))),
        }
    }
}

/// Some measurements that `fit -` may read.
fn data_on_stdin() -> Stdio {
    let Ok((reader, mut writer)) = std::io::pipe() else { return Stdio::null() };
    let _ = std::io::Write::write_all(&mut writer, b"g,epsilon\n0.01,0.9\n0.1,0.85\n1,0.8\n");
    reader.into()
}

/// Keeps a mutated path inside the sandbox: no argument names an absolute path or a folder above.
fn harmless(line: Vec<OsString>) -> Vec<OsString> {
    use std::os::unix::ffi::{OsStrExt, OsStringExt};
    let tame = |argument: OsString| {
        let mut bytes = argument.as_bytes().to_vec();
        bytes.retain(|byte| *byte != 0); // no argument can hold one
        for i in 0..bytes.len() {
            let before = i.checked_sub(1).map(|i| bytes[i]);
            let starts = !before.is_some_and(|before| before.is_ascii_alphanumeric() || before == b')');
            if bytes[i] == b'/' && (starts || (i == 2 && bytes.starts_with(b"-o"))) {
                bytes[i] = b'_';
            }
        }
        OsString::from_vec(bytes)
    };
    line.into_iter().map(tame).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_path_leads_out_of_the_sandbox() {
        let tame = |text: &str| harmless(vec![text.into()])[0].clone().into_string().unwrap();
        for (text, tamed) in
            [("/etc", "_etc"), ("../x", ".._x"), ("-o/x", "-o_x"), ("--output=/x", "--output=_x")]
        {
            assert_eq!(tame(text), tamed);
        }
        for text in ["3/2,1/2", "folder/x", "1cm/s"] {
            assert_eq!(tame(text), text);
        }
    }
}
