//! The certified interpolant against single collisions, which are integrated another way.

use crate::numbers::ratio;
use num_rational::BigRational;
use restitution_direct::{Collision, DirectError, End, Variable};
use restitution_real::Ball;

fn collision(law: &str, end: End) -> Collision {
    Collision::new(&law.parse().unwrap(), end).unwrap()
}

/// A law, an end of contact, the ends of an interval as fractions, and a remainder.
type PieceOf = (&'static str, End, (i64, i64), (i64, i64), f64);

/// What the remainder must stay below at degree 8 and 80 bits.
const PIECES: [PieceOf; 12] = [
    ("3/2,1/2", End::ZeroCompression, (0, 1), (1, 20), 1e-13),
    ("3/2,1/2", End::ZeroCompression, (49, 50), (51, 50), 1e-15),
    ("3/2,1/2", End::ZeroForce, (49, 50), (51, 50), 1e-14),
    ("3/2,1/2", End::ZeroForce, (3, 1), (31, 10), 1e-15),
    ("3/2,1/2", End::ZeroCompression, (3, 1), (49, 16), 1e-14),
    ("3/2,1/2", End::ZeroCompression, (6, 1), (49, 8), 1e-15),
    ("3/2,1/2", End::ZeroForce, (1, 16), (5, 64), 1e-12),
    ("3/2,1/2", End::ZeroForce, (1, 1_000_000), (2, 1_000_000), 1e-15),
    ("3/2,1/2", End::ZeroForce, (100, 1), (102, 1), 1e-14),
    ("3/2,1/2", End::ZeroForce, (1000, 1), (1008, 1), 1e-14),
    ("1,0", End::ZeroCompression, (1, 2), (11, 20), 1e-12),
    ("2,1", End::ZeroCompression, (1, 3), (2, 5), 1e-12),
];

#[test]
fn every_damping_of_the_interval_is_enclosed() {
    for (law, end, from, to, largest) in PIECES {
        let (from, to) = (ratio(from.0, from.1), ratio(to.0, to.1));
        let collision = collision(law, end);
        let piece = collision.interpolant(&from, &to, Variable::Damping, 8, 80).unwrap();
        assert!(piece.remainder().upper() < largest, "{law} {end:?} {from}: {:?}", piece.remainder());
        for k in 0..=8 {
            let u = &from + (&to - &from) * ratio(k, 8);
            let point = collision.enclose(&Ball::from_rational(&u, 120), 120).unwrap();
            let enclosure = piece.enclose(&Ball::from_rational(&u, 120));
            // The ends of the interval are rounded when they are no binary fractions.
            let Some(enclosure) = enclosure else {
                assert!(k == 0 || k == 8, "{law} {u}");
                continue;
            };
            assert!(enclosure.contains(&point), "{law} {end:?} {u}: {enclosure:?} {point:?}");
        }
    }
}

#[test]
fn a_point_is_an_interval_of_no_width() {
    let spheres = collision("3/2,1/2", End::ZeroCompression);
    let one = ratio(1, 1);
    let piece = spheres.interpolant(&one, &one, Variable::Damping, 0, 120).unwrap();
    let epsilon = piece.enclose(&Ball::from_integer(1, 120)).unwrap();
    assert_eq!(epsilon.to_digits(30).as_deref(), Some("0.331164810466640935279720797775"));
}

#[test]
fn the_remainder_falls_with_the_degree_and_covers_what_is_left_out() {
    let spheres = collision("3/2,1/2", End::ZeroCompression);
    let (from, to) = (ratio(19, 20), ratio(21, 20));
    let mut last = f64::INFINITY;
    for degree in [4, 6, 8] {
        let piece = spheres.interpolant(&from, &to, Variable::Damping, degree, 60).unwrap();
        let remainder = piece.remainder().to_f64();
        assert!(remainder < last / 10.0, "{degree}: {remainder}");
        last = remainder;
        for k in 1..8 {
            let u = &from + (&to - &from) * ratio(k, 8);
            let point = spheres.enclose(&Ball::from_rational(&u, 120), 120).unwrap();
            let u = Ball::from_rational(&u, 120);
            assert!(piece.enclose(&u).unwrap().contains(&point), "{degree} {u:?}");
        }
    }
}

#[test]
fn the_square_root_serves_as_well() {
    let delayed = collision("3/2,1/2", End::ZeroForce);
    let (from, to) = (ratio(9, 10), ratio(1, 1));
    let piece = delayed.interpolant(&from, &to, Variable::Root, 8, 80).unwrap();
    assert!(piece.remainder().upper() < 1e-10, "{:?}", piece.remainder());
    for u in [ratio(91, 100), ratio(19, 20), ratio(99, 100)] {
        let point = delayed.enclose(&Ball::from_rational(&u, 120), 120).unwrap();
        let enclosure = piece.enclose(&Ball::from_rational(&u, 120)).unwrap();
        assert!(enclosure.contains(&point), "{u}: {enclosure:?} {point:?}");
    }
}

#[test]
fn what_has_no_interpolant_is_said() {
    let spheres = collision("3/2,1/2", End::ZeroCompression);
    let ask = |from: BigRational, to: BigRational, degree, prec| {
        spheres.interpolant(&from, &to, Variable::Damping, degree, prec)
    };
    for refused in [
        ask(ratio(-1, 10), ratio(1, 1), 5, 80),
        ask(ratio(1, 1), ratio(1, 2), 5, 80),
        ask(ratio(1, 1), ratio(1, 1), 101, 80),
        ask(ratio(1, 1), ratio(1, 1), 5, 0),
    ] {
        assert!(matches!(refused, Err(DirectError::Interval { .. })));
    }
    let branch = collision("7/3,5/6", End::ZeroCompression);
    let refused = branch.interpolant(&ratio(1, 1), &ratio(1, 1), Variable::Damping, 0, 80);
    assert!(matches!(refused, Err(DirectError::NoInterpolant { .. })));
}
