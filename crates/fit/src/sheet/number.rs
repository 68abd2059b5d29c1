//! Numbers as programs and people write them into tables.

/// The sign between whole and fraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decimal {
    /// `0.5`; commas can only group digits, as in `1,203.5`.
    Point,
    /// `0,5`; points can only group digits, as in `1.203,5`.
    Comma,
}

/// What a cell says about the decimal sign of its file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Evidence {
    /// Only a decimal point makes sense of it.
    Point,
    /// Only a decimal comma makes sense of it.
    Comma,
    /// A comma with three digits behind it: `1,203`.
    AmbiguousComma,
    /// A point with three digits behind it: `1.203`.
    AmbiguousPoint,
    /// It has no such sign, or is no number.
    None,
}

/// Splits a cell behind its number: what follows is a unit, or nothing.
pub(crate) fn split(cell: &str) -> (&str, &str) {
    let bytes = cell.as_bytes();
    let digit = |i: usize| bytes.get(i).is_some_and(u8::is_ascii_digit);
    let sign = |i: usize| matches!(bytes.get(i), Some(b'+' | b'-'));
    let minus = if cell.starts_with('−') { '−'.len_utf8() } else { usize::from(sign(0)) };
    let mut end = minus;
    while let Some(byte) = bytes.get(end) {
        match byte {
            b'0'..=b'9' | b'.' | b',' => end += 1,
            b'e' | b'E' | b'd' | b'D' if digit(end + 1) || (sign(end + 1) && digit(end + 2)) => end += 2,
            b'/' if digit(end + 1) => end += 1,
            b'\'' if end > minus && digit(end - 1) && (1..=3).all(|k| digit(end + k)) => end += 1, // 1'203 of Switzerland
            b'+' | b'-' if end > minus && (1..=3).all(|k| digit(end + k)) => end += 1, // 1.5-103 of Fortran
            _ => break,
        }
    }
    (&cell[..end], cell[end..].trim())
}

/// Reads a number; `None` for anything else. The result may be infinite.
pub(crate) fn parse(text: &str, decimal: Decimal) -> Option<f64> {
    let simple = |b: u8| b.is_ascii_digit() || matches!(b, b'.' | b'-' | b'+' | b'e' | b'E');
    if decimal == Decimal::Point
        && text.bytes().all(simple)
        && let Ok(value) = text.parse()
    {
        return Some(value);
    }
    if let Some((numerator, denominator)) = text.split_once('/') {
        return Some(parse(numerator, decimal)? / parse(denominator, decimal)?)
            .filter(|value| !value.is_nan());
    }
    plain(text, decimal)?.parse().ok()
}

/// Writes a number as Rust reads it.
fn plain(text: &str, decimal: Decimal) -> Option<String> {
    let text = text.replace('−', "-");
    let (sign, unsigned) = match text.strip_prefix(['-', '+']) {
        Some(rest) => (&text[..1], rest),
        None => ("", text.as_str()),
    };
    let end = unsigned.find(|c: char| !c.is_ascii_digit() && !".,'".contains(c)).unwrap_or(unsigned.len());
    let (mantissa, exponent) = unsigned.split_at(end);
    let (point, other) = if decimal == Decimal::Point { ('.', ',') } else { (',', '.') };
    let group = if mantissa.contains('\'') { '\'' } else { other };
    let (whole, fraction) = mantissa.split_once(point).unwrap_or((mantissa, ""));
    let digits = |s: &str| s.bytes().all(|b| b.is_ascii_digit());
    let mut groups = whole.split(group);
    let first = groups.next()?;
    let rest = groups.collect::<Vec<_>>();
    let grouped = rest.is_empty() || ((1..=3).contains(&first.len()) && rest.iter().all(|g| g.len() == 3));
    let open = decimal == Decimal::Comma && mantissa.ends_with(','); // `1,` is a number and a separator
    if open || !grouped || !digits(first) || !rest.iter().all(|g| digits(g)) || !digits(fraction) {
        return None;
    }
    let exponent = if exponent.is_empty() {
        "0"
    } else {
        exponent.strip_prefix(['e', 'E', 'd', 'D']).unwrap_or(exponent)
    };
    let power = exponent.strip_prefix(['-', '+']).unwrap_or(exponent);
    if first.len() + fraction.len() == 0 || power.is_empty() || !digits(power) {
        return None;
    }
    Some(format!("{sign}{first}{}.{fraction}0e{exponent}", rest.concat()))
}

