//! `restitution report`: speed against error, figures and stability, measured on this machine.

mod folder;

use crate::CliError;
use crate::progress::Progress;
use folder::Folder;
use restitution_report::{Effort, make};
use std::path::PathBuf;

/// Arguments of `restitution report`.
#[derive(Debug, clap::Args)]
pub struct ReportArgs {
    /// Write to the folder DIR, whole or not at all: index.html, its figures as SVG, its data as CSV
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Measure little and in seconds: every part is there, its times say nothing
    #[arg(long)]
    quick: bool,
}

impl ReportArgs {
    /// Measures and writes the report.
    ///
    /// # Errors
    ///
    /// Failure if the folder cannot be written or holds something else; what the libraries say.
    pub fn run(&self) -> Result<(), CliError> {
        let folder = Folder::at(&self.output)?;
        let effort = if self.quick { Effort::quick() } else { Effort::full() };
        let progress = Progress::steps("report", effort.steps());
        let files = make(&effort, &|| progress.advance(1))?;
        drop(progress);
        folder.write(&files)
    }
}
