//! Decimal digits of a ball of any length, each proved, at the speed of GMP's conversion.

use restitution_real::Ball;
use rug::float::Round;
use rug::ops::{AddAssignRound, Pow};
use rug::{Float, Integer};

/// A certified decimal: what is shown, and how far the true value is from it at most.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certified {
    /// The value, rounded to nearest; every digit is right.
    pub value: String,
    /// An upper bound of `|true value - value|` with two digits, `0` if there is no difference.
    pub radius: String,
}

/// Returns a ball rounded to `digits` significant decimals, if the ball proves them.
///
/// As [`Ball::to_digits`] and with the same form, by one conversion instead of several: with
/// `V = |midpoint| 10^k`, `m = floor(V + 1/2)`, every point of the ball rounds to `m` if
/// `|V - m| + radius 10^k < 1/2`. A ball so narrow that only a tie can be the reason that it is not so gives
/// one of the two. `None` if the ball is too wide, or contains 0 without being 0.
pub fn certified(value: &Ball, digits: usize) -> Option<Certified> {
    if value.is_exact() && value.mid().is_zero() {
        return Some(Certified { value: "0".to_owned(), radius: "0".to_owned() });
    }
    if digits == 0 || !value.is_finite() || value.contains_zero() {
        return None;
    }
    // Near a power of ten this may be off by one, which the number of digits found tells.
    let (mantissa, exponent) = value.mid().to_f64_exp();
    let mut decade =
        (mantissa.abs().log10() + f64::from(exponent) * std::f64::consts::LOG10_2).floor() as i64 + 1;
    loop {
        let shift = i64::try_from(digits).ok()? - decade;
        let (rounded, distance) = scaled(value.mid(), shift)?;
        let mut text = rounded.to_string();
        if text.len() < digits {
            decade -= 1;
            continue;
        }
        if text.len() > digits {
            decade += 1;
            if !text[1..].bytes().all(|b| b == b'0') {
                continue;
            }
            text.truncate(digits); // 9.99... has been rounded to 10
        }
        let error = times_power_of_ten_up(value.rad(), shift);
        let mut total = distance;
        total.add_assign_round(&error, Round::Up);
        if total >= 0.5 && error > 1e-9 {
            return None;
        }
        let radius = times_power_of_ten_up(&total, -shift);
        let radius = if radius.is_zero() {
            "0".to_owned()
        } else {
            radius.to_string_radix_round(10, Some(2), Round::Up)
        };
        return Some(Certified {
            value: layout(value.mid().is_sign_negative(), &text, decade, digits),
            radius,
        });
    }
}

/// `m = floor(V + 1/2)` and `|V - m|`, rounded up, for `V = |x| 10^shift`.
fn scaled(x: &Float, shift: i64) -> Option<(Integer, Float)> {
    let (mantissa, exponent) = x.to_integer_exp()?;
    let mantissa = mantissa.abs();
    let power = Integer::from(5).pow(u32::try_from(shift.unsigned_abs()).ok()?);
    let exponent = i64::from(exponent) + shift;
    let (mut numerator, mut denominator) =
        if shift >= 0 { (mantissa * power, Integer::from(1)) } else { (mantissa, power) };
    if exponent >= 0 {
        numerator <<= u32::try_from(exponent).ok()?;
    } else if shift >= 0 {
        return rounded_shift(numerator, u32::try_from(-exponent).ok()?);
    } else {
        denominator <<= u32::try_from(-exponent).ok()?;
    }
    let (quotient, remainder) =
        (numerator * 2u32 + &denominator).div_rem_floor(Integer::from(&denominator * 2u32));
    let distance = (remainder - &denominator).abs();
    let mut distance = Float::with_val_round(32, &distance, Round::Up).0;
    let below = Float::with_val_round(32, Integer::from(&denominator * 2u32), Round::Down).0;
    rug::ops::DivAssignRound::div_assign_round(&mut distance, &below, Round::Up);
    Some((quotient, distance))
}

/// [`scaled`] where the denominator is a power of two, which most often it is.
fn rounded_shift(numerator: Integer, bits: u32) -> Option<(Integer, Float)> {
    if bits == 0 {
        return Some((numerator, Float::new(32)));
    }
    let quotient = (&numerator + (Integer::from(1) << (bits - 1))) >> bits;
    let difference = (numerator - Integer::from(&quotient << bits)).abs();
    Some((quotient, Float::with_val_round(32, &difference, Round::Up).0 >> bits))
}

/// An upper bound of `x 10^power`, `x >= 0`.
fn times_power_of_ten_up(x: &Float, power: i64) -> Float {
    let ten = Float::with_val(64, 10);
    let factor = Float::with_val_round(64, ten.pow(i32::try_from(power).unwrap_or(i32::MAX)), Round::Up).0;
    // The power is within a few units of its 64 bits: 2^-40 covers it.
    let raised = factor * (1.0 + 2.0_f64.powi(-40));
    let mut out = Float::with_val_round(32, x, Round::Up).0;
    rug::ops::MulAssignRound::mul_assign_round(
        &mut out,
        &Float::with_val_round(32, raised, Round::Up).0,
        Round::Up,
    );
    out
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
        Ok(whole) if whole >= digits.len() => format!("{sign}{digits}"),
        Ok(whole) => format!("{sign}{}.{}", &digits[..whole], &digits[whole..]),
    }
}
