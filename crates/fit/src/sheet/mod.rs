//! Tables as files hold them: lines, cells, names and numbers, whatever program wrote them.

mod error;
mod header;
mod layout;
mod number;
mod text;

pub use error::SheetError;
pub use header::Column;
pub use number::Decimal;
pub use text::Separator;

pub(crate) use layout::is_missing;
pub(crate) use number::{parse, split};

use number::Evidence;
use text::Lines;

/// What the reader of a file is told about it; `None` leaves it to the file.
#[derive(Clone, Copy, Debug, Default)]
pub struct Dialect {
    /// What separates columns.
    pub separator: Option<Separator>,
    /// The decimal sign.
    pub decimal: Option<Decimal>,
}

/// A table of cells, held as the text of its file.
#[derive(Debug)]
pub struct Sheet {
    text: String,
    separator: Separator,
    decimal: Option<Decimal>,
    columns: Vec<Column>,
    /// The line of the header.
    header: Option<usize>,
    /// The line of the first row.
    first: usize,
    /// Whether the names stand in a comment, which may be no header at all.
    names_in_comment: bool,
}

impl Sheet {
    /// Finds columns and header of a file.
    ///
    /// # Errors
    ///
    /// [`SheetError`] for what is no text, has no columns, or can be read in two ways.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_fit::sheet::{Dialect, Separator, Sheet, SheetError};
    ///
    /// let sheet = Sheet::read(b"v / m/s;e\n0,1;0,9\n".to_vec(), Dialect::default())?;
    /// assert_eq!(sheet.separator(), Separator::Semicolon);
    /// assert_eq!(sheet.columns()[0].unit.as_deref(), Some("m/s"));
    ///
    /// assert!(matches!(Sheet::read(b"# nothing".to_vec(), Dialect::default()), Err(SheetError::Empty)));
    /// # Ok::<(), SheetError>(())
    /// ```
    pub fn read(bytes: Vec<u8>, dialect: Dialect) -> Result<Self, SheetError> {
        let text = text::decode(bytes)?;
        let found = layout::find(&text, dialect)?;
        Ok(Self {
            separator: found.separator,
            decimal: dialect.decimal,
            columns: found.columns,
            header: found.header,
            first: found.first,
            names_in_comment: found.names_in_comment,
            text,
        })
    }

    /// The heads of the columns; without name where there is no header.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// The line of the header, if there is one.
    pub fn header(&self) -> Option<usize> {
        self.header
    }

    /// What separates the columns.
    pub fn separator(&self) -> Separator {
        self.separator
    }

    /// Takes a header in a comment for what it may be: a remark.
    pub(crate) fn without_comment_names(mut self) -> Self {
        if self.names_in_comment {
            self.columns.fill(Column::unnamed());
            self.header = None;
        }
        self
    }

    /// Whether the names stand in a comment.
    pub(crate) fn has_comment_names(&self) -> bool {
        self.names_in_comment
    }

    /// What was seen, for a message: the columns and what separates them.
    pub fn seen(&self) -> String {
        let width = self.columns.len();
        let columns = if width == 1 {
            "1 column".to_owned()
        } else {
            format!("{width} columns separated by {}", self.separator.name())
        };
        match self.header {
            None => format!("there is no header and {columns}"),
            Some(line) => {
                let names = self.columns.iter().map(|column| format!("'{}'", column.text));
                let shown = names.take(8).collect::<Vec<_>>().join(", ");
                let more = if width > 8 { ", …" } else { "" };
                format!("line {line} has {columns}: {shown}{more}")
            }
        }
    }

    /// Calls `row` with the number and the cells of every row.
    ///
    /// # Errors
    ///
    /// [`SheetError::Width`] for a row of another width, and what `row` returns.
    pub fn rows<E: From<SheetError>>(
        &self,
        mut row: impl FnMut(usize, &[&str]) -> Result<(), E>,
    ) -> Result<(), E> {
        let width = self.columns.len();
        let mut cells = Vec::with_capacity(width + 1);
        for (line, text) in Lines::of(&self.text).skip(self.first - 1) {
            if layout::is_idle(text) {
                continue;
            }
            self.separator.split(text::without_remark(text), &mut cells);
            if cells.iter().all(|cell| cell.is_empty()) {
                continue;
            }
            if cells.len() == width + 1 && cells[width].is_empty() {
                cells.pop();
            }
            if cells.len() != width {
                return Err(self.wrong_width(line, cells.len()).into());
            }
            row(line, &cells)?;
        }
        Ok(())
    }

    fn wrong_width(&self, line: usize, cells: usize) -> SheetError {
        let columns = self.columns.len();
        let decimals = self.separator == Separator::Comma && cells > columns;
        let remedy = if decimals {
            "give one for each; if commas are decimal signs, separate the columns by semicolons, tabs or blanks"
        } else {
            "give one for each"
        };
        SheetError::Width { line, cells, columns, separator: self.separator.name(), remedy }
    }

    /// Finds the decimal sign of these columns by what every cell of them says.
    ///
    /// # Errors
    ///
    /// [`SheetError::DecimalQuestion`] where `1,203` may be one and a bit or a thousand and some, and nothing else tells;
    /// [`SheetError::MixedDecimals`].
    pub fn decimal(&self, columns: &[usize]) -> Result<Decimal, SheetError> {
        if let Some(decimal) = self.decimal {
            return Ok(decimal);
        }
        let mut first: [Option<(usize, String)>; 4] = [const { None }; 4];
        self.rows::<SheetError>(|line, cells| {
            for &column in columns {
                let (number, _) = split(cells[column]);
                let place = match number::evidence(number) {
                    Evidence::Point => 0,
                    Evidence::Comma => 1,
                    Evidence::AmbiguousComma => 2,
                    Evidence::AmbiguousPoint => 3,
                    Evidence::None => continue,
                };
                if first[place].is_none() {
                    first[place] = Some((line, number.to_owned()));
                }
            }
            Ok(())
        })?;
        let question = |(line, text): (usize, String), group: &str| SheetError::DecimalQuestion {
            line,
            one: text.replace(group, "."),
            other: text.replace(group, ""),
            text,
        };
        match first {
            [Some((other, point)), Some((line, comma)), ..] => {
                Err(SheetError::MixedDecimals { line, comma, other, point })
            }
            [None, Some(_), _, Some(point)] => Err(question(point, ".")),
            [None, Some(_), ..] => Ok(Decimal::Comma),
            [_, None, Some(comma), _] => Err(question(comma, ",")),
            _ => Ok(Decimal::Point),
        }
    }
}
