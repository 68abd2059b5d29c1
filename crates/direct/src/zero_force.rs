//! The zero of the force on the way out, where contact ends under delayed recovery: where it lies, proved.

use crate::field::Field;
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
pub(crate) fn none_left(field: &Field, point: &PhasePoint, settled: &Float) -> Option<Ball> {
    if point.z > *settled {
        return None;
    }
    let z = Ball::exact(point.z.clone()).with_prec(field.prec);
    let speed = point.velocity().abs();
    if !field.balance(&z, &speed).is_positive() {
        return None;
    }
    let c = &field.coordinate;
    let left = (field.rational(&(&c.q / &c.elastic)) * z.pow(&c.elastic)).shifted(1);
    let fastest = (&speed * &speed + left).sqrt();
    fastest.is_finite().then(|| speed.union(&fastest))
}

/// Decides whether the force vanishes on this arc, and gives the speed there.
///
/// On the way out the speed is largest there, so an error of the place matters only by its square
/// (docs/direct-integration.md, Prop. 5).
pub(crate) fn locate(field: &Field, arc: &PhaseArc) -> ForceZero {
    let end = Ball::exact(arc.end.clone()).with_prec(field.prec);
    let balance = field.balance(&end, &arc.reached.velocity().abs());
    if balance.is_positive() {
        return ForceZero::NotPassed;
    }
    if balance.is_negative() { ForceZero::Passed(speed_at_zero(field, arc)) } else { ForceZero::Undecided }
}

/// The speed at a zero of the force that lies on the arc.
fn speed_at_zero(field: &Field, arc: &PhaseArc) -> Ball {
    let (z, speed) = newton(field, arc);
    let off = field.balance(&z, &speed).abs();
    // The zero lies within 2 |balance|/((A-B) z^(A-B-1)); the balance there stays within its size.
    let c = &field.coordinate;
    let low = |x: &Ball| lower_bound(&x.with_prec(BOUND_BITS));
    let power = c.force_power();
    let rise = |z: &Ball| field.rational(&power) * z.pow(&(&power - BigRational::one()));
    let room = z.with_prec(BOUND_BITS).widened(&upper_bound(&z.shifted(-NEAR)).upper());
    let least_rise = low(&rise(&room)).shifted(-1);
    let width = upper_bound(&(upper_bound(&off) / &least_rise));
    let pull = upper_bound(
        &(field.rational(&c.q) * room.pow(&(&c.damping - BigRational::one())) / &speed).shifted(1),
    );
    let bent = upper_bound(&(&pull * upper_bound(&off) * upper_bound(&field.u.abs())));
    let inside = (z.shifted(-NEAR).with_prec(BOUND_BITS) - &width).is_positive()
        && !(bent - &least_rise).is_positive();
    if !inside {
        return Ball::whole_line(field.prec);
    }
    let excess = upper_bound(&(pull * upper_bound(&off) * width));
    speed.widened(&excess.upper())
}

/// Newton's iteration for the zero of the balance on an arc, kept between its ends.
fn newton(field: &Field, arc: &PhaseArc) -> (Ball, Ball) {
    let c = &field.coordinate;
    let (mut low, mut high) = (Float::new(field.prec), Float::with_val(field.prec, 1));
    let mut theta = Float::with_val(field.prec, 0.5);
    let mut best = (Ball::whole_line(field.prec), Ball::whole_line(field.prec));
    for _ in 0..ITERATIONS {
        let part = Ball::exact(theta.clone());
        let z = arc.coordinate(field, &part);
        let speed = arc.velocity(&part).abs();
        let balance = field.balance(&z, &speed);
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
        let slope = field.rational(&power) * z.pow(&(&power - &one))
            + &field.u * field.rational(&c.q) * z.pow(&(&c.damping - &one)) * &balance / &speed;
        let step = balance / (slope * arc.pace(field, &z));
        let next = Float::with_val(field.prec, &theta - step.mid());
        let bracketed = step.is_finite() && next > low && next < high;
        let next = if bracketed { next } else { Float::with_val(field.prec, &low + &high) / 2u32 };
        if next == theta {
            break;
        }
        theta = next;
    }
    best
}
