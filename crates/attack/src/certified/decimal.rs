//! What a printed decimal claims.

use restitution_real::Ball;
use rug::Float;

/// Whether every point of `value` is less than a unit of the last digit away from the decimal `text`.
pub fn within_a_unit(value: &Ball, text: &str) -> bool {
    let prec = value.prec() + 64;
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let places = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len() as i64);
    let Ok(exponent) = exponent.parse::<i64>() else { return false };
    let Ok(shown) = Float::parse(text) else { return false };
    let Ok(unit) = Float::parse(format!("1e{}", exponent - places)) else { return false };
    let distance = (Float::with_val(prec, shown) - value.mid()).abs() + value.rad();
    distance < Float::with_val(prec, unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_is_one_of_the_last_digit_shown() {
        let third = Ball::from_ratio(1, 3, 100);
        for (text, kept) in
            [("0.333", true), ("0.334", true), ("0.335", false), ("3.33e-1", true), ("x", false)]
        {
            assert_eq!(within_a_unit(&third, text), kept, "{text}");
        }
    }
}
