use num_rational::BigRational;
use num_traits::One;
use restitution_law::ForceLaw;
use restitution_real::Ball;

/// Returns the undamped turning time `T`, half the duration of the elastic collision (A16).
///
/// ```text
/// T = ((a+1)/2)^(1/(a+1)) B(1/(a+1), 1/2)/(a+1)
/// ```
///
/// 1.609032... for spheres. In units of length over impact velocity (MATH section 1); the radius of the ball
/// is a bound of the error.
pub fn turning_time(law: &ForceLaw, prec: u32) -> Ball {
    let step = law.elastic_step();
    let inverse = BigRational::one() / &step;
    let half = BigRational::new(1.into(), 2.into());
    let guarded = prec + 32;
    let reach = Ball::from_rational(&(&step * &half), guarded).pow(&inverse);
    (reach * Ball::beta(&inverse, &half, guarded) * Ball::from_rational(&inverse, guarded)).with_prec(prec)
}
