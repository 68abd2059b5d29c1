//! A CSV file of measurements, read with care for its lines.

use crate::CliError;
use crate::units::{Dimension, Quantity};
use csv::StringRecord;
use restitution::Measurement;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// The largest file that is read: no table of collisions comes near.
const LARGEST_FILE: u64 = 100_000_000;
const VELOCITY_NAMES: [&str; 6] = ["g", "v", "velocity", "speed", "impact velocity", "impact_velocity"];
const EPSILON_NAMES: [&str; 7] =
    ["epsilon", "eps", "e", "cor", "restitution", "coefficient of restitution", "ε"];

/// The measurements of a file.
#[derive(Debug)]
pub(super) struct Data {
    /// The pairs, with velocities in `unit`.
    pub(super) rows: Vec<Measurement>,
    /// The line of each, counted from 1.
    pub(super) lines: Vec<usize>,
    /// The unit of the velocities.
    pub(super) unit: String,
}

impl Data {
    /// Reads the file; `unit` is what `--velocity-unit` said.
    pub(super) fn read(path: &Path, unit: Option<&str>) -> Result<Self, CliError> {
        let name = path.display();
        let cannot = |error: std::io::Error| {
            let reason = error.to_string().to_lowercase();
            CliError::usage(format!(
                "cannot read '{name}': {}",
                reason.split(" (os error").next().unwrap_or_default()
            ))
        };
        let mut bytes = Vec::new();
        let source: Box<dyn Read> = match path.to_str() {
            Some("-") => Box::new(std::io::stdin()),
            _ => Box::new(File::open(path).map_err(cannot)?),
        };
        source.take(LARGEST_FILE + 1).read_to_end(&mut bytes).map_err(cannot)?;
        if bytes.len() as u64 > LARGEST_FILE {
            return Err(CliError::usage(format!(
                "'{name}' has more than 100 MB: give a table of measurements"
            )));
        }
        let text = String::from_utf8(bytes)
            .map_err(|_| CliError::usage(format!("'{name}' is not text: give a CSV file in UTF-8")))?;
        Self::parse(&text, unit).map_err(|error| CliError::usage(format!("'{name}' {error}")))
    }

    fn parse(text: &str, unit: Option<&str>) -> Result<Self, String> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let delimiter = delimiter(text);
        let filled =
            text.lines().zip(1..).filter(|(line, _)| !line.starts_with('#') && !line.trim().is_empty());
        let mut records = filled.map(|(line, number)| match record(line, delimiter) {
            Some(record) => Ok((number, record)),
            None => Err(format!("line {number} is not CSV: give one row to a line")),
        });
        let (line, header) =
            records.next().ok_or("is empty: give a header line and rows of measurements")??;
        let columns = Columns::find(&header, unit).map_err(|reason| format!("line {line}: {reason}"))?;
        let mut data = Self { rows: Vec::new(), lines: Vec::new(), unit: columns.unit.clone() };
        for record in records {
            let (line, record): (usize, _) = record?;
            if record.iter().all(str::is_empty) {
                continue;
            }
            let row = columns.read(&record).map_err(|reason| format!("line {line}: {reason}"))?;
            data.rows.push(row);
            data.lines.push(line);
        }
        if data.rows.is_empty() {
            return Err(format!("has no row below the header in line {line}: give measurements"));
        }
        Ok(data)
    }
}

/// The delimiter of the first line that is not a comment: comma, semicolon or tab.
fn delimiter(text: &str) -> u8 {
    let header =
        text.lines().find(|line| !line.starts_with('#') && !line.trim().is_empty()).unwrap_or_default();
    [b',', b';', b'\t'].into_iter().find(|d| header.as_bytes().contains(d)).unwrap_or(b',')
}

/// Reads one line; line by line, because the reader of whole files does not count the blank ones.
fn record(line: &str, delimiter: u8) -> Option<StringRecord> {
    let mut builder = csv::ReaderBuilder::new();
    let reader = builder.has_headers(false).delimiter(delimiter).trim(csv::Trim::All);
    let mut records = reader.from_reader(line.as_bytes()).into_records();
    records.next()?.ok()
}

/// Where velocity and coefficient stand, and the unit of the velocity.
struct Columns {
    velocity: usize,
    epsilon: usize,
    width: usize,
    unit: String,
}

impl Columns {
    fn find(header: &StringRecord, asked: Option<&str>) -> Result<Self, String> {
        if header.iter().all(|cell| Quantity::parse(cell, Dimension::Velocity).is_ok()) {
            return Err(
                "there are numbers where the header should be: begin with a line such as g[cm/s],epsilon"
                    .into(),
            );
        }
        let named = header.iter().map(split_unit).collect::<Vec<_>>();
        let (velocity, unit) = one_column(&named, &VELOCITY_NAMES, "velocity, such as g[cm/s]")?;
        let (epsilon, percent) = one_column(&named, &EPSILON_NAMES, "coefficients, such as epsilon")?;
        if let Some(unit) = percent.filter(|unit| !matches!(*unit, "" | "1" | "-")) {
            return Err(format!("the coefficients are in '{unit}': give them as plain numbers"));
        }
        let unit = match (unit, asked) {
            (Some(header), Some(asked)) if header != asked => {
                return Err(format!(
                    "the header says {header} and --velocity-unit says {asked}: give one of them"
                ));
            }
            (Some(unit), _) | (None, Some(unit)) => unit,
            (None, None) => "m/s",
        };
        Quantity::parse(&format!("1{unit}"), Dimension::Velocity).map_err(|error| error.to_string())?;
        Ok(Self { velocity, epsilon, width: header.len(), unit: unit.to_owned() })
    }

