//! Decimal digits that a ball proves, of any length at the speed of GMP's conversion.

use crate::Ball;
use rug::float::Round;
use rug::ops::{AddAssignRound, DivAssignRound, MulAssignRound, Pow};
use rug::{Float, Integer};
use std::cmp::Ordering;

/// Half of a 2^-30th of a unit: a ball as narrow as this, seen from the last digit, fails only at a tie.
const TIE: f64 = 1.0 / (1u64 << 31) as f64;
/// Decimal exponents up to which powers of ten are exact integers; beyond, they are balls.
const EXACT_POWERS: u64 = 65_536;

impl Ball {
    /// Returns the value rounded to `digits` significant decimals, if the ball proves them.
    ///
    /// Every point of the ball rounds to the same decimals, so each digit is right and the true value
    /// differs from what is shown by at most half a unit of the last digit. (A ball so narrow that only
    /// a tie between two decimals can be the reason it rounds both ways gives one of the two, which is
    /// then right to half a unit and a 2^-30th of it.) The form is plain
    /// (`-0.0123`) for exponents from -6 to `digits`, scientific (`1.23e-9`) elsewhere. `None` if the
    /// ball is too wide, or contains zero without being exactly zero.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_real::Ball;
    ///
    /// let third = Ball::from_ratio(1, 3, 64);
    /// assert_eq!(third.to_digits(10).as_deref(), Some("0.3333333333"));
    ///
    /// assert_eq!(third.to_digits(30), None); // 64 bits prove 19 digits
    /// ```
    pub fn to_digits(&self, digits: usize) -> Option<String> {
        Some(self.to_digits_and_radius(digits)?.0)
    }

    /// Returns the proved digits as [`Ball::to_digits`] does, and how far the true value is from them at most.
    ///
    /// With `V = |midpoint| 10^k` and `m` the integer nearest to it, every point of the ball rounds to `m` if
    /// `|V - m| + radius 10^k < 1/2`. Cost: one multiplication and one conversion of the length of the midpoint.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_real::Ball;
    ///
    /// let third = Ball::from_ratio(1, 3, 64);
    /// let (digits, radius) = third.to_digits_and_radius(10).unwrap();
    /// assert_eq!((digits.as_str(), radius.as_str()), ("0.3333333333", "3.4e-11"));
    /// assert_eq!(third.radius_text(), "1.4e-20"); // that of the ball itself
    ///
    /// assert_eq!(third.to_digits_and_radius(30), None); // 64 bits prove 19 digits
    /// ```
    pub fn to_digits_and_radius(&self, digits: usize) -> Option<(String, String)> {
        if digits == 0 || !self.is_finite() {
            return None;
        }
        if self.is_exact() && self.mid.is_zero() {
            return Some(("0".to_owned(), "0".to_owned()));
        }
        if self.contains_zero() {
            return None;
        }
        // Near a power of ten this may be off by a few, which the number of digits found tells.
        let (mantissa, exponent) = self.mid.to_f64_exp();
        let logarithm = mantissa.abs().log10() + f64::from(exponent) * std::f64::consts::LOG10_2;
        let mut decade = logarithm.ceil() as i64;
        let (text, distance, error, shift) = loop {
            let shift = i64::try_from(digits).ok()? - decade;
            let (nearest, distance, error) = self.in_units(shift, digits)?;
            let text = nearest.to_string();
            match text.len().cmp(&digits) {
                Ordering::Less => decade -= 1,
                Ordering::Greater => decade += 1, // also where 9.99... has been rounded to 10
                Ordering::Equal => break (text, distance, error, shift),
            }
        };
        let mut total = distance;
        total.add_assign_round(&error, Round::Up);
        if total >= 0.5 && error > TIE {
            return None;
        }
        let radius = Self::new(Float::new(64), &times_power_of_ten_up(&total, -shift)?).radius_text();
        Some((layout(self.mid.is_sign_negative(), &text, decade, digits), radius))
    }

    /// Returns the radius as an upper bound with two digits, such as `1.3e-42`; `0` if exact.
    pub fn radius_text(&self) -> String {
        if self.rad.is_zero() {
            "0".to_owned()
        } else {
            self.rad.to_string_radix_round(10, Some(2), Round::Up)
        }
    }

