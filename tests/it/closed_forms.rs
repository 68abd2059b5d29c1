//! Laws whose restitution coefficient does not depend on velocity have it in closed form.

use crate::numbers::{law, ratio};
use num_traits::Zero;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{Quantity, coefficients};

const BITS: u32 = 320;

/// `exp(-pi zeta/sqrt(1 - zeta^2))`, `zeta = (u/2) sqrt(2/(a+1))`, to `u^order`.
fn expanded(law: &ForceLaw, order: usize) -> Vec<Ball> {
    let ball = |n: i64| Ball::from_integer(n, BITS);
    let rate_squared = ball(1) / Ball::from_rational(&(law.elastic_step() * ratio(2, 1)), BITS);
    // zeta/sqrt(1 - zeta^2) = sum_k binomial(2k, k)/4^k zeta^(2k+1)
    let mut exponent = vec![Ball::zero(); order + 1];
    let mut c = -(Ball::pi(BITS) * rate_squared.sqrt());
    for k in 0..order.div_ceil(2) {
        exponent[2 * k + 1] = c.clone();
        c = c * &rate_squared * Ball::from_ratio(2 * k as i64 + 1, 2 * k as i64 + 2, BITS);
    }
    // k e_k = sum_i i w_i e_(k-i) for e = exp(w).
    let mut exponential = vec![ball(1)];
    for k in 1..=order {
        let term = |i: usize| ball(i as i64) * &exponent[i] * &exponential[k - i];
        let sum = (1..=k).fold(Ball::zero(), |sum, i| sum + term(i));
        exponential.push(sum / ball(k as i64));
    }
    exponential
}

#[test]
fn constant_restitution_to_40_digits_through_order_20() {
    for text in ["1,0", "3/2,1/4", "2,1/2", "5/2,3/4"] {
        let law = law(text);
        assert!(law.velocity_exponent().is_zero());
        let derived = coefficients(Quantity::Restitution, &law, 20, 40).expect("the expansion exists");
        let closed = expanded(&law, 20);
        for (k, (c, exact)) in derived.iter().zip(&closed).enumerate() {
            assert!(c.overlaps(exact), "{text}, k = {k}: {c:?} {exact:?}");
            assert_eq!(c.to_digits(40), exact.to_digits(40), "{text}, k = {k}");
            assert!(c.to_digits(40).is_some());
        }
    }
}

#[test]
fn the_compression_of_a_linear_dashpot_is_known() {
    // x_max = exp(-(zeta/sqrt(1-zeta^2)) acos(zeta)), zeta = u/2: y_1 = -pi/4, y_2 = pi^2/32 + 1/4.
    let y = coefficients(Quantity::Compression, &law("1,0"), 2, 40).expect("the expansion exists");
    let pi = Ball::pi(BITS);
    assert_eq!(y[0].to_digits(40), Ball::from_integer(1, BITS).to_digits(40));
    assert_eq!(y[1].to_digits(40), (-pi.shifted(-2)).to_digits(40));
    let second = (&pi * &pi).shifted(-5) + Ball::from_ratio(1, 4, BITS);
    assert_eq!(y[2].to_digits(40), second.to_digits(40));
}
