//! Elementary functions, powers and gamma against MPFR at more than twice the precision.

use crate::operands::{Random, cases, exact, half_unit, nearly_inside, not_wider};
use num_rational::BigRational;
use restitution_real::Ball;
use rug::float::{Constant, Round};
use rug::{Float, Rational};

/// The precision at which results are judged: every operand of these tests is exact in it.
const BITS: u32 = 900;

/// Points of a ball as numbers of [`BITS`] bits, which hold them exactly or lie a little inside.
fn points(ball: &Ball) -> Vec<Float> {
    let (mid, rad) = (Float::with_val(BITS, ball.mid()), Float::with_val(BITS, ball.rad()));
    let share = |s: f64| Float::with_val(BITS, &mid + rad.clone() * s);
    [-1.0, -0.75, 0.0, 0.3, 1.0].map(share).to_vec()
}

/// A positive ball whose ends are exact in [`BITS`] bits and with a moderate exponent.
fn moderate(random: &mut Random) -> Ball {
    loop {
        let x = random.positive();
        if x.mid().get_exp().is_some_and(|e| e.abs() < 80) && x.rad().get_exp().is_none_or(|e| e > -400) {
            return x;
        }
    }
}

fn high(x: &Ball) -> (Float, Float) {
    (Float::with_val(BITS, x.mid()), Float::with_val(BITS, x.rad()))
}

/// Checks one function: points inside, nearest midpoint, radius by the rule plus the rounding.
fn check(name: &str, x: &Ball, result: &Ball, function: impl Fn(&Float) -> Float, rule: &Float) {
    assert_eq!(result.prec(), x.prec());
    for point in points(x) {
        assert!(nearly_inside(result, &function(&point)), "{name} {x:?} = {result:?} at {point}");
    }
    let (middle, half) = (exact(&function(&high(x).0)), half_unit(result));
    let off = (&middle - exact(result.mid())).abs();
    assert!(off <= half, "{name} {x:?}: the midpoint is the nearest");
    let rounding = if off == 0 { Rational::new() } else { half };
    let rule = exact(rule) + rounding;
    assert!(not_wider(result, &rule), "{name} {x:?} = {result:?}, rule {:e}", rule.to_f64());
}

#[test]
fn square_roots() {
    let mut random = Random::new(21);
    for _ in 0..cases(2000) {
        let x = moderate(&mut random);
        let (mid, rad) = high(&x);
        check("sqrt", &x, &x.sqrt(), |p| p.clone().sqrt(), &(rad / mid.sqrt()));
    }
    let four = Ball::from_integer(4, 20).sqrt();
    assert!(four.is_exact() && four.mid() == &2 && Ball::from_integer(0, 20).sqrt().is_exact());
    assert!(!Ball::from_integer(-4, 20).sqrt().is_finite());
    assert!(!Ball::new(Float::with_val(20, 1), &Float::with_val(20, 1)).sqrt().is_finite());
}

#[test]
fn exponentials() {
    let mut random = Random::new(22);
    for _ in 0..cases(2000) {
        let x = random.ball();
        let Some(exponent) = x.mid().get_exp().or(Some(0)) else { continue };
        if !(-60..12).contains(&exponent) || x.rad().get_exp().is_some_and(|e| !(-400..12).contains(&e)) {
            continue;
        }
        let (mid, rad) = high(&x);
        check("exp", &x, &x.exp(), |p| p.clone().exp(), &(mid.exp() * rad.exp_m1()));
    }
    assert!(Ball::from_integer(0, 20).exp().is_exact() && !Ball::whole_line(20).exp().is_finite());
}

#[test]
fn logarithms() {
    let mut random = Random::new(23);
    for _ in 0..cases(2000) {
        let x = moderate(&mut random);
        let (mid, rad) = high(&x);
        let least = Float::with_val(BITS, &mid - &rad);
        let rule = Float::with_val(BITS, rad / least).ln_1p();
        check("ln", &x, &x.ln(), |p| p.clone().ln(), &rule);
    }
    assert!(Ball::from_integer(1, 20).ln().is_exact());
    assert!(!Ball::from_integer(0, 20).ln().is_finite() && !Ball::from_integer(-1, 20).ln().is_finite());
}

#[test]
fn gamma_of_positive_numbers() {
    let mut random = Random::new(24);
    let slope = |x: Float| (x.clone().gamma() * x.digamma()).abs();
    for _ in 0..cases(600) {
        let x = random.positive();
        let size = x.mid().get_exp().unwrap_or(0);
        if !(-30..8).contains(&size) || x.rad().get_exp().is_some_and(|e| e < -400) {
            continue;
        }
        let (mid, rad) = (Float::with_val(300, x.mid()), Float::with_val(300, x.rad()));
        let ends = [Float::with_val(300, x.lower()), Float::with_val(300, x.upper())];
        let [low, high] = ends.map(slope);
        let result = x.gamma();
        if result.is_finite() {
            let rule = Float::with_val(BITS, low.max(&high) * rad);
            check("gamma", &x, &result, |p| Float::with_val(300, p).gamma(), &rule);
        }
        assert!(result.is_finite() || mid < Float::with_val(64, x.rad()) * 2, "{x:?}");
    }
    assert!(Ball::from_integer(5, 20).gamma().is_exact());
    assert!(
        !Ball::from_integer(0, 20).gamma().is_finite() && !Ball::from_ratio(-1, 2, 20).gamma().is_finite()
    );
}

