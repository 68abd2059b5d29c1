//! Making balls, asking them, joining them.

use crate::operands::{Random, cases, exact, half_unit, inside, not_wider};
use num_bigint::BigInt;
use num_rational::BigRational;
use restitution_real::Ball;
use restitution_real::convert::{big_integer, big_rational, rug_integer, rug_rational};
use rug::ops::Pow;
use rug::{Float, Integer, Rational};

fn big(value: &Rational) -> BigRational {
    BigRational::new(big_integer(value.numer()), big_integer(value.denom()))
}

#[test]
fn numbers_are_rounded_with_their_error() {
    let mut random = Random::new(41);
    for _ in 0..cases(1000) {
        let prec = random.pick(&[2, 3, 17, 53, 64, 200]);
        let (n, d) = (random.next() as i64, (random.next() >> random.below(60)) as i64 | 1);
        let value = Rational::from((n, d));
        let integer = Integer::from(n).pow(random.below(5) as u32);
        let made = [
            (Ball::from_integer(n, prec), Rational::from(n)),
            (Ball::from_ratio(n, d, prec), value.clone()),
            (Ball::from_rational(&big(&value), prec), value.clone()),
            (Ball::from_big_integer(&integer, prec), Rational::from(integer)),
        ];
        for (ball, truth) in made {
            let rule = if exact(ball.mid()) == truth { Rational::new() } else { half_unit(&ball) };
            assert!(ball.prec() == prec && inside(&ball, &truth) && not_wider(&ball, &rule), "{ball:?}");
        }
        let double = f64::from_bits(random.next());
        let ball = Ball::from_f64(double, prec);
        assert_eq!(ball.is_finite(), double.is_finite());
        assert!(!double.is_finite() || (ball.is_exact() && *ball.mid() == double && ball.to_f64() == double));
    }
    assert!(!Ball::from_ratio(1, 0, 20).is_finite() && Ball::from_f64(0.1, 80).prec() == 80);
}

#[test]
fn wrong_parts_give_the_whole_line() {
    let (one, line) = (Float::with_val(20, 1), |ball: Ball| !ball.is_finite() && ball.prec() == 20);
    assert!(line(Ball::new(one.clone(), &Float::with_val(9, -1))));
    assert!(line(Ball::new(one.clone(), &Float::with_val(9, f64::NAN))));
    assert!(line(Ball::new(one.clone(), &Float::with_val(9, f64::INFINITY))));
    assert!(line(Ball::exact(Float::with_val(20, f64::NAN))));
    assert!(line(Ball::exact(Float::with_val(20, f64::INFINITY))) && line(Ball::whole_line(20)));
    for error in [-1e-9, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let widened = Ball::new(one.clone(), &Float::with_val(9, 1)).widened(&Float::with_val(20, error));
        assert!(line(widened), "{error}");
    }
    let rounded_up = Ball::new(one, &Float::with_val(90, 1).next_up_by_a_bit());
    assert!(*rounded_up.rad() > 1);
}

trait NextUp {
    fn next_up_by_a_bit(self) -> Self;
}

impl NextUp for Float {
    fn next_up_by_a_bit(mut self) -> Self {
        self.next_up();
        self
    }
}

#[test]
fn ends_signs_and_widths() {
    let mut random = Random::new(42);
    for _ in 0..cases(2000) {
        let x = random.ball();
        let (mid, rad) = (exact(x.mid()), exact(x.rad()));
        let (low, high) = (Rational::from(&mid - &rad), Rational::from(&mid + &rad));
        let ulp = |f: &Float| {
            f.get_exp().map_or(Rational::new(), |e| exact(&(Float::with_val(9, 1) << (e - x.prec() as i32))))
        };
        let (lower, upper) = (x.lower(), x.upper());
        assert!(exact(&lower) <= low && low <= exact(&lower) + ulp(&lower) * 2, "{x:?}");
        assert!(exact(&upper) >= high && high >= exact(&upper) - ulp(&upper) * 2, "{x:?}");
        assert_eq!(x.contains_zero(), low <= 0 && high >= 0, "{x:?}");
        assert_eq!((x.is_positive(), x.is_negative()), (low > 0, high < 0), "{x:?}");
        assert_eq!(x.is_exact(), rad == 0);
        match x.relative_bits() {
            None => assert!(rad == 0),
            Some(bits) if bits == i64::MIN => assert!(mid == 0),
            Some(bits) => {
                let scaled =
                    if bits < 0 { rad.clone() >> (-bits) as u32 } else { rad.clone() << bits as u32 };
                assert!(scaled <= mid.clone().abs() && scaled * 4 >= mid.clone().abs(), "{x:?} {bits}");
            }
        }
        let prec = random.pick(&[2, 10, 40, 80, 300]);
        let rounded = x.with_prec(prec);
        assert!(rounded.prec() == prec && rounded.contains(&x), "{x:?} {rounded:?}");
        let off = if exact(rounded.mid()) == mid { Rational::new() } else { half_unit(&rounded) };
        assert!(not_wider(&rounded, &(&rad + off)), "{x:?} {rounded:?}");
        let power = random.between(-90, 90) as i32;
        let (shifted, factor) = (x.shifted(power), Rational::from(2).pow(power));
        assert_eq!(
            (exact(shifted.mid()), exact(shifted.rad())),
            (mid.clone() * &factor, rad.clone() * factor)
        );
        let error = random.float(20, -7).abs();
        let wider = x.clone().widened(&error);
        let sum = exact(&error) + &rad;
        assert!(exact(wider.rad()) >= sum && not_wider(&wider, &sum) && wider.mid() == x.mid());
    }
    assert_eq!(Ball::whole_line(20).relative_bits(), Some(i64::MIN));
}

