use num_rational::BigRational;
use num_traits::ToPrimitive;
use restitution_real::Ball;
use rug::Float;
use rug::float::Round;

/// An upper bound with two digits.
pub fn error_bound(error: &Ball) -> String {
    let up: Float = error.upper();
    up.to_string_radix_round(10, Some(2), Round::Up)
}

/// A level such as `1e-3` as it is usually written.
pub fn error_text(level: &BigRational) -> String {
    format!("{:e}", level.to_f64().unwrap_or(f64::NAN))
}

/// A point of a grid to four digits, rounded down.
pub fn decimal(value: &BigRational) -> String {
    let near = Float::with_val(64, value.to_f64().unwrap_or(f64::NAN));
    let text = near.to_string_radix_round(10, Some(4), Round::Down);
    text.parse::<f64>().map_or(text, |x| x.to_string())
}
