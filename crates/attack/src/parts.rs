//! The parts of an attack and how large they are.

use crate::Tally;
use crate::certified::Certified;
use crate::commands::Commands;
use crate::data_files::DataFiles;
use crate::ends::Ends;
use crate::exports::Exports;
use crate::f64_functions::F64Functions;
use crate::parsers::Parsers;
use crate::random::Source;
use std::path::PathBuf;

/// An attack on one kind of promise.
pub trait Part: Sync {
    /// Its name on the command line and in the state file.
    fn name(&self) -> &'static str;

    /// What a case is, in one sentence.
    fn about(&self) -> &'static str;

    /// How many cases there are in a run of a size.
    fn cases(&self, size: Size) -> u64;

    /// Whether a case keeps several cores busy or measures time, and so runs alone.
    fn alone(&self) -> bool {
        false
    }

    /// Attacks once; what it counts and finds goes to `tally`.
    fn attack(&self, random: &mut Source, tally: &mut Tally);
}

/// How much is attacked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Size {
    /// A fixed slice of every part in at most a minute, as the tests run it.
    Slice,
    /// Minutes.
    Minutes,
    /// The counts that docs/reliability.md reports: hours.
    Full,
}

/// Returns all parts; `command` is the executable that is attacked.
pub fn all(command: PathBuf) -> Vec<Box<dyn Part>> {
    vec![
        Box::new(Certified),
        Box::new(F64Functions),
        Box::new(Parsers),
        Box::new(Commands::new(command.clone())),
        Box::new(DataFiles::new(command.clone())),
        Box::new(Exports::new(command.clone())),
        Box::new(Ends::new(command)),
    ]
}
