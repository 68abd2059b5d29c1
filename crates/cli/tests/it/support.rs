//! Runs the real command.

use std::path::Path;
use std::process::{Command, Output};

/// Returns the command with these arguments, words of one line.
pub fn restitution(line: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_restitution"));
    command.args(line.split_whitespace());
    command
}

/// Runs the command and returns what it printed; it must succeed and say nothing on stderr.
pub fn succeed(line: &str) -> String {
    let output = restitution(line).output().unwrap();
    assert!(output.status.success() && output.stderr.is_empty(), "{line}: {output:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// Runs the command, which must print nothing but one line on stderr, and returns exit code and line.
pub fn fail(line: &str) -> (i32, String) {
    one_line(&restitution(line).output().unwrap())
}

/// Returns the exit code and the one line on stderr of a run that printed nothing else.
pub fn one_line(output: &Output) -> (i32, String) {
    let message = String::from_utf8(output.stderr.clone()).unwrap();
    assert!(output.stdout.is_empty(), "{output:?}");
    assert_eq!(message.matches('\n').count(), 1, "{message}");
    assert!(message.starts_with("restitution: ") && !message.contains("panicked"), "{message}");
    let code = output.status.code().expect("ended by itself");
    (code, message["restitution: ".len()..].trim_end().to_owned())
}

/// Returns the names of the files in a folder, sorted.
pub fn files(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect::<Vec<_>>();
    names.sort();
    names
}
