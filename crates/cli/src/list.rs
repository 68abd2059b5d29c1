//! Lists and grids of numbers with or without units: `1cm/s,2cm/s`, `0.1:2:20`, `1cm/s:10m/s:50log`.

use crate::exact::Exact;
use crate::units::{self, Quantity};
use std::fmt::Display;

/// The most points of a grid.
const MOST_POINTS: usize = 100_000;

/// What a list can be made of.
pub trait Entry: Sized + Clone + Display {
    /// The value, in units that all entries share.
    fn value(&self) -> f64;

    /// The size of the unit that the entry was typed with, and its text.
    fn unit(&self) -> (f64, &str);
}

impl Entry for Exact {
    fn value(&self) -> f64 {
        self.to_f64()
    }

    fn unit(&self) -> (f64, &str) {
        (1.0, "")
    }
}

impl Entry for Quantity {
    fn value(&self) -> f64 {
        self.to_f64()
    }

    fn unit(&self) -> (f64, &str) {
        (self.unit_size(), Quantity::unit(self).unwrap_or_default())
    }
}

/// The entries of one argument.
///
/// # Examples
///
/// ```
/// use restitution_cli::list::velocities;
///
/// let typed = |text| velocities(text).map(|list| list.0.iter().map(ToString::to_string).collect::<Vec<_>>());
/// assert_eq!(typed("1cm/s, 2cm/s").unwrap(), ["1cm/s", "2cm/s"]);
/// assert_eq!(typed("1cm/s:1m/s:3log").unwrap(), ["1cm/s", "10cm/s", "1m/s"]);
/// assert_eq!(typed("1:2:5").unwrap(), ["1", "1.25", "1.5", "1.75", "2"]);
///
/// assert!(typed("0,5").unwrap_err().contains("write 0.5"));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct List<T>(pub Vec<T>);

/// Reads a list of velocities; for clap's `value_parser`.
///
/// # Errors
///
/// The line to print.
pub fn velocities(text: &str) -> Result<List<Quantity>, String> {
    List::parse(text, |entry| units::velocity(entry).map_err(|error| error.to_string()))
}

/// Reads a list of numbers of at least 0; for clap's `value_parser`.
///
/// # Errors
///
/// The line to print.
pub fn at_least_zero(text: &str) -> Result<List<Exact>, String> {
    List::parse(text, |entry| crate::exact::at_least_zero(entry).map_err(|error| error.to_string()))
}

/// The entries of several arguments, one after the other.
pub fn flat<T: Clone>(lists: &[List<T>]) -> Vec<T> {
    lists.iter().flat_map(|list| list.0.iter().cloned()).collect()
}

impl<T: Entry> List<T> {
    /// Reads entries between commas, each a value or a grid.
    ///
    /// A grid is `FROM:TO:N`, equally spaced, or `FROM:TO:Nlog`, of equal ratio. Its ends are as typed; what lies between
    /// is rounded to six digits, so that what is computed is what is printed.
    ///
    /// # Errors
    ///
    /// The line to print.
    pub fn parse(text: &str, read: impl Fn(&str) -> Result<T, String>) -> Result<Self, String> {
        if let Some(message) = decimal_comma(text) {
            return Err(message);
        }
        let mut entries = Vec::new();
        for part in text.split(',') {
            match part.split(':').collect::<Vec<_>>()[..] {
                [one] => entries.push(read(one)?),
                [from, to, points] => entries.extend(grid(&read(from)?, &read(to)?, points, &read)?),
                _ => {
                    return Err(format!(
                        "'{part}' is not a grid: write it as FROM:TO:N, or FROM:TO:Nlog for equal ratios, such as 1cm/s:10m/s:50log"
                    ));
                }
            }
        }
        Ok(Self(entries))
    }
}

