use crate::sheet::SheetError;
use thiserror::Error;

/// Why a file does not give measurements; every message can follow the name of the file.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum DataError {
    /// The file is no table.
    #[error(transparent)]
    Sheet(#[from] SheetError),
    /// No column, or more than one, could be the one that is needed.
    #[error("{seen}; {problem}: {remedy}")]
    Columns {
        /// What was seen.
        seen: String,
        /// What is wrong with it.
        problem: String,
        /// What to do.
        remedy: String,
    },
    /// A row cannot be read.
    #[error("line {line}: {reason}")]
    Row {
        /// The line.
        line: usize,
        /// What is wrong and what to do.
        reason: String,
    },
    /// No row is left.
    #[error("has no row with values: give measurements")]
    NoRows,
}
