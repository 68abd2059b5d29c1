//! The field operations: the exact result inside, the radius as the rules state it.

use crate::operands::{Random, cases, exact, half_unit, inside, not_wider};
use num_traits::{One, Zero};
use restitution_real::{Ball, Balls, Field};
use rug::{Float, Rational};

type Exactly = fn(&Rational, &Rational) -> Rational;

/// Checks one operation on many operands: points of the operands, the rounding error, the rule.
fn check(
    name: &str,
    on_balls: impl Fn(&Ball, &Ball) -> Ball,
    exactly: Exactly,
    rule: impl Fn(&Ball, &Ball, &Ball) -> Rational,
) {
    let mut random = Random::new(name.len() as u64);
    for _ in 0..cases(3000) {
        let (x, y) = (random.ball(), random.ball());
        if name == "/" && y.contains_zero() {
            assert!(!on_balls(&x, &y).is_finite(), "{x:?} {name} {y:?}");
            continue;
        }
        let result = on_balls(&x, &y);
        assert!(result.is_finite(), "{x:?} {name} {y:?}");
        assert_eq!(result.prec(), x.prec().max(y.prec()));
        let ys = random.points(&y);
        for a in random.points(&x) {
            for b in &ys {
                assert!(inside(&result, &exactly(&a, b)), "{x:?} {name} {y:?} = {result:?} without {a} {b}");
            }
        }
        let middle = exactly(&exact(x.mid()), &exact(y.mid()));
        let rounding = if middle == exact(result.mid()) { Rational::new() } else { half_unit(&result) };
        let off = (&middle - exact(result.mid())).abs();
        assert!(off <= half_unit(&result), "{x:?} {name} {y:?}: the midpoint is the nearest");
        let rule = rule(&x, &y, &result) + rounding;
        assert!(not_wider(&result, &rule), "{x:?} {name} {y:?} = {result:?} wider than {rule}");
    }
}

fn radii(x: &Ball, y: &Ball) -> (Rational, Rational) {
    (exact(x.rad()), exact(y.rad()))
}

fn sizes(x: &Ball, y: &Ball) -> (Rational, Rational) {
    (exact(x.mid()).abs(), exact(y.mid()).abs())
}

#[test]
fn sums() {
    let rule = |x: &Ball, y: &Ball, _: &Ball| radii(x, y).0 + radii(x, y).1;
    check("+", |x, y| x + y, |a, b| Rational::from(a + b), rule);
}

#[test]
fn differences() {
    let rule = |x: &Ball, y: &Ball, _: &Ball| radii(x, y).0 + radii(x, y).1;
    check("-", |x, y| x - y, |a, b| Rational::from(a - b), rule);
}

#[test]
fn products() {
    let rule = |x: &Ball, y: &Ball, _: &Ball| {
        let ((rx, ry), (mx, my)) = (radii(x, y), sizes(x, y));
        (mx + &rx) * ry + my * rx
    };
    check("*", |x, y| x * y, |a, b| Rational::from(a * b), rule);
}

#[test]
fn quotients() {
    let rule = |x: &Ball, y: &Ball, quotient: &Ball| {
        let ((rx, ry), (_, my)) = (radii(x, y), sizes(x, y));
        // |x/y| is taken from the rounded quotient.
        let size = exact(quotient.mid()).abs() + half_unit(quotient);
        (rx + size * &ry) / (my - ry)
    };
    check("/", |x, y| x / y, |a, b| Rational::from(a / b), rule);
}

#[test]
fn every_way_to_write_an_operation_is_the_same() {
    let mut random = Random::new(9);
    let same = |a: &Ball, b: &Ball| a.mid() == b.mid() && a.rad() == b.rad() && a.prec() == b.prec();
    for _ in 0..cases(50) {
        let (x, y) = (random.ball(), random.ball());
        macro_rules! all_ways {
            ($op:tt, $assign:tt) => {
                let expected = &x $op &y;
                assert!(same(&expected, &(x.clone() $op y.clone())));
                assert!(same(&expected, &(x.clone() $op &y)) && same(&expected, &(&x $op y.clone())));
                let (mut a, mut b) = (x.clone(), x.clone());
                a $assign &y;
                b $assign y.clone();
                assert!(same(&expected, &a) && same(&expected, &b));
            };
        }
        all_ways!(+, +=);
        all_ways!(-, -=);
        all_ways!(*, *=);
        if !y.contains_zero() {
            all_ways!(/, /=);
        }
    }
}

