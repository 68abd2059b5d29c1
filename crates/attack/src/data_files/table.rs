//! A table of measurements with a known `g*`, written in some way that people and programs write tables.

use crate::random::{Source, by_ratio, choose};
use rand::RngExt;
use restitution::{End, Restitution};

/// Units of velocity and what they are in m/s.
const UNITS: [(&str, f64); 7] = [
    ("m/s", 1.0),
    ("cm/s", 1e-2),
    ("mm/s", 1e-3),
    ("km/h", 1.0 / 3.6),
    ("m s-1", 1.0),
    ("ft/s", 0.3048),
    ("", 1.0),
];
const VELOCITY: [&str; 8] = ["g", "v", "velocity", "speed", "impact velocity", "V", "v_imp", "Velocity"];
const COEFFICIENT: [&str; 7] =
    ["epsilon", "e", "cor", "COR", "eps", "coefficient of restitution", "restitution"];

/// A file and what it says.
#[derive(Clone, Debug)]
pub struct Written {
    /// The file.
    pub bytes: Vec<u8>,
    /// The characteristic velocity it was made with, in m/s.
    pub g_star: f64,
    /// Where its contacts end.
    pub end: End,
}

/// How a table is written.
struct Style {
    separator: &'static str,
    decimal_comma: bool,
    number: u32,
    header: u32,
    unit: &'static str,
    line_end: &'static str,
    quoted: bool,
    padded: bool,
    extra: bool,
    swapped: bool,
    comment: Option<&'static str>,
}

/// What a unit is in m/s, without a unit that of the default.
pub fn metres_per_second(unit: &str) -> Option<f64> {
    UNITS.iter().find(|(name, _)| *name == unit.trim()).map(|(_, factor)| *factor)
}

impl Written {
    /// Writes a random table.
    pub fn new(random: &mut Source) -> Self {
        let style = Style::new(random);
        let end = *choose(random, &[End::ZeroCompression, End::ZeroForce]);
        let g_star = by_ratio(random, 1e-3, 10.0);
        let rows = match random.random_range(0..50) {
            0 => random.random_range(1000..20_000),
            _ => random.random_range(4..30),
        };
        let curve = Restitution::from_g_star(g_star, end);
        let factor = metres_per_second(style.unit).unwrap_or(1.0);
        let mut text = style.head(random);
        for row in 0..rows {
            let velocity = g_star * by_ratio(random, 1e-3, 1.0);
            let shown = style.number(velocity / factor);
            let exact: f64 = shown.replace(',', ".").replace('D', "E").parse().unwrap_or(velocity / factor);
            let epsilon = style.number(curve.epsilon(exact * factor));
            text.push_str(&style.row(&[&shown, &epsilon], row));
        }
        let mut bytes = text.into_bytes();
        match random.random_range(0..12) {
            0 => drop(bytes.splice(0..0, *b"\xef\xbb\xbf")),
            1 => drop(bytes.pop()), // no end of the last line, or half of it
            _ => {}
        }
        Self { bytes, g_star, end }
    }
}

/// Whether there is a header; one that has a unit to tell always.
fn has_header(header: u32, unit: &str) -> bool {
    header < 7 || !unit.is_empty()
}

impl Style {
    fn new(random: &mut Source) -> Self {
        let (header, unit) = (random.random_range(0..8), choose(random, &UNITS).0);
        let named = has_header(header, unit); // without, the order is velocity, coefficient
        let separator = *choose(random, &[",", ",", ",", ";", "\t", " ", "  ", " , ", ";\t"]);
        Self {
            separator,
            decimal_comma: !separator.contains(',') && random.random_bool(0.3),
            number: random.random_range(0..4),
            header,
            unit,
            line_end: *choose(random, &["\n", "\n", "\n", "\r\n", "\r\n", "\r"]),
            quoted: random.random_bool(0.1),
            padded: random.random_bool(0.1),
            extra: random.random_bool(0.15),
            swapped: named && random.random_bool(0.2),
            comment: if random.random_bool(0.3) { Some(*choose(random, &["# ", "% ", "#"])) } else { None },
        }
    }

    /// Five digits.
    fn number(&self, x: f64) -> String {
        let plain = format!("{:.*}", (4 - x.abs().log10().floor() as i32).clamp(0, 12) as usize, x);
        let text = match self.number {
            0 => format!("{x:.4e}"),
            1 => format!("{x:.4E}").replace('E', "D"),
            _ => plain,
        };
        if self.decimal_comma { text.replace('.', ",") } else { text }
    }

    /// Comments and the header.
    fn head(&self, random: &mut Source) -> String {
        let mut text = String::new();
        if let Some(mark) = self.comment {
            text.push_str(&format!("{mark}measured with a ball, run 7{}", self.line_end));
        }
        let velocity = *choose(random, &VELOCITY);
        let named = match (self.header, self.unit) {
            (_, "") => velocity.to_owned(),
            (0..=2, unit) => format!("{velocity}[{unit}]"),
            (3 | 4, unit) => format!("{velocity} ({unit})"),
            (_, unit) => format!("{velocity} / {unit}"),
        };
        // Without a header there is no unit, and so no other than m/s.
        if has_header(self.header, self.unit) {
            text.push_str(
                &self.row(&[&named, *choose(random, &COEFFICIENT)], 0).replace("extra", "temperature"),
            );
        }
        text
    }

    fn row(&self, cells: &[&str; 2], number: usize) -> String {
        let is_header = cells[0].starts_with(|c: char| c.is_alphabetic());
        let cell = |text: &&str| {
            let words = is_header && self.separator.trim().is_empty() && self.separator != "\t";
            if self.quoted || (words && text.contains(' ')) {
                format!("\"{text}\"")
            } else {
                (*text).to_owned()
            }
        };
        let mut written: Vec<String> = cells.iter().map(cell).collect();
        if self.swapped {
            written.reverse();
        }
        if self.extra {
            written.push(if is_header { "extra".to_owned() } else { format!("{}", 20 + number % 3) });
        }
        let line = written.join(self.separator);
        if self.padded { format!("  {line} {}", self.line_end) } else { format!("{line}{}", self.line_end) }
    }
}
