use restitution_real::Ball;

/// Decimal digits between the working precision and what a ball knows.
pub fn digits_lost(ball: &Ball) -> f64 {
    let known = ball.relative_bits().unwrap_or(i64::from(ball.prec()));
    (i64::from(ball.prec()) - known) as f64 * std::f64::consts::LOG10_2
}
