//! Many digits, by long steps in time, against few digits, by the steps of the phase plane.

use num_rational::BigRational;
use restitution_direct::{Collision, End};
use restitution_real::Ball;

/// Bits of working precision on both sides of the change.
const FEW: u32 = 480;
const MANY: u32 = 680;
/// Bits that a collision may lose.
const LOST: i64 = 40;

fn agree(law: &str, end: End, u: (i64, i64)) {
    let collision = Collision::new(&law.parse().unwrap(), end).unwrap();
    let enclosed = |prec| {
        let u = Ball::from_rational(&BigRational::new(u.0.into(), u.1.into()), prec);
        collision.enclose(&u, prec).unwrap()
    };
    let (few, many) = (enclosed(FEW), enclosed(MANY));
    assert!(few.contains(&many), "{law} {end:?} {u:?}");
    assert!(many.relative_bits().unwrap() >= i64::from(MANY) - LOST, "{law} {end:?} {u:?}");
}

#[test]
fn long_steps_agree_with_the_phase_plane() {
    for law in ["3/2,1/2", "3,2", "2,1", "3/2,1/4"] {
        for u in [(1, 1_000_000), (1, 3), (7, 5)] {
            agree(law, End::ZeroCompression, u);
            agree(law, End::ZeroForce, u);
        }
    }
    agree("3/2,1/2", End::ZeroCompression, (15, 2));
    agree("3/2,1/2", End::ZeroForce, (15, 2));
}
