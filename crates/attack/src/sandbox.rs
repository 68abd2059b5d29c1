//! Runs the command in an empty folder, with limits, and keeps all that it said.

use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use std::ffi::{OsStr, OsString};
use std::fs::{self, File};
use std::io;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::Duration;
use wait_timeout::ChildExt;

/// Address space of the command in KiB: what runs away must not take the machine along.
pub const ADDRESS_SPACE: u64 = 4 << 20;
/// Largest file of the command in blocks of 512 bytes.
pub const FILE_SIZE: u64 = 1 << 18;
/// How long a command that was asked to end may take.
const TO_END: Duration = Duration::from_secs(10);

/// An empty folder for one command, with names for what cannot be written to.
#[derive(Debug)]
pub struct Sandbox {
    root: tempfile::TempDir,
}

/// What a command did.
#[derive(Debug)]
pub struct Outcome {
    /// How it ended.
    pub status: ExitStatus,
    /// Its standard output.
    pub stdout: Vec<u8>,
    /// Its standard error.
    pub stderr: String,
    /// Whether it was interrupted because it took too long.
    pub interrupted: bool,
}

/// What a run may take, beside its arguments.
#[derive(Clone, Debug)]
pub struct Limits {
    /// `ulimit -v`, in KiB.
    pub address_space: u64,
    /// `ulimit -f`, in blocks of 512 bytes.
    pub file_size: u64,
    /// After this it is interrupted.
    pub time: Duration,
}

impl Default for Limits {
    fn default() -> Self {
        Self { address_space: ADDRESS_SPACE, file_size: FILE_SIZE, time: Duration::from_secs(3) }
    }
}

impl Sandbox {
    /// Makes the folder, in memory where the system has a place for that.
    ///
    /// # Errors
    ///
    /// If no folder can be made.
    pub fn new() -> io::Result<Self> {
        let memory = Path::new("/dev/shm");
        let place = if memory.is_dir() { memory.to_owned() } else { std::env::temp_dir() };
        let sandbox = Self { root: tempfile::Builder::new().prefix("attack-").tempdir_in(place)? };
        fs::create_dir(sandbox.folder())?;
        fs::create_dir(sandbox.folder().join("folder"))?;
        std::os::unix::fs::symlink("/dev/null", sandbox.folder().join("null"))?;
        std::os::unix::fs::symlink("/dev/full", sandbox.folder().join("full"))?;
        Ok(sandbox)
    }

    /// The folder the command runs in.
    pub fn folder(&self) -> PathBuf {
        self.root.path().join("work")
    }

    /// A path beside the folder, for files that the command may read.
    pub fn outside(&self, name: &str) -> PathBuf {
        self.root.path().join(name)
    }

    /// The names in the folder, but for those that were there from the beginning, sorted.
    ///
    /// # Errors
    ///
    /// If the folder cannot be read.
    pub fn files(&self) -> io::Result<Vec<OsString>> {
        let mut names = Vec::new();
        for entry in fs::read_dir(self.folder())? {
            names.push(entry?.file_name());
        }
        for entry in fs::read_dir(self.folder().join("folder"))? {
            names.push(Path::new("folder").join(entry?.file_name()).into());
        }
        names.retain(|name| !["folder", "null", "full"].iter().any(|own| name == own));
        names.sort();
        Ok(names)
    }

    /// Starts `command` with `arguments` under `limits`, its output kept in files beside the folder.
    ///
    /// # Errors
    ///
    /// If it cannot be started.
    pub fn start(
        &self,
        command: &Path,
        arguments: &[OsString],
        stdin: Stdio,
        limits: &Limits,
    ) -> io::Result<Child> {
        let script =
            format!("ulimit -v {}; ulimit -f {}; exec \"$0\" \"$@\"", limits.address_space, limits.file_size);
        Command::new("sh")
            .args([OsStr::new("-c"), OsStr::new(&script), command.as_os_str()])
            .args(arguments)
            .current_dir(self.folder())
            .env("NO_COLOR", "1")
            .env_remove("RUST_BACKTRACE")
            .stdin(stdin)
            .stdout(File::create(self.root.path().join("stdout"))?)
            .stderr(File::create(self.root.path().join("stderr"))?)
            .spawn()
    }

    /// Waits for the end of `child`, and interrupts it after the time of `limits`.
    ///
    /// # Errors
    ///
    /// If it cannot be waited for, or does not end when it is asked to.
    pub fn finish(&self, mut child: Child, limits: &Limits) -> io::Result<Outcome> {
        let (status, interrupted) = match child.wait_timeout(limits.time)? {
            Some(status) => (status, false),
            None => {
                send(&child, Signal::SIGINT)?;
                let Some(status) = child.wait_timeout(TO_END)? else {
                    child.kill()?;
                    child.wait()?;
                    return Err(io::Error::other("did not end when it was interrupted"));
                };
                (status, true)
            }
        };
        let read = |name: &str| fs::read(self.root.path().join(name));
        let stderr = String::from_utf8_lossy(&read("stderr")?).into_owned();
        Ok(Outcome { status, stdout: read("stdout")?, stderr, interrupted })
    }

    /// Runs `command` from beginning to end.
    ///
    /// # Errors
    ///
    /// As [`Sandbox::start`] and [`Sandbox::finish`].
    pub fn run(
        &self,
        command: &Path,
        arguments: &[OsString],
        stdin: Stdio,
        limits: &Limits,
    ) -> io::Result<Outcome> {
        let child = self.start(command, arguments, stdin, limits)?;
        self.finish(child, limits)
    }
}

/// Sends a signal to a process that was started here.
///
/// # Errors
///
/// If it has ended.
pub fn send(child: &Child, signal: Signal) -> io::Result<()> {
    let id = i32::try_from(child.id()).map_err(io::Error::other)?;
    Ok(kill(Pid::from_raw(id), signal)?)
}

impl Outcome {
    /// The exit code, or 128 and the signal that ended it, as shells say it.
    pub fn code(&self) -> i32 {
        self.status.code().unwrap_or_else(|| 128 + self.status.signal().unwrap_or(0))
    }
}
