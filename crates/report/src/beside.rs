//! The times of another build beside those of this one.

use crate::ReportError;
use crate::contestants::{Contestant, Family};
use crate::machine::Machine;
use crate::page::{Data, Figure, Section};
use crate::speed::{self, RANGES, Result as Measured, end_name, figures};
use restitution_table::{Cell, Table};
use std::collections::BTreeMap;

/// The file of a report that says on what it was measured.
pub const MACHINE: &str = "machine.csv";
/// The rows of [`MACHINE`] that two builds for one machine have in common, and that in which they differ.
const SAME: [&str; 2] = ["processor", "version"];
const INSTRUCTIONS: &str = "instructions";

/// What a report of another build says.
#[derive(Clone, Debug)]
pub struct Beside {
    machine: BTreeMap<String, String>,
    /// Nanoseconds by method, range and column.
    times: BTreeMap<(String, String), [f64; 2]>,
}

impl Beside {
    /// Reads the two files of a report, given as text: those of [`Beside::FILES`].
    ///
    /// # Errors
    ///
    /// [`ReportError`] if one of them is not a file of a report, or comes from another processor or another version.
    ///
    /// ```
    /// use restitution_report::Beside;
    ///
    /// let error = Beside::read("u,v\n1,2\n", "what,value\n").unwrap_err();
    /// assert!(error.to_string().contains("no report of this version"));
    /// ```
    pub fn read(speed: &str, machine: &str) -> Result<Self, ReportError> {
        let machine =
            rows(machine, ["what", "value"])?.into_iter().map(|[what, value]| (what, value)).collect();
        let times = rows(speed, ["method", "u_to", "ns", "chained_ns"])?.into_iter();
        let times = times.map(|[method, range, apart, chained]| {
            let number = |text: String| text.parse::<f64>().ok().filter(|ns| *ns > 0.0).ok_or_else(no_report);
            Ok(((method, range), [number(apart)?, number(chained)?]))
        });
        let other = Self { machine, times: times.collect::<Result<_, ReportError>>()? };
        let here = Machine::this();
        if other.of(INSTRUCTIONS).is_empty() {
            return Err(no_report());
        }
        for what in SAME {
            let (ours, theirs) = (here.of(what), other.of(what));
            if ours != theirs {
                return Err(ReportError::failure(format!(
                    "its {what} is '{theirs}', here it is '{ours}': builds are compared on one machine and in one version, make it anew"
                )));
            }
        }
        Ok(other)
    }

    /// The files that [`Beside::read`] takes, in this order.
    pub const FILES: [&str; 2] = [speed::FILE, MACHINE];

    fn of(&self, what: &str) -> &str {
        self.machine.get(what).map_or("", String::as_str)
    }
}

/// The columns of these names, row by row.
fn rows<const N: usize>(text: &str, names: [&str; N]) -> Result<Vec<[String; N]>, ReportError> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().map_err(|_| no_report())?.clone();
    let place = |name: &str| header.iter().position(|column| column == name).ok_or_else(no_report);
    let places = names.map(place).into_iter().collect::<Result<Vec<_>, _>>()?;
    let row = |record: csv::Result<csv::StringRecord>| {
        let record = record.map_err(|_| no_report())?;
        Ok(std::array::from_fn(|i| record.get(places[i]).unwrap_or_default().to_owned()))
    };
    reader.records().map(row).collect()
}

fn no_report() -> ReportError {
    ReportError::failure("it holds no report of this version: give the folder of one")
}

/// The part of the report on two builds.
pub fn section(contestants: &[Contestant], results: &[Measured], other: &Beside) -> Section {
    let range = RANGES[RANGES.len() - 1];
    let mut table = Table::new(&[
        "method",
        "end",
        "ns",
        "other_ns",
        "ratio",
        "chained_ns",
        "chained_other_ns",
        "chained_ratio",
    ]);
    let shown = |family| !matches!(family, Family::Series | Family::Pade | Family::TwoPoint);
    for r in results.iter().filter(|r| r.range == range && shown(contestants[r.contestant].family)) {
        let contestant = &contestants[r.contestant];
        let Some(theirs) = other.times.get(&(contestant.name.clone(), range.to_string())) else { continue };
        let mut row = vec![contestant.name.as_str().into(), end_name(contestant.end).into()];
        for (ours, theirs) in
            [r.apart, r.chained].map(|t| t.median / speed::NANOSECOND).into_iter().zip(theirs)
        {
            row.extend([ours, *theirs, ours / theirs].map(|t| Cell::digits(figures(t, 3))));
        }
        table.push(row);
    }
    Section::new(
        "Two builds",
        &format!(
            "Instructions of this build: {}; of the other: {}. Batches choose the widest vectors of the processor when they run, so that they hardly differ; single calls use what the build allows. Times for 0 < u ≤ {range}, of two runs one after the other: what disturbed one of them is in the ratios.",
            Machine::this().of(INSTRUCTIONS),
            other.of(INSTRUCTIONS)
        ),
        vec![Figure::table("", Data::new("two-builds.csv", table))],
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use restitution_table::Format;

    fn machine() -> String {
        Machine::this().table().render(Format::Csv)
    }

    #[test]
    fn a_report_of_this_machine_is_read() {
        let speed = "u_to,method,ns,chained_ns\n7.5,\"a, b\",0.5,12\n";
        let read = Beside::read(speed, &machine()).unwrap();
        assert_eq!(read.times[&("a, b".to_owned(), "7.5".to_owned())], [0.5, 12.0]);
    }

    #[test]
    fn what_is_no_report_or_another_machines_is_refused() {
        let speed = "u_to,method,ns,chained_ns\n";
        for bad in
            ["", "u_to,method,ns\n", "u_to,method,ns,chained_ns\n1,a,b,2\n", "u_to,method,ns,chained_ns\n1\n"]
        {
            assert!(Beside::read(bad, &machine()).is_err(), "{bad:?}");
        }
        let older: String =
            machine().lines().filter(|l| !l.starts_with(INSTRUCTIONS)).map(|l| format!("{l}\n")).collect();
        assert!(Beside::read(speed, &older).is_err());
        let other = machine().replace(&Machine::this().of("version"), "restitution 0.0.1");
        let refused = Beside::read(speed, &other).unwrap_err().to_string();
        assert!(refused.starts_with("its version is 'restitution 0.0.1'"), "{refused}");
    }
}
