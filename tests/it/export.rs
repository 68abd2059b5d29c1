//! Exported sources are compiled, run, and compared with certified values.

mod drivers;
mod hostile;
mod names;
mod random_requests;
mod tools;

use crate::certified::{exact, reference};
use drivers::{DRIVERS, Driver};
use restitution::End;
use restitution_export::{Beyond, Language, Listing, Request};
use rug::Float;
use std::fs;
use std::sync::OnceLock;
use tools::run;

/// Points of each comparison.
const POINTS: usize = 3000;

const fn request(tolerance: f64, range: (f64, f64), beyond: Beyond) -> Request {
    Request { tolerance, range, beyond }
}

/// What is tried in every language.
const REQUESTS: [(Request, End); 4] = [
    (request(1e-3, (0.0, 2.0), Beyond::NotANumber), End::ZeroCompression),
    (request(1e-9, (0.0, 8.0), Beyond::Law), End::ZeroForce),
    (request(1e-12, (0.01, 40.0), Beyond::Law), End::ZeroCompression),
    (request(2e-15, (0.0, 10.0), Beyond::NotANumber), End::ZeroForce),
];

fn listings() -> &'static [Listing] {
    static LISTINGS: OnceLock<Vec<Listing>> = OnceLock::new();
    LISTINGS
        .get_or_init(|| REQUESTS.map(|(request, end)| Listing::new(reference(end), request).unwrap()).into())
}

/// `epsilon`, `1 - epsilon` and the slope as a source gives them.
type Values = [f64; 3];

/// Writes the source and what drives it, runs the self-check and the driver; `None` if the tool is missing.
fn values(driver: &Driver, listing: &Listing, flags: &[&str], arguments: &[f64]) -> Option<Vec<Values>> {
    let folder = tempfile::tempdir().unwrap();
    let language = Language::of(driver.language).unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at(&language.file.replace("NAME", "tried")), language.write(listing, "tried").unwrap())
        .unwrap();
    fs::write(at(driver.file), driver.source).unwrap();
    let lines = |u: &f64| format!("{:016x}\n", u.to_bits());
    fs::write(at("arguments"), arguments.iter().map(lines).collect::<String>()).unwrap();
    let mut command = (driver.build)(folder.path(), flags)?;
    let output = run(&mut command, Some(&at("arguments")))?;
    let word = |word: &str| f64::from_bits(u64::from_str_radix(word.trim(), 16).unwrap());
    let line = |line: &str| -> Values {
        let words: Vec<f64> = line.split_whitespace().map(word).collect();
        words.try_into().unwrap()
    };
    let values: Vec<Values> = output.lines().map(line).collect();
    assert_eq!(values.len(), arguments.len());
    Some(values)
}

fn spaced((low, high): (f64, f64)) -> Vec<f64> {
    let spaced = |i: usize| low + (high - low) * (i as f64 / (POINTS - 1) as f64).powi(3);
    (0..POINTS).map(|i| spaced(i).clamp(low, high)).collect()
}

/// Every value is what the library gives, to the bit, and within the bounds that the source states.
fn compare(driver: &Driver) {
    for listing in listings() {
        let arguments = spaced(listing.request.range);
        let Some(values) = values(driver, listing, driver.plain, &arguments) else { return };
        let (mut worst, mut worst_loss, mut worst_slope) = (0.0_f64, 0.0_f64, 0.0_f64);
        for (u, [epsilon, loss, slope]) in arguments.iter().zip(&values) {
            let (pieces, reference) = (&listing.pieces, reference(listing.end));
            assert_eq!(*epsilon, pieces.epsilon(*u), "{}: {u:e}", driver.language);
            assert_eq!(*slope, pieces.slope(*u), "{}: {u:e}", driver.language);
            assert_eq!(*loss, listing.loss.at(pieces, *u), "{}: {u:e}", driver.language);
            let (lost, kept) = exact(reference, *u);
            let relative =
                |value: f64, exact: &Float| (Float::with_val(112, value - exact) / exact).to_f64().abs();
            worst = worst.max(relative(*epsilon, &kept));
            if *u > 0.0 {
                worst_loss = worst_loss.max(relative(*loss, &lost));
                worst_slope = worst_slope.max(-slope.min(0.0));
            }
        }
        println!("{}, {:?}: {worst:.2e} {worst_loss:.2e}", driver.language, listing.request);
        assert!(worst <= listing.request.tolerance && worst <= listing.pieces.bound.total());
        assert!(worst_loss <= listing.loss.bound);
        assert!(0.0 < worst_slope && worst_slope < 1.5, "{worst_slope}");
    }
}

macro_rules! in_every_language {
    ($($language:ident)*) => {
        /// The drivers that are run.
        const RUN: &[&str] = &[$(stringify!($language)),*];
        $(#[test]
        fn $language() {
            compare(DRIVERS.iter().find(|driver| driver.test == stringify!($language)).unwrap());
        })*
    };
}
in_every_language!(rust c cpp fortran python numpy javascript matlab);

#[test]
fn every_language_has_a_driver_or_is_not_run() {
    let not_run = ["julia"];
    for language in restitution_export::LANGUAGES {
        let driven = DRIVERS.iter().any(|driver| driver.language == language.name);
        assert_ne!(driven, not_run.contains(&language.name), "{}", language.name);
    }
    for driver in DRIVERS {
        assert!(RUN.contains(&driver.test), "{}: its name belongs to in_every_language!", driver.test);
    }
}

#[test]
fn what_is_observed_is_below_what_is_stated() {
    for listing in listings() {
        assert!(listing.observed.epsilon <= listing.pieces.bound.total());
        assert!(listing.observed.loss <= listing.loss.bound);
        assert!(listing.observed.slope <= 0.1, "{:?}", listing.observed);
        assert!(listing.pieces.bound.total() <= listing.request.tolerance);
    }
}

#[test]
fn what_cannot_be_kept_is_refused() {
    let keeps = |tolerance: f64, end: End| {
        let request = request(tolerance, (0.0, 8.0), Beyond::Law);
        Listing::new(reference(end), request).map(|_| ()).map_err(|error| error.to_string())
    };
    let refusal = keeps(1e-15, End::ZeroForce).unwrap_err();
    assert!(refusal.starts_with("no evaluator of at most 64 KiB keeps 1e-15"), "{refusal}");
    assert_eq!(
        keeps(1e-16, End::ZeroForce).unwrap_err(),
        "a tolerance is a relative error: give one from 1e-15 to 0.1"
    );
}
