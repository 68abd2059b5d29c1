/// The form of a printed table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Format {
    /// Aligned columns for reading.
    #[default]
    Text,
    /// Comma-separated values with a header line.
    Csv,
    /// An array of objects; numbers whose digits are proved are strings.
    Json,
    /// A tabular environment.
    Latex,
    /// A pipe table.
    Markdown,
    /// Numbers separated by blanks, names and notes in comments: for programs that look values up.
    Lookup,
}
