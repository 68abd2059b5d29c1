//! How far the largest compression found is from the true one (`docs/error-bounds.md`, theorem 5).

use super::motion_proof::SETTLED;
use super::one_variable::reciprocal;
use super::response::{Cause, response};
use super::sketch::{Detail, Grading, Powers, Sketch, Unbounded, in_detail, over_one_minus, within};
use super::turning::{Neighbourhood, TurningScale};
use super::units::Scale;
use crate::kernels::{Fixed, Workshop, power_of_two};
use restitution_real::Magnitude;

/// The error of one coefficient of a product: rounded once, worthless digits of the factors left away.
///
/// Each of at most [`MOST_PLACES`] places contributes `2 2^-16` of a unit to the second part.
pub(crate) const PRODUCT: f64 = SETTLED + 0.25;
/// Places of the longest product for which [`PRODUCT`] holds; `attempt` proves no longer expansion.
pub(crate) const MOST_PLACES: usize = 8192;
/// Degrees in `theta` that are followed one by one, at most.
const MOST_DEGREES: usize = 4000;
/// Limits: of the relative error, so that its square is nothing; of the shift; of the contraction (`docs/error-bounds.md`).
const FIRST_ORDER: f64 = 1e-6;
const LARGEST_SHIFT: f64 = 0.999999;
const CONTRACTION: f64 = 0.499;

fn exact(x: f64) -> Magnitude {
    Magnitude::exact(x * (1.0 + 1e-12))
}

/// A bound of `||y - y~||` in units of the fixed point, for the errors of the initial values.
///
/// `shift` was found to half the length, `compression` from it; `None` if the norms are too large.
pub(crate) fn bound(
    shop: &Workshop,
    scale: &Scale,
    turning: &TurningScale,
    near: &Neighbourhood,
    (position, velocity): (Magnitude, Magnitude),
    shift: &Fixed,
) -> Option<Magnitude> {
    in_detail(|detail| bound_in(detail, shop, scale, turning, near, (position, velocity), shift)).ok()
}

