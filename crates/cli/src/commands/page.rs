//! `restitution page`: one HTML file to play with epsilon(g).

use crate::CliError;
use crate::output::TargetArgs;

/// Arguments of `restitution page`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  restitution page -o explore.html")]
pub struct PageArgs {
    #[command(flatten)]
    target: TargetArgs,
}

impl PageArgs {
    /// Writes the page.
    ///
    /// # Errors
    ///
    /// Those of the output.
    pub fn run(&self) -> Result<(), CliError> {
        self.target.check()?;
        self.target.write(&restitution_page::page())
    }
}
