//! What approximations are compared with: values between certified ones.

use proptest::prelude::Rng;
use restitution::End;
use restitution_direct::Collision;
use restitution_export::InterpolatedCurve;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use rug::Float;
use std::sync::OnceLock;

/// Bits of a value that judges an f64.
pub const PREC: u32 = 112;

/// Returns the reference of one end of contact, made once.
pub fn reference(end: End) -> &'static InterpolatedCurve {
    static REFERENCES: [OnceLock<InterpolatedCurve>; 2] = [OnceLock::new(), OnceLock::new()];
    let slot = &REFERENCES[usize::from(end == End::ZeroForce)];
    slot.get_or_init(|| InterpolatedCurve::new(end).expect("the integrator proves every node"))
}

/// Returns `1 - epsilon(u)` and `epsilon(u)` for an f64.
pub fn exact(reference: &InterpolatedCurve, u: f64) -> (Float, Float) {
    if u == 0.0 {
        return (Float::new(PREC), Float::with_val(PREC, 1));
    }
    let lost = reference.one_minus_epsilon(&Float::with_val(PREC, u));
    let epsilon = reference.epsilon(&Float::with_val(PREC, u));
    (lost, epsilon)
}

/// Returns the distance of `value` from `exact` in units of the last place of `exact`.
pub fn ulps(value: f64, exact: &Float) -> f64 {
    let size = exact.to_f64().abs();
    let ulp = (size.next_up() - size).max(5e-324);
    (Float::with_val(PREC, value - exact) / ulp).to_f64().abs()
}

/// The interpolation between certified values is itself compared with certified values elsewhere.
#[test]
fn interpolation_agrees_with_the_integrator() {
    let mut random = crate::support::generator(5, 1);
    for (end, direct) in [
        (End::ZeroCompression, restitution_direct::End::ZeroCompression),
        (End::ZeroForce, restitution_direct::End::ZeroForce),
    ] {
        let collision = Collision::new(&ForceLaw::viscoelastic_spheres(), direct).unwrap();
        let mut worst = 0.0_f64;
        for _ in 0..crate::support::cases(60) {
            let spread = f64::from(random.rng().next_u32()) / f64::from(u32::MAX);
            let u = 1e-3 * 1e6_f64.powf(spread);
            let certified = collision.enclose(&Ball::from_f64(u, 160), 160).unwrap();
            assert!(certified.relative_bits().unwrap() > 100);
            let (_, epsilon) = exact(reference(end), u);
            let error = (epsilon - certified.mid()) / certified.mid();
            worst = worst.max(error.to_f64().abs());
        }
        println!("{end:?}: interpolation is within {worst:.1e} of the certified integrator");
        assert!(worst <= 1e-27, "{end:?}: {worst:e}");
    }
}
