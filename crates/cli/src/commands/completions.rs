//! `restitution completions`: what shells and `man` want to know about the command.

use crate::CliError;
use crate::output::TargetArgs;
use clap_complete::Shell;

/// Arguments of `restitution completions`.
#[derive(Debug, clap::Args)]
pub struct CompletionsArgs {
    /// Whom they are for
    #[arg(value_enum)]
    reader: Reader,
    #[command(flatten)]
    target: TargetArgs,
}

/// Who reads a description of the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Reader {
    Bash,
    Elvish,
    Fish,
    Man,
    PowerShell,
    Zsh,
}

impl CompletionsArgs {
    /// Writes the completions or the manual page.
    ///
    /// # Errors
    ///
    /// Those of the output.
    pub fn run(&self) -> Result<(), CliError> {
        let shell = match self.reader {
            Reader::Bash => Shell::Bash,
            Reader::Elvish => Shell::Elvish,
            Reader::Fish => Shell::Fish,
            Reader::PowerShell => Shell::PowerShell,
            Reader::Zsh => Shell::Zsh,
            Reader::Man => return self.target.write(&manual_page()?),
        };
        let mut text = Vec::new();
        clap_complete::generate(shell, &mut super::command(), "restitution", &mut text);
        self.target.write(&String::from_utf8_lossy(&text))
    }
}

fn manual_page() -> Result<String, CliError> {
    let mut page = Vec::new();
    clap_mangen::Man::new(super::command()).render(&mut page).map_err(CliError::failure)?;
    Ok(String::from_utf8_lossy(&page).into_owned())
}
