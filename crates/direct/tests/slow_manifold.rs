//! Where damping balances the force for long, the polynomials of steps are almost constant and end in noise.

use num_rational::BigRational;
use restitution_direct::{Collision, End};
use restitution_real::Ball;

/// For `a = gamma = 1` the motion has the integral `v/u - ln(1 + u v)/u^2 + x^2/2`, so that at zero compression
/// `u epsilon = 1 - exp(-(u + u epsilon - ln(1 + u)))`: one to a thousand digits where `u` is some thousands.
#[test]
fn a_motion_along_it_has_its_known_end() {
    let collision = Collision::new(&"1,1".parse().unwrap(), End::ZeroCompression).unwrap();
    for (n, d) in [(10_989, 5), (1201, 1), (80_001, 7)] {
        let (u, truth) = (BigRational::new(n.into(), d.into()), Ball::from_ratio(d, n, 600));
        for prec in (90..180).step_by(if n == 10_989 { 1 } else { 9 }) {
            let found = collision.enclose(&Ball::from_rational(&u, prec + 40), prec).unwrap();
            let inside = found.contains(&Ball::exact(truth.mid().clone()));
            assert!(inside, "u = {u}, {prec} bits: {found:?}, not {truth:?}");
        }
    }
}
