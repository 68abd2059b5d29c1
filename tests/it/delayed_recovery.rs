//! The factor between the two ends of contact, from the phase plane, against direct integration of both.

use num_rational::BigRational;
use restitution_direct::{Collision, End};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::DelayedRecovery;

const ORDER: usize = 36;
const DIGITS: usize = 40;

/// The sum of `Psi` at `y` and the size of its last term.
fn sum(law: &ForceLaw, y: &Ball) -> (Ball, f64) {
    let psi = DelayedRecovery::new(law).expect("an end at zero force").psi(ORDER);
    let psi: Vec<Ball> = psi.iter().map(|c| Ball::from_rational(c, y.prec())).collect();
    let sum = psi.iter().rev().fold(Ball::from_integer(0, y.prec()), |sum, c| sum * y + c);
    (sum, (psi[ORDER].to_f64() * y.to_f64().powi(ORDER as i32)).abs())
}

#[test]
fn the_quotient_of_the_two_ends_is_the_sum_of_psi() {
    // (law, u): y is well inside the radius of convergence, and large enough for every coefficient to count.
    for (law, n, d) in [
        ("3/2,1/2", 1, 2),
        ("3/2,1/2", 1, 1000),
        ("1,0", 1, 5),
        ("2,1/3", 2, 5),
        ("5/2,-1/3", 1, 4),
        ("7/3,5/6", 1, 3),
        ("3,1/2", 1, 3),
        ("3/4,3/5", 9, 10),
    ] {
        let law: ForceLaw = law.parse().expect("a force law");
        let u = BigRational::new(n.into(), d.into());
        let value = |end| {
            Collision::new(&law, end)
                .and_then(|c| c.epsilon(&u, DIGITS))
                .unwrap_or_else(|e| panic!("{law}: {e}"))
        };
        let (compression, force) = (value(End::ZeroCompression), value(End::ZeroForce));
        let (n, d) = (law.elastic_step(), law.a() - law.gamma());
        let u = Ball::from_rational(&u, compression.prec());
        let y = (u * compression.pow(&law.velocity_exponent())).pow(&(n / d));
        let (sum, last) = sum(&law, &y);
        let off = (&force / &compression - sum).abs_up().to_f64();
        // Terms fall at least by a half each here, so that what is left out is less than the last one.
        assert!(last < 1e-9, "{law}: the last term is {last:e}");
        assert!(off <= 2.0 * last + 1e-38, "{law}: {off:e}, last term {last:e}");
    }
}

#[test]
fn a_high_order_begins_with_the_low_ones() {
    let end = DelayedRecovery::new(&ForceLaw::viscoelastic_spheres()).expect("an end at zero force");
    let (all, few) = (end.psi(60), end.psi(4));
    assert_eq!(all.len(), 61);
    assert_eq!(all[..5], few);
}
