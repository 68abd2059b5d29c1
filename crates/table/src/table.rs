//! What a subcommand prints: a table with named columns.

/// One entry of a table.
///
/// # Examples
///
/// ```
/// use restitution_table::Cell;
///
/// assert_eq!(Cell::digits("0.10").plain(), "0.10"); // every digit counts
/// assert_eq!(Cell::Float(0.10).plain(), "0.1");
/// assert_eq!(Cell::decimals(0.126, 2).plain(), "0.13");
/// assert_eq!(Cell::Empty.plain(), "");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// A whole number; a number in JSON.
    Integer(i64),
    /// A decimal or a fraction whose every digit counts; a string in JSON, where numbers are read as f64.
    Digits(String),
    /// A number in double precision, printed with the fewest digits that give it back.
    Float(f64),
    /// Anything else.
    Text(String),
    /// Nothing; null in JSON.
    Empty,
}

impl Cell {
    /// Returns an exact or certified number as it is printed.
    pub fn digits(value: impl ToString) -> Self {
        Self::Digits(value.to_string())
    }

    /// Returns a number rounded to `digits` significant ones; without a limit, or none at all, as words say it.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_table::Cell;
    ///
    /// assert_eq!(Cell::rounded(0.123_456, 3), Cell::Float(0.123));
    /// assert_eq!(Cell::rounded(f64::INFINITY, 3), Cell::text("no limit"));
    /// assert_eq!(Cell::rounded(f64::NAN, 3), Cell::text("-"));
    /// ```
    pub fn rounded(value: f64, digits: usize) -> Self {
        if !value.is_finite() {
            return Self::Text(if value > 0.0 { "no limit" } else { "-" }.to_owned());
        }
        Self::Float(format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value))
    }

    /// Returns a number rounded to `places` behind the decimal point.
    pub fn decimals(value: f64, places: usize) -> Self {
        Self::Float(format!("{value:.places$}").parse().unwrap_or(value))
    }

    /// Returns a bound with `digits` significant ones, rounded so that it is no smaller.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_table::Cell;
    ///
    /// assert_eq!(Cell::upper_bound(1.01e-4, 2), Cell::digits("1.1e-4"));
    /// assert_eq!(Cell::upper_bound(1.0e-4, 2), Cell::digits("1.0e-4"));
    /// assert_eq!(Cell::upper_bound(9.99e-3, 2), Cell::digits("1.0e-2"));
    /// ```
    pub fn upper_bound(value: f64, digits: usize) -> Self {
        let places = digits.saturating_sub(1);
        let nearest = format!("{value:.places$e}");
        let half_up = 0.5_f64.mul_add(0.1_f64.powi(i32::try_from(places).unwrap_or(i32::MAX)), 1.0);
        let no_smaller = nearest.parse::<f64>().is_ok_and(|shown| shown >= value);
        // half a unit of the last digit at most, relative to the number
        Self::Digits(if no_smaller { nearest } else { format!("{:.places$e}", value * half_up) })
    }

    /// Returns a number with the digits that a relative error leaves, and one more; two at least, ten at most.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_table::Cell;
    ///
    /// assert_eq!(Cell::uncertain(1.234_567, 1e-3), Cell::Float(1.2346));
    /// assert_eq!(Cell::uncertain(1.234_567, 10.0), Cell::Float(1.2));
    /// assert_eq!(Cell::uncertain(1.234_567, 0.0), Cell::Float(1.234_567)); // no error: ten digits
    /// ```
    pub fn uncertain(value: f64, relative_error: f64) -> Self {
        let digits = if relative_error > 0.0 { (1.5 - relative_error.log10()).ceil() } else { 10.0 };
        Self::rounded(value, digits.clamp(2.0, 10.0) as usize)
    }

    /// Returns a text.
    pub fn text(value: impl ToString) -> Self {
        Self::Text(value.to_string())
    }
}

impl From<usize> for Cell {
    fn from(value: usize) -> Self {
        i64::try_from(value).map_or_else(|_| Self::digits(value), Self::Integer)
    }
}

impl From<i64> for Cell {
    fn from(value: i64) -> Self {
        Self::Integer(value)
    }
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Self::Float(value)
    }
}

impl From<&str> for Cell {
    fn from(value: &str) -> Self {
        Self::text(value)
    }
}

/// Named columns and rows of cells, with a title above and notes below.
///
/// Title and notes are for readers: text, Markdown and LaTeX show them, CSV and JSON leave them out,
/// except that what is [`said`](Table::said) about the whole makes the JSON an object with `rows`.
///
/// # Examples
///
/// ```
/// use restitution_table::{Cell, Format, Table};
///
/// let mut table = Table::new(&["k", "value"]).titled("Coefficients");
/// table.push(vec![1_usize.into(), Cell::digits("-1.15")]);
/// table.note("every digit is proved");
/// table.said("law", "force law", Cell::text("3/2,1/2"));
/// assert_eq!((table.columns().len(), table.rows().len()), (2, 1));
/// assert_eq!(table.render(Format::Csv), "k,value\n1,-1.15\n");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    pub(crate) title: Option<String>,
    pub(crate) columns: Vec<String>,
    pub(crate) rows: Vec<Vec<Cell>>,
    pub(crate) notes: Vec<String>,
    pub(crate) fields: Vec<(String, Cell)>,
}

impl Table {
    /// Returns an empty table with these columns.
    pub fn new(columns: &[&str]) -> Self {
        let columns = columns.iter().map(ToString::to_string).collect();
        Self { title: None, columns, rows: Vec::new(), notes: Vec::new(), fields: Vec::new() }
    }

    /// The names of the columns.
    pub fn columns(&self) -> &[String] {
        &self.columns
    }

    /// The rows, each with one cell for each column.
    pub fn rows(&self) -> &[Vec<Cell>] {
        &self.rows
    }

    /// Sets the title.
    #[must_use]
    pub fn titled(mut self, title: impl ToString) -> Self {
        self.title = Some(title.to_string());
        self
    }

    /// Adds a note below the rows.
    pub fn note(&mut self, note: impl ToString) {
        self.notes.push(note.to_string());
    }

    /// Adds what is said about the table as a whole: a note `label: value`, and in JSON a field `name`.
    pub fn said(&mut self, name: &str, label: &str, value: Cell) {
        self.note(format!("{label}: {}", value.plain()));
        self.fields.push((name.to_owned(), value));
    }

    /// Adds a row.
    ///
    /// # Panics
    ///
    /// If the row has not one cell for each column.
    pub fn push(&mut self, row: Vec<Cell>) {
        assert_eq!(row.len(), self.columns.len(), "one cell for each column");
        self.rows.push(row);
    }
}
