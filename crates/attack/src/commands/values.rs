//! Values of arguments, by the names under which the command asks for them.

use crate::random::{Source, by_ratio, choose};
use clap::Arg;
use rand::RngExt;

/// What no argument expects.
const NONSENSE: [&str; 40] = [
    "",
    " ",
    "-",
    "--",
    "-1",
    "-0",
    "0",
    "+1",
    "1e-1",
    "1e400",
    "-1e-400",
    "NaN",
    "nan",
    "inf",
    "-inf",
    "0x10",
    "1_000",
    "1,2",
    "0,5",
    "1;2",
    "1.",
    ".5",
    "1..2",
    "1/0",
    "0/0",
    "1/3/2",
    "2/-3",
    "1e",
    "1e+",
    "e5",
    "٣",
    "1\u{a0}000",
    "½",
    "∞",
    "%s%n",
    "\u{1b}[31m",
    "\u{202e}",
    "99999999999999999999999999999999999999",
    "1e999999999",
    "=",
];
/// Where output can go.
const PATHS: [&str; 12] = [
    "out",
    "out",
    "out",
    "out.csv",
    "folder/out",
    "missing/out",
    "folder",
    "null",
    "full",
    "-",
    ".",
    "a b\tc",
];
const LENGTHS: [&str; 6] = ["m", "cm", "mm", "um", "km", ""];
const SPEEDS: [&str; 6] = ["m/s", "cm/s", "mm/s", "km/h", "", "m"];
/// A request of `material` and `fit` in one piece each, since random words seldom make one.
const LAWS: [&str; 22] = [
    "3/2,1/2",
    "1,0",
    "3/2,1/4",
    "2,1",
    "2,1/2",
    "5/2,3/4",
    "3,1/2",
    "3/4,3/5",
    "1/2,1/3",
    "3,2",
    "4,1",
    "1/4,1/5",
    "1.5,0.5",
    "1e0,0",
    "3/2,-1/2",
    "1/50,1/10",
    "9,-13/100",
    "7/3,5/6",
    "100000,1",
    "3/2,1000",
    "-1,0",
    "1,-1",
];

/// Returns a value for an argument: mostly one of the kind it asks for.
pub fn value(argument: &Arg, command: &str, random: &mut Source) -> String {
    if random.random_bool(0.03) {
        return (*choose(random, &NONSENSE)).to_owned();
    }
    let possible: Vec<String> =
        argument.get_possible_values().iter().map(|value| value.get_name().to_owned()).collect();
    if !possible.is_empty() {
        return choose(random, &possible).clone();
    }
    let name = argument.get_value_names().and_then(|names| names.first()).map_or("", |name| name.as_str());
    let long = argument.get_long().unwrap_or_default();
    match (long, name) {
        ("output", _) => (*choose(random, &PATHS)).to_owned(),
        (_, "DATA" | "FILE") => (*choose(random, &["-", "missing.csv", "folder", "null", "full"])).to_owned(),
        ("law", _) => (*choose(random, &LAWS)).to_owned(),
        ("digits", _) => whole(random, 1, 60),
        ("order", _) => whole(random, 1, 14),
        ("damping-order", _) => whole(random, 0, 5),
        ("time-order" | "table", _) => whole(random, 0, if long == "table" { 5 } else { 30 }),
        ("tolerance" | "error", _) => power_of_ten(random, -16, 0),
        ("range" | "between", _) => format!("{},{}", small(random), small(random)),
        ("measured", _) => format!("{},{}", with_unit(random, &SPEEDS), fraction(random)),
        ("poisson" | "poisson2", _) => {
            (*choose(random, &["0.3", "0", "0.5", "-0.5", "0.49", "1", "-1"])).to_owned()
        }
        (_, "U") => exact(random),
        (_, "L" | "M") => whole(random, 0, 8),
        (_, "G") => with_unit(random, &SPEEDS),
        (_, "R") => with_unit(random, &LENGTHS),
        (_, "Y" | "E") => with_unit(random, &["GPa", "MPa", "Pa", "kPa", "N/m^2", ""]),
        (_, "DENSITY") => with_unit(random, &["kg/m3", "g/cm3", "kg/m^3", ""]),
        (_, "ETA") => with_unit(random, &["Pa*s", "Pa s", ""]),
        (_, "A") => with_unit(random, &["s", "us", "ms", "ns", ""]),
        (_, "KEY=VALUE,...") => format!("k_n={},eta_n0={},en=0.7,vn=1", number(random), number(random)),
        _ if command == "audit" => {
            (*choose(random, &["A26", "A14", "TableI", "Fig1", "MP2011", "x"])).to_owned()
        }
        _ => any(random),
    }
}

/// A value of any kind, for arguments that nothing is known of.
fn any(random: &mut Source) -> String {
    match random.random_range(0..6) {
        0 => whole(random, 0, 12),
        1 => exact(random),
        2 => with_unit(random, &SPEEDS),
        3 => with_unit(random, &LENGTHS),
        4 => (*choose(random, &LAWS)).to_owned(),
        _ => (*choose(random, &NONSENSE)).to_owned(),
    }
}

fn whole(random: &mut Source, low: u32, high: u32) -> String {
    random.random_range(low..=high).to_string()
}

/// A number of a few digits and any size.
pub fn number(random: &mut Source) -> String {
    let x =
        if random.random_bool(0.1) { by_ratio(random, 1e-300, 1e300) } else { by_ratio(random, 1e-6, 1e6) };
    match random.random_range(0..4) {
        0 => format!("{x:.3e}"),
        1 => format!("{x}"),
        2 => format!("{:.0}", x.min(1e9)),
        _ => format!("{x:.4}"),
    }
}

fn exact(random: &mut Source) -> String {
    match random.random_range(0..6) {
        0 => format!("{}/{}", random.random_range(0..30), random.random_range(1..30)),
        1 => format!("{}e-{}", random.random_range(1..100), random.random_range(0..30)),
        2 => format!("{}", random.random_range(0..50)),
        3 => format!("{}e{}", random.random_range(1..9), random.random_range(0..20)),
        _ => small(random),
    }
}

fn small(random: &mut Source) -> String {
    format!("{:.2}", by_ratio(random, 0.01, 20.0))
}

fn fraction(random: &mut Source) -> String {
    format!("{:.3}", random.random::<f64>())
}

fn power_of_ten(random: &mut Source, low: i32, high: i32) -> String {
    format!("1e{}", random.random_range(low..=high))
}

fn with_unit(random: &mut Source, units: &[&str]) -> String {
    let space = if random.random_bool(0.1) { " " } else { "" };
    let number = number(random);
    format!("{number}{space}{}", choose(random, units))
}
