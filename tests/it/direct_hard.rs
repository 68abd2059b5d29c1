//! Hard cases of direct integration: docs/stability.md has their figures.

use num_rational::BigRational;
use restitution_direct::{Collision, DirectError, End};
use restitution_real::Ball;

/// Law, damping as a fraction, the most bits of working precision that may be lost at either end.
const CASES: [(&str, &str, i64); 14] = [
    ("3/2,1/2", "1/1000000000000", 18),
    ("3/2,1/2", "1388361925615829/1000000000000000", 20),
    ("3/2,1/2", "8", 22),
    ("3/2,1/2", "20", 25),
    ("3/2,1/2", "1000", 37),
    ("3/2,1/2", "1000000", 60),
    ("3/2,501/1000", "1", 32),
    ("3/2,1499/1000", "1", 33),
    ("3/2,1501/1000", "1", 33),
    ("1001/1000,0", "1", 24),
    ("1001/1000,1/1000", "1", 24),
    ("3/2,-9/10", "1/100", 18),
    ("3/2,-99/100", "1/1000", 21),
    ("1/1000,0", "1/10", 34),
];

#[test]
fn few_bits_are_lost_and_twice_the_precision_agrees() {
    for (law, u, limit) in CASES {
        let u: BigRational = u.parse().unwrap();
        for end in [End::ZeroCompression, End::ZeroForce] {
            let collision = match Collision::new(&law.parse().unwrap(), end) {
                Err(DirectError::NoZeroForce { .. }) => continue,
                collision => collision.unwrap(),
            };
            let enclose = |prec| collision.enclose(&Ball::from_rational(&u, prec), prec).unwrap();
            let (coarse, fine) = (enclose(130), enclose(170));
            let lost = 130 - coarse.relative_bits().unwrap();
            assert!(lost <= limit, "{law} u = {u} {end:?}: {lost} bits lost");
            assert!(coarse.contains(&fine), "{law} u = {u} {end:?}: {coarse:?} {fine:?}");
        }
    }
}

#[test]
fn a_lost_velocity_of_any_size_keeps_twelve_digits() {
    let spheres = Collision::new(&"3/2,1/2".parse().unwrap(), End::ZeroCompression).unwrap();
    let first = "1.15344885810"; // -C_1 of reference.json
    for zeros in [20, 60, 200] {
        let u = BigRational::new(1.into(), num_bigint::BigInt::from(10).pow(zeros));
        let lost = spheres.one_minus_epsilon(&u, 12).unwrap().to_digits(12).unwrap();
        assert_eq!(lost, format!("{first}e-{zeros}"));
    }
}

#[test]
fn a_law_and_its_neighbours_in_another_coordinate_agree() {
    // Continuity: the neighbours use the branch-point coordinate, the law itself a polynomial.
    let epsilon = |law: &str| {
        let collision = Collision::new(&law.parse().unwrap(), End::ZeroCompression).unwrap();
        collision.epsilon(&BigRational::from_integer(1.into()), 20).unwrap()
    };
    let (below, at, above) = (epsilon("3/2,49999/100000"), epsilon("3/2,1/2"), epsilon("3/2,50001/100000"));
    let middle = (&below + &above).shifted(-1);
    assert!((&above - &below).is_positive());
    assert!((middle - at).abs().upper() < 1e-9);
}

#[test]
fn a_critical_dashpot_is_told_from_its_neighbours() {
    let dashpot = Collision::new(&"1,0".parse().unwrap(), End::ZeroCompression).unwrap();
    let near = BigRational::new(1999.into(), 1000.into());
    let epsilon = dashpot.epsilon(&near, 15).unwrap();
    // exp(-pi zeta/sqrt(1 - zeta^2)), zeta = 0.9995
    let zeta = Ball::from_ratio(1999, 2000, 200);
    let root = (Ball::from_integer(1, 200) - &zeta * &zeta).sqrt();
    assert_eq!(epsilon.to_digits(15), (-(Ball::pi(200) * zeta / root)).exp().to_digits(15));
    let critical = BigRational::from_integer(2.into());
    assert!(matches!(dashpot.epsilon(&critical, 15), Err(DirectError::Overdamped { .. })));
}