#[test]
fn rational_powers() {
    let mut random = Random::new(25);
    for _ in 0..cases(1500) {
        let x = moderate(&mut random);
        let (n, d) = (random.between(-9, 9), random.between(1, 7));
        let exponent = BigRational::new(n.into(), d.into());
        let power = x.pow(&exponent);
        if !power.is_finite() {
            assert!(x.prec() < 16 || Float::with_val(64, x.rad() << 4u32) > *x.mid(), "{x:?}^{exponent}");
            continue;
        }
        assert_eq!(power.prec(), x.prec());
        let q = Float::with_val(BITS, &Rational::from((n, d)));
        let value = |p: &Float| (p.clone().ln() * &q).exp();
        for point in points(&x).iter().filter(|p| **p > 0) {
            // The judge itself is off by a few units of 2^-900, times the size of the logarithm.
            let near = Float::with_val(BITS - 60, &value(point));
            assert!(nearly_inside(&power, &near), "{x:?}^{exponent} = {power:?} at {point}");
        }
        let relative = Float::with_val(64, x.rad()) / x.abs_down();
        if relative < 1e-3 && x.prec() >= 16 {
            let expected = relative * (n.unsigned_abs() + 1) * 2
                + Float::with_val(64, 64) * 0.5_f64.powi(x.prec() as i32);
            let got = Float::with_val(64, power.rad() / Float::with_val(64, power.mid()).abs());
            assert!(got <= expected, "{x:?}^{exponent}: {got} {expected}");
        }
    }
}

#[test]
fn powers_with_special_bases_and_exponents() {
    let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
    let one = Ball::from_integer(1, 30);
    assert!(one.pow(&ratio(1, 3)).is_exact() && one.pow(&ratio(-5, 7)).is_exact());
    let half = Ball::new(Float::with_val(30, 1), &Float::with_val(30, 0.5)).pow(&ratio(1, 3));
    assert!(half.contains_rational(&ratio(9, 8)) && !half.is_exact());
    assert!(Ball::from_integer(9, 30).pow(&ratio(3, 2)).is_exact()); // by roots
    assert!(Ball::from_integer(-3, 30).pow(&ratio(3, 1)).contains_rational(&ratio(-27, 1)));
    assert!(!Ball::from_integer(-8, 30).pow(&ratio(1, 3)).is_finite());
    assert!(Ball::from_integer(0, 30).pow(&ratio(3, 2)).is_exact());
    assert!(!Ball::from_integer(0, 30).pow(&ratio(-1, 2)).is_finite());
    let huge = BigRational::from_integer(num_bigint::BigInt::from(10).pow(30));
    let power = Ball::from_ratio(1_000_001, 1_000_000, 200).pow(&huge);
    assert!(!power.is_finite() || power.is_positive());
    assert!(Ball::from_integer(32, 60).fifth_root().contains(&Ball::from_integer(2, 60)));
    assert!(Ball::from_integer(32, 60).fifth_root().relative_bits().is_none_or(|bits| bits > 55));
}

#[test]
fn pi_and_beta() {
    for prec in [2, 10, 64, 500] {
        let (pi, truth) = (Ball::pi(prec), Float::with_val(BITS, Constant::Pi));
        assert!(nearly_inside(&pi, &truth) && not_wider(&pi, &half_unit(&pi)) && !pi.is_exact());
        assert_eq!(pi.prec(), prec);
    }
    let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
    // B(1/2, 1/2) = pi, B(3, 2) = 1/12, B(2/5, 3/5) = pi/sin(2 pi/5).
    for prec in [30, 64, 300] {
        let close = |b: &Ball| b.relative_bits().is_none_or(|bits| bits > i64::from(prec) - 8);
        let half = Ball::beta(&ratio(1, 2), &ratio(1, 2), prec);
        assert!(nearly_inside(&half, &Float::with_val(BITS, Constant::Pi)) && close(&half));
        let whole = Ball::beta(&ratio(3, 1), &ratio(2, 1), prec);
        assert!(whole.contains_rational(&ratio(1, 12)) && close(&whole));
        let pi = Float::with_val(BITS, Constant::Pi);
        let reflected = pi.clone() / (pi * 2u32 / 5u32).sin();
        let fifths = Ball::beta(&ratio(2, 5), &ratio(3, 5), prec);
        assert!(nearly_inside(&fifths, &Float::with_val_round(BITS - 9, reflected, Round::Nearest).0));
        assert!(close(&fifths));
    }
    assert!(!Ball::beta(&ratio(-1, 2), &ratio(1, 2), 60).is_finite());
}
