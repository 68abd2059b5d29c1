//! From the bytes of a file to its lines.

use super::SheetError;

/// Blanks at which no line is broken.
const UNBREAKABLE: [char; 4] = ['\u{a0}', '\u{2007}', '\u{2009}', '\u{202f}'];

/// Decodes UTF-8 with or without its mark, UTF-16 with it, or else Latin-1.
pub(super) fn decode(bytes: Vec<u8>) -> Result<String, SheetError> {
    let wide = |pair: fn([u8; 2]) -> u16| {
        let units = bytes[2..].chunks_exact(2).map(|unit| pair([unit[0], unit[1]]));
        let text = char::decode_utf16(units).collect::<Result<String, _>>().ok();
        text.filter(|_| bytes.len().is_multiple_of(2)).ok_or(SheetError::NotText)
    };
    let text = match bytes.as_slice() {
        [0xff, 0xfe, ..] => wide(u16::from_le_bytes)?,
        [0xfe, 0xff, ..] => wide(u16::from_be_bytes)?,
        _ => match String::from_utf8(bytes) {
            Ok(text) => text,
            Err(error) => error.into_bytes().into_iter().map(char::from).collect(),
        },
    };
    let strange = |c: char| c.is_control() && !matches!(c, '\n' | '\r' | '\t' | '\u{c}');
    if text.bytes().any(|b| b < 0x20 && strange(b.into())) || text.chars().take(1000).any(strange) {
        return Err(SheetError::NotText);
    }
    // blanks that do not break a line
    let text = if text.contains(UNBREAKABLE) { text.replace(UNBREAKABLE, " ") } else { text };
    Ok(match text.strip_prefix('\u{feff}') {
        Some(rest) => rest.to_owned(),
        None => text,
    })
}

/// The lines of a text with their numbers from 1; they end with LF, CR LF or CR.
pub(super) struct Lines<'a> {
    rest: Option<&'a str>,
    number: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn of(text: &'a str) -> Self {
        Self { rest: Some(text), number: 0 }
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (usize, &'a str);

    fn next(&mut self) -> Option<Self::Item> {
        let rest = self.rest?;
        self.number += 1;
        let Some(end) = rest.bytes().position(|b| b == b'\n' || b == b'\r') else {
            self.rest = None;
            return Some((self.number, rest));
        };
        let length = if rest[end..].starts_with("\r\n") { 2 } else { 1 };
        self.rest = Some(&rest[end + length..]);
        Some((self.number, &rest[..end]))
    }
}

/// A comment's text, without its sign; `None` for a line that is none.
pub(super) fn comment(line: &str) -> Option<&str> {
    let line = line.trim();
    ["#", "%", "//", "!"]
        .into_iter()
        .find_map(|sign| line.strip_prefix(sign))
        .map(|text| text.trim_start_matches(['#', '%']).trim())
}

/// The line without what follows a `#`, or a `%` with blanks around it.
pub(super) fn without_remark(line: &str) -> &str {
    let hash = line.find('#');
    let percent = line.find(" % ").or_else(|| line.find("\t% "));
    match hash.into_iter().chain(percent).min() {
        Some(end) if !line[..end].contains('"') => &line[..end],
        _ => line,
    }
}

/// What separates the cells of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// Tabs.
    Tab,
    /// Semicolons.
    Semicolon,
    /// Commas.
    Comma,
    /// A comma with a blank behind it, where commas without are decimal signs.
    CommaBlank,
    /// Vertical bars.
    Bar,
    /// Any number of blanks or tabs.
    Blanks,
}

impl Separator {
    /// Splits a line into its cells, without blanks and quotation marks around them.
    pub(super) fn split<'a>(self, line: &'a str, cells: &mut Vec<&'a str>) {
        cells.clear();
        let line = line.trim_matches(' ');
        let line = if self == Self::Bar { line.trim_matches('|') } else { line };
        let (mut start, mut quote) = (0, None);
        let bytes = line.as_bytes();
        for (place, &byte) in bytes.iter().enumerate() {
            match (quote, byte) {
                (Some(open), _) => quote = if byte == open { None } else { quote },
                (None, b'"') if line[start..place].trim().is_empty() => quote = Some(byte),
                (None, _) if self.ends(byte, bytes.get(place + 1)) => {
                    if self != Self::Blanks || start < place {
                        cells.push(bare(&line[start..place]));
                    }
                    start = place + 1;
                }
                _ => {}
            }
        }
        if self != Self::Blanks || start < line.len() {
            cells.push(bare(&line[start..]));
        }
    }

    fn ends(self, byte: u8, next: Option<&u8>) -> bool {
        match self {
            Self::Tab => byte == b'\t',
            Self::Semicolon => byte == b';',
            Self::Comma => byte == b',',
            Self::CommaBlank => byte == b',' && matches!(next, Some(b' ' | b'\t')),
            Self::Bar => byte == b'|',
            Self::Blanks => byte == b' ' || byte == b'\t',
        }
    }

    /// What it is called in a message.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Tab => "tabs",
            Self::Semicolon => "semicolons",
            Self::Comma | Self::CommaBlank => "commas",
            Self::Bar => "vertical bars",
            Self::Blanks => "blanks",
        }
    }
}

fn bare(cell: &str) -> &str {
    let cell = cell.trim();
    let inside = |mark: char| cell.strip_prefix(mark).and_then(|rest| rest.strip_suffix(mark));
    inside('"').or_else(|| inside('\'')).map_or(cell, str::trim)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_line_ends_count() {
        let lines = |text| Lines::of(text).collect::<Vec<_>>();
        assert_eq!(lines("a\nb\r\n\rc"), [(1, "a"), (2, "b"), (3, ""), (4, "c")]);
        assert_eq!(lines("a\n"), [(1, "a"), (2, "")]);
    }

    #[test]
    fn cells_lose_blanks_and_quotes() {
        let split = |separator: Separator, line| {
            let mut cells = Vec::new();
            separator.split(line, &mut cells);
            cells.join("|")
        };
        assert_eq!(split(Separator::Comma, "1, \"0,5\" ,'x'"), "1|0,5|x");
        assert_eq!(split(Separator::Blanks, "  1 \t 0,5 "), "1|0,5");
        assert_eq!(split(Separator::CommaBlank, "1,5, 0,5"), "1,5|0,5");
        assert_eq!(split(Separator::Semicolon, ";a;"), "|a|");
        assert_eq!(split(Separator::Bar, "| 1 | 2 |"), "1|2");
    }

    #[test]
    fn encodings_are_told_apart() {
        let text = |bytes: &[u8]| decode(bytes.to_vec()).unwrap();
        assert_eq!(text("\u{feff}g;ε".as_bytes()), "g;ε");
        assert_eq!(text(b"\xff\xfeg\x00\xb5\x03"), "gε");
        assert_eq!(text(b"\xfe\xff\x00g"), "g");
        assert_eq!(text(b"v [\xb5m/s]"), "v [µm/s]");
        for bytes in [&b"\x89PNG\r\n\x1a\n"[..], b"PK\x03\x04", b"\xff\xfe\n", b"a\x00b"] {
            assert!(matches!(decode(bytes.to_vec()), Err(SheetError::NotText)));
        }
    }

    #[test]
    fn remarks_are_cut_off() {
        assert_eq!(without_remark("1 0.5 # first"), "1 0.5 ");
        assert_eq!(without_remark("1 0.5 % first"), "1 0.5");
        assert_eq!(without_remark("1 50 %"), "1 50 %");
        assert_eq!(comment("  ## g eps"), Some("g eps"));
        assert_eq!(comment("1 2"), None);
    }
}
