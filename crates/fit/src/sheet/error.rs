use thiserror::Error;

/// Why a file could not be read as a table of numbers.
///
/// Every message can follow the name of the file.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SheetError {
    /// Neither UTF-8, UTF-16 nor Latin-1.
    #[error("is not text: give a table of columns, such as CSV")]
    NotText,
    /// No line but comments and blank ones.
    #[error("is empty: give rows of measurements")]
    Empty,
    /// A header and nothing below it.
    #[error("has no row below the header in line {line}: give measurements")]
    NoRows {
        /// The line of the header.
        line: usize,
    },
    /// No separator makes columns of numbers of the lines.
    #[error(
        "has no columns of numbers: line {line} reads '{text}'; separate columns by commas, semicolons, tabs or blanks"
    )]
    NoColumns {
        /// The first line that is no comment.
        line: usize,
        /// What it says.
        text: String,
    },
    /// A row has more or fewer cells than there are columns.
    #[error(
        "line {line}: there are {cells} cells under {columns} columns, separated by {separator}: {remedy}"
    )]
    Width {
        /// The line.
        line: usize,
        /// Its cells.
        cells: usize,
        /// The columns.
        columns: usize,
        /// What separates them.
        separator: &'static str,
        /// What to do.
        remedy: &'static str,
    },
    /// A comma may separate columns or digits.
    #[error(
        "line {line}: the commas of '{text}' may separate columns or decimals: give --separator comma, or --decimal comma with columns separated by semicolons, tabs or blanks"
    )]
    CommaQuestion {
        /// The line.
        line: usize,
        /// What it says.
        text: String,
    },
    /// A sign may separate decimals or group digits.
    #[error("line {line}: '{text}' may mean {one} or {other}: give --decimal point or --decimal comma")]
    DecimalQuestion {
        /// The line.
        line: usize,
        /// The cell.
        text: String,
        /// The one meaning.
        one: String,
        /// The other.
        other: String,
    },
    /// Cells with a decimal point beside cells with a decimal comma.
    #[error(
        "line {line}: '{comma}' has a decimal comma and '{point}' in line {other} a decimal point: write them alike"
    )]
    MixedDecimals {
        /// The line of the comma.
        line: usize,
        /// The cell with it.
        comma: String,
        /// The line of the point.
        other: usize,
        /// The cell with it.
        point: String,
    },
}