    fn read(&self, record: &StringRecord) -> Result<Measurement, String> {
        if record.len() != self.width {
            let (cells, columns) = (record.len(), self.width);
            return Err(format!("there are {cells} cells under {columns} columns: give one for each"));
        }
        let velocity = number(&record[self.velocity], "velocity", &self.unit)?;
        let epsilon = number(&record[self.epsilon], "coefficient", "")?;
        Measurement::new(velocity, epsilon).map_err(|error| error.to_string())
    }
}

/// Finds the only column of one of `names`; returns its place and unit.
fn one_column<'a>(
    named: &[(String, Option<&'a str>)],
    names: &[&str],
    what: &str,
) -> Result<(usize, Option<&'a str>), String> {
    let mut found = named.iter().enumerate().filter(|(_, (name, _))| names.contains(&name.as_str()));
    match (found.next(), found.next()) {
        (Some((place, (_, unit))), None) => Ok((place, *unit)),
        (None, _) => Err(format!("no column holds the {what}: name it in the header")),
        (Some(_), Some(_)) => Err(format!("more than one column could hold the {what}: rename the others")),
    }
}

/// Splits `g[cm/s]`, `g (cm/s)` into name and unit.
fn split_unit(cell: &str) -> (String, Option<&str>) {
    let (name, unit) = match cell.find(['[', '(']) {
        Some(start) => (&cell[..start], Some(cell[start + 1..].trim_end_matches([']', ')']).trim())),
        None => (cell, None),
    };
    (name.trim().to_lowercase(), unit)
}

/// Reads a number that may repeat the unit of its column, but not bring another.
fn number(cell: &str, what: &str, unit: &str) -> Result<f64, String> {
    if cell.is_empty() {
        return Err(format!("the {what} is blank: fill it in or delete the line"));
    }
    let bare = match cell.strip_suffix(unit) {
        Some(bare) if !unit.is_empty() => bare.trim(),
        _ => cell,
    };
    if let Ok(number) = bare.parse::<crate::exact::Exact>() {
        return Ok(number.to_f64());
    }
    match Quantity::parse(cell, Dimension::Velocity) {
        Ok(_) if unit.is_empty() => Err(format!("the {what} '{cell}' has a unit: give a plain number")),
        Ok(_) => Err(format!(
            "the {what} '{cell}' is in another unit than its column ({unit}): give all in one unit"
        )),
        Err(_) => Err(format!("the {what} '{cell}' is not a number: write it as 0.1 or 1e-3")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_of_many_makes_are_read() {
        for text in [
            "g[cm/s],epsilon\n1,0.5\n2,0.4\n",
            "\u{feff}velocity (cm/s);run;eps\r\n1;a;0.5\r\n\r\n2;b;4e-1\r\n",
            "# a comment\nCOR\tv [cm/s]\n0.5\t1cm/s\n2/5\t2\n",
        ] {
            let data = Data::parse(text, None).unwrap();
            assert_eq!(data.unit, "cm/s");
            assert_eq!(data.rows, [Measurement::new(1.0, 0.5).unwrap(), Measurement::new(2.0, 0.4).unwrap()]);
        }
        assert_eq!(Data::parse("g,e\n1,0.5\n", Some("mm/s")).unwrap().unit, "mm/s");
        assert_eq!(Data::parse("# two\n\ng,e\n1,0.5\n\n2,0.4", None).unwrap().lines, [4, 6]);
    }

    #[test]
    fn faults_are_named_with_their_line() {
        let message = |text: &str| Data::parse(text, None).unwrap_err();
        for (text, part) in [
            ("", "is empty"),
            ("g,epsilon\n", "has no row below the header in line 1"),
            ("1,0.5\n2,0.4\n", "line 1: there are numbers where the header should be"),
            ("g,epsilon\n1,0.5\n,0.4\n", "line 3: the velocity is blank"),
            ("g,epsilon\n1,NaN\n", "line 2: the coefficient 'NaN' is not a number"),
            ("g,epsilon\n1,fast\n", "line 2: the coefficient 'fast' is not a number"),
            ("g,epsilon\n1,0.5,3\n", "line 2: there are 3 cells under 2 columns"),
            ("g[cm/s],epsilon\n1,0.5\n1mm/s,0.5\n", "line 3: the velocity '1mm/s' is in another unit"),
            ("g[kg],epsilon\n1,0.5\n", "line 1: '1kg' is a mass, not a velocity"),
            ("g,epsilon\n1,57\n", "line 2: a measured coefficient of 57.0 cannot be used"),
            ("g,epsilon\n1,0\n", "line 2: a measured coefficient of 0.0 cannot be used"),
            ("g,epsilon\n-1,0.5\n", "line 2: an impact velocity of -1.0 cannot be used"),
            ("g,epsilon[%]\n1,50\n", "line 1: the coefficients are in '%'"),
            ("g,v,epsilon\n1,1,0.5\n", "line 1: more than one column could hold the velocity"),
            ("time,epsilon\n1,0.5\n", "line 1: no column holds the velocity"),
        ] {
            assert!(message(text).contains(part), "{text:?}: {}", message(text));
        }
        assert!(
            Data::parse("g[cm/s],e\n1,0.5\n", Some("m/s")).unwrap_err().contains("--velocity-unit says m/s")
        );
    }
}
