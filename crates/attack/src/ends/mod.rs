//! Violent ends: signals at random moments, limits on memory and file size, full devices, closed and broken streams.
//! What `-o` names is whole or as it was, and nothing else is left.

use crate::commands::{judge, quoted};
use crate::random::{Source, by_ratio, choose};
use crate::sandbox::{ADDRESS_SPACE, FILE_SIZE, Limits, Outcome, Sandbox, send};
use crate::{Part, Size, Tally};
use nix::sys::signal::Signal;
use rand::RngExt;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Requests that take some tenths of a second or write some hundred kilobytes.
const REQUESTS: [&str; 6] = [
    "table --order 20 --digits 60",
    "table --quantity h --order 12 --digits 40 --format csv",
    "trajectory --damping-order 4 --time-order 120 --format csv",
    "trajectory --damping-order 6 --time-order 240 --format json",
    "epsilon --u 0.1,0.2,0.5,1,2,3 --digits 60 --format json",
    "pade 6 8 --format csv",
];
/// Time that a command has to end after all.
const PATIENCE: Duration = Duration::from_secs(60);

/// Ends the command in every violent way.
#[derive(Debug)]
pub struct Ends {
    command: PathBuf,
    /// What each request writes, and how long it takes, undisturbed.
    undisturbed: Mutex<BTreeMap<&'static str, (Vec<u8>, Duration)>>,
}

impl Ends {
    /// Attacks the executable `command`.
    pub fn new(command: PathBuf) -> Self {
        Self { command, undisturbed: Mutex::default() }
    }

    fn undisturbed(&self, request: &'static str) -> std::io::Result<(Vec<u8>, Duration)> {
        let mut known = self.undisturbed.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = known.get(request) {
            return Ok(found.clone());
        }
        let started = Instant::now();
        let output = Command::new(&self.command).args(request.split(' ')).output()?;
        let found = (output.stdout, started.elapsed());
        known.insert(request, found.clone());
        Ok(found)
    }
}

impl Part for Ends {
    fn name(&self) -> &'static str {
        "ends"
    }

    fn about(&self) -> &'static str {
        "a signal, a limit, a full device, a closed or broken stream: the file is whole or as it was, nothing is left"
    }

    fn cases(&self, size: Size) -> u64 {
        match size {
            Size::Slice => 14,
            Size::Minutes => 300,
            Size::Full => 2_000,
        }
    }

    fn attack(&self, random: &mut Source, tally: &mut Tally) {
        let request = *choose(random, &REQUESTS);
        let attacked = self.undisturbed(request).and_then(|(whole, time)| {
            let case = Case { command: &self.command, request, whole, time, old: random.random_bool(0.5) };
            match random.random_range(0..10) {
                0..=5 => case.signal(random, tally),
                6 => case.memory(random, tally),
                7 => case.file_size(random, tally),
                8 => case.full_device(random, tally),
                _ => case.streams(random, tally),
            }
        });
        if let Err(error) = attacked {
            tally.fault("the command ends", format!("{request}: {error}"));
        }
    }
}

/// One request about to be disturbed.
struct Case<'a> {
    command: &'a Path,
    request: &'static str,
    whole: Vec<u8>,
    time: Duration,
    /// Whether the file is there before.
    old: bool,
}

/// Content of a file that was there before.
const OLD: &[u8] = b"as it was\n";

