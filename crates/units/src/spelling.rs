//! From the text of a unit to its size: a product of powers of single units.

use crate::{Unit, symbols};
use num_rational::BigRational;
use num_traits::One;

/// The longest unit that is read, in bytes.
const LONGEST: usize = 40;
/// The largest power of a single unit.
const LARGEST_POWER: i32 = 4;

/// Reads `m/s`, `m s-1`, `m·s^-1`, `kg m⁻³`; `None` for what is not a unit.
pub(crate) fn read(text: &str) -> Option<Unit> {
    let text = text.trim();
    if text.is_empty() || text.len() > LONGEST {
        return None;
    }
    product(&plain(text)).or_else(|| {
        let shouted = text.chars().all(|c| !c.is_lowercase()) && text.contains('/');
        if shouted { product(&plain(&text.to_lowercase())) } else { None }
    })
}

/// Writes every product as a blank, every quotient as `/` and every power as `^`, in ASCII.
fn plain(text: &str) -> String {
    let text = text.replace("**", "^").replace(" per ", " / ");
    let mut out = String::with_capacity(text.len());
    let mut raised = false;
    for c in text.chars() {
        let power = "⁻⁰¹²³⁴".chars().position(|p| p == c);
        match (c, power) {
            (_, Some(place)) => {
                if !raised {
                    out.push('^');
                }
                out.push(b"-01234"[place].into());
            }
            ('·' | '⋅' | '×' | '*' | '.' | '\u{a0}' | '\u{202f}', None) => out.push(' '),
            ('−' | '–', None) => out.push('-'),
            _ => out.push(c),
        }
        raised = power.is_some();
    }
    out
}

fn product(text: &str) -> Option<Unit> {
    let mut unit = Unit { size: BigRational::one(), powers: [0; 3] };
    for (place, part) in text.split('/').enumerate() {
        let mut factors = part.split_whitespace();
        // a quotient turns the factor behind it upside down, and no other
        let sign = if place == 0 { 1 } else { -1 };
        let first = factors.next()?;
        unit.multiply(first, sign)?;
        for factor in factors {
            unit.multiply(factor, 1)?;
        }
    }
    Some(unit)
}

impl Unit {
    /// Multiplies by `m`, `s-1`, `cm^3` or `m3`; a numeral 1, as in `1/s`, changes nothing.
    fn multiply(&mut self, factor: &str, sign: i32) -> Option<()> {
        if factor == "1" {
            return Some(());
        }
        let end = factor.find(|c: char| c == '^' || c == '-' || c == '+' || c.is_ascii_digit());
        let (symbol, power) = factor.split_at(end.unwrap_or(factor.len()));
        let power = power.strip_prefix('^').unwrap_or(power);
        let power = if end.is_none() { 1 } else { power.trim_matches(['(', ')']).parse::<i32>().ok()? };
        if power == 0 || power.abs() > LARGEST_POWER {
            return None;
        }
        let single = symbols::find(symbol)?;
        for (total, of_single) in self.powers.iter_mut().zip(single.powers) {
            *total += sign * power * of_single;
        }
        self.size *= num_traits::Pow::pow(&single.size, sign * power);
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use crate::{Dimension, dimension_of, size};

    #[test]
    fn one_unit_has_many_spellings() {
        let read = |text, dimension| size(text, dimension).map(|size| size.to_string());
        for (dimension, value, spellings) in [
            (
                Dimension::Velocity,
                "1",
                &["m/s", "m s-1", "m s^-1", "m·s⁻¹", "m*s**-1", "m.s-1", "M/S", "mps", " m / s ", "m s−1"][..],
            ),
            (Dimension::Velocity, "1/1000", &["mm/s", "mm s-1", "m/s/1"][..1]),
            (Dimension::Velocity, "381/1250", &["ft/s", "fps", "feet/sec", "ft s^-1"]),
            (Dimension::Velocity, "5/18", &["km/h", "kmh", "km h-1", "km/hr"]),
            (Dimension::Velocity, "1/1000000", &["um/s", "µm/s", "μm/s", "micron/s"]),
            (Dimension::Density, "1000", &["g/cm^3", "g/cm3", "g/cm³", "g cm-3", "g cm⁻³", "kg/dm3", "t/m3"]),
            (Dimension::Modulus, "1000000", &["MPa", "N/mm2", "N/mm^2", "N mm-2", "MN m^-2"]),
            (Dimension::Viscosity, "1/1000", &["mPa s", "mPas", "mPa·s", "mPa*s", "cP"]),
            (Dimension::Acceleration, "1", &["m/s^2", "m/s²", "m s-2", "m/s/s", "N/kg"]),
        ] {
            for spelling in spellings {
                assert_eq!(read(spelling, dimension).as_deref(), Some(value), "{spelling}");
                assert_eq!(dimension_of(spelling), Some(dimension), "{spelling}");
            }
        }
    }

    #[test]
    fn what_is_no_unit_is_refused() {
        for text in [
            "", " ", "/", "m/", "/s", "m//s", "furlong", "ms-1", "m^0", "m^99", "m s^-1.5", "1", "%", "m s-",
            "a.u.", "m^s", "-", "m^(", "m/s^", "s²³",
        ] {
            assert_eq!(size(text, Dimension::Velocity), None, "{text}");
        }
        assert_eq!(size(&"m ".repeat(100), Dimension::Length), None);
    }

    proptest::proptest! {
        #[test]
        fn any_text_is_read_or_refused(text in "[a-zµA-Z0-9/^*. ⁻¹²()-]{0,12}|.{0,12}") {
            for dimension in Dimension::ALL {
                let _ = size(&text, dimension);
            }
        }
    }
}
