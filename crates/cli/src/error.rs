//! What can go wrong in a subcommand, as one line on stderr and an exit code.

use restitution_audit::AuditError;
use restitution_closed::ClosedError;
use restitution_law::LawError;
use restitution_report::ReportError;
use restitution_series::SeriesError;
use std::ffi::OsString;
use std::fmt::Display;
use std::process::ExitCode;

/// The longest message that is shown: beyond it an argument was quoted that nobody wants to read.
const LONGEST_MESSAGE: usize = 400;

/// Why a subcommand did not do what was asked.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CliError {
    /// The request is at fault: exit code 2.
    #[error("{0}")]
    Usage(String),
    /// The request is sound and could not be carried out: exit code 1.
    #[error("{0}")]
    Failure(String),
    /// The reader of stdout has gone, as `head` does: nothing to say, exit code 0.
    #[error("the reader of the output has gone")]
    ClosedPipe,
}

impl CliError {
    /// Returns a usage error; the message names what was given and the remedy.
    pub fn usage(message: impl Display) -> Self {
        Self::Usage(message.to_string())
    }

    /// Returns a failure; the message names what failed and the remedy, if there is one.
    pub fn failure(message: impl Display) -> Self {
        Self::Failure(message.to_string())
    }

    /// Prints the error as one line on stderr and returns its exit code.
    pub fn report(&self) -> ExitCode {
        if matches!(self, Self::ClosedPipe) {
            return ExitCode::SUCCESS;
        }
        // A message that cannot be delivered leaves the exit code to tell.
        let _ = std::io::Write::write_all(
            &mut std::io::stderr(),
            format!("restitution: {}\n", one_line(&self.to_string())).as_bytes(),
        );
        ExitCode::from(if matches!(self, Self::Usage(_)) { 2 } else { 1 })
    }
}

impl From<LawError> for CliError {
    fn from(error: LawError) -> Self {
        Self::usage(error)
    }
}

impl From<AuditError> for CliError {
    fn from(error: AuditError) -> Self {
        match error {
            AuditError::UnknownClaim { .. } => Self::usage(error),
            _ => Self::failure(error),
        }
    }
}

impl From<ReportError> for CliError {
    fn from(error: ReportError) -> Self {
        Self::failure(error)
    }
}

impl From<SeriesError> for CliError {
    fn from(error: SeriesError) -> Self {
        match error {
            SeriesError::NoZeroForceEnd { .. } => Self::usage(error),
            _ => Self::failure(error),
        }
    }
}

impl From<ClosedError> for CliError {
    fn from(error: ClosedError) -> Self {
        match error {
            ClosedError::BeyondBeta { .. }
            | ClosedError::BeyondAlgebra { .. }
            | ClosedError::TooManyTerms { .. } => Self::usage(error),
            ClosedError::Series(error) => error.into(),
            _ => Self::failure(error),
        }
    }
}

impl CliError {
    /// Keeps of clap's several paragraphs what was wrong and the remedy; `arguments` are those that were read.
    pub(crate) fn of_arguments(error: &clap::Error, arguments: &[OsString]) -> Self {
        if let Some(said) = crate::hint::of(error, arguments) {
            return Self::Usage(said);
        }
        let text = error.render().to_string();
        let lines = || text.lines().map(str::trim);
        let said = lines()
            .take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more information"))
            .filter(|line| !line.is_empty() && !line.starts_with("tip: to pass"))
            .collect::<Vec<_>>()
            .join(" ");
        let said = said.trim_start_matches("error: ").replace(" tip: ", "; ");
        if [": give", ": write", ": use", "; ", "[possible values"].iter().any(|remedy| said.contains(remedy))
        {
            return Self::Usage(said);
        }
        let usage = lines().find_map(|line| line.strip_prefix("Usage: "));
        let command = usage.and_then(|usage| usage.split(" -").next()?.split(['<', '[']).next());
        let subcommand = || match arguments.get(1).and_then(|word| word.to_str()) {
            Some(word) if crate::commands::command().find_subcommand(word).is_some() => format!(" {word}"),
            _ => String::new(),
        };
        let command =
            command.map_or_else(|| format!("restitution{}", subcommand()), |name| name.trim().to_owned());
        Self::Usage(format!("{said}; see '{command} --help'"))
    }
}

/// Returns `text` without line breaks and control characters, shortened in the middle when very long.
fn one_line(text: &str) -> String {
    let escape = |c: char| if c.is_control() { c.escape_default().to_string() } else { c.to_string() };
    let line = text.chars().map(escape).collect::<String>();
    let length = line.chars().count();
    if length <= LONGEST_MESSAGE {
        return line;
    }
    let half = LONGEST_MESSAGE / 2;
    let head = line.chars().take(half).collect::<String>();
    let tail = line.chars().skip(length - half).collect::<String>();
    format!("{head}...{tail}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_are_one_short_line() {
        assert_eq!(one_line("a\nb\x1b[1m"), "a\\nb\\u{1b}[1m");
        let long = one_line(&"x".repeat(100_000));
        assert_eq!(long.len(), LONGEST_MESSAGE + 3);
    }
}
