//! `restitution report`: speed against error, figures and stability, measured on this machine.

mod folder;

use crate::CliError;
use crate::input;
use crate::progress::Progress;
use folder::Folder;
use restitution_report::{Beside, Effort, make};
use std::path::{Path, PathBuf};

/// Arguments of `restitution report`.
#[derive(Debug, clap::Args)]
pub struct ReportArgs {
    /// Write to the folder DIR, whole or not at all: index.html, its figures as SVG, its data as CSV
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Measure little and in seconds: every part is there, its times say nothing
    #[arg(long)]
    quick: bool,
    /// Show the times of another build beside those of this one: DIR is a report that it wrote on this machine
    #[arg(long, value_name = "DIR")]
    beside: Option<PathBuf>,
}

impl ReportArgs {
    /// Measures and writes the report.
    ///
    /// # Errors
    ///
    /// Failure if the folder cannot be written or holds something else; usage if the other report cannot be read; what the libraries say.
    pub fn run(&self) -> Result<(), CliError> {
        let folder = Folder::at(&self.output)?;
        let other = self.beside.as_deref().map(read).transpose()?;
        let effort = if self.quick { Effort::quick() } else { Effort::full() };
        let progress = Progress::steps("report", effort.steps());
        let files = make(&effort, other.as_ref(), &|| progress.advance(1))?;
        drop(progress);
        folder.write(&files)
    }
}

/// Longest file of a report that is read, in bytes.
const LARGEST_FILE: u64 = 10_000_000;

/// Reads the report of another build.
fn read(folder: &Path) -> Result<Beside, CliError> {
    let remedy = "give --beside the folder that another build wrote with 'report -o'";
    let file = |name: &str| {
        let bytes = input::read(&folder.join(name), LARGEST_FILE, remedy)
            .map_err(|error| CliError::usage(format!("{error}; {remedy}")))?;
        Ok::<_, CliError>(String::from_utf8_lossy(&bytes).into_owned())
    };
    let [speed, machine] = Beside::FILES;
    Beside::read(&file(speed)?, &file(machine)?)
        .map_err(|error| CliError::usage(format!("cannot use the report in '{}': {error}", folder.display())))
}
