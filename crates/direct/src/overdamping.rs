use crate::equation::Equation;
use crate::phase_arc::PhasePoint;
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
    let c = &equation.coordinate;
    let twice = &c.damping + &c.damping;
    if !c.has_zero_force() || c.elastic < twice || point.z.is_zero() {
        return false;
    }
    let (z, speed) = (Ball::exact(point.z.clone()).with_prec(equation.prec), point.velocity().abs());
    let rise = equation.rational(&(c.force_power() / &c.q)) * z.pow(&(&c.elastic - twice));
    let widest = &equation.u / rise.shifted(1);
    let barred = (&equation.u * &equation.u - rise.shifted(2)).lower() >= 0;
    barred && (widest * z.pow(&c.force_power()) - speed).lower() >= 0
}
