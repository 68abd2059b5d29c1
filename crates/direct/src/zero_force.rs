//! The zero of the force on the way out, where contact ends under delayed recovery: where it lies, proved.

use crate::equation::Equation;
use crate::fixed::{BOUND_BITS, lower_bound, upper_bound};
use crate::phase_arc::{PhaseArc, PhasePoint};
use num_rational::BigRational;
use num_traits::One;
use restitution_real::Ball;
use rug::Float;

/// Halvings and Newton steps that the search may take; a tiny damping needs many.
const ITERATIONS: u32 = 4096;
/// Bits that say how close, relative to the place, the zero must be known.
const NEAR: i32 = 20;

/// What one arc of the way out proves about the zero of the force.
pub(crate) enum ForceZero {
    /// The force is negative at the end of the arc, so its only zero lies before; the speed there.
    Passed(Ball),
    /// The force is positive all along the arc: its zero lies beyond.
    NotPassed,
    /// The sign at the end is not known.
    Undecided,
}

/// The speed at the zero of the force, if the zero lies below a point where the elastic energy that
/// is left is less than the working precision shows; `None` if that is not proved.
///
/// ```text
/// balance(z, w) > 0   =>   w^2 <= w_f^2 <= w^2 + 2 q z^A/A
/// ```
///
/// The speed grows as long as the force is positive, and the damping only takes from it
/// (docs/direct-integration.md, Prop. 5b).
pub(crate) fn none_left(equation: &Equation, point: &PhasePoint, settled: &Float) -> Option<Ball> {
    if point.z > *settled {
        return None;
    }
    let z = Ball::exact(point.z.clone()).with_prec(equation.prec);
    let speed = point.velocity().abs();
    if !equation.balance(&z, &speed).is_positive() {
        return None;
    }
    let c = &equation.coordinate;
    let left = (equation.rational(&(&c.q / &c.elastic)) * z.pow(&c.elastic)).shifted(1);
    let fastest = (&speed * &speed + left).sqrt();
    fastest.is_finite().then(|| speed.union(&fastest))
}

/// Decides whether the force vanishes on this arc, and gives the speed there.
///
/// On the way out the speed is largest there, so an error of the place matters only by its square
/// (docs/direct-integration.md, Prop. 5).
pub(crate) fn locate(equation: &Equation, arc: &PhaseArc) -> ForceZero {
    let end = Ball::exact(arc.end.clone()).with_prec(equation.prec);
    let balance = equation.balance(&end, &arc.reached.velocity().abs());
    if balance.is_positive() {
        return ForceZero::NotPassed;
    }
    if balance.is_negative() { ForceZero::Passed(speed_at_zero(equation, arc)) } else { ForceZero::Undecided }
}

/// The speed at a zero of the force that lies on the arc.
fn speed_at_zero(equation: &Equation, arc: &PhaseArc) -> Ball {
    let (z, speed) = newton(equation, arc);
    around_zero(equation, &z, &speed)
}

/// The speed at the zero of the force next to a point of the motion; the whole line if it may be farther than a part `2^-20` of the place.
fn around_zero(equation: &Equation, z: &Ball, speed: &Ball) -> Ball {
    let off = equation.balance(z, speed).abs();
    // The zero lies within 2 |balance|/((A-B) z^(A-B-1)); the balance there stays within its size.
    let c = &equation.coordinate;
    let low = |x: &Ball| lower_bound(&x.with_prec(BOUND_BITS));
    let power = c.force_power();
    let rise = |z: &Ball| equation.rational(&power) * z.pow(&(&power - BigRational::one()));
    let room = z.with_prec(BOUND_BITS).widened(&upper_bound(&z.shifted(-NEAR)).upper());
    let least_rise = low(&rise(&room)).shifted(-1);
    let width = upper_bound(&(upper_bound(&off) / &least_rise));
    let pull = upper_bound(
        &(equation.rational(&c.q) * room.pow(&(&c.damping - BigRational::one())) / speed).shifted(1),
    );
    let bent = upper_bound(&(&pull * upper_bound(&off) * upper_bound(&equation.u.abs())));
    let inside = (z.shifted(-NEAR).with_prec(BOUND_BITS) - &width).is_positive()
        && !(bent - &least_rise).is_positive();
    if !inside {
        return Ball::whole_line(equation.prec);
    }
    let excess = upper_bound(&(pull * upper_bound(&off) * width));
    speed.clone().widened(&excess.upper())
}

