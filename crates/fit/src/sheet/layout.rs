//! Where the columns, the header and the first row of a file are.

use super::header::{self, Column};
use super::number::{self, Decimal};
use super::text::{Lines, Separator, comment, without_remark};
use super::{Dialect, SheetError};
use restitution_units::dimension_of;

/// How many lines are looked at.
const SAMPLE: usize = 200;
/// What separates columns, the surest first.
const SEPARATORS: [Separator; 6] = [
    Separator::Tab,
    Separator::Semicolon,
    Separator::Bar,
    Separator::Comma,
    Separator::CommaBlank,
    Separator::Blanks,
];

/// What was found.
pub(super) struct Layout {
    pub(super) separator: Separator,
    pub(super) columns: Vec<Column>,
    pub(super) header: Option<usize>,
    pub(super) first: usize,
    pub(super) names_in_comment: bool,
}

/// The lines that were looked at, and the last comment before the first row.
struct Sample<'a> {
    lines: Vec<(usize, &'a str)>,
    comments: Vec<(usize, &'a str)>,
}

/// One way to see the sample.
struct View {
    separator: Separator,
    /// The place of the first row in the sample.
    first: usize,
    width: usize,
    /// The share of rows with this width.
    even: f64,
    /// Whether the line above the first row has as many cells; none counts as well.
    headed: bool,
}

/// Finds the layout of a text.
pub(super) fn find(text: &str, dialect: Dialect) -> Result<Layout, SheetError> {
    let sample = Sample::of(text);
    let Some(&(line, first)) = sample.lines.first() else { return Err(SheetError::Empty) };
    let known = dialect.separator;
    let candidates = SEPARATORS.into_iter().filter(|separator| known.is_none_or(|known| known == *separator));
    let views = candidates.filter_map(|separator| sample.view(separator, dialect)).collect::<Vec<_>>();
    let Some(view) = best(&views) else { return sample.unread(line, first, known) };
    sample.check_header(view)?;
    if known.is_none() {
        sample.question_commas(&views, view, dialect)?;
    }
    Ok(sample.layout(view))
}

/// Whether a line is no row: blank, a comment, or a rule of dashes.
pub(super) fn is_idle(line: &str) -> bool {
    let line = line.trim();
    let rule = line.len() > 1 && line.bytes().all(|b| b"-=+|: \t".contains(&b)) && line.contains(['-', '=']);
    line.is_empty() || rule || comment(line).is_some()
}

fn best(views: &[View]) -> Option<&View> {
    let wide = views.iter().filter(|view| view.width > 1 && view.even >= 0.5);
    let better = |a: &&View, b: &&View| {
        // the earlier in the list of separators wins a draw
        (a.headed, a.even).partial_cmp(&(b.headed, b.even)).unwrap_or(core::cmp::Ordering::Equal)
    };
    let wide = wide.rev().max_by(better);
    let single = views.iter().find(|view| view.width == 1 && view.separator == Separator::Blanks);
    match (wide, single) {
        (Some(wide), Some(single)) if !wide.headed && single.headed => Some(single),
        (Some(wide), _) => Some(wide),
        (None, single) => single,
    }
}

impl<'a> Sample<'a> {
    fn of(text: &'a str) -> Self {
        let (mut lines, mut comments) = (Vec::new(), Vec::new());
        for (number, line) in Lines::of(text) {
            if lines.len() == SAMPLE {
                break;
            }
            if let Some(comment) = comment(line) {
                comments.push((number, comment));
            } else if !is_idle(line) {
                lines.push((number, without_remark(line)));
            }
        }
        Self { lines, comments }
    }

    fn cells(&self, place: usize, separator: Separator) -> Vec<&'a str> {
        let mut cells = Vec::new();
        separator.split(self.lines[place].1, &mut cells);
        cells
    }

    fn view(&self, separator: Separator, dialect: Dialect) -> Option<View> {
        if separator == Separator::CommaBlank && !self.commas_may_be_decimal() {
            return None;
        }
        if separator == Separator::Comma
            && dialect.decimal == Some(Decimal::Comma)
            && dialect.separator.is_none()
        {
            return None;
        }
        let cells = |place| self.cells(place, separator);
        let first = (0..self.lines.len()).find(|&place| {
            is_row(&cells(place)) || (place > 0 && is_row_below(&cells(place), &cells(place - 1)))
        })?;
        let cells = self.cells(first, separator);
        let several = |cell: &&str| cell.split_whitespace().filter(|word| is_number(word)).count() > 1;
        if separator == Separator::Comma && cells.iter().any(several) {
            return None; // `0,1 0,5`
        }
        let width = if is_row(&cells) { trimmed(&cells) } else { cells.len() };
        let rows = self.lines.len() - first;
        let even = (first..self.lines.len()).filter(|&place| {
            let cells = self.cells(place, separator);
            trimmed(&cells) == width || cells.len() == width
        });
        let even = even.count() as f64 / rows as f64;
        let headed = first == 0 || header::split(self.lines[first - 1].1, separator, width).is_some();
        Some(View { separator, first, width, even, headed })
    }

    /// Whether commas stand between digits only, some of them without a blank, and no point is there.
    fn commas_may_be_decimal(&self) -> bool {
        let rows = self
            .lines
            .iter()
            .map(|(_, line)| *line)
            .filter(|line| line.contains(',') && line.starts_with(|c: char| c.is_ascii_digit()));
        let mut any = false;
        for line in rows {
            let inner = line
                .match_indices(',')
                .any(|(place, _)| line[place + 1..].starts_with(|c: char| c.is_ascii_digit()));
            if line.contains('.') || !inner {
                return false;
            }
            any = true;
        }
        any
    }

    /// Refuses `0,5` and `0,1, 0,5` where neither header nor points tell what their commas are.
    fn question_commas(&self, views: &[View], view: &View, dialect: Dialect) -> Result<(), SheetError> {
        let comma = matches!(view.separator, Separator::Comma | Separator::CommaBlank);
        let named = view.first > 0
            && header::split(self.lines[view.first - 1].1, view.separator, view.width).is_some();
        let rivals = views.iter().filter(|other| other.headed && other.even == 1.0 && other.width > 1);
        let rival = rivals
            .filter(|other| matches!(other.separator, Separator::Comma | Separator::CommaBlank))
            .count()
            > 1;
        let (line, text) = self.lines[view.first];
        let whole_numbers = !self.lines[view.first..].iter().any(|(_, line)| line.contains(['.', ' ']));
        if comma && dialect.decimal.is_none() && !named && (rival || (view.width == 2 && whole_numbers)) {
            return Err(SheetError::CommaQuestion { line, text: shortened(text) });
        }
        Ok(())
    }

    /// Refuses a line of words above the rows that names more or fewer columns than there are.
    fn check_header(&self, view: &View) -> Result<(), SheetError> {
        let Some(above) = view.first.checked_sub(1).filter(|_| !view.headed) else { return Ok(()) };
        let names = trimmed(&self.cells(above, view.separator));
        let remedy = match view.separator {
            Separator::Comma if names < view.width => {
                "give one for each; if commas are decimal signs, separate the columns by semicolons, tabs or blanks"
            }
            Separator::Blanks => {
                "name each column, that of row numbers too, with two blanks between names of several words, or begin the line with #"
            }
            _ if names == 1 => return Ok(()), // a title
            _ => "give one for each",
        };
        let (line, separator) = (self.lines[view.first].0, view.separator.name());
        Err(SheetError::Width { line, cells: view.width, columns: names, separator, remedy })
    }

    fn layout(&self, view: &View) -> Layout {
        let split = |text: &str| header::split(text, view.separator, view.width);
        let above = |back: usize| view.first.checked_sub(back).map(|place| self.lines[place]);
        let mut named = above(1).and_then(|(line, text)| Some((line, split(text)?, None)));
        if let Some((_, units, _)) = &named
            && header::is_row_of_units(units)
            && let Some((line, names)) = above(2).and_then(|(line, text)| Some((line, split(text)?)))
        {
            named = Some((line, names, Some(units.clone())));
        }
        let first = self.lines[view.first].0;
        let mut names_in_comment = false;
        if named.is_none() {
            let before = self.comments.iter().filter(|(line, _)| *line < first);
            named = before.rev().find_map(|&(line, text)| {
                let cells = split(text).or_else(|| header::split(text, Separator::Blanks, view.width));
                cells.filter(|cells| cells.len() > 1).map(|cells| (line, cells, None))
            });
            names_in_comment = named.is_some();
        }
        let header = named.as_ref().map(|(line, ..)| *line);
        let columns = match named {
            Some((_, names, units)) => columns(&names, units),
            None => vec![Column::unnamed(); view.width],
        };
        Layout { separator: view.separator, columns, header, first, names_in_comment }
    }

    /// No way to see it makes a row of numbers: the first line is a header then, or nothing is.
    fn unread(&self, line: usize, text: &str, known: Option<Separator>) -> Result<Layout, SheetError> {
        let widths = SEPARATORS
            .into_iter()
            .filter(|separator| known.is_none_or(|known| known == *separator))
            .map(|separator| (separator, trimmed(&self.cells(0, separator))));
        let Some((separator, width)) = widths.into_iter().find(|(_, width)| *width > 1) else {
            return Err(SheetError::NoColumns { line, text: shortened(text) });
        };
        if text.trim_start().starts_with(['[', '{', '<']) {
            return Err(SheetError::NoColumns { line, text: shortened(text) }); // JSON, lists of programs, HTML
        }
        let Some(&(first, _)) = self.lines.get(1) else { return Err(SheetError::NoRows { line }) };
        let names = header::split(text, separator, width).unwrap_or_default();
        let columns = columns(&names, None);
        Ok(Layout { separator, columns, header: Some(line), first, names_in_comment: false })
    }
}

