//! Measurements out of a table, whatever was measured.

mod cell;
mod error;
mod role;
mod select;

pub use error::DataError;
pub use role::Method;

use crate::sheet::{Dialect, Sheet, split};
use crate::{Measurement, STANDARD_GRAVITY, bounces};
use cell::Source;
use num_traits::ToPrimitive;
use restitution_units::{Dimension, size};
use role::Role;
use select::Selection;

/// What a reader of measurements is told about them.
#[derive(Clone, Debug)]
pub struct DataOptions {
    /// How the file is written.
    pub dialect: Dialect,
    /// How the coefficient was measured; found by the names of the columns if `None`.
    pub method: Option<Method>,
    /// Which columns hold what: names or numbers from 1, in order or as `KEY=COLUMN`.
    pub columns: Option<String>,
    /// The unit of velocities where the file names none; m/s if `None`.
    pub velocity_unit: Option<String>,
    /// The acceleration of gravity, in m/s^2, for heights and times.
    pub gravity: f64,
    /// Whether rows without a value are left out instead of refused.
    pub skip_missing: bool,
}

impl Default for DataOptions {
    fn default() -> Self {
        Self {
            dialect: Dialect::default(),
            method: None,
            columns: None,
            velocity_unit: None,
            gravity: STANDARD_GRAVITY,
            skip_missing: false,
        }
    }
}

/// The measurements of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Data {
    /// How they were measured.
    pub method: Method,
    /// The collisions, with velocities in `unit`.
    pub rows: Vec<Measurement>,
    /// The line of each, counted from 1.
    pub lines: Vec<u32>,
    /// The duration of each contact in s; empty if it was not measured.
    pub durations: Vec<f64>,
    /// The unit of the velocities.
    pub unit: String,
    /// Its size in m/s.
    pub unit_size: f64,
    /// What was taken for granted or left out, a sentence each.
    pub remarks: Vec<String>,
}

impl Data {
    /// Reads the measurements of a file.
    ///
    /// Cost: two passes over the text; some 100 bytes of memory for a row beside it.
    ///
    /// # Errors
    ///
    /// [`DataError`]; what could be read in two ways is refused with the option that decides.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_fit::{Data, DataError, DataOptions, Method};
    ///
    /// let data = Data::read(b"% Fallversuch\nDrop height (cm);Rebound height (cm)\n20,0;5,0\n".to_vec(), &DataOptions::default())?;
    /// assert_eq!((data.method, data.rows[0].epsilon(), data.lines[0]), (Method::Heights, 0.5, 3));
    ///
    /// let asked = Data::read(b"g\tepsilon\n1,203\t5/6\n".to_vec(), &DataOptions::default());
    /// assert!(asked.unwrap_err().to_string().contains("'1,203' may mean 1.203 or 1203"));
    /// # Ok::<(), DataError>(())
    /// ```
    pub fn read(bytes: Vec<u8>, options: &DataOptions) -> Result<Self, DataError> {
        let mut sheet = Sheet::read(bytes, options.dialect)?;
        let mut selection = select::select(&sheet, options);
        if selection.is_err() && sheet.has_comment_names() {
            sheet = sheet.without_comment_names();
            selection = select::select(&sheet, options);
        }
        Reader::new(&sheet, selection?, options)?.read()
    }

    /// A velocity in the unit of the table, in m/s.
    pub fn in_si(&self, velocity: f64) -> f64 {
        velocity * self.unit_size
    }

    /// Keeps the rows with velocities between `low` and `high`, in m/s, ends included; returns how many were left out.
    pub fn keep_between(&mut self, low: f64, high: f64) -> usize {
        let before = self.rows.len();
        let inside = |row: &Measurement| (low..=high).contains(&self.in_si(row.velocity()));
        let kept = self.rows.iter().map(inside).collect::<Vec<_>>();
        let mut flags = kept.iter();
        self.lines.retain(|_| *flags.next().unwrap_or(&true));
        let mut flags = kept.iter();
        self.durations.retain(|_| *flags.next().unwrap_or(&true));
        let mut flags = kept.iter();
        self.rows.retain(|_| *flags.next().unwrap_or(&true));
        before - self.rows.len()
    }
}

