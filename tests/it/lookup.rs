//! Tables of velocities for codes that interpolate: the bound of what they miss.

use num_rational::BigRational;
use restitution_direct::{Collision, Damping, End};
use restitution_law::ForceLaw;
use restitution_real::Ball;

const ENDS: [End; 2] = [End::ZeroCompression, End::ZeroForce];

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

fn at(collision: &Collision, g: &BigRational) -> Ball {
    let damping = Damping::of_velocity(g, &ratio(1, 1), collision.law()).unwrap();
    collision.epsilon_at(&damping, 20).unwrap()
}

/// `3^k`.
fn power(k: i32) -> BigRational {
    num_traits::pow::Pow::pow(&ratio(3, 1), k)
}

#[test]
fn epsilon_bends_one_way_over_the_velocity() {
    // spheres, other laws whose u rises with g, and one whose u falls
    for (text, convex) in [("3/2,1/2", true), ("2,1", true), ("3/2,0", false)] {
        let law: ForceLaw = text.parse().unwrap();
        for end in ENDS {
            let collision = Collision::new(&law, end).unwrap();
            let range = if convex { -12..8 } else { 2..9 }; // beyond its critical damping
            let values = range.map(|k| (power(k), at(&collision, &power(k)))).collect::<Vec<_>>();
            let slope = |pair: &[(BigRational, Ball)]| {
                (&pair[1].1 - &pair[0].1) / Ball::from_rational(&(&pair[1].0 - &pair[0].0), 200)
            };
            let slopes = values.windows(2).map(slope).collect::<Vec<_>>();
            for pair in slopes.windows(2) {
                let bend = &pair[1] - &pair[0];
                let right = if convex { bend.is_positive() } else { (-bend).is_positive() };
                assert!(right, "{law} {end:?}");
            }
        }
    }
}

#[test]
fn the_bound_of_interpolation_holds_and_is_no_larger_than_it_must() {
    for (text, end) in
        [("3/2,1/2", End::ZeroCompression), ("3/2,1/2", End::ZeroForce), ("2,1", End::ZeroForce)]
    {
        let law: ForceLaw = text.parse().unwrap();
        let collision = Collision::new(&law, end).unwrap();
        let damping = |g: &BigRational| Damping::of_velocity(g, &ratio(1, 1), &law);
        for (from, to) in [
            (ratio(0, 1), ratio(1, 1000)),
            (ratio(1, 1000), ratio(1, 100)),
            (ratio(1, 1), ratio(21, 20)),
            (ratio(1, 1), ratio(50, 1)),
        ] {
            let bound = collision.interpolation_error(&from, &to, damping).unwrap();
            let (first, last) = (at(&collision, &from), at(&collision, &to));
            // to both ends, where a steep curve is farthest from its chord
            let shares = (1..12).map(|k| ratio(k, 12)).chain((4..9).map(|k| ratio(1, 1 << k)));
            let mut largest = 0.0_f64;
            for share in shares {
                let chord = &first + (&last - &first) * Ball::from_rational(&share, 128);
                let miss = (at(&collision, &(&from + (&to - &from) * share)) - chord).abs();
                largest = largest.max(miss.upper().to_f64());
            }
            let tight = largest > 0.74 * bound;
            assert!(largest <= bound && tight, "{law} {end:?} [{from}, {to}]: {largest} and {bound}");
        }
    }
}