fn columns(names: &[String], units: Option<Vec<String>>) -> Vec<Column> {
    let mut columns = names.iter().map(|name| Column::of(name)).collect::<Vec<_>>();
    for (column, unit) in columns.iter_mut().zip(units.into_iter().flatten()) {
        let unit = unit.trim_matches(['[', ']', '(', ')']).trim();
        if column.unit.is_none() && !unit.is_empty() {
            column.unit = Some(unit.to_owned());
        }
    }
    columns
}

/// The number of cells without an empty one behind the last separator.
fn trimmed(cells: &[&str]) -> usize {
    cells.len() - usize::from(cells.len() > 1 && cells.last().is_some_and(|cell| cell.is_empty()))
}

fn is_row(cells: &[&str]) -> bool {
    let numbers = cells.iter().filter(|cell| is_number(cell)).count();
    let missing = cells.iter().filter(|cell| !cell.is_empty() && is_missing(cell)).count();
    numbers > 0 && (cells.len() == 1 || numbers + missing > 1)
}

/// Whether cells, some of which are blank, are the row of a table whose names stand above.
fn is_row_below(cells: &[&str], above: &[&str]) -> bool {
    let names = above.len() == cells.len() && above.iter().all(|name| !name.is_empty() && !is_number(name));
    let values = cells.iter().all(|cell| is_number(cell) || is_missing(cell));
    cells.len() > 1 && names && values && cells.iter().any(|cell| is_number(cell))
}

/// Whether a cell is a number, perhaps with a unit.
fn is_number(cell: &str) -> bool {
    let (number, unit) = number::split(cell);
    let read = |decimal| number::parse(number, decimal).is_some();
    (read(Decimal::Point) || read(Decimal::Comma))
        && (matches!(unit, "" | "%") || dimension_of(unit).is_some())
}

/// Whether a cell says that there is no value.
pub(crate) fn is_missing(cell: &str) -> bool {
    let names = ["", "-", "--", "nan", "na", "n/a", "#n/a", "null", "none", "?", "*", "inf", "-inf", "+inf"];
    names.iter().any(|name| cell.eq_ignore_ascii_case(name))
}

fn shortened(text: &str) -> String {
    let text = text.trim();
    if text.chars().count() <= 60 {
        text.to_owned()
    } else {
        text.chars().take(57).chain("…".chars()).collect()
    }
}
