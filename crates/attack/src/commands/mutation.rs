//! Mutations of command lines, on bytes and on words.

use crate::random::{Source, choose};
use rand::RngExt;
use std::ffi::OsString;
use std::os::unix::ffi::{OsStrExt, OsStringExt};

/// Pieces that upset parsers.
const PIECES: [&[u8]; 30] = [
    b"0",
    b"9",
    b"-",
    b"+",
    b".",
    b",",
    b"e",
    b"E",
    b"/",
    b"=",
    b" ",
    b"\t",
    b"\n",
    b"\r",
    b"\"",
    b"'",
    b"%",
    b"\\",
    b";",
    b":",
    b"\xff",
    b"\xc3",
    b"\xef\xbb\xbf",
    "µ".as_bytes(),
    "\u{202e}".as_bytes(),
    b"\x1b[2J",
    b"\x07",
    b"inf",
    b"NaN",
    b"00000000000000000000000000000000000000000",
];

/// Bytes of a repeated word; systems take no argument that is much longer.
const LONGEST_WORD: usize = 60_000;

/// Changes a line in one place.
pub fn mutate(line: &mut Vec<OsString>, random: &mut Source) {
    if line.is_empty() {
        return line.push("--help".into());
    }
    let (at, other) = (random.random_range(0..line.len()), random.random_range(0..line.len()));
    match random.random_range(0..12) {
        0 => drop(line.remove(at)),
        1 => line.insert(at, line[at].clone()),
        2 => line.swap(at, other),
        3 => line[at] = line[other].clone(),
        4 => {
            let times = random.random_range(2..2000).min(LONGEST_WORD / line[at].len().max(1)).max(1);
            line[at] = OsString::from_vec(line[at].as_bytes().repeat(times));
        }
        5 => line.push(OsString::from_vec(choose(random, &PIECES).to_vec())),
        6 => line.truncate(at),
        _ => bytes(&mut line[at], random),
    }
}

/// Changes a word in one place.
fn bytes(word: &mut OsString, random: &mut Source) {
    let mut bytes = word.as_bytes().to_vec();
    let at = random.random_range(0..=bytes.len());
    match random.random_range(0..5) {
        0 => bytes.truncate(at),
        1 if at < bytes.len() => drop(bytes.remove(at)),
        2 if at < bytes.len() => bytes[at] ^= 1 << random.random_range(0..8),
        3 if at < bytes.len() => bytes.insert(at, bytes[at]),
        _ => drop(bytes.splice(at..at, choose(random, &PIECES).iter().copied())),
    }
    *word = OsString::from_vec(bytes);
}
