//! Rational powers of rational numbers to any number of digits.

use num_rational::{BigRational, Ratio};
use restitution_real::Ball;
use rug::Float;
use rug::ops::Pow;

/// Returns `x^(p/q)` of a positive rational number in a ball of `bits` bits.
///
/// `z = x^(-1/q)` by Newton's iteration `z <- z (1 + r/q)`, `r = 1 - x z^q`, which doubles the right bits
/// and needs no division but by `q`; `x^(p/q) = z^-p`.
///
/// # Error bound
///
/// The radius. The last step is its own proof: exactly, `x^(-1/q) = z (1-r)^(-1/q)`, and for `|r| <= 1/2`,
/// `|(1-r)^(-1/q) - 1 - r/q| <= r^2`, because `(1-r)^(-1/q)` has the coefficients `(1/q)_k/k! <= 1/q` and their
/// sum from `k = 2` on is at most `r^2/(q (1-|r|))`. Cost: `O(M(bits) log q)`.
///
/// # Panics
///
/// If `x` is not positive.
pub(crate) fn rational_power(x: &BigRational, exponent: Ratio<i64>, bits: u32) -> Ball {
    let (p, q) = (*exponent.numer(), *exponent.denom());
    let guard = 64 + 2 * (64 - p.unsigned_abs().leading_zeros());
    if q == 1 {
        return Ball::from_rational(x, bits + guard).powi(p).with_prec(bits);
    }
    inverse_root(x, q, bits + guard).powi(-p).with_prec(bits)
}

/// `x^(-1/q)`.
fn inverse_root(x: &BigRational, q: i64, bits: u32) -> Ball {
    let start = Float::with_val(128, Ball::from_rational(x, 128).mid());
    let guess = start.pow(-(Float::with_val(128, 1) / q));
    let mut z = Ball::exact(guess);
    let mut known: u32 = 60;
    // Each step doubles the known bits, less what z^q loses.
    let loss = 8 + 64 - q.unsigned_abs().leading_zeros();
    let mut steps = vec![bits];
    while let Some(&last) = steps.last()
        && last > known
    {
        steps.push(last / 2 + loss);
    }
    steps.pop();
    for prec in steps.into_iter().rev() {
        z = newton_step(x, q, z.mid(), prec + loss);
        known = prec;
    }
    let _ = known;
    z.with_prec(bits)
}

/// One step from the number `z`, with its error; the whole line if `z` is not close.
fn newton_step(x: &BigRational, q: i64, z: &Float, prec: u32) -> Ball {
    let z = Ball::exact(z.clone()).with_prec(prec);
    let residual = Ball::from_integer(1, prec) - Ball::from_rational(x, prec) * z.powi(q);
    let size = residual.abs_up();
    if size > 0.5 {
        return Ball::whole_line(prec);
    }
    let size = Ball::exact(size);
    let error = (&z * &size * &size).abs_up();
    let step = &residual / Ball::from_integer(q, 64);
    (&z + &z * step).widened(&error)
}