struct Reader<'a> {
    sheet: &'a Sheet,
    options: &'a DataOptions,
    method: Method,
    assumed: bool,
    sources: Vec<Source>,
}

impl<'a> Reader<'a> {
    fn new(sheet: &'a Sheet, selection: Selection, options: &'a DataOptions) -> Result<Self, DataError> {
        let line = sheet.header().unwrap_or(1);
        let firsts = first_units(sheet, &selection)?;
        let source = |(&(role, place), first): (&(Role, usize), &Option<String>)| {
            Source::of(role, place, &sheet.columns()[place], first.as_deref(), options)
                .map_err(|reason| DataError::Row { line, reason })
        };
        let sources = selection.columns.iter().zip(&firsts).map(source).collect::<Result<_, _>>()?;
        Ok(Self { sheet, options, method: selection.method, assumed: selection.assumed, sources })
    }

    fn read(&self) -> Result<Data, DataError> {
        let places = self.sources.iter().map(|source| source.place).collect::<Vec<_>>();
        let decimal = self.sheet.decimal(&places)?;
        let velocity = self.sources[0].role.dimension() == Some(Dimension::Velocity);
        let (unit, unit_size) = if velocity {
            (self.sources[0].unit.clone(), self.sources[0].size)
        } else {
            ("m/s".to_owned(), 1.0)
        };
        let mut data = Data {
            method: self.method,
            rows: Vec::new(),
            lines: Vec::new(),
            durations: Vec::new(),
            unit,
            unit_size,
            remarks: Vec::new(),
        };
        let mut missing: Option<(usize, usize)> = None;
        let mut times: Vec<(usize, f64)> = Vec::new();
        let mut values = Vec::with_capacity(self.sources.len());
        self.sheet.rows::<DataError>(|line, cells| {
            values.clear();
            for source in &self.sources {
                match source.value(cells[source.place], decimal, line)? {
                    Some(value) => values.push(value),
                    None if self.options.skip_missing => {
                        missing = Some(missing.map_or((1, line), |(number, first)| (number + 1, first)));
                        return Ok(());
                    }
                    None => return Err(self.blank(source, cells[source.place], line)),
                }
            }
            if self.method == Method::Bounces {
                times.push((line, values[0] * self.sources[0].size));
                return Ok(());
            }
            self.push(&mut data, &values).map_err(|reason| DataError::Row { line, reason })?;
            data.lines.push(u32::try_from(line).unwrap_or(u32::MAX));
            Ok(())
        })?;
        let series = self.bounce(&mut data, &times)?;
        if data.rows.is_empty() {
            return Err(match self.sheet.header() {
                Some(line) if missing.is_none() => crate::sheet::SheetError::NoRows { line }.into(),
                _ => DataError::NoRows,
            });
        }
        self.remark(&mut data, missing, series);
        Ok(data)
    }

    fn blank(&self, source: &Source, cell: &str, line: usize) -> DataError {
        let says = if cell.is_empty() { "is blank".to_owned() } else { format!("'{cell}' is not a number") };
        let reason =
            format!("the {} {says}: fill it in, delete the line or give --skip-missing", source.role.noun());
        DataError::Row { line, reason }
    }