#[test]
fn a_field_rounds_to_its_own_precision() {
    let mut random = Random::new(11);
    for _ in 0..cases(500) {
        let (x, y, field) = (random.ball(), random.ball(), Balls::new(random.pick(&[2, 20, 64, 150])));
        let results = [field.add(&x, &y), field.sub(&x, &y), field.mul(&x, &y), field.neg(&x)];
        let (a, b) = (exact(x.mid()), exact(y.mid()));
        let truths = [Rational::from(&a + &b), Rational::from(&a - &b), Rational::from(&a * &b), -a.clone()];
        for (result, truth) in results.iter().zip(&truths) {
            assert!(result.prec() == field.prec() && inside(result, truth), "{x:?} {y:?}");
        }
        if !y.contains_zero() {
            let quotient = field.div(&x, &y);
            assert!(quotient.prec() == field.prec() && inside(&quotient, &(a / b)), "{x:?} {y:?}");
        }
    }
}

#[test]
fn signs_and_absolute_values() {
    let mut random = Random::new(12);
    for _ in 0..cases(2000) {
        let x = random.ball();
        let (size, negative) = (x.abs(), -&x);
        let (up, down) = (exact(&x.abs_up()), exact(&x.abs_down()));
        for a in random.points(&x) {
            let value = a.clone().abs();
            assert!(inside(&negative, &Rational::from(-&a)) && inside(&size, &value), "{x:?}");
            assert!(down <= value && value <= up, "{x:?} {down} {up}");
        }
        let (mid, rad) = (exact(x.mid()).abs(), exact(x.rad()));
        let slack = Rational::from(&mid + &rad) >> 30;
        assert!(up <= Rational::from(&mid + &rad) + &slack, "{x:?}");
        assert!(down >= Rational::from(&mid - &rad) - slack && down >= 0, "{x:?}");
        assert!(exact(size.rad()) <= rad && !size.is_negative(), "{x:?}: abs is no wider");
        assert!(size.lower() >= 0, "{x:?}");
    }
}

#[test]
fn whole_powers() {
    let mut random = Random::new(13);
    for _ in 0..cases(1000) {
        let (x, n) = (random.ball(), random.between(-6, 9));
        let power = x.powi(n);
        if n < 0 && x.contains_zero() {
            assert!(!power.is_finite(), "{x:?}^{n}");
            continue;
        }
        assert_eq!(power.prec(), x.prec(), "{x:?}^{n}");
        for a in random.points(&x) {
            let times = |base: &Rational| (0..n.abs()).fold(Rational::from(1), |p, _| p * base);
            let value = if n < 0 { times(&a).recip() } else { times(&a) };
            assert!(inside(&power, &value), "{x:?}^{n} = {power:?} without {a}");
        }
    }
    let wide = Ball::whole_line(50);
    assert!(wide.powi(0).is_exact() && wide.powi(0).mid() == &1 && !wide.powi(3).is_finite());
    assert!(Ball::from_integer(3, 10).powi(2).contains(&Ball::from_integer(9, 10)));
    assert!(!Ball::from_integer(0, 10).powi(i64::MIN).is_finite());
    assert!(Ball::from_integer(-1, 10).powi(i64::MIN).contains(&Ball::from_integer(1, 10)));
}

#[test]
fn what_is_not_known_stays_unknown() {
    let (line, one) = (Ball::whole_line(40), Ball::from_integer(1, 90));
    for result in [&line + &one, &one - &line, &line * &one, &one * &line, &line / &one, &one / &line] {
        assert!(!result.is_finite() && result.prec() == 90);
    }
    let zero = Ball::from_integer(0, 90);
    assert!(!(&line * &zero).is_finite() && !(&one / &zero).is_finite() && !(&zero / &zero).is_finite());
    assert!(!line.abs().is_finite() && !line.sqrt().is_finite() && !line.ln().is_finite());
}

#[test]
fn constants_are_exact() {
    assert!(Ball::zero().is_zero() && Ball::one().is_exact() && Ball::one().mid() == &1);
    assert!(!Ball::one().is_zero() && !Ball::new(Float::new(9), &Float::with_val(9, 1)).is_zero());
    assert!(!Ball::exact(Float::with_val(9, 1)).is_zero());
}
