//! A digit that is printed is right: random balls, ties, carries, long and short.

use crate::operands::{Random, cases, exact};
use restitution_real::Ball;
use rug::ops::Pow;
use rug::{Float, Integer, Rational};

/// What a decimal text says, exactly, and one unit of its last digit.
fn read(text: &str) -> (Rational, Rational) {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len()) as i32;
    let digits: Integer = mantissa.replace('.', "").parse().unwrap();
    let unit = Rational::from(10).pow(exponent.parse::<i32>().unwrap() - decimals);
    (digits * unit.clone(), unit)
}

/// Significant digits of a text.
fn count(text: &str) -> usize {
    let mantissa = text.split('e').next().unwrap().trim_start_matches('-').replace('.', "");
    mantissa.trim_start_matches('0').len()
}

/// Checks that every point of the ball is within half a unit of what is shown, ties a 2^-30th more.
fn check(ball: &Ball, digits: usize) -> bool {
    let Some(text) = ball.to_digits(digits) else { return false };
    let (shown, unit) = read(&text);
    assert_eq!(count(&text), digits, "{text}");
    let (mid, rad) = (exact(ball.mid()), exact(ball.rad()));
    let half = Rational::from(&unit >> 1);
    let room = Rational::from(&half >> 30) + half;
    for end in [Rational::from(&mid - &rad), Rational::from(&mid + &rad)] {
        assert!(Rational::from(&end - &shown).abs() <= room, "{ball:?} to {digits} digits: {text}");
    }
    let (again, radius) = ball.to_digits_and_radius(digits).unwrap();
    assert_eq!(again, text);
    let (radius, _) = read(&radius);
    let farthest = Rational::from(&mid - &shown).abs() + rad;
    assert!(farthest <= radius, "{ball:?} {text} {radius}");
    let slack = mid.abs() >> (ball.prec() + 60);
    assert!(radius <= farthest * Rational::from((11, 10)) + slack, "{ball:?} {text} {radius}");
    true
}

#[test]
fn random_balls() {
    let mut random = Random::new(31);
    let mut shown = 0;
    for _ in 0..cases(4000) {
        let ball = random.ball();
        for digits in [1, 2, 3, 7, 16, 20, 45] {
            shown += usize::from(!ball.mid().is_zero() && check(&ball, digits));
        }
    }
    assert!(shown > cases(4000), "{shown}");
}

/// Balls around, beside and across the points where rounding turns, of every width.
#[test]
fn ties_and_carries() {
    let mut random = Random::new(32);
    for _ in 0..cases(1500) {
        let (digits, prec) = (1 + random.below(30), random.pick(&[64, 100, 200, 400]));
        let last = Integer::from(10).pow(digits as u32);
        let whole = match random.below(3) {
            0 => last.clone() - 1,
            1 => Integer::from(&last / 10u32),
            _ => Integer::from(random.next()) % &last + 1u32,
        };
        // whole + 1/2 is a tie, just below 10^digits it carries.
        let tie = (Rational::from(whole) + Rational::from((1, 2)))
            * Rational::from(10).pow(random.between(-40, 8) as i32);
        let rad = Float::with_val(32, 1) >> random.between(-3, 700) as u32;
        let offset = Rational::from((random.between(-2, 2), 1)) * exact(&rad);
        let ball = Ball::exact(Float::with_val(prec, &tie + offset)).widened(&rad);
        for asked in [digits.saturating_sub(1).max(1), digits, digits + 1, 2 * digits] {
            check(&ball, asked);
            check(&-&ball, asked);
        }
    }
}

#[test]
fn a_radius_far_below_the_last_bit_moves_no_digit() {
    // Rounding the ends to a few bits more than the midpoint has would print 0.99999...
    let one = Ball::from_integer(1, 64).widened(&Float::with_val(32, 1e-300));
    assert_eq!(one.to_digits(40), Some(format!("1.{}", "0".repeat(39))));
    let third = Ball::from_ratio(1, 3, 64);
    assert!(third.to_digits(18).is_some() && third.to_digits(20).is_none());
}

