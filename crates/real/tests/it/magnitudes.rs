//! Upper bounds: sums and products never below the exact ones, and not far above.

use crate::operands::{Random, cases, exact};
use restitution_real::{Ball, Magnitude};
use rug::{Float, Rational};

fn value(bound: Magnitude) -> Rational {
    Rational::from_f64(bound.to_f64()).unwrap()
}

#[test]
fn sums_and_products_are_upper_bounds() {
    let mut random = Random::new(51);
    for _ in 0..cases(5000) {
        let mut draw = || loop {
            let x = f64::from_bits(random.next() >> 1);
            let x = if random.below(3) == 0 { x.fract().abs() + random.below(2) as f64 } else { x };
            if x.is_finite() {
                return x;
            }
        };
        let (x, y) = (Magnitude::exact(draw()), Magnitude::exact(draw()));
        let (sum, product) = (x + y, x * y);
        let near = |bound: Magnitude, truth: Rational| {
            let truth_f64 = truth.to_f64();
            !bound.is_finite() || (value(bound) >= truth && bound.to_f64() <= truth_f64.next_up().next_up())
        };
        assert!(near(sum, value(x) + value(y)) && near(product, value(x) * value(y)), "{x:?} {y:?}");
        assert!(sum.is_finite() || (value(x) + value(y)).to_f64() >= f64::MAX);
        assert!(product.is_finite() || (value(x) * value(y)).to_f64() >= f64::MAX);
    }
}

#[test]
fn corners() {
    let (zero, one) = (Magnitude::ZERO, Magnitude::ONE);
    let unknown = Magnitude::exact(f64::NAN);
    assert!(!unknown.is_finite() && !Magnitude::exact(-1.0).is_finite() && Magnitude::exact(0.0).is_finite());
    assert_eq!((zero * unknown, unknown * zero, zero + one, one + zero), (zero, zero, one, one));
    assert!(!(one + unknown).is_finite() && !(one * unknown).is_finite());
    let tiny = Magnitude::exact(f64::from_bits(1));
    assert!(tiny * tiny > zero && !(Magnitude::exact(f64::MAX) * Magnitude::exact(2.0)).is_finite());
    assert_eq!(one.to_f64(), 1.0);
    assert_eq!(tiny.to_float(), f64::from_bits(1));
    assert_eq!(Vec::<Magnitude>::new().into_iter().sum::<Magnitude>(), zero);
    assert!([one, one, tiny].into_iter().sum::<Magnitude>() > Magnitude::exact(2.0));
}

#[test]
fn powers_in_order() {
    let third = Magnitude::exact(1.0 / 3.0);
    let powers = third.powers(5);
    assert_eq!((powers.len(), powers[0], powers[1] >= third), (5, Magnitude::ONE, true));
    let mut truth = Rational::from(1);
    for power in powers {
        assert!(value(power) >= truth && power.to_f64() < truth.to_f64() * (1.0 + 1e-14));
        truth *= value(third);
    }
    assert!(third.powers(0).is_empty());
}

#[test]
fn bounds_of_balls() {
    let mut random = Random::new(52);
    for _ in 0..cases(2000) {
        let ball = random.ball();
        let bound = Magnitude::of(&ball);
        let truth = exact(ball.mid()).abs() + exact(ball.rad());
        assert!(value(bound) >= truth && bound.to_f64() <= truth.to_f64() * (1.0 + 1e-8), "{ball:?}");
    }
    let tiny = Ball::exact(Float::with_val(64, 1) >> 100_000u32);
    assert_eq!(Magnitude::of(&tiny).to_f64(), f64::from_bits(1));
    let huge = Ball::exact(Float::with_val(64, 1) << 100_000u32);
    assert!(!Magnitude::of(&huge).is_finite() && !Magnitude::of(&Ball::whole_line(20)).is_finite());
}