    /// For `V = |midpoint| 10^shift` of `digits` digits: the nearest integer, how far it is, and the radius in the
    /// same unit, both up.
    fn in_units(&self, shift: i64, digits: usize) -> Option<(Integer, Float, Float)> {
        let needed = u32::try_from(digits.saturating_mul(4)).ok()?.max(self.prec()).checked_add(96)?;
        if shift.unsigned_abs() > EXACT_POWERS.max(u64::from(needed)) {
            let scaled = self.with_prec(needed) * Self::from_integer(10, needed).powi(shift);
            let (nearest, distance) = nearest_integer(&scaled.mid, 0)?;
            return Some((nearest, distance, scaled.rad));
        }
        let (nearest, distance) = nearest_integer(&self.mid, shift)?;
        Some((nearest, distance, times_power_of_ten_up(&self.rad, shift)?))
    }
}

/// The integer nearest to `V = |x| 10^shift`, the even one at a tie, and how far it is, rounded up.
fn nearest_integer(x: &Float, shift: i64) -> Option<(Integer, Float)> {
    let (mantissa, exponent) = x.to_integer_exp()?;
    let power = Integer::from(5).pow(u32::try_from(shift.unsigned_abs()).ok()?);
    let exponent = i64::from(exponent) + shift;
    let twos = u32::try_from(exponent.unsigned_abs()).ok()?;
    let (mut above, mut below) = (mantissa.abs(), Integer::from(1));
    if shift >= 0 {
        above *= power;
    } else {
        below = power;
    }
    if exponent >= 0 {
        above <<= twos;
    } else if shift >= 0 {
        return Some(nearest_multiple(above, twos));
    } else {
        below <<= twos;
    }
    let twice = Integer::from(&below * 2u32);
    let (mut nearest, rest) = (above * 2u32 + &below).div_rem_floor(twice.clone());
    if rest.is_zero() && nearest.is_odd() {
        nearest -= 1;
    }
    let mut distance = Float::with_val_round(32, &(rest - &below).abs(), Round::Up).0;
    distance.div_assign_round(&Float::with_val_round(32, &twice, Round::Down).0, Round::Up);
    Some((nearest, distance))
}

/// The integer nearest to `n 2^-bits`, and how far it is: most often the denominator is a power of two.
fn nearest_multiple(n: Integer, bits: u32) -> (Integer, Float) {
    if bits == 0 {
        return (n, Float::new(32));
    }
    let half = Integer::from(1) << (bits - 1);
    let mut nearest = Integer::from(&n + &half) >> bits;
    let difference = (n - Integer::from(&nearest << bits)).abs();
    if difference == half && nearest.is_odd() {
        nearest -= 1;
    }
    (nearest, Float::with_val_round(32, &difference, Round::Up).0 >> bits)
}

/// An upper bound of `x 10^power`, `x >= 0`; exact where it can be.
fn times_power_of_ten_up(x: &Float, power: i64) -> Option<Float> {
    let ten = Float::with_val(64, 10);
    let factor = Float::with_val_round(64, Pow::pow(&ten, i32::try_from(power).ok()?), Round::Up).0;
    let mut out = Float::with_val_round(64, x, Round::Up).0;
    out.mul_assign_round(&factor, Round::Up);
    Some(out)
}

/// The decimal `0.digits 10^decade`: plain for small exponents, scientific elsewhere.
fn layout(negative: bool, digits: &str, decade: i64, wanted: usize) -> String {
    let sign = if negative { "-" } else { "" };
    if decade > i64::try_from(wanted).unwrap_or(i64::MAX) || decade < -5 {
        let (first, rest) = digits.split_at(1);
        let point = if rest.is_empty() { "" } else { "." };
        return format!("{sign}{first}{point}{rest}e{}", decade - 1);
    }
    match usize::try_from(decade) {
        Ok(0) | Err(_) => {
            let zeros = "0".repeat(usize::try_from(-decade).unwrap_or(0));
            format!("{sign}0.{zeros}{digits}")
        }
        Ok(whole) if whole == digits.len() => format!("{sign}{digits}"),
        Ok(whole) => format!("{sign}{}.{}", &digits[..whole], &digits[whole..]),
    }
}