impl Case<'_> {
    fn line(&self, target: &str) -> Vec<OsString> {
        let mut line: Vec<OsString> = self.request.split(' ').map(OsString::from).collect();
        line.extend(["-o".into(), target.into()]);
        line
    }

    fn sandbox(&self) -> std::io::Result<Sandbox> {
        let sandbox = Sandbox::new()?;
        if self.old {
            std::fs::write(sandbox.folder().join("out"), OLD)?;
        }
        Ok(sandbox)
    }

    /// The file is whole or as it was; but for a kill, nothing else is left.
    fn file(&self, how: &str, outcome: &Outcome, sandbox: &Sandbox, may_leave: bool, tally: &mut Tally) {
        let show = || format!("{} {how} -> {}, stderr {:?}", self.request, outcome.code(), outcome.stderr);
        let content = std::fs::read(sandbox.folder().join("out")).ok();
        let whole = content.as_deref() == Some(&self.whole);
        let before = content.as_deref() == self.old.then_some(OLD);
        tally.expect(whole || before, "a file is whole or as it was", show);
        tally.expect(outcome.code() != 0 || whole, "a success has written its file", show);
        let others: Vec<_> =
            sandbox.files().unwrap_or_default().into_iter().filter(|name| name != "out").collect();
        tally.expect(may_leave || others.is_empty(), "nothing is left beside the file", || {
            format!("{} {others:?}", show())
        });
        tally.expect(!outcome.stderr.contains("panicked"), "no panic", show);
        if !others.is_empty() && may_leave {
            tally.count("temporary files left by kill -9", 1);
        }
    }

    fn signal(&self, random: &mut Source, tally: &mut Tally) -> std::io::Result<()> {
        let signal = *choose(random, &[Signal::SIGINT, Signal::SIGTERM, Signal::SIGKILL, Signal::SIGHUP]);
        let sandbox = self.sandbox()?;
        let limits = Limits { time: PATIENCE, ..Limits::default() };
        let child = sandbox.start(self.command, &self.line("out"), Stdio::null(), &limits)?;
        if random.random_bool(0.5) {
            std::thread::sleep(self.time.mul_f64(1.2 * random.random::<f64>()));
        } else {
            self.while_writing(&sandbox, random);
        }
        let sent = send(&child, signal).is_ok();
        let outcome = sandbox.finish(child, &limits)?;
        tally.count(&format!("{signal} sent"), 1);
        if outcome.code() != 0 {
            tally.count("commands that a signal ended", 1);
        }
        let expected = match signal {
            Signal::SIGINT => [0, 130, 130],
            Signal::SIGTERM => [0, 143, 130],
            Signal::SIGHUP => [0, 129, 130],
            _ => [0, 137, 137],
        };
        self.file(&format!("{signal}"), &outcome, &sandbox, signal == Signal::SIGKILL, tally);
        tally.expect(sent && expected.contains(&outcome.code()), "the exit code tells the signal", || {
            format!("{} {signal} -> {}", self.request, outcome.code())
        });
        Ok(())
    }

    /// Waits for the temporary file of the output, the first or the second that is made.
    fn while_writing(&self, sandbox: &Sandbox, random: &mut Source) {
        let (deadline, mut left, mut seen) =
            (Instant::now() + 3 * self.time, random.random_range(1..=2), false);
        while Instant::now() < deadline {
            let now = sandbox.files().is_ok_and(|files| files.iter().any(|name| name != "out"));
            left -= u32::from(now && !seen);
            if left == 0 {
                return;
            }
            seen = now;
        }
    }

    /// Too little memory ends in a line or in the allocator's own end, never in half a file.
    fn memory(&self, random: &mut Source, tally: &mut Tally) -> std::io::Result<()> {
        let address_space = by_ratio(random, 3e3, 3e5) as u64;
        let limits = Limits { address_space, time: PATIENCE, file_size: FILE_SIZE };
        let sandbox = self.sandbox()?;
        let outcome = sandbox.run(self.command, &self.line("out"), Stdio::null(), &limits)?;
        tally.count(&format!("limits on memory, exit code {}", outcome.code()), 1);
        self.file(&format!("ulimit -v {address_space}"), &outcome, &sandbox, false, tally);
        Ok(())
    }

    fn file_size(&self, random: &mut Source, tally: &mut Tally) -> std::io::Result<()> {
        let file_size = random.random_range(0..=self.whole.len() as u64 / 512 + 1);
        let limits = Limits { file_size, time: PATIENCE, address_space: ADDRESS_SPACE };
        let sandbox = self.sandbox()?;
        let outcome = sandbox.run(self.command, &self.line("out"), Stdio::null(), &limits)?;
        tally.count("limits on file size", 1);
        self.file(&format!("ulimit -f {file_size}"), &outcome, &sandbox, false, tally);
        tally.expect([0, 1].contains(&outcome.code()), "the exit code is 0, 1 or 2", || {
            format!("{} ulimit -f {file_size} -> {}", self.request, outcome.code())
        });
        Ok(())
    }

    fn full_device(&self, random: &mut Source, tally: &mut Tally) -> std::io::Result<()> {
        let target = *choose(random, &["full", "missing/out", "folder"]);
        let sandbox = Sandbox::new()?;
        let limits = Limits { time: PATIENCE, ..Limits::default() };
        let line = self.line(target);
        let outcome = sandbox.run(self.command, &line, Stdio::null(), &limits)?;
        tally.count("outputs that cannot be written", 1);
        judge(&line, &outcome, &sandbox, tally);
        tally.expect(outcome.code() == 1, "what cannot be written is a failure", || {
            format!("{} -> {}", quoted(&line), outcome.code())
        });
        Ok(())
    }

    /// A stream that is closed from the beginning, or whose reader goes away.
    fn streams(&self, random: &mut Source, tally: &mut Tally) -> std::io::Result<()> {
        tally.count("closed and broken streams", 1);
        let which = *choose(random, &["broken", ">&-", "<&-", "2>&-", ">&- 2>&- <&-"]);
        let mut command = Command::new("sh");
        let script = format!("exec \"$0\" \"$@\" {}", if which == "broken" { "" } else { which });
        command.args(["-c", &script]).arg(self.command).args(self.request.split(' '));
        let mut child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()?;
        if which == "broken" {
            let some = random.random_range(0..self.whole.len().max(1));
            if let Some(mut stdout) = child.stdout.take() {
                stdout.by_ref().take(some as u64).read_to_end(&mut Vec::new())?;
            }
        }
        let output = child.wait_with_output()?;
        let stderr = String::from_utf8_lossy(&output.stderr);
        let code = output.status.code().unwrap_or(-1);
        tally.expect(
            (code == 0 && stderr.is_empty()) || (code == 1 && which != "broken"),
            "a closed stream ends quietly",
            || format!("{} {which} -> {code}, stderr {stderr:?}", self.request),
        );
        Ok(())
    }
}
