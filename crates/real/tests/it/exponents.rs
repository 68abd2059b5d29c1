//! Where MPFR's exponents end.

use restitution_real::Ball;
use rug::Float;
use rug::float::{Special, exp_max, exp_min};

fn smallest() -> Ball {
    let mut x = Float::with_val(64, Special::Zero);
    x.next_up();
    Ball::exact(x)
}

fn largest() -> Ball {
    let mut x = Float::with_val(64, Special::Infinity);
    x.next_down();
    Ball::exact(x)
}

#[test]
fn what_vanishes_leaves_a_radius() {
    let tiny = smallest();
    let quarter = Ball::from_ratio(3, 16, 64);
    for result in
        [&tiny * &tiny, &tiny * &quarter, &tiny / &Ball::from_integer(7, 64), tiny.shifted(-1), tiny.powi(3)]
    {
        assert!(result.is_finite() && !result.is_exact(), "{result:?}");
        assert!(result.contains_zero() && *result.upper().as_abs() > 0, "{result:?}");
    }
    assert!((&tiny - &tiny).is_exact());
    let wide = Ball::from_integer(1, 64).shifted(exp_min() / 2);
    assert!(wide.is_exact() && wide.mid().get_exp() == Some(exp_min() / 2 + 1));
    // 2^(emin - 1) is MPFR's smallest number: shifting to it loses nothing, one further does.
    let one = Ball::from_integer(1, 64);
    assert!(one.shifted(exp_min() - 1).is_exact() && !one.shifted(exp_min() - 2).is_exact());
    assert!(one.shifted(exp_max() - 1).is_exact() && !one.shifted(exp_max()).is_finite());
    let down = Ball::from_integer(0, 64).widened(&Float::with_val(32, 1)).shifted(exp_min() - 5);
    assert!(!down.is_exact());
}

#[test]
fn what_is_too_large_is_unknown() {
    let (huge, two) = (largest(), Ball::from_integer(2, 64));
    for result in [
        &huge * &two,
        &huge + &huge,
        huge.powi(2),
        huge.exp(),
        huge.shifted(1),
        huge.gamma(),
        &huge / &smallest(),
    ] {
        assert!(!result.is_finite(), "{result:?}");
    }
    assert!((&huge - &huge).is_exact() && huge.ln().is_finite() && huge.sqrt().is_finite());
    assert!(!two.shifted(i32::MAX).is_finite());
}

#[test]
fn exponentials_of_large_numbers() {
    let low = Ball::from_integer(-5_000_000_000, 64).exp();
    assert!(low.is_finite() && low.abs_up() < 1e-300 && low.upper() > 0);
    assert!(!Ball::from_integer(5_000_000_000, 64).exp().is_finite());
    let wide = Ball::from_integer(0, 64).widened(&Float::with_val(32, 1e12));
    assert!(!wide.exp().is_finite());
}

#[test]
fn gamma_near_zero_is_large_and_bounded() {
    let near = Ball::new(Float::with_val(64, 1e-9), &Float::with_val(32, 0.999e-9)).gamma();
    assert!(near.contains(&Ball::from_f64(1e12 - 0.5772156649, 64)) || near.upper() > 1e11);
    // A ball whose lower end rounds to nothing: positive, but no bound of the slope there.
    let mut mid = smallest().mid().clone();
    mid <<= 40;
    let rad = Float::with_val(32, &mid);
    let ball = Ball::new(Float::with_val(64, &mid * 1.5), &rad).gamma();
    assert!(!ball.is_finite() || ball.upper() > 0);
}