/// What the digits and signs of a number say about its file.
pub(super) fn evidence(number: &str) -> Evidence {
    let mantissa = number.split(['e', 'E', 'd', 'D', '/']).next().unwrap_or_default();
    let mantissa = mantissa.trim_start_matches(['-', '+', '−']);
    if mantissa.contains('\'') {
        // its groups are told, so that any other sign is decimal
        return if mantissa.contains(',') {
            Evidence::Comma
        } else if mantissa.contains('.') {
            Evidence::Point
        } else {
            Evidence::None
        };
    }
    let (commas, points) = (mantissa.matches(',').count(), mantissa.matches('.').count());
    let alone = |sign: char| {
        let (whole, fraction) = mantissa.split_once(sign).unwrap_or_default();
        fraction.len() == 3 && (1..=3).contains(&whole.len()) && !whole.starts_with('0')
    };
    match (commas, points) {
        (0, 0) => Evidence::None,
        (1, 0) if alone(',') => Evidence::AmbiguousComma,
        (0, 1) if alone('.') => Evidence::AmbiguousPoint,
        (1, 0) => Evidence::Comma,
        (0, 1) => Evidence::Point,
        (_, 0) => Evidence::Point, // commas that group
        (0, _) => Evidence::Comma, // points that group
        _ if mantissa.rfind(',') > mantissa.rfind('.') => Evidence::Comma,
        _ => Evidence::Point,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_many_programs_are_read() {
        for (text, value) in [
            ("0.5", 0.5),
            ("-.5", -0.5),
            ("5.", 5.0),
            ("+1e-3", 1e-3),
            ("1.2D-03", 1.2e-3),
            ("1.2d3", 1200.0),
            ("1.5-103", 1.5e-103),
            ("−2", -2.0),
            ("2/5", 0.4),
            ("1,203.5", 1203.5),
            ("1,203", 1203.0),
            ("1'203", 1203.0),
            ("1'203'400.5", 1_203_400.5),
        ] {
            assert_eq!(parse(text, Decimal::Point), Some(value), "{text}");
        }
        for (text, value) in
            [("0,5", 0.5), ("1,203", 1.203), ("1.203,5", 1203.5), ("1,5E-2", 0.015), ("7", 7.0), (",5", 0.5)]
        {
            assert_eq!(parse(text, Decimal::Comma), Some(value), "{text}");
        }
        for text in [
            "",
            "-",
            ".",
            "e5",
            "1e",
            "nan",
            "inf",
            "infinity",
            "1 2",
            "0x1",
            "1,20.5",
            "1..2",
            "1/0/",
            "--1",
            "1'20",
            "'203",
            "1'203,400",
        ] {
            assert_eq!(parse(text, Decimal::Point), None, "{text}");
        }
        assert_eq!(parse("0/0", Decimal::Point), None);
    }

    #[test]
    fn a_sign_is_evidence_or_a_question() {
        for (text, says) in [
            ("0,5", Evidence::Comma),
            ("0,512", Evidence::Comma),
            ("1,203", Evidence::AmbiguousComma),
            ("1203,512", Evidence::Comma),
            ("1.203", Evidence::AmbiguousPoint),
            ("0.203", Evidence::Point),
            ("1,203.5", Evidence::Point),
            ("1.203,5", Evidence::Comma),
            ("1,203,512", Evidence::Point),
            ("1'203.512", Evidence::Point),
            ("1'203", Evidence::None),
            ("12", Evidence::None),
            ("1e-3", Evidence::None),
        ] {
            assert_eq!(evidence(text), says, "{text}");
        }
    }

    #[test]
    fn a_number_ends_where_its_unit_begins() {
        assert_eq!(split("1.5cm/s"), ("1.5", "cm/s"));
        assert_eq!(split("1e-3 m s-1"), ("1e-3", "m s-1"));
        assert_eq!(split("57 %"), ("57", "%"));
        assert_eq!(split("2/5"), ("2/5", ""));
        assert_eq!(split("5 ft/s"), ("5", "ft/s"));
        assert_eq!(split("fast"), ("", "fast"));
        assert_eq!(split("−1,5"), ("−1,5", ""));
    }
}
