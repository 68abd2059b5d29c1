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
/// Neither the energy nor the friction lets it further in than `z^A = (a+1)/2` and `z^B = B/(q u)`; what turns there has
/// the speed 0, which is below any barrier.
pub(crate) fn never_leaves(equation: &Equation) -> bool {
    let c = &equation.coordinate;
    let root = |reach: Ball, power: &BigRational| reach.pow(&(BigRational::one() / power));
    let by_energy = root(equation.rational(&equation.law.elastic_step()).shifted(-1), &c.elastic);
    let by_friction = root(equation.rational(&(&c.damping / &c.q)) / &equation.u, &c.damping);
    [by_energy, by_friction].iter().any(|z| barrier(equation, &Ball::exact(z.upper())).is_some())
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
