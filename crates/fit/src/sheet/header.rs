//! Names of columns and the units beside them.

use super::text::Separator;
use restitution_units::dimension_of;

/// The head of a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// The text of the cell.
    pub text: String,
    /// The name alone, in small letters, words separated by single blanks.
    pub name: String,
    /// The unit, if one stands beside the name.
    pub unit: Option<String>,
}

impl Column {
    /// Reads `g[cm/s]`, `g (cm/s)`, `g / cm/s`, `g in cm/s`, `g, cm/s`, `g cm/s`, `g_cm_s`.
    pub(super) fn of(cell: &str) -> Self {
        let (name, unit) = in_brackets(cell)
            .or_else(|| behind(cell, " in "))
            .or_else(|| behind_blank(cell))
            .or_else(|| behind(cell, "/"))
            .or_else(|| behind(cell, ","))
            .or_else(|| behind_underscore(cell))
            .map_or((cell, None), |(name, unit)| (name, Some(unit)));
        let name = name.trim().trim_end_matches(['/', ',']).replace(['_', '-'], " ").to_lowercase();
        let name = name.split_whitespace().map(word).collect::<Vec<_>>().join(" ");
        Self { text: cell.to_owned(), name, unit }
    }

    /// A column without a name.
    pub(super) fn unnamed() -> Self {
        Self { text: String::new(), name: String::new(), unit: None }
    }
}

fn is_unit(text: &str) -> bool {
    matches!(text, "%" | "-" | "1" | "") || dimension_of(text).is_some()
}

/// A word of a name without its abbreviation, its index on the line.
fn word(word: &str) -> String {
    if matches!(word.trim_end_matches('.'), "coeff" | "coef") {
        return "coefficient".to_owned();
    }
    let digit = |c: char| match c {
        '₀'..='₉' => char::from_u32(c as u32 - '₀' as u32 + '0' as u32).unwrap_or(c),
        _ => c,
    };
    word.chars().map(digit).collect()
}

/// What stands in the brackets at the end, be it a unit or not.
fn in_brackets(cell: &str) -> Option<(&str, String)> {
    let inner = cell.trim_end().strip_suffix([']', ')', '}', '>'])?;
    let mut depth = 0_usize;
    let start = inner.char_indices().rev().find_map(|(place, c)| {
        let opens = "[({<".contains(c);
        if opens && depth == 0 {
            return Some(place);
        }
        depth = if opens { depth - 1 } else { depth + usize::from("])}>".contains(c)) };
        None
    })?;
    let name = inner[..start].trim().trim_end_matches('/');
    // `(m/s)`, not `(impact)`: a word is part of the name, unless it should be the unit; `^{-1}` as LaTeX has it
    let unit = inner[start + 1..]
        .trim()
        .trim_start_matches("in ")
        .replace(['{', '}', '$'], "")
        .replace(" per ", "/");
    (!name.is_empty()).then_some((name, unit))
}

fn behind<'a>(cell: &'a str, mark: &str) -> Option<(&'a str, String)> {
    let (name, unit) = cell.split_once(mark)?;
    let unit = unit.trim();
    (is_unit(unit) && !unit.is_empty() && !name.trim().is_empty()).then(|| (name, unit.to_owned()))
}

/// `v cm/s`, `v m s-1`, `e %`: only what can be nothing but a unit.
fn behind_blank(cell: &str) -> Option<(&str, String)> {
    let places = cell.match_indices(' ').map(|(place, _)| place);
    places.into_iter().find_map(|place| {
        let (name, unit) = (&cell[..place], cell[place..].trim());
        let compound = unit == "%" || unit.contains(['/', '^', '-', '⁻', '·']);
        (compound && unit != "-" && is_unit(unit)).then(|| (name, unit.to_owned()))
    })
}

/// `v_cm_s`, `v_mm_per_s`, `v_mps`, `h_cm`.
fn behind_underscore(cell: &str) -> Option<(&str, String)> {
    let places = cell.match_indices('_').map(|(place, _)| place);
    places.into_iter().find_map(|place| {
        let (name, tail) = (&cell[..place], &cell[place + 1..]);
        let unit = tail.replace("_per_", "/").replacen('_', "/", 1);
        let long = unit.len() > 1 && (unit.contains('/') || !matches!(unit.as_str(), "in" | "min"));
        (long && dimension_of(&unit).is_some()).then_some((name, unit))
    })
}

