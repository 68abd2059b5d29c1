//! Mutations of a file, on bytes and on lines.

use crate::random::{Source, choose};
use rand::RngExt;

/// Pieces that upset readers of tables.
const PIECES: [&[u8]; 36] = [
    b"0",
    b"-",
    b"+",
    b".",
    b",",
    b";",
    b"\t",
    b" ",
    b"\n",
    b"\r",
    b"\r\n\r\n",
    b"\"",
    b"\"\"",
    b"'",
    b"#",
    b"%",
    b"\0",
    b"\0\0\0\0",
    b"\xff\xfe",
    b"\xfe\xff",
    b"\xef\xbb\xbf",
    b"\xb5",
    b"\xa0",
    b"\xc2\xa0",
    b"nan",
    b"inf",
    b"-1e400",
    b"1e308",
    b"5e-324",
    b"1,203",
    b"1.203,5",
    b"\x1b[2J",
    b"\x1a",
    "−0,5".as_bytes(),
    "\u{202e}".as_bytes(),
    b"g,epsilon\n",
];
/// The longest file after a mutation.
const LONGEST: usize = 4 << 20;

/// Changes a file in one place, or throughout.
pub fn mutate(bytes: &mut Vec<u8>, random: &mut Source) {
    let at = random.random_range(0..=bytes.len());
    match random.random_range(0..16) {
        0 => bytes.truncate(at),
        1 => drop(bytes.drain(..at)),
        2 if at < bytes.len() => bytes[at] ^= 1 << random.random_range(0..8),
        3 => {
            let piece = choose(random, &PIECES).repeat(random.random_range(1..100_000));
            drop(bytes.splice(at..at, piece.into_iter().take(LONGEST)));
        }
        4 => *bytes = utf16(bytes, random.random_bool(0.5), random.random_bool(0.8)),
        5 => replace(bytes, *choose(random, b",;. \t\n"), *choose(random, b",;. \t\n\r\0")),
        6 => lines(bytes, random),
        7 => bytes.clear(),
        8 => (0..random.random_range(1..2000)).for_each(|_| bytes.push(random.random())),
        _ => drop(bytes.splice(at..at, choose(random, &PIECES).iter().copied())),
    }
    bytes.truncate(LONGEST);
}

fn utf16(bytes: &[u8], big: bool, marked: bool) -> Vec<u8> {
    let text = String::from_utf8_lossy(bytes);
    let mark = marked.then_some(0xfeff);
    let units = mark.into_iter().chain(text.encode_utf16());
    units.flat_map(|unit| if big { unit.to_be_bytes() } else { unit.to_le_bytes() }).collect()
}

fn replace(bytes: &mut [u8], from: u8, to: u8) {
    bytes.iter_mut().filter(|byte| **byte == from).for_each(|byte| *byte = to);
}

/// Removes, repeats or moves a line.
fn lines(bytes: &mut Vec<u8>, random: &mut Source) {
    let mut lines: Vec<&[u8]> = bytes.split_inclusive(|byte| *byte == b'\n').collect();
    if lines.is_empty() {
        return;
    }
    let (at, other) = (random.random_range(0..lines.len()), random.random_range(0..lines.len()));
    match random.random_range(0..3) {
        0 => drop(lines.remove(at)),
        1 => lines.insert(at, lines[other]),
        _ => lines.swap(at, other),
    }
    *bytes = lines.concat();
}
