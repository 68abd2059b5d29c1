//! The zero of the force on the way out, where contact ends under delayed recovery: where it lies, proved.

use crate::equation::Equation;
use crate::fixed::{BOUND_BITS, lower_bound, upper_bound};
use crate::phase_arc::{PhaseArc, PhasePoint};
use num_rational::BigRational;
use num_traits::One;
use restitution_real::Ball;
use rug::Float;

/// Evaluations that the search for a place may take; a tiny damping needs many.
const EVALUATIONS: u32 = 4096;
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
    let at = |equation: &Equation, theta: &Float| {
        let part = Ball::exact(theta.clone()).with_prec(equation.prec);
        (arc.coordinate(equation, &part), arc.velocity(&part, equation.prec).abs())
    };
    let rough = equation.at(rough(equation.prec));
    let theta = crossing(rough.prec, |theta| {
        let (z, speed) = at(&rough, theta);
        rough.balance(&z, &speed)
    });
    let (z, speed) = at(equation, &theta);
    around_zero(equation, &z, &speed)
}

/// Bits of a place whose error counts by its square.
fn rough(bits: u32) -> u32 {
    bits / 2 + 16
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

/// A place in `0..=1` where a function that falls from above 0 to below is 0 within its radius.
///
/// Regula falsi, in which an end that stays twice counts half (Illinois): three evaluations triple the digits of the place.
fn crossing(bits: u32, mut value: impl FnMut(&Float) -> Ball) -> Float {
    let mut ends = [0, 1].map(|place| Float::with_val(bits, place));
    let mut values = ends.each_ref().map(|place| value(place).mid().clone());
    let mut last = None;
    for _ in 0..EVALUATIONS {
        let part = Float::with_val(bits, &values[0] - &values[1]);
        let part = Float::with_val(bits, &values[0] / part);
        let next = Float::with_val(bits, &ends[1] - &ends[0]) * part + &ends[0];
        let found = value(&next);
        if found.contains_zero() || ends.contains(&next) {
            return next;
        }
        let side = usize::from(found.is_negative());
        if last == Some(side) {
            values[1 - side] >>= 1;
        }
        ends[side] = next;
        values[side] = found.mid().clone();
        last = Some(side);
    }
    let [low, _] = ends;
    low
}

#[cfg(test)]
mod tests {
    use super::*;
    use restitution_law::ForceLaw;

    /// The zero is met to the last bits, in as many evaluations as the rule takes: a wrong step would need more.
    #[test]
    fn a_crossing_is_found_in_few_evaluations() {
        let search = |bits: u32, value: &dyn Fn(&Ball) -> Ball| {
            let mut places = Vec::new();
            let found = crossing(bits, |place| {
                places.push(place.clone());
                value(&Ball::exact(place.clone()))
            });
            (found, places)
        };
        let ratio = |n: i64, d: i64| Ball::from_ratio(n, d, 1000);
        assert_eq!((rough(101), rough(3000)), (66, 1516));
        // A line at once; then by the rule, in fractions: 1/3 - x^2 at 1/3, 1/2 (an end that stays counts half), 3/5.
        let (found, places) = search(100, &|x| ratio(1, 4) - x);
        assert_eq!((found, places.len()), (Float::with_val(100, 0.25), 3));
        let (found, places) = search(1000, &|x| ratio(1, 3) - x * x);
        let near = |found: &Float, n: u32, d: u32| {
            (Float::with_val(1000, found * d) - n).abs() < Float::with_val(1000, Float::i_exp(1, -900))
        };
        assert!(near(&places[2], 1, 3) && near(&places[3], 1, 2) && near(&places[4], 3, 5), "{places:?}");
        assert!((found.square() * 3u32 - 1u32).abs() < Float::with_val(1000, Float::i_exp(1, -996)));
        assert_eq!(places.len(), 19);
        // From the other side, and a zero that is nearly a double one at an end.
        let (found, places) = search(300, &|x| {
            let y = ratio(1, 1) - x;
            &y * &y * &y - ratio(1, 1 << 60)
        });
        assert!(near(&(1u32 - found), 1, 1 << 20));
        assert_eq!(places.len(), 55);
        // Where the values never contain 0 the search ends at the last bit.
        let step = |x: &Ball| if *x.mid() < 0.3 { ratio(1, 1) } else { ratio(-1, 1) };
        let (found, places) = search(30, &step);
        assert!((found.to_f64() - 0.3).abs() < 1e-8);
        assert_eq!(places.len(), 38);
        // A value that is not known is no sign.
        let (found, places) = search(30, &|_| Ball::whole_line(30));
        assert!(places.len() == 3, "{found} {places:?}");
    }

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