/// Splits a header into as many cells as the rows have, if it can.
pub(super) fn split(line: &str, separator: Separator, width: usize) -> Option<Vec<String>> {
    let mut cells = Vec::new();
    separator.split(line, &mut cells);
    // a separator behind the last name, or behind the last number only
    while cells.len() > width && cells.last().is_some_and(|cell| cell.is_empty()) {
        cells.pop();
    }
    let plain = (cells.len() == width).then(|| cells.iter().map(ToString::to_string).collect());
    if separator != Separator::Blanks {
        return plain;
    }
    let by_two = line
        .split("  ")
        .flat_map(|part| part.split('\t'))
        .map(|cell| cell.trim().trim_matches('"').to_owned());
    let by_two = by_two.filter(|cell| !cell.is_empty()).collect::<Vec<_>>();
    [Some(joined(line)), Some(by_two), plain]
        .into_iter()
        .flatten()
        .find(|cells: &Vec<String>| cells.len() == width)
}

/// Splits by blanks, but not within brackets or around a stroke.
fn joined(line: &str) -> Vec<String> {
    let mut cells: Vec<String> = Vec::new();
    let (mut depth, mut glued) = (0_i32, false);
    let mut tokens = Vec::new();
    Separator::Blanks.split(line, &mut tokens);
    for token in tokens {
        let opens = token.starts_with(['[', '(', '{']);
        if let Some(last) = cells.last_mut()
            && (depth > 0 || glued || opens || token == "/")
        {
            last.push(' ');
            last.push_str(token);
        } else {
            cells.push(token.to_owned());
        }
        depth += token.chars().filter(|c| "[({".contains(*c)).count() as i32;
        depth -= token.chars().filter(|c| "])}".contains(*c)).count() as i32;
        glued = token == "/";
    }
    cells
}

/// Whether the cells say nothing but units, as some programs write them below the names.
pub(super) fn is_row_of_units(cells: &[String]) -> bool {
    let bare = |cell: &String| cell.trim_matches(['[', ']', '(', ')']).trim().to_owned();
    let units = cells.iter().map(bare).collect::<Vec<_>>();
    units.iter().all(|unit| is_unit(unit)) && units.iter().any(|unit| dimension_of(unit).is_some())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_units_are_told_apart() {
        for (cell, name, unit) in [
            ("g[cm/s]", "g", Some("cm/s")),
            ("Velocity (cm/s)", "velocity", Some("cm/s")),
            ("v / m/s", "v", Some("m/s")),
            ("v/(m s-1)", "v", Some("m s-1")),
            ("v/m/s", "v", Some("m/s")),
            ("impact velocity in mm/s", "impact velocity", Some("mm/s")),
            ("v, ft/s", "v", Some("ft/s")),
            ("v m s-1", "v", Some("m s-1")),
            ("v_cm_s", "v", Some("cm/s")),
            ("impact_velocity_mm_per_s", "impact velocity", Some("mm/s")),
            ("v_mps", "v", Some("mps")),
            ("h_cm", "h", Some("cm")),
            ("impact_velocity", "impact velocity", None),
            ("e (%)", "e", Some("%")),
            ("e %", "e", Some("%")),
            ("e (-)", "e", Some("-")),
            ("v_in", "v in", None),
            ("coefficient of restitution", "coefficient of restitution", None),
            ("Vn_impact (cm s^{-1})", "vn impact", Some("cm s^-1")),
            ("v₀ (m·s⁻¹)", "v0", Some("m·s⁻¹")),
            ("velocity (cm per s)", "velocity", Some("cm/s")),
            ("Coeff. of Restitution", "coefficient of restitution", None),
            ("e (normal) [%]", "e (normal)", Some("%")),
            ("u(e)", "u", Some("e")),
            ("v [furlong/h]", "v", Some("furlong/h")),
            ("", "", None),
        ] {
            let column = Column::of(cell);
            assert_eq!((column.name.as_str(), column.unit.as_deref()), (name, unit), "{cell}");
        }
    }

    #[test]
    fn headers_between_blanks_have_as_many_cells_as_rows() {
        let cells = |line| split(line, Separator::Blanks, 2).map(|cells| cells.join("|"));
        assert_eq!(cells("v [m s-1]  e").as_deref(), Some("v [m s-1]|e"));
        assert_eq!(cells("v / m/s   e").as_deref(), Some("v / m/s|e"));
        assert_eq!(
            cells("impact velocity  coefficient of restitution").as_deref(),
            Some("impact velocity|coefficient of restitution")
        );
        assert_eq!(cells("v e").as_deref(), Some("v|e"));
        assert_eq!(cells("one two three"), None);
        assert!(is_row_of_units(&["cm/s".into(), "-".into()]) && !is_row_of_units(&["-".into(), "".into()]));
    }
}
