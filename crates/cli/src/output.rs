//! Where a table goes: stdout, or a file that is written whole or not at all.

use crate::interrupt::Pending;
use crate::{CliError, Table};
pub use restitution_table::Format;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// The arguments `--format` and `-o` of every subcommand that prints a table.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct OutputArgs {
    /// The form of the table
    #[arg(long, value_enum, default_value_t, hide_default_value = true, value_name = "FORMAT")]
    pub format: Format,
    /// The argument `-o`.
    #[command(flatten)]
    pub target: TargetArgs,
}

/// The argument `-o` alone, for subcommands whose output is not a table.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct TargetArgs {
    /// Write to FILE instead of stdout, whole or not at all
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl OutputArgs {
    /// Checks that the output can be written; call it before the work starts.
    ///
    /// # Errors
    ///
    /// As [`TargetArgs::check`].
    pub fn check(&self) -> Result<(), CliError> {
        self.target.check()
    }

    /// Prints the table in the chosen form to the chosen place.
    ///
    /// # Errors
    ///
    /// As [`TargetArgs::write`].
    pub fn print(&self, table: &Table) -> Result<(), CliError> {
        self.target.write(&table.render(self.format))
    }

    /// Prints lines that are no table, such as the input of another program.
    ///
    /// # Errors
    ///
    /// [`CliError::Usage`] for any format but text, else as [`TargetArgs::write`].
    pub fn print_lines(&self, lines: &str) -> Result<(), CliError> {
        match self.format {
            Format::Text => self.target.write(lines),
            _ => Err(CliError::usage("these lines are no table: leave --format out")),
        }
    }
}

impl TargetArgs {
    /// Checks that the output can be written; call it before the work starts.
    ///
    /// # Errors
    ///
    /// [`CliError::Failure`] if the file is a directory or cannot be written, or its folder is missing.
    pub fn check(&self) -> Result<(), CliError> {
        self.file().map_or(Ok(()), |path| Target::of(path)?.probe())
    }

    /// Writes `text` to the chosen place.
    ///
    /// # Errors
    ///
    /// As [`TargetArgs::check`]; [`CliError::ClosedPipe`] if the reader of stdout has gone.
    pub fn write(&self, text: &str) -> Result<(), CliError> {
        match self.file() {
            Some(path) => write_whole(path, text.as_bytes()),
            None => write_stdout(text.as_bytes()),
        }
    }

    /// The file that was named; `-` is stdout.
    fn file(&self) -> Option<&Path> {
        self.output.as_deref().filter(|path| *path != Path::new("-"))
    }
}

/// Writes the file at `path` whole or not at all: an existing file stays as it was until the end.
///
/// The content goes to a temporary file in the same folder, which then takes the name. A symbolic
/// link is followed, the permissions of an existing file are kept; what is not a regular file (such
/// as `/dev/null` or a named pipe) is written directly.
///
/// # Errors
///
/// [`CliError::Failure`] with the reason, one line.
pub fn write_whole(path: &Path, content: &[u8]) -> Result<(), CliError> {
    Target::of(path)?.write(content)
}

fn write_stdout(content: &[u8]) -> Result<(), CliError> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(content).and_then(|()| stdout.flush()).map_err(|error| match error.kind() {
        ErrorKind::BrokenPipe => CliError::ClosedPipe,
        _ => CliError::failure(format!("cannot write to stdout: {}", reason(&error))),
    })
}

/// What `-o` names, with symbolic links resolved.
enum Target {
    /// A file that exists or will: it is replaced in one step.
    Regular(PathBuf),
    /// A device or a pipe: it can only be written to.
    Special(PathBuf),
}

impl Target {
    fn of(path: &Path) -> Result<Self, CliError> {
        let real = fs::canonicalize(path);
        match real.as_ref().map(fs::metadata) {
            Ok(Ok(meta)) if meta.is_dir() => {
                Err(failure(path, "it is a directory: give -o the name of a file"))
            }
            Ok(Ok(meta)) if !meta.is_file() => Ok(Self::Special(path.to_owned())),
            Err(error) if error.kind() != ErrorKind::NotFound => Err(failure(path, &reason(error))),
            _ if path.file_name().is_none() => Err(failure(path, "give -o the name of a file")),
            _ => Ok(Self::Regular(real.unwrap_or_else(|_| path.to_owned()))),
        }
    }

    /// Finds out whether it can be written, and leaves it as it is.
    fn probe(&self) -> Result<(), CliError> {
        match self {
            Self::Regular(path) => temporary(path).map(drop),
            Self::Special(_) => Ok(()), // opening a pipe would wait for its reader
        }
    }

    fn write(&self, content: &[u8]) -> Result<(), CliError> {
        match self {
            Self::Regular(path) => replace(path, content),
            Self::Special(path) => {
                let file = OpenOptions::new().write(true).open(path);
                match file.and_then(|mut file| file.write_all(content)) {
                    Err(error) if error.kind() == ErrorKind::BrokenPipe => Err(CliError::ClosedPipe),
                    result => result.map_err(|error| failure(path, &reason(&error))),
                }
            }
        }
    }
}

fn replace(path: &Path, content: &[u8]) -> Result<(), CliError> {
    let (_pending, mut file) = temporary(path)?; // dropped last, after the file
    let whole = file.write_all(content).and_then(|()| file.as_file().sync_all());
    whole.map_err(|error| failure(path, &reason(&error)))?;
    file.persist(path).map(drop).map_err(|error| failure(path, &reason(&error.error)))
}

/// Makes a temporary file beside `path`, with the permissions that `path` has or a new file gets.
fn temporary(path: &Path) -> Result<(Pending, NamedTempFile), CliError> {
    let failed = |error: io::Error| failure(path, &reason(&error));
    let existing = match OpenOptions::new().write(true).open(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => None,
        opened => Some(opened.and_then(|file: File| file.metadata()).map_err(failed)?),
    };
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if !folder.is_dir() {
        return Err(failure(path, &format!("there is no folder '{}': make it first", folder.display())));
    }
    let pending = Pending::nothing();
    let make = |path: &Path| {
        pending.file(path);
        OpenOptions::new().write(true).create_new(true).open(path)
    };
    let file = tempfile::Builder::new().prefix(".restitution-").make_in(folder, make).map_err(failed)?;
    if let Some(existing) = existing {
        file.as_file().set_permissions(existing.permissions()).map_err(failed)?;
    }
    Ok((pending, file))
}

fn failure(path: &Path, reason: &str) -> CliError {
    CliError::failure(format!("cannot write '{}': {reason}", path.display()))
}

/// Says why, without the number that systems put behind it.
fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    let text =
        text.split(" (os error").next().unwrap_or_default().split(" at path").next().unwrap_or_default();
    match error.kind() {
        ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => {
            format!("{}: choose a place you may write to", text.to_lowercase())
        }
        _ => text.to_lowercase(),
    }
}
