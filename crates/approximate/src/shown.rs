use num_rational::BigRational;
use num_traits::ToPrimitive;
use restitution_real::Ball;
use rug::Float;
use rug::float::Round;

/// A rational in `digits` significant decimals, off by less than a unit of the last; an integer as it is.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_approximate::rational_digits;
///
/// assert_eq!(rational_digits(&BigRational::new(2.into(), 3.into()), 5), "0.66667");
/// assert_eq!(rational_digits(&BigRational::from_integer(12.into()), 1), "12");
/// ```
pub fn rational_digits(value: &BigRational, digits: usize) -> String {
    if value.is_integer() {
        return value.to_string();
    }
    let bits = u32::try_from(digits.saturating_mul(4)).unwrap_or(u32::MAX / 64).saturating_add(64);
    let text = (0..6).find_map(|k| Ball::from_rational(value, bits << k).to_digits(digits));
    text.unwrap_or_else(|| value.to_string())
}

/// An upper bound with two digits.
///
/// # Examples
///
/// ```
/// use restitution_approximate::error_bound;
/// use restitution_real::Ball;
///
/// assert_eq!(error_bound(&Ball::from_ratio(1, 3, 64)), "3.4e-1");
/// assert_eq!(error_bound(&Ball::whole_line(64)), "inf");
/// ```
pub fn error_bound(error: &Ball) -> String {
    let up: Float = error.upper();
    up.to_string_radix_round(10, Some(2), Round::Up)
}

/// A level such as `1e-3` as it is usually written.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_approximate::error_text;
///
/// assert_eq!(error_text(&BigRational::new(1.into(), 1000.into())), "1e-3");
/// ```
pub fn error_text(level: &BigRational) -> String {
    format!("{:e}", level.to_f64().unwrap_or(f64::NAN))
}

/// A point of a grid to four digits, rounded down.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_approximate::decimal;
///
/// assert_eq!(decimal(&BigRational::new(2.into(), 3.into())), "0.6666");
/// assert_eq!(decimal(&BigRational::from_integer(0.into())), "0");
/// ```
pub fn decimal(value: &BigRational) -> String {
    let near = Float::with_val(64, value.to_f64().unwrap_or(f64::NAN));
    let text = near.to_string_radix_round(10, Some(4), Round::Down);
    text.parse::<f64>().map_or(text, |x| x.to_string())
}
