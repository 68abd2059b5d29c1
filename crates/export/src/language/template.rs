//! Templates and their fields.
//!
//! `{FIELD}` is replaced. A line that starts with `?FLAG ` stands only if the flag is set, one with `!FLAG ` only if it
//! isn't; the flags are LAW (values beyond the range), NEAR (`1 - epsilon` has a polynomial of its own), ROOT (its
//! variable is `sqrt(u)`) and VELOCITY (a characteristic velocity is given).

use super::{Language, Rows};
use crate::Listing;
use crate::grid::Grid;
use crate::listing::u_at_g_star;
use crate::loss::Variable;

/// Returns the source.
pub(super) fn fill(language: &Language, listing: &Listing, name: &str) -> String {
    let flags = flags(listing);
    let mut text: String = language
        .template
        .lines()
        .filter_map(|line| kept(line, &flags))
        .map(|line| format!("{line}\n"))
        .collect();
    for (field, value) in fields(language, listing, name) {
        text = text.replace(&format!("{{{field}}}"), &value);
    }
    text
}

/// The flags that are set.
fn flags(listing: &Listing) -> Vec<&'static str> {
    let flags = [
        ("LAW", listing.pieces.law.is_some()),
        ("NEAR", !listing.loss.coefficients.is_empty()),
        ("ROOT", listing.loss.variable == Variable::SqrtU),
        ("VELOCITY", listing.velocity.is_some()),
    ];
    flags.into_iter().filter(|(_, set)| *set).map(|(flag, _)| flag).collect()
}

/// The line without its condition, if that is met.
fn kept<'a>(line: &'a str, flags: &[&str]) -> Option<&'a str> {
    let wanted = match line.as_bytes().first() {
        Some(b'?') => true,
        Some(b'!') if line.as_bytes().get(1).is_some_and(u8::is_ascii_uppercase) => false,
        _ => return Some(line),
    };
    let (flag, rest) = line[1..].split_once(' ').unwrap_or((&line[1..], ""));
    if flags.contains(&flag) == wanted { kept(rest, flags) } else { None }
}

/// Every field and its value.
fn fields(language: &Language, listing: &Listing, name: &str) -> Vec<(&'static str, String)> {
    let (pieces, rows) = (&listing.pieces, &language.rows);
    let plain = |x: f64| number(x, "");
    let bits = |x: f64| x.to_bits().to_string();
    let (low, high) = (listing.request.range.0, listing.last());
    let law = pieces.law;
    let from = law.map_or(f64::INFINITY, |law| law.from);
    let law_first = Grid { shift: 0.0, ..pieces.grid }.number(from);
    let checks: Vec<Vec<f64>> = listing.checks.iter().map(|check| check.to_vec()).collect();
    let near = &listing.loss.coefficients;
    let g_star = listing.velocity.as_ref().map_or(f64::NAN, |velocity| velocity.metres_per_second);
    let head =
        listing.head().into_iter().map(|line| format!("{}{line}", language.comment).trim_end().to_owned());
    vec![
        ("HEAD", head.collect::<Vec<_>>().join("\n")),
        ("OPTIONS", listing.options()),
        ("LANGUAGE", language.name.to_owned()),
        ("FILE", language.file.replace("NAME", name)),
        ("NAME", name.to_owned()),
        ("CAPITALS", name.to_uppercase()),
        ("FINGERPRINT", format!("{:016X}", fingerprint(listing))),
        ("TABLE", table(rows, "table", &pieces.rows, 0)),
        ("ROWS", pieces.rows.len().to_string()),
        ("LAST_ROW", (pieces.rows.len() - 1).to_string()),
        ("WIDTH", pieces.rows[0].len().to_string()),
        ("DEGREE", (pieces.rows[0].len() - 1).to_string()),
        ("SHIFT", plain(pieces.grid.shift)),
        ("BITS", pieces.grid.bits.to_string()),
        ("REST", pieces.grid.rest().to_string()),
        ("FIRST", pieces.first.to_string()),
        ("LOW", plain(low)),
        ("HIGH", plain(if high.is_finite() { high } else { f64::MAX })),
        ("LOW_BITS", bits(low)),
        ("HIGH_BITS", bits(high)),
        ("NEAR", list(near, rows)),
        ("NEAR_COUNT", near.len().to_string()),
        ("NEAR_LAST", near.len().saturating_sub(1).to_string()),
        ("NEAR_ROW", listing.loss.near_row.to_string()),
        ("LAW_FROM", plain(from)),
        ("LAW_BITS", bits(from)),
        ("LAW_FIRST", law_first.to_string()),
        ("LAW_ROW", pieces.law_row.to_string()),
        ("OCTAVES", law.map_or(1, |law| law.octaves).to_string()),
        ("FALL", law.map_or(1, |law| law.octaves + 5).to_string()),
        ("CHECKS", checks.len().to_string()),
        ("POINTS", table(rows, "check", &checks, 1)),
        ("TOLERANCE", format!("{:e}", listing.request.tolerance)),
        ("LOSS_BOUND", format!("{:.1e}", listing.loss.bound * 1.05)),
        ("G_STAR", plain(g_star)),
        ("U_AT_G_STAR", plain(u_at_g_star().to_f64())),
    ]
}

/// The rows of an array called `what`, numbered from `first`.
fn table(rows: &Rows, what: &str, numbers: &[Vec<f64>], first: usize) -> String {
    let line = |(i, row): (usize, &Vec<f64>)| {
        let before = rows.before.replace("{what}", what).replace("{i}", &(i + first).to_string());
        before + &list(row, rows) + rows.after
    };
    let lines: String = numbers.iter().enumerate().map(line).collect();
    lines.trim_end_matches('\n').to_owned()
}

/// Tells tables apart.
fn fingerprint(listing: &Listing) -> u64 {
    let constants = listing.pieces.rows.iter().flatten();
    constants.fold(0xcbf2_9ce4_8422_2325, |hash, c| (hash ^ c.to_bits()).wrapping_mul(0x0100_0000_01b3))
}

fn list(numbers: &[f64], rows: &Rows) -> String {
    numbers.iter().map(|x| number(*x, rows.suffix)).collect::<Vec<_>>().join(rows.between)
}

/// A number with 17 significant digits, which give the f64 back.
fn number(x: f64, suffix: &str) -> String {
    format!("{x:.16e}{suffix}")
}