    /// Adds one collision.
    fn push(&self, data: &mut Data, values: &[f64]) -> Result<(), String> {
        let si = |k: usize| values[k] * self.sources[k].size;
        let words = |error: crate::FitError| {
            let exchanged = self.assumed && matches!(error, crate::FitError::Epsilon { .. });
            let hint = if exchanged { "; if the columns are exchanged, give --columns 2,1" } else { "" };
            format!("{error}{hint}")
        };
        let (one, other) = self.pair();
        let row = match self.method {
            Method::Coefficients => Measurement::new(values[one], si(other)),
            Method::Speeds => Measurement::of_speeds(values[one], si(other) / self.sources[one].size),
            Method::Heights => Measurement::of_heights(si(one), si(other), self.options.gravity),
            Method::Bounces => return Ok(()),
        };
        let mut row = row.map_err(words)?;
        for (k, source) in self.sources.iter().enumerate() {
            match source.role {
                Role::Sigma => row = row.with_sigma(si(k)).map_err(words)?,
                Role::Duration if si(k) > 0.0 && si(k).is_finite() => data.durations.push(si(k)),
                Role::Duration => return Err(words(crate::FitError::Duration { value: si(k) })),
                _ => {}
            }
        }
        data.rows.push(row);
        Ok(())
    }

    /// Where the two columns stand that every method but that of times needs.
    fn pair(&self) -> (usize, usize) {
        let place = |role: Role| self.sources.iter().position(|source| source.role == role).unwrap_or(0);
        match self.method.needs() {
            [one, other] => (place(*one), place(*other)),
            _ => (0, 0),
        }
    }

    /// Makes collisions of times; a time earlier than the one before begins another series. Returns their number.
    fn bounce(&self, data: &mut Data, times: &[(usize, f64)]) -> Result<usize, DataError> {
        let series = times.chunk_by(|one, other| other.1 > one.1);
        let mut number = 0;
        for run in series {
            let seconds = run.iter().map(|(_, time)| *time).collect::<Vec<_>>();
            let line = run[0].0;
            let rows = bounces(&seconds, self.options.gravity)
                .map_err(|error| DataError::Row { line, reason: error.to_string() })?;
            data.rows.extend(rows);
            data.lines.extend(
                run[1..run.len() - 1].iter().map(|(line, _)| u32::try_from(*line).unwrap_or(u32::MAX)),
            );
            number += 1;
        }
        Ok(number)
    }

    fn remark(&self, data: &mut Data, missing: Option<(usize, usize)>, series: usize) {
        let columns = self.sources.iter().map(|source| {
            let unit = if source.unit.is_empty() { String::new() } else { format!(" in {}", source.unit) };
            format!("column {} as the {}{unit}", source.place + 1, source.role.noun())
        });
        if self.assumed {
            data.remarks.push(format!("No header: read {}.", columns.collect::<Vec<_>>().join(", ")));
        } else if let Some(source) =
            self.sources.iter().find(|source| !source.stated && source.role.dimension().is_some())
        {
            data.remarks.push(format!(
                "No unit beside the {}: {} was taken.",
                source.role.noun(),
                source.unit
            ));
        }
        if let Some((number, first)) = missing {
            let rows = if number == 1 { "row" } else { "rows" };
            data.remarks
                .push(format!("{number} {rows} without a value left out, the first in line {first}."));
        }
        if series > 1 {
            data.remarks.push(format!("{series} series of bounces, told apart by times that go back."));
        }
        if matches!(self.method, Method::Heights | Method::Bounces) {
            data.remarks.push(format!(
                "Free fall with {} m/s^2; drag is left out, and lowers epsilon.",
                self.options.gravity
            ));
        }
    }
}

/// The unit that the first cell of each column repeats, if its head has none.
fn first_units(sheet: &Sheet, selection: &Selection) -> Result<Vec<Option<String>>, DataError> {
    let mut units = vec![None; selection.columns.len()];
    let mut seen = false;
    sheet.rows::<DataError>(|_, cells| {
        if !seen {
            for ((role, place), unit) in selection.columns.iter().zip(&mut units) {
                let text = split(cells[*place]).1;
                let known = role.dimension().is_some_and(|dimension| {
                    size(text, dimension).is_some_and(|size| size.to_f64().is_some())
                });
                *unit = known.then(|| text.to_owned());
            }
        }
        seen = true;
        Ok(())
    })?;
    Ok(units)
}