fn bound_in(
    detail: Detail,
    shop: &Workshop,
    scale: &Scale,
    turning: &TurningScale,
    near: &Neighbourhood,
    (position, velocity): (Magnitude, Magnitude),
    shift: &Fixed,
) -> Result<Magnitude, Unbounded> {
    let unit = scale.lattice.unit as f64;
    let [a, c] = scale.powers().map(|steps| steps as f64 / unit);
    let grading = Grading { row: 1.0, column: 1.0 };
    let powers = Powers::new(Sketch::new(&near.rows, &[], shop.bits(), grading, detail)?, grading)?;
    let [lower, gamma] = scale.lower_powers();
    let stiffness = powers.power(lower)?;
    let drag = if scale.shared { stiffness.clone() } else { powers.power(gamma)? };
    let rows = near.rows.len() as f64;
    let coefficients = exact(rows * (rows + 1.0) / 2.0);

    // The powers: every coefficient of row n misses its sum by n times less than 2 units.
    let power_error = |power: f64, lower: &Sketch| -> Result<Magnitude, Unbounded> {
        let defects = coefficients * Magnitude::exact(2.0);
        Ok(lower.norm() * powers.base() * (Magnitude::ONE + powers.power(-power - 1.0)?.norm() * defects))
    };
    let pull_error = power_error(a, &stiffness)?;
    let drag_error = if scale.shared {
        pull_error * exact(scale.ratio.0 as f64 / scale.ratio.1 as f64)
    } else {
        power_error(c, &drag)?
    };

    let rho = exact(turning.step.0 as f64 / turning.step.1 as f64);
    let (e, d) = (Magnitude::of(&turning.elastic), Magnitude::of(&turning.damping));
    let by_degree = |sketch: &Sketch, factor: Magnitude| -> Vec<Magnitude> {
        sketch.norms_by(|_, l| l).into_iter().map(|norm| norm * factor).collect()
    };
    let (pull, friction) = (rho * rho * e * exact(a.abs()), rho * d);
    let causes = [
        Cause {
            step: 2,
            sizes: &by_degree(&stiffness, pull),
            weight: &|_, place| 1.0 / (place as f64 * (place as f64 - 1.0)),
        },
        Cause { step: 1, sizes: &by_degree(&drag, friction), weight: &|_, place| 1.0 / place as f64 },
    ];
    let growth = response(0, &causes, MOST_DEGREES).ok_or(Unbounded::Large)?;
    let half = exact(0.5);
    let rounding = coefficients * Magnitude::exact(2.0);
    let forcing = rho * rho * pull_error + rho * drag_error * exact(1.0 / c);
    // Twice, for what is of second order: it must stay below what is of first, here and in the slope.
    let known = position + rho * velocity + rounding + forcing * half;
    let error = growth * known * Magnitude::exact(2.0);
    let small = power_of_two(-i64::from(shop.bits()));
    let relative = error * small * powers.reciprocal();
    let larger = relative * powers.reciprocal() * powers.base();
    let second = error
        * larger
        * (pull * exact(lower.abs()) * stiffness.norm() + friction * exact(gamma.abs()) * drag.norm());
    if !within(relative * exact(a.max(c).max(1.0) + 8.0), FIRST_ORDER)
        || !within(larger * exact(lower.abs().max(gamma.abs())), 1.0)
        || second * half > known
    {
        return Err(Unbounded::Large);
    }
    // l E_l: as above, each step divided by its larger factor only.
    let slope_error = rho * velocity
        + rounding * exact(rows)
        + forcing
        + error * (pull * stiffness.norm() + friction * drag.norm()) * Magnitude::exact(2.0);

    let columns = columns(near, shop);
    let moment = |power: u32| -> Magnitude {
        let falling = |l: usize| (0..power).map(|k| (l as f64 - f64::from(k)).max(0.0)).product::<f64>();
        columns.iter().enumerate().map(|(l, &norm)| norm * exact(falling(l))).sum()
    };
    // What evaluating the polynomial and its derivatives costs.
    let size = shift.norm(i64::from(shop.bits()), 1.0);
    if !within(size, LARGEST_SHIFT) {
        return Err(Unbounded::Large);
    }
    let evaluation = |derivative: u32| {
        let places = exact(PRODUCT * rows);
        let steps = exact(rows + 2.0 * rows.sqrt() + 4.0);
        places * steps * (Magnitude::ONE + moment(derivative))
    };
    let len = shift.len();
    let residual = near.derivative_at(shop, shift, 1, len).norm(0, 1.0) + evaluation(1) + slope_error;
    let acceleration = near.derivative_at(shop, shift, 2, len);
    let inverse = reciprocal(shop, &acceleration);
    let mut gap = shop.product(&acceleration, &inverse, len);
    gap.add(&super::one_variable::one_padded(shop, len).negated());
    let inverse = inverse.norm(i64::from(shop.bits()), 1.0);
    let curvature_error = evaluation(2) + slope_error * exact(rows);
    let gap = (gap.norm(0, 1.0) + exact(PRODUCT * rows) + inverse * curvature_error) * small;
    let inverse = inverse * over_one_minus(gap).ok_or(Unbounded::Large)?;
    let shift_error = inverse * residual * Magnitude::exact(2.0);
    // The derivatives of the true polynomial: those of the one found and of its error.
    let third = third_derivative(moment(3), slope_error * small, rows);
    let contraction = third * inverse * shift_error * small * Magnitude::exact(4.0);
    let inside = is_inside(size, shift_error * small, slope_error * small, moment(1));
    (inside && within(contraction, CONTRACTION))
        .then(|| error + evaluation(0) + moment(1) * shift_error * Magnitude::exact(2.0))
        .ok_or(Unbounded::Large)
}

/// `sum_k |P_(k,l)|` for every degree `l`.
fn columns(near: &Neighbourhood, shop: &Workshop) -> Vec<Magnitude> {
    let unit = i64::from(shop.bits());
    let column = |l: usize| near.rows.iter().skip(l).map(|row| row.size(l, unit)).sum();
    (0..near.rows.len()).map(column).collect()
}

/// The third derivative of the true polynomial: that of the one found, and of its error, in whose `rows` degrees every place counts.
fn third_derivative(found: Magnitude, slope_error: Magnitude, rows: f64) -> Magnitude {
    found + slope_error * exact(rows * rows)
}

/// Whether the true turning point is in the unit ball, and its slope error no larger than the slope.
fn is_inside(shift: Magnitude, shift_error: Magnitude, slope_error: Magnitude, slope: Magnitude) -> bool {
    within(shift + shift_error, 1.0) && slope_error <= slope
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turning_point_is_inside_with_its_errors() {
        let exact = |x: f64| Magnitude::exact(x);
        let inside = |numbers: [f64; 4]| {
            let [shift, shift_error, slope_error, slope] = numbers.map(exact);
            is_inside(shift, shift_error, slope_error, slope)
        };
        assert!(inside([0.5, 0.25, 0.1, 0.1]));
        assert!(!inside([0.5, 0.75, 0.1, 0.1]) && !inside([0.9, 0.2, 0.1, 1.0]));
        assert!(!inside([0.5, 0.25, 0.2, 0.1]));
        let third = third_derivative(exact(5.0), exact(0.5), 7.0).to_f64();
        assert!((29.5..29.5 * (1.0 + 1e-11)).contains(&third), "{third}");
    }
}
