//! The table of single units.

use crate::Unit;
use num_rational::BigRational;

/// Symbols, size in SI units as numerator and denominator, powers of metre, kilogram and second.
type Entry = (&'static [&'static str], i64, i64, [i32; 3]);

const METRE: [i32; 3] = [1, 0, 0];
const KILOGRAM: [i32; 3] = [0, 1, 0];
const SECOND: [i32; 3] = [0, 0, 1];
const VELOCITY: [i32; 3] = [1, 0, -1];
const NEWTON: [i32; 3] = [1, 1, -2];
const PASCAL: [i32; 3] = [-1, 1, -2];
const PASCAL_SECOND: [i32; 3] = [-1, 1, -1];

const UNITS: &[Entry] = &[
    (&["m", "meter", "meters", "metre", "metres"], 1, 1, METRE),
    (&["km"], 1000, 1, METRE),
    (&["dm"], 1, 10, METRE),
    (&["cm"], 1, 100, METRE),
    (&["mm"], 1, 1000, METRE),
    (&["um", "µm", "μm", "micron", "microns"], 1, 1_000_000, METRE),
    (&["nm"], 1, 1_000_000_000, METRE),
    (&["in", "inch", "inches"], 127, 5000, METRE),
    (&["ft", "foot", "feet"], 381, 1250, METRE),
    (&["yd"], 1143, 1250, METRE),
    (&["mi", "mile", "miles"], 201_168, 125, METRE),
    (&["kg"], 1, 1, KILOGRAM),
    (&["g"], 1, 1000, KILOGRAM),
    (&["mg"], 1, 1_000_000, KILOGRAM),
    (&["ug", "µg", "μg"], 1, 1_000_000_000, KILOGRAM),
    (&["t"], 1000, 1, KILOGRAM),
    (&["lb", "lbm"], 45_359_237, 100_000_000, KILOGRAM),
    (&["s", "sec", "second", "seconds"], 1, 1, SECOND),
    (&["ms", "msec"], 1, 1000, SECOND),
    (&["us", "µs", "μs", "usec"], 1, 1_000_000, SECOND),
    (&["ns"], 1, 1_000_000_000, SECOND),
    (&["min", "minute", "minutes"], 60, 1, SECOND),
    (&["h", "hr", "hour", "hours"], 3600, 1, SECOND),
    (&["mps"], 1, 1, VELOCITY),
    (&["fps"], 381, 1250, VELOCITY),
    (&["kmh", "kph"], 5, 18, VELOCITY),
    (&["mph"], 1397, 3125, VELOCITY),
    (&["N"], 1, 1, NEWTON),
    (&["mN"], 1, 1000, NEWTON),
    (&["kN"], 1000, 1, NEWTON),
    (&["MN"], 1_000_000, 1, NEWTON),
    (&["dyn", "dyne"], 1, 100_000, NEWTON),
    (&["Pa"], 1, 1, PASCAL),
    (&["mPa"], 1, 1000, PASCAL),
    (&["kPa"], 1000, 1, PASCAL),
    (&["MPa"], 1_000_000, 1, PASCAL),
    (&["GPa"], 1_000_000_000, 1, PASCAL),
    (&["bar"], 100_000, 1, PASCAL),
    (&["mbar"], 100, 1, PASCAL),
    (&["psi"], 44_482_216_152_605, 6_451_600_000, PASCAL),
    (&["ksi"], 44_482_216_152_605, 6_451_600, PASCAL),
    (&["Pas"], 1, 1, PASCAL_SECOND),
    (&["mPas"], 1, 1000, PASCAL_SECOND),
    (&["kPas"], 1000, 1, PASCAL_SECOND),
    (&["MPas"], 1_000_000, 1, PASCAL_SECOND),
    (&["GPas"], 1_000_000_000, 1, PASCAL_SECOND),
    (&["P", "poise"], 1, 10, PASCAL_SECOND),
    (&["cP"], 1, 1000, PASCAL_SECOND),
];

/// Returns the unit with this symbol.
pub(crate) fn find(symbol: &str) -> Option<Unit> {
    let &(_, numerator, denominator, powers) = UNITS.iter().find(|entry| entry.0.contains(&symbol))?;
    Some(Unit { size: BigRational::new(numerator.into(), denominator.into()), powers })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_symbol_stands_for_two_units() {
        let symbols = UNITS.iter().flat_map(|entry| entry.0).collect::<Vec<_>>();
        for (i, symbol) in symbols.iter().enumerate() {
            assert!(!symbols[..i].contains(symbol), "{symbol}");
        }
    }

    #[test]
    fn sizes_are_those_of_their_definitions() {
        let size = |symbol: &str| find(symbol).unwrap().size;
        let inch = BigRational::new(254.into(), 10_000.into());
        let twelve = BigRational::from_integer(12.into());
        assert_eq!((size("in"), size("ft")), (inch.clone(), inch * &twelve));
        let five_thousand = BigRational::from_integer(5280.into());
        assert_eq!(size("mi"), size("ft") * five_thousand);
        assert_eq!(size("mph"), size("mi") / size("h"));
        let gravity = BigRational::new(980_665.into(), 100_000.into());
        assert_eq!(size("psi"), size("lb") * gravity / (size("in") * size("in")));
    }
}