#[test]
fn containment_and_overlap_are_exact() {
    let ball = |m: f64, r: f64| Ball::new(Float::with_val(60, m), &Float::with_val(32, r));
    let tiny = 2.0_f64.powi(-40);
    let (unit, line) = (ball(0.0, 1.0), Ball::whole_line(60));
    assert!(unit.contains(&ball(0.5, 0.5)) && !unit.contains(&ball(0.5 + tiny, 0.5)));
    assert!(unit.contains(&ball(-0.5, 0.5)) && !unit.contains(&ball(-0.5 - tiny, 0.5)));
    assert!(line.contains(&unit) && line.contains(&line) && !unit.contains(&line));
    let rational = |x: f64| BigRational::from_float(x).unwrap();
    for end in [-1.0, 1.0] {
        assert!(
            unit.contains_rational(&rational(end)) && !unit.contains_rational(&rational(end * (1.0 + tiny)))
        );
    }
    assert!(line.contains_rational(&rational(1e300)));
    assert!(unit.overlaps(&ball(1.5, 0.5)) && !unit.overlaps(&ball(1.5 + tiny, 0.5)));
    assert!(unit.overlaps(&ball(-1.5, 0.5)) && !unit.overlaps(&ball(-1.5 - tiny, 0.5)));
    let far = ball(5.0, 1.0);
    assert!(far.overlaps(&line) && line.overlaps(&far) && !far.overlaps(&unit));
    assert!(!far.union(&line).is_finite() && !line.union(&far).is_finite() && !line.union(&line).is_finite());
    assert!(unit.overlaps(&line) && line.overlaps(&unit) && unit.overlaps(&ball(0.1, 0.1)));
    assert!(unit.contains_zero() && !ball(1.0 + tiny, 1.0).contains_zero() && ball(1.0, 1.0).contains_zero());
    assert!(ball(-1.0, 1.0).contains_zero() && ball(-1.0 - tiny, 1.0).is_negative());
}

#[test]
fn unions_and_intervals() {
    let mut random = Random::new(43);
    for _ in 0..cases(1500) {
        let (x, y) = (random.ball(), random.ball());
        let joined = x.union(&y);
        assert!(joined.contains(&x) && joined.contains(&y) && joined.prec() == x.prec().max(y.prec()));
        let prec = random.pick(&[2, 20, 64]);
        let (low, high) = (x.mid().clone(), y.mid().clone());
        let around = Ball::between(&low, &high, prec);
        assert!(around.prec() == prec && inside(&around, &exact(&low)) && inside(&around, &exact(&high)));
        let half = (exact(&low) - exact(&high)).abs() / 2;
        let off = (exact(around.mid()) - (exact(&low) + exact(&high)) / 2u32).abs();
        assert!(off <= half_unit(&around) && not_wider(&around, &(half + off)), "{low} {high} {around:?}");
        let ends = [&x, &y].map(|b| (exact(&b.lower()), exact(&b.upper())));
        let width = ends[0].1.clone().max(ends[1].1.clone()) - ends[0].0.clone().min(ends[1].0.clone());
        assert!(not_wider(&joined, &(width / 2 + half_unit(&joined))), "{x:?} {y:?} {joined:?}");
    }
    let line = Ball::whole_line(30);
    let one = Ball::from_integer(1, 50);
    assert!(!one.union(&line).is_finite() && !line.union(&one).is_finite() && line.union(&one).prec() == 50);
    assert!(!Ball::between(&Float::with_val(9, f64::NEG_INFINITY), &Float::new(9), 20).is_finite());
}

#[test]
fn conversions_are_exact_both_ways() {
    let mut random = Random::new(44);
    for _ in 0..cases(300) {
        let text = (0..1 + random.below(12)).map(|_| random.next().to_string()).collect::<String>();
        for text in [text.clone(), format!("-{text}"), "0".into()] {
            let (ours, theirs): (BigInt, Integer) = (text.parse().unwrap(), text.parse().unwrap());
            assert_eq!((rug_integer(&ours), big_integer(&theirs)), (theirs.clone(), ours.clone()));
            let fraction = BigRational::new(ours, BigInt::from(random.next() | 1));
            assert_eq!(rug_rational(&fraction).to_string(), fraction.to_string());
            assert_eq!(big_rational(&rug_rational(&fraction)), fraction);
        }
    }
}

#[test]
fn what_is_shown_while_debugging() {
    let ball = Ball::from_ratio(1, 4, 20).widened(&Float::with_val(32, 0.125));
    assert_eq!(format!("{ball:?}"), "2.5000000000000000000e-1 +/- 1.25e-1");
}
