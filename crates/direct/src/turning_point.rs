//! Where a step around the turning point starts and ends.

use crate::equation::Equation;
use restitution_real::Ball;
use rug::Float;

/// A point near the turning point: `v` is exact, the true potential energy is near `y`.
#[derive(Clone, Debug)]
pub(crate) struct TurningPoint {
    pub(crate) v: Float,
    pub(crate) y: Float,
    /// Bound of the error of `F(y, v) = y + u v x^(gamma+1)/(gamma+1)`.
    pub(crate) energy: Ball,
    /// Bound of the error of `y` itself.
    pub(crate) spread: Ball,
}

/// Damping over elastic force per unit of velocity, `K = u x^(gamma-a)`, at potential energy `y`.
pub(crate) fn friction_ratio(equation: &Equation, y: &Ball) -> Ball {
    let power = -(equation.law.a() - equation.law.gamma()) / equation.law.elastic_step();
    &equation.u * (y * equation.rational(&equation.law.elastic_step())).pow(&power)
}
