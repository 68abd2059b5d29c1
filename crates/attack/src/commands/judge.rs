//! What every end of the command has to look like.

use crate::Tally;
use crate::sandbox::{Outcome, Sandbox};
use std::ffi::OsString;
use std::os::unix::ffi::OsStrExt;

/// Characters that a message on stderr may have.
const LONGEST_MESSAGE: usize = 500;
/// Exit code of a command that was interrupted.
const INTERRUPTED: i32 = 130;

/// Returns the arguments as a shell would take them.
pub fn quoted(line: &[OsString]) -> String {
    let word = |word: &OsString| {
        let shown: String = word.as_bytes().escape_ascii().to_string();
        let shown =
            if shown.len() > 120 { format!("{}… ({} bytes)", &shown[..100], word.len()) } else { shown };
        if shown.is_empty() || shown.contains([' ', '\\', ';', '|', '*']) {
            format!("$'{shown}'")
        } else {
            shown
        }
    };
    line.iter().map(word).collect::<Vec<_>>().join(" ")
}

/// Checks exit code, messages, output and files of a run.
pub fn judge(line: &[OsString], outcome: &Outcome, sandbox: &Sandbox, tally: &mut Tally) {
    let code = outcome.code();
    let show = || {
        let stderr: String = outcome.stderr.chars().take(300).collect();
        let stdout = String::from_utf8_lossy(&outcome.stdout[..outcome.stdout.len().min(100)]);
        format!("{} -> {code}, stderr {stderr:?}, stdout {stdout:?}", quoted(line))
    };
    let panicked =
        ["panicked", "RUST_BACKTRACE", "internal error"].iter().any(|sign| outcome.stderr.contains(sign));
    tally.expect(!panicked, "no panic", show);
    let files = sandbox.files().unwrap_or_default();
    if outcome.interrupted && code == INTERRUPTED {
        tally.example("interrupted after some seconds", quoted(line));
        tally.expect(files.is_empty(), "an interrupted command leaves no file", || {
            format!("{} and {files:?}", show())
        });
        return;
    }
    tally.count(&format!("exit code {code}"), 1);
    tally.expect([0, 1, 2].contains(&code), "the exit code is 0, 1 or 2", show);
    let hidden = files.iter().any(|name| name.to_string_lossy().contains(".restitution-"));
    tally.expect(!hidden, "no temporary file is left", || format!("{} and {files:?}", show()));
    if code == 0 {
        success(line, outcome, &files, tally, &show);
    } else {
        tally.expect(files.is_empty(), "a failure leaves no file", || format!("{} and {files:?}", show()));
        tally.expect(outcome.stdout.is_empty(), "a failure prints nothing on stdout", show);
        tally.expect(is_one_line(&outcome.stderr), "a failure is one clear line on stderr", show);
    }
}

fn is_one_line(stderr: &str) -> bool {
    let line = stderr.strip_suffix('\n').unwrap_or("\n");
    line.starts_with("restitution: ")
        && line.len() > "restitution: ".len() + 8
        && line.chars().count() <= LONGEST_MESSAGE
        && !line.chars().any(char::is_control)
}

fn success(
    line: &[OsString],
    outcome: &Outcome,
    files: &[OsString],
    tally: &mut Tally,
    show: &dyn Fn() -> String,
) {
    let names_output = line.iter().any(|word| {
        let word = word.as_bytes();
        word.starts_with(b"-o") || word.starts_with(b"--o")
    });
    let said = &outcome.stderr;
    let partly = said.starts_with("restitution: no value for ") && said.lines().count() == 1;
    tally.count("lists answered in part", u64::from(partly));
    tally.expect(partly || said.is_empty(), "a success says on stderr only which values there are not", show);
    tally.expect(names_output || !outcome.stdout.is_empty(), "a success prints something", show);
    tally.expect(files.is_empty() || names_output, "no file that was not asked for", || {
        format!("{} and {files:?}", show())
    });
    let text = String::from_utf8_lossy(&outcome.stdout);
    let prints_source =
        line.first().is_some_and(|word| ["export", "completions", "page"].iter().any(|name| word == name));
    if !prints_source {
        let interval = text.replace(", inf)", ""); // [0, inf) is a sound set
        let mut words = interval.split(|c: char| !c.is_alphanumeric());
        let unsound = words.any(|word| ["NaN", "nan", "inf"].contains(&word));
        tally.expect(!unsound, "no NaN and no infinity in a table", || {
            let at =
                text.lines().find(|line| line.contains("NaN") || line.contains("inf")).unwrap_or_default();
            format!("{} has {at:?}", show())
        });
    }
    let asks = |format: &str| line.iter().any(|word| word.to_string_lossy().ends_with(format));
    if asks("json")
        && !prints_source
        && !text.is_empty()
        && line.iter().any(|word| word.to_string_lossy().starts_with("--format"))
    {
        let sound = serde_json::from_str::<serde_json::Value>(&text).is_ok();
        tally.expect(sound || text.contains("Usage:"), "JSON is JSON", show);
    }
}