fn grid<T: Entry>(
    from: &T,
    to: &T,
    points: &str,
    read: impl Fn(&str) -> Result<T, String>,
) -> Result<Vec<T>, String> {
    let points = points.trim();
    let (number, logarithmic) = match points.strip_suffix("log") {
        Some(number) => (number, true),
        None => (points.strip_suffix("lin").unwrap_or(points), false),
    };
    let number = number.trim().parse::<usize>().ok().filter(|n| (2..=MOST_POINTS).contains(n));
    let Some(number) = number else {
        return Err(format!(
            "'{points}' is not a number of points: give one from 2 to {MOST_POINTS}, with log behind it for equal ratios"
        ));
    };
    let (size, unit) = from.unit();
    let (low, high) = (from.value() / size, to.value() / size);
    if unit.is_empty() != to.unit().1.is_empty() {
        return Err(format!("of '{from}' and '{to}' one has a unit: give it with both or with none"));
    }
    if logarithmic && !(low > 0.0 && high > 0.0) {
        return Err(format!(
            "a grid of equal ratios from '{from}' to '{to}' has no points: give positive ends"
        ));
    }
    let between = |k: usize| {
        let part = k as f64 / (number - 1) as f64;
        let value = if logarithmic { low * (high / low).powf(part) } else { low + part * (high - low) };
        read(&format!("{}{unit}", format!("{value:.5e}").parse::<f64>().unwrap_or(value)))
    };
    let mut entries = vec![from.clone()];
    for k in 1..number - 1 {
        entries.push(between(k)?);
    }
    entries.push(to.clone());
    Ok(entries)
}

/// What to say about `0,5` and `1,5cm/s`, which are lists here and decimal fractions elsewhere.
fn decimal_comma(text: &str) -> Option<String> {
    let (whole, rest) = text.trim().split_once(',')?;
    let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
    let unit = rest[digits..].trim();
    if digits == 0 || whole.is_empty() || !whole.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let starts_like_a_unit = unit.starts_with(|c: char| c.is_alphabetic());
    let alone = unit.is_empty() && whole.bytes().all(|b| b == b'0');
    (alone || (starts_like_a_unit && !unit.contains(','))).then(|| {
        let (point, fraction) = (format!("{whole}.{}", &rest[..digits]), &rest[..digits]);
        format!(
            "'{text}' is a list of two here, as commas separate values: write {point}{unit} for the decimal, or {whole}{unit}, {fraction}{unit} for two"
        )
    })
    .filter(|_| !text.contains(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn typed(text: &str) -> Result<Vec<String>, String> {
        velocities(text).map(|list| list.0.iter().map(ToString::to_string).collect())
    }

    #[test]
    fn grids_keep_their_ends() {
        let list = velocities("1cm/s:10m/s:50log").unwrap().0;
        assert_eq!(list.len(), 50);
        assert_eq!((list[0].to_string().as_str(), list[49].to_string().as_str()), ("1cm/s", "10m/s"));
        assert!(
            list.windows(2)
                .all(|pair| (pair[1].to_f64() / pair[0].to_f64()).ln() - 1000f64.ln() / 49.0 < 1e-5)
        );
        assert_eq!(typed("1:3:3,7").unwrap(), ["1", "2", "3", "7"]);
        assert_eq!(typed("3:1:3lin").unwrap(), ["3", "2", "1"]);
        assert_eq!(at_least_zero("0:1:3").unwrap().0[1].to_string(), "0.5");
        assert_eq!(at_least_zero("0, 5").unwrap().0.len(), 2);
        assert_eq!(at_least_zero("1,2").unwrap().0.len(), 2);
    }

    #[test]
    fn what_is_no_list_is_refused() {
        for (text, part) in [
            ("0,5", "write 0.5 for the decimal"),
            ("1,5cm/s", "write 1.5cm/s for the decimal"),
            ("1:2", "is not a grid"),
            ("1:2:3:4", "is not a grid"),
            ("1:2:x", "is not a number of points"),
            ("1:2:1", "is not a number of points"),
            ("1:2:1000000", "is not a number of points"),
            ("0:2:5log", "give positive ends"),
            ("1cm/s:2:5", "one has a unit"),
            ("1cm/s,,2cm/s", "is not a number"),
            ("", "is not a number"),
            ("1mm:1m:3", "is a length"),
        ] {
            let message = typed(text).unwrap_err();
            assert!(message.contains(part), "{text}: {message}");
        }
    }
}
