//! Decimal digits that a ball proves.

use crate::Ball;
use rug::Float;
use rug::float::Round;

impl Ball {
    /// Returns the value rounded to `digits` significant decimals, if the ball proves them.
    ///
    /// Every point of the ball rounds to the same decimals, so each digit is right and the true value
    /// differs from what is shown by at most half a unit of the last digit. (A ball so narrow that only
    /// a tie between two decimals can be the reason it rounds both ways gives one of the two, which is
    /// then right to half a unit and a 2^-30th of it.) The form is plain
    /// (`-0.0123`) for exponents from -6 to `digits`, scientific (`1.23e-9`) elsewhere. `None` if the
    /// ball is too wide, or contains zero without being exactly zero.
    pub fn to_digits(&self, digits: usize) -> Option<String> {
        if digits == 0 || !self.is_finite() {
            return None;
        }
        if self.is_exact() && self.mid.is_zero() {
            return Some("0".to_owned());
        }
        if self.contains_zero() {
            return None;
        }
        // Both ends are rounded outwards by less than a 2^-30th of half a unit of the last digit.
        let prec = self.prec().max(narrow(digits)) + 2;
        let low = Float::with_val_round(prec, &self.mid - &self.rad, Round::Down).0;
        let high = Float::with_val_round(prec, &self.mid + &self.rad, Round::Up).0;
        let low = decimal(&low, digits);
        if low == decimal(&high, digits) {
            return Some(layout(&low, digits));
        }
        let at_a_tie = self.relative_bits().is_none_or(|known| known > i64::from(narrow(digits)));
        at_a_tie.then(|| layout(&decimal(&self.mid, digits), digits))
    }

    /// Returns the proved digits as [`Ball::to_digits`] does, and how far the true value is from them at most.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_real::Ball;
    ///
    /// let third = Ball::from_ratio(1, 3, 64);
    /// let (digits, radius) = third.to_digits_and_radius(10).unwrap();
    /// assert_eq!((digits.as_str(), radius.as_str()), ("0.3333333333", "3.4e-11"));
    ///
    /// assert_eq!(third.to_digits_and_radius(30), None); // 64 bits prove 19 digits
    /// ```
    pub fn to_digits_and_radius(&self, digits: usize) -> Option<(String, String)> {
        let shown = self.to_digits(digits)?;
        let text = Float::parse(&shown).ok()?;
        let number = Self::rounded(self.prec().max(narrow(digits)) + 64, text);
        let difference = number - self;
        let radius = Self::new(Float::new(64), &difference.abs_up()).radius_text();
        Some((shown, radius))
    }

    /// Returns the radius as an upper bound with two digits, such as `1.3e-42`; `0` if exact.
    pub fn radius_text(&self) -> String {
        if self.rad.is_zero() {
            "0".to_owned()
        } else {
            self.rad.to_string_radix_round(10, Some(2), Round::Up)
        }
    }
}

/// Relative bits beyond which a radius is below a 2^-30th of half a unit of the last of `digits` digits.
///
/// A unit of the last digit is more than `10^-digits` of the value, and `10 < 2^(10/3)`.
fn narrow(digits: usize) -> u32 {
    u32::try_from(digits.saturating_mul(10) / 3).unwrap_or(u32::MAX).saturating_add(34).min(u32::MAX / 8)
}

/// Sign, digits and exponent of `0.d1d2d3... * 10^exponent`.
type Decimal = (bool, String, i32);

fn decimal(x: &Float, digits: usize) -> Decimal {
    let (negative, text, exponent) = x.to_sign_string_exp_round(10, Some(digits), Round::Nearest);
    (negative, text, exponent.unwrap_or(0))
}

fn layout((negative, digits, exponent): &Decimal, wanted: usize) -> String {
    let sign = if *negative { "-" } else { "" };
    let exponent = i64::from(*exponent);
    if exponent > i64::try_from(wanted).unwrap_or(i64::MAX) || exponent < -5 {
        let (first, rest) = digits.split_at(1);
        let point = if rest.is_empty() { "" } else { "." };
        return format!("{sign}{first}{point}{rest}e{}", exponent - 1);
    }
    match usize::try_from(exponent) {
        Ok(0) | Err(_) => {
            let zeros = "0".repeat(usize::try_from(-exponent).unwrap_or(0));
            format!("{sign}0.{zeros}{digits}")
        }
        Ok(whole) if whole == wanted => format!("{sign}{digits}"),
        Ok(whole) => format!("{sign}{}.{}", &digits[..whole], &digits[whole..]),
    }
}