#[test]
fn ties_are_answered_only_when_nothing_else_can_be_the_reason() {
    let tie = |rad: f64| Ball::from_ratio(1, 8, 300).widened(&Float::with_val(32, rad));
    assert_eq!(tie(0.0).to_digits(2).as_deref(), Some("0.12"));
    assert_eq!(tie(1e-14).to_digits(2).as_deref(), Some("0.12"));
    assert_eq!(tie(1e-10).to_digits(2), None);
    // In units of the last digit, here 1, the narrowest radius that is refused is just above 2^-31.
    let narrow = |power: u32| Ball::from_ratio(5, 2, 300).widened(&(Float::with_val(32, 1) >> power));
    let even = |n: i64| Ball::from_integer(n, 60).to_digits(1).unwrap();
    assert_eq!([even(25), even(35), even(-45)], ["2e1", "4e1", "-4e1"]);
    assert_eq!((narrow(31).to_digits(1).as_deref(), narrow(30).to_digits(1)), (Some("2"), None));
    assert_eq!(tie(1e-10).to_digits(3).as_deref(), Some("0.125"));
}

#[test]
fn numbers_are_laid_out_plainly() {
    let show = |n, d, digits| Ball::from_ratio(n, d, 200).to_digits(digits).unwrap();
    for (n, d, digits, text) in [
        (1, 3, 5, "0.33333"),
        (-200, 3, 5, "-66.667"),
        (200_000, 3, 3, "6.67e4"),
        (200_000, 3, 5, "66667"),
        (200_000, 3, 4, "6.667e4"),
        (-200_000, 3, 1, "-7e4"),
        (1, 3000, 3, "0.000333"),
        (1, 300_000, 3, "0.00000333"),
        (-1, 3_000_000, 3, "-3.33e-7"),
        (12, 1, 2, "12"),
        (1, 1, 1, "1"),
        (99_999, 10, 4, "1.000e4"),
        (99_999, 10_000, 4, "10.00"),
        (0, 1, 5, "0"),
    ] {
        assert_eq!(show(n, d, digits), text);
    }
    assert_eq!(Ball::from_integer(1, 64).to_digits(0), None);
    assert_eq!(Ball::whole_line(64).to_digits(3), None);
    assert_eq!(Ball::from_integer(0, 64).widened(&Float::with_val(9, 1e-9)).to_digits(1), None);
}

/// A short ball has as many digits as are asked for: zeros, if it is exact.
#[test]
fn exact_numbers_have_any_number_of_digits() {
    for digits in [70_000, 300_000] {
        let one = Ball::from_integer(1, 2).to_digits(digits);
        assert_eq!(one, Some(format!("1.{}", "0".repeat(digits - 1))));
        let large = Ball::from_integer(10, 64).powi(19).powi(10_000);
        assert_eq!(large.to_digits(digits), None);
    }
}

#[test]
fn numbers_beyond_every_float_have_digits() {
    for n in [70_000, 1_000_003, -1_000_003] {
        let ball = Ball::from_integer(10, 200).powi(n) * Ball::from_ratio(2, 3, 200);
        let text = format!("6.6667e{}", n - 1);
        assert_eq!(ball.to_digits(5), Some(text));
        assert_eq!(ball.to_digits(60), None);
    }
}

#[test]
fn radii_are_rounded_up() {
    let radius = |r: f64| Ball::from_integer(1, 64).widened(&Float::with_val(32, r)).radius_text();
    assert_eq!((radius(0.0).as_str(), radius(0.25).as_str()), ("0", "2.5e-1"));
    assert!(radius(1.01e-30).parse::<f64>().unwrap() > 1.01e-30);
    let wide = Ball::from_ratio(1, 3, 64).widened(&Float::with_val(32, 1e-3));
    assert_eq!((wide.to_digits(2).as_deref(), wide.to_digits(4)), (Some("0.33"), None));
    assert_eq!(wide.to_digits_and_radius(4), None);
}
