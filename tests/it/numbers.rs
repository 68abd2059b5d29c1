//! Short names for laws and fractions, and what a printed decimal claims.

use num_bigint::BigInt;
use num_rational::BigRational;
use restitution_law::ForceLaw;
use restitution_real::Ball;

pub fn law(text: &str) -> ForceLaw {
    text.parse().expect("a force law")
}

pub fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

/// Reads a decimal such as `-0.0123` or `1.2e-9`: its exact value, and one unit of its last digit.
pub fn decimal(text: &str) -> (BigRational, BigRational) {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let exponent = exponent.parse::<i32>().expect("an exponent") - fraction.len() as i32;
    let unit = BigRational::from_integer(BigInt::from(10)).pow(exponent);
    let digits: BigInt = format!("{whole}{fraction}").parse().expect("digits");
    (BigRational::from_integer(digits) * &unit, unit)
}

/// Whether every point of the ball is less than one unit of the last digit away from the text.
pub fn within_a_unit(ball: &Ball, text: &str) -> bool {
    let (value, unit) = decimal(text);
    let prec = ball.prec() + 64;
    let difference = (ball.with_prec(prec) - Ball::from_rational(&value, prec)).abs();
    (Ball::from_rational(&unit, prec) - difference).is_positive()
}

#[test]
fn decimals_are_read_exactly() {
    assert_eq!(decimal("-0.0125"), (ratio(-1, 80), ratio(1, 10_000)));
    assert_eq!(decimal("1.5e-3"), (ratio(3, 2000), ratio(1, 10_000)));
    assert_eq!(decimal("6.7e4"), (ratio(67_000, 1), ratio(1000, 1)));
    let third = Ball::from_ratio(1, 3, 100);
    assert!(within_a_unit(&third, "0.333") && within_a_unit(&third, "0.334"));
    assert!(!within_a_unit(&third, "0.335") && !within_a_unit(&third, "0.332"));
}