/// Newton's iteration for the zero of the balance on an arc, kept between its ends.
fn newton(equation: &Equation, arc: &PhaseArc) -> (Ball, Ball) {
    let c = &equation.coordinate;
    let (mut low, mut high) = (Float::new(equation.prec), Float::with_val(equation.prec, 1));
    let mut theta = Float::with_val(equation.prec, 0.5);
    let mut best = (Ball::whole_line(equation.prec), Ball::whole_line(equation.prec));
    for _ in 0..ITERATIONS {
        let part = Ball::exact(theta.clone());
        let z = arc.coordinate(equation, &part);
        let speed = arc.velocity(&part).abs();
        let balance = equation.balance(&z, &speed);
        best = (z.clone(), speed.clone());
        if balance.contains_zero() {
            break;
        }
        if balance.is_positive() {
            low.clone_from(&theta)
        } else {
            high.clone_from(&theta)
        }
        let power = c.force_power();
        let one = BigRational::one();
        let slope = equation.rational(&power) * z.pow(&(&power - &one))
            + &equation.u * equation.rational(&c.q) * z.pow(&(&c.damping - &one)) * &balance / &speed;
        let step = balance / (slope * arc.pace(equation, &z));
        let next = Float::with_val(equation.prec, &theta - step.mid());
        let bracketed = step.is_finite() && next > low && next < high;
        let next = if bracketed { next } else { Float::with_val(equation.prec, &low + &high) / 2u32 };
        if next == theta {
            break;
        }
        theta = next;
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use restitution_law::ForceLaw;

    /// Spheres, `q = 2`, `A = 5`, `A - B = 2`, at `u = 1/2`: near contact the force vanishes at `w = 2 z^2`.
    #[test]
    fn what_elastic_energy_is_left_is_in_the_speed() {
        let equation = Equation::new(&ForceLaw::viscoelastic_spheres(), &Ball::from_ratio(1, 2, 100), 100);
        let z = Float::with_val(100, 0.125);
        let ask = |speed: f64, settled: f64| {
            let (v, energy) = (Float::with_val(100, -speed), Ball::from_f64(0.0, BOUND_BITS));
            none_left(&equation, &PhasePoint { z: z.clone(), v, energy }, &Float::with_val(100, settled))
        };
        let speed = 0.0078125;
        // w_f^2 <= w^2 + 2 q z^A/A = w^2 + (4/5) z^5.
        let most = (speed * speed + 0.8 * 0.125_f64.powi(5)).sqrt();
        let found = ask(speed, 0.125).expect("positive balance where the energy no longer counts");
        assert!(found.lower() <= speed && found.lower() > 0.999 * speed, "{found:?}");
        assert!(found.upper() >= most && found.upper() < 1.001 * most, "{found:?} {most}");
        assert!(ask(speed, 0.12).is_none(), "not settled");
        assert!(ask(0.04, 0.125).is_none(), "the force is negative");
    }

    /// Prop. 5 at `z = 1`, where the balance is `g = 1 - u w` and `m` half of 2: the zero within `|g|/m`, the speed up to `2 q g^2/(w m)` more.
    #[test]
    fn a_place_that_is_off_counts_by_its_square() {
        let around = |u: f64, off: f64| {
            let equation = Equation::new(&ForceLaw::viscoelastic_spheres(), &Ball::from_f64(u, 100), 100);
            let speed = Ball::from_f64((1.0 - off) / u, 100);
            (around_zero(&equation, &Ball::from_integer(1, 100), &speed), speed)
        };
        let part = f64::exp2(-20.0);
        let m = 1.0 - part;
        for sign in [1.0, -1.0] {
            for u in [0.5, 3.0] {
                let off = part / 4.0;
                let (found, speed) = around(u, sign * off);
                let excess = 4.0 * (1.0 + part).powi(2) / speed.to_f64() * off * off / m;
                assert!((found.rad().to_f64() / excess - 1.0).abs() < 1e-9, "{found:?} {excess:e}");
                assert_eq!(found.mid(), speed.mid());
            }
            // At z = 2: g = 4 - u w, m half of 4.
            let equation = Equation::new(&ForceLaw::viscoelastic_spheres(), &Ball::from_f64(0.5, 100), 100);
            let (off, w) = (sign * part / 4.0, 2.0 * (4.0 - sign * part / 4.0));
            let found = around_zero(&equation, &Ball::from_integer(2, 100), &Ball::from_f64(w, 100));
            let excess = 4.0 * (2.0 * (1.0 + part)).powi(2) / w * off * off / (2.0 * m);
            assert!((found.rad().to_f64() / excess - 1.0).abs() < 1e-9, "{found:?} {excess:e}");
            // The zero lies in the part 2^-20 around z, over which m was taken.
            assert!(around(0.5, sign * 0.999 * part * m).0.is_finite());
            for beyond in [1.001, 2.0, 1000.0] {
                assert!(!around(0.5, sign * beyond * part).0.is_finite(), "{beyond}");
            }
            // 2 q u z^(B-1) |g|/w <= m, which is narrower where u is large.
            let limit = f64::exp2(-24.0);
            assert!(around(2048.0, sign * 0.999 * limit).0.is_finite());
            for beyond in [1.001, 2.0, 8.0] {
                assert!(!around(2048.0, sign * beyond * limit).0.is_finite(), "{beyond}");
            }
        }
    }
}
