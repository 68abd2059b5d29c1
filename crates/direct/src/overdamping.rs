use crate::equation::Equation;
use crate::phase_arc::PhasePoint;
use num_rational::BigRational;
use num_traits::One;
use restitution_real::Ball;

/// Whether a point on the way out proves that the motion comes to rest before zero compression.
///
/// The curve `w = c z^(A-B)` is a barrier for all smaller `z` if `A >= 2 B` and
///
/// ```text
/// q (u c - 1) >= (A-B) c^2 z^(A-2B)
/// ```
///
/// which is easiest to meet at `c = q u z^(2B-A)/(2 (A-B))`. A motion below such a curve stays below
/// it: its speed goes to zero with the compression (docs/direct-integration.md, Prop. 7).
pub(crate) fn traps(equation: &Equation, point: &PhasePoint) -> bool {
    let speed = point.velocity().abs();
    barrier(equation, &Ball::exact(point.z.clone())).is_some_and(|highest| (highest - speed).lower() >= 0)
}

/// Whether a barrier stands wherever the motion may turn: it comes to rest on the way out, whatever it does before.
///
/// Friction alone lets it in no further than `z^B = B/(q u)`, and what turns there has the speed 0, which is below any barrier. (Where
/// a barrier stands at all the energy would let it in further, `z^A = (a+1)/2`.)
pub(crate) fn never_leaves(equation: &Equation) -> bool {
    let c = &equation.coordinate;
    let reach = equation.rational(&(&c.damping / &c.q)) / &equation.u;
    let z = reach.pow(&(BigRational::one() / &c.damping));
    barrier(equation, &Ball::exact(z.upper())).is_some()
}

/// The largest speed below which a motion at `z` is trapped, if the barrier stands there.
fn barrier(equation: &Equation, z: &Ball) -> Option<Ball> {
    let c = &equation.coordinate;
    let twice = &c.damping + &c.damping;
    if !c.has_zero_force() || c.elastic < twice || !z.is_positive() {
        return None;
    }
    let z = z.with_prec(equation.prec);
    let rise = equation.rational(&(c.force_power() / &c.q)) * z.pow(&(&c.elastic - twice));
    let stands = (&equation.u * &equation.u - rise.shifted(2)).lower() >= 0;
    stands.then(|| &equation.u / rise.shifted(1) * z.pow(&c.force_power()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Float;

    fn equation(law: &str, u: f64) -> Equation {
        Equation::new(&law.parse().unwrap(), &Ball::from_f64(u, 80), 80)
    }

    /// With `a = 3`, `gamma = 1/2`: `q = 2`, `A = 8`, `B = 3`, and the barrier stands where `u^2 >= 10 z^2`, at `w = u z^3/5`.
    #[test]
    fn a_motion_below_the_barrier_is_trapped() {
        let equation_at = |u: f64| equation("3,1/2", u);
        for u in [1.0, 3.0] {
            let z = 0.999 * u / 10.0_f64.sqrt();
            let highest = |z: f64| barrier(&equation_at(u), &Ball::from_f64(z, 80));
            assert!((highest(z).unwrap().to_f64() / (u * z.powi(3) / 5.0) - 1.0).abs() < 1e-12);
            for beyond in [1.002, 1.5, 3.0] {
                assert!(highest(beyond * z).is_none(), "{u} {beyond}");
            }
            let speed = u * 0.125_f64.powi(3) / 5.0;
            let trapped = |v: f64, energy: f64| {
                let (z, v) = (Float::with_val(80, 0.125), Float::with_val(80, -v));
                traps(&equation_at(u), &PhasePoint { z, v, energy: Ball::from_f64(energy, 64) })
            };
            assert!(trapped(0.999 * speed, 0.0) && !trapped(1.001 * speed, 0.0));
            // What the speed may be off by counts.
            assert!(trapped(0.9 * speed, 0.08 * speed * speed) && !trapped(0.9 * speed, 0.1 * speed * speed));
        }
        // Not where the damping is the weaker near contact, or the force has no zero.
        for law in ["3/2,1/2", "1,1", "1/2,3/2"] {
            assert!(barrier(&equation(law, 100.0), &Ball::from_f64(0.001, 80)).is_none(), "{law}");
        }
        assert!(barrier(&equation("1,0", 2.0), &Ball::from_f64(1.0, 80)).is_some(), "critical");
        assert!(barrier(&equation("1,0", 1.999), &Ball::from_f64(1.0, 80)).is_none());
    }

    /// Friction alone ends the motion at `z^3 = 3/(2 u)`, where the barrier stands from `u^(8/3) = 10 (3/2)^(2/3)` on.
    #[test]
    fn a_barrier_at_the_farthest_place_traps_every_motion() {
        let limit = (10.0 * 1.5_f64.powf(2.0 / 3.0)).powf(3.0 / 8.0);
        assert!(never_leaves(&equation("3,1/2", 1.001 * limit)));
        for below in [0.999, 0.9, 0.5] {
            assert!(!never_leaves(&equation("3,1/2", below * limit)), "{below}");
        }
        assert!(!never_leaves(&equation("3/2,1/2", 1e6)));
    }
}
