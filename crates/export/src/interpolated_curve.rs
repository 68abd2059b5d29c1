//! `epsilon(u)` to 30 digits in microseconds: interpolation between certified values.

use super::chebyshev::{PREC, clenshaw, coefficients, nodes};
use restitution::End;
use restitution_direct::{Collision, DirectError, saturation_speed};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use rug::Float;
use rug::ops::Pow;

/// Nodes of an arc.
const NODES: usize = 44;
/// More nodes than the degree of the difference between an arc and a polynomial of degree 8 in `u`.
const MORE_NODES: usize = 48;
/// Digits of the saturated exit speed.
const DIGITS: usize = 40;

/// The coefficient of restitution of viscoelastic spheres, interpolated from certified values.
///
/// Each arc holds 44 values of the certified integrator (`restitution-direct`) at Chebyshev nodes; the
/// function interpolated is `(1 - epsilon)/u` near 0, `epsilon` in the middle, and beyond what remains
/// when the power law is taken off. The variable is `u`, `sqrt(u)` or `ln(u)`.
///
/// # Error bound
///
/// The values are proved, the interpolation between them is judged: the last coefficients of every arc
/// are below 1e-24 of the first, and `tests/it/certified.rs` compares with the integrator at points that
/// are no nodes, to 1e-27 relative.
#[derive(Debug)]
pub struct InterpolatedCurve {
    end: End,
    arcs: Vec<Arc>,
    /// `R^5`, or `(3/2)^(2/3)`: the factor of the power law.
    factor: Float,
}

/// What an arc interpolates, and in which variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shape {
    /// `(1 - epsilon)/u`.
    Loss,
    /// `epsilon`.
    Plain,
    /// `(epsilon u^(5/3)/factor - 1) u^(5/3)` in `ln u`.
    Tail,
}

#[derive(Debug)]
struct Arc {
    shape: Shape,
    low: f64,
    high: f64,
    coefficients: Vec<Float>,
}

/// Ends of the arcs in `u`, then where the power law takes over.
const COMPRESSION_ARCS: [f64; 8] = [0.0, 0.5, 1.5, 2.4, 3.25, 4.5, 6.0, 8.0];
/// Ends of the arcs in `sqrt(u)`.
const FORCE_ARCS: [f64; 7] = [0.0, 0.35, 0.7, 1.2, 1.9, 2.8, 4.0];
/// Ends of the arcs in `ln u`. After the last one the tail is a straight line but for terms of
/// `u^(-5/3) ln(u)^2`, which leaves 1e-17 of `epsilon`.
const TAIL_ARCS: [f64; 5] = [2.7, 4.0, 6.0, 9.0, 14.0];

impl InterpolatedCurve {
    /// Interpolates for one end of contact and every `u`; takes seconds.
    ///
    /// # Errors
    ///
    /// A [`DirectError`] if the integrator cannot prove a value.
    pub fn new(end: End) -> Result<Self, DirectError> {
        Self::up_to(end, f64::INFINITY)
    }

    /// As [`InterpolatedCurve::new`], for `u` up to `last` only.
    ///
    /// # Errors
    ///
    /// As [`InterpolatedCurve::new`].
    pub fn up_to(end: End, last: f64) -> Result<Self, DirectError> {
        let law = ForceLaw::viscoelastic_spheres();
        let mut reference = Self { end, arcs: Vec::new(), factor: factor(end, &law)? };
        let collision = Collision::new(&law, end)?;
        let spans: &[(Shape, &[f64])] = match end {
            End::ZeroCompression => &[(Shape::Plain, &COMPRESSION_ARCS)],
            End::ZeroForce => &[(Shape::Plain, &FORCE_ARCS), (Shape::Tail, &TAIL_ARCS)],
        };
        for (shape, ends) in spans {
            for ends in ends.windows(2) {
                let shape = if ends[0] == 0.0 { Shape::Loss } else { *shape };
                if reference.u_of(shape, &Float::with_val(PREC, ends[0])) > last {
                    break;
                }
                let arc = reference.interpolate(&collision, shape, ends[0], ends[1])?;
                reference.arcs.push(arc);
            }
        }
        Ok(reference)
    }

    fn interpolate(
        &self,
        collision: &Collision,
        shape: Shape,
        low: f64,
        high: f64,
    ) -> Result<Arc, DirectError> {
        let nodes = nodes(&Float::with_val(PREC, low), &Float::with_val(PREC, high), NODES);
        let value = |x: &Float| -> Result<Float, DirectError> {
            let u = self.u_of(shape, x);
            let epsilon = collision.enclose(&Ball::exact(u.clone()), PREC)?.mid().clone();
            Ok(match shape {
                Shape::Loss => (1 - epsilon) / u,
                Shape::Plain => epsilon,
                Shape::Tail => {
                    let power = u.pow(five_thirds());
                    (epsilon * &power / &self.factor - 1u32) * power
                }
            })
        };
        let values = nodes.iter().map(value).collect::<Result<Vec<_>, _>>()?;
        Ok(Arc { shape, low, high, coefficients: coefficients(&values) })
    }

    /// `u` of the variable of an arc.
    fn u_of(&self, shape: Shape, x: &Float) -> Float {
        match (shape, self.end) {
            (Shape::Tail, _) => x.clone().exp(),
            (_, End::ZeroForce) => x.clone().square(),
            (_, End::ZeroCompression) => x.clone(),
        }
    }

    /// Where the contact ends.
    pub fn end(&self) -> End {
        self.end
    }

