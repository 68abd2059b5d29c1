//! The fields as generic code sees them.

use num_rational::BigRational;
use restitution_real::{Ball, Balls, Field, OrderedField, Rationals, ZeroTest};
use rug::Float;
use std::cmp::Ordering;

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

#[test]
fn rationals_are_exact() {
    let (x, y) = (ratio(2, 3), ratio(-1, 6));
    let field = Rationals;
    assert_eq!([field.add(&x, &y), field.sub(&x, &y)], [ratio(1, 2), ratio(5, 6)]);
    assert_eq!(
        [field.mul(&x, &y), field.div(&x, &y), field.neg(&x)],
        [ratio(-1, 9), ratio(-4, 1), ratio(-2, 3)]
    );
    assert_eq!([field.zero(), field.one(), field.rational(&x)], [ratio(0, 1), ratio(1, 1), x.clone()]);
    assert_eq!((field.zero_test(&field.zero()), field.zero_test(&y)), (ZeroTest::Zero, ZeroTest::NonZero));
    assert_eq!(
        [&x, &y, &field.zero()].map(|n| field.sign(n)),
        [Ordering::Greater, Ordering::Less, Ordering::Equal].map(Some)
    );
}

#[test]
fn balls_say_what_they_know() {
    let field = Balls::new(70);
    let around_zero = field.zero().widened(&Float::with_val(32, 0.5));
    let below = Ball::from_integer(-1, 70).widened(&Float::with_val(32, 0.5));
    assert_eq!(field.zero_test(&field.zero()), ZeroTest::Zero);
    assert_eq!(field.zero_test(&around_zero), ZeroTest::Undecided);
    assert_eq!(field.zero_test(&below), ZeroTest::NonZero);
    assert_eq!(
        field.zero_test(&Ball::from_integer(1, 70).widened(&Float::with_val(32, 1))),
        ZeroTest::Undecided
    );
    let signs = [&field.zero(), &around_zero, &below, &field.one()].map(|x| field.sign(x));
    assert_eq!(signs, [Some(Ordering::Equal), None, Some(Ordering::Less), Some(Ordering::Greater)]);
    assert!(field.one().is_exact() && field.one().mid() == &1 && field.zero().mid() == &0);
    assert!([field.one(), field.zero(), field.ratio(1, 3)].iter().all(|x| x.prec() == 70));
    assert!(field.rational(&ratio(2, 7)).contains_rational(&ratio(2, 7)) && field.ratio(-2, 7).is_negative());
    assert_eq!((Balls::new(0).prec(), Balls::new(2).prec(), Balls::new(3).prec()), (2, 2, 3));
}

#[test]
fn powers_that_exist() {
    let field = Balls::new(90);
    let cube_root = field.power(&field.ratio(27, 8), &ratio(1, 3)).unwrap();
    assert!(cube_root.contains_rational(&ratio(3, 2)) && cube_root.prec() == 90);
    assert!(field.power(&field.ratio(-1, 2), &ratio(1, 3)).is_none());
    assert!(field.power(&field.zero(), &ratio(-2, 1)).is_none());
}

#[test]
fn large_balls_make_the_better_divisors() {
    let field = Balls::new(64);
    let rank = |x: &Ball| field.pivot_rank(x);
    let wide = field.ratio(8, 1).widened(&Float::with_val(32, 7.5));
    assert!(rank(&field.ratio(8, 1)) > rank(&field.ratio(-3, 1)) && rank(&field.ratio(3, 1)) > rank(&wide));
    assert_eq!(rank(&field.zero()), i64::MIN);
}
