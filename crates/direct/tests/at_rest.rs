//! Motions that come to rest before they separate have no rebound, whatever the precision.

use num_rational::BigRational;
use restitution_direct::{Collision, DirectError, End};
use restitution_real::Ball;

fn collision(law: &str) -> Collision {
    Collision::new(&law.parse().unwrap(), End::ZeroCompression).unwrap()
}

#[test]
fn what_comes_to_rest_has_no_rebound_at_any_precision() {
    // p < 0: near contact friction alone acts, v falls along a straight line, and a step may be long enough to pass its zero.
    for (law, digits) in [("3/2,-9/10", 5), ("3/2,-9/10", 13), ("3/2,-9/10", 30)] {
        let u = BigRational::new(53_999.into(), 1_000_000.into());
        let found = collision(law).epsilon(&u, digits);
        assert!(matches!(found, Err(DirectError::Overdamped { .. })), "{digits}: {found:?}");
    }
    for law in ["3/2,-9/10", "3/2,-99/100", "2,-3/4", "26/5,-1/2", "3,1/2"] {
        let collision = collision(law);
        let mut last = f64::INFINITY;
        for k in 0..28 {
            let u = Ball::from_integer(6, 200) * Ball::from_ratio(3, 4, 200).powi(28 - k);
            let [rough, fine] = [80, 150].map(|prec| collision.enclose(&u, prec));
            let here = match (rough, fine) {
                (Ok(rough), Ok(fine)) => {
                    assert!(rough.overlaps(&fine), "{law} {u:?}: {rough:?} {fine:?}");
                    fine.to_f64()
                }
                (Err(DirectError::Overdamped { .. }), Err(DirectError::Overdamped { .. })) => 0.0,
                // No step of a length that can be used: nothing is said.
                (Err(DirectError::StepVanished { .. }), _) | (_, Err(DirectError::StepVanished { .. })) => {
                    continue;
                }
                other => panic!("{law} {u:?}: {other:?}"),
            };
            assert!(here < last || here == 0.0, "{law} {u:?}: {here} after {last}");
            last = here;
        }
        assert!(last == 0.0, "{law}");
    }
}