    /// The factor of the power law at large `u`: `R^5`, or `(3/2)^(2/3)`.
    pub fn factor(&self) -> &Float {
        &self.factor
    }

    /// Returns `epsilon(u)` for a positive `u`, at the precision of `u`.
    pub fn epsilon(&self, u: &Float) -> Float {
        let (arc, value) = self.look_up(u);
        match arc.map(|arc| arc.shape) {
            Some(Shape::Loss) => 1 - value * u,
            Some(Shape::Tail) => (value / u.clone().pow(five_thirds()) + 1u32) * self.power_law(u),
            Some(Shape::Plain) | None => value,
        }
    }

    /// Returns `1 - epsilon(u)`, with all its digits where `u` is small.
    pub fn one_minus_epsilon(&self, u: &Float) -> Float {
        match self.look_up(u) {
            (Some(Arc { shape: Shape::Loss, .. }), value) => value * u,
            _ => 1 - self.epsilon(u),
        }
    }

    /// Returns `epsilon(u) u^(5/3)/factor - 1` at zero force, for large `u`.
    pub(super) fn departure(&self, u: &Float) -> Float {
        match self.look_up(u) {
            (Some(Arc { shape: Shape::Tail, .. }), value) => value / u.clone().pow(five_thirds()),
            (_, value) => value / self.power_law(u) - 1u32,
        }
    }

    /// The arc that `u` lies on and its value there; without one, `epsilon` by the power law.
    fn look_up(&self, u: &Float) -> (Option<&Arc>, Float) {
        let variable = match self.end {
            End::ZeroCompression => u.clone(),
            End::ZeroForce => u.clone().sqrt(),
        };
        if let Some(arc) = self.arcs.iter().find(|arc| arc.shape != Shape::Tail && variable <= arc.high) {
            return (Some(arc), arc.at(&variable));
        }
        let logarithm = u.clone().ln();
        match self.arcs.iter().filter(|arc| arc.shape == Shape::Tail).find(|arc| logarithm <= arc.high) {
            Some(arc) => (Some(arc), arc.at(&logarithm)),
            None => match self.arcs.last().filter(|arc| arc.shape == Shape::Tail) {
                Some(arc) => (Some(arc), arc.straight_on(&logarithm)),
                None => (None, self.power_law(u)),
            },
        }
    }

    /// Splits a range of `u` where the interpolation changes its polynomial.
    pub(super) fn split(&self, low: f64, high: f64) -> Vec<(f64, f64)> {
        let ends: &[f64] = match self.end {
            End::ZeroCompression => &COMPRESSION_ARCS,
            End::ZeroForce => &FORCE_ARCS,
        };
        let u_of = |x: &f64| if self.end == End::ZeroCompression { *x } else { x * x };
        let mut points = vec![low];
        points.extend(ends.iter().map(u_of).filter(|u| low < *u && *u < high));
        points.push(high);
        points.windows(2).map(|ends| (ends[0], ends[1])).collect()
    }

    /// Returns the sum of the Chebyshev coefficients of `error` on `[low, high]`, in the variable of the interpolation.
    ///
    /// An upper bound of `|error|` there, if `error` is the difference of the interpolation and a polynomial of degree 8 or
    /// less in `u` and [`Self::split`] does not split the range: such a difference has degree 45 at most, so it is its own
    /// interpolation through 48 points.
    pub(super) fn largest(&self, low: f64, high: f64, error: &dyn Fn(&Float) -> Float) -> f64 {
        let root = self.end == End::ZeroForce;
        let variable = |u: f64| if root { Float::with_val(PREC, u).sqrt() } else { Float::with_val(PREC, u) };
        let points = nodes(&variable(low), &variable(high), MORE_NODES);
        let values: Vec<Float> =
            points.iter().map(|x| error(&if root { x.clone().square() } else { x.clone() })).collect();
        coefficients(&values).iter().map(|c| c.to_f64().abs()).sum()
    }

    /// The law at infinity.
    pub(super) fn power_law(&self, u: &Float) -> Float {
        let power = match self.end {
            End::ZeroCompression => u.clone().pow(5u32),
            End::ZeroForce => u.clone().pow(five_thirds()),
        };
        Float::with_val(u.prec(), &self.factor / power)
    }
}

impl Arc {
    fn at(&self, x: &Float) -> Float {
        let width = self.high - self.low;
        let t = (Float::with_val(x.prec(), x - self.low) * 2u32) / width - 1u32;
        clenshaw(&self.coefficients, &t)
    }

    /// The straight line through the values at the end of the arc and a tenth of it before.
    fn straight_on(&self, x: &Float) -> Float {
        let step = (self.high - self.low) / 10.0;
        let end = Float::with_val(x.prec(), self.high);
        let (last, before) = (self.at(&end), self.at(&Float::with_val(x.prec(), self.high - step)));
        let slope = (Float::with_val(x.prec(), &last) - before) / step;
        slope * (Float::with_val(x.prec(), x) - end) + last
    }
}

fn five_thirds() -> Float {
    Float::with_val(PREC, 5) / 3u32
}

/// `R^5`, proved to 40 digits, or `(9/4)^(1/3)`.
fn factor(end: End, law: &ForceLaw) -> Result<Float, DirectError> {
    Ok(match end {
        End::ZeroCompression => saturation_speed(law, DIGITS)?.mid().clone(),
        End::ZeroForce => (Float::with_val(PREC, 9) / 4u32).cbrt(),
    })
}
