//! Errors of known size, put into a motion on its way: what the proofs make of them has to hold the true coefficient at the end.
//!
//! Without them all errors are roundings, whose bounds are so wide that a wrong factor on the way would not show.

use crate::collision::Collision;
use crate::compression::compress;
use crate::equation::Equation;
use crate::error::DirectError;
use crate::exit::{to_zero_compression, to_zero_force};
use crate::fixed::{BOUND_BITS, upper_bound};
use crate::phase_arc::PhasePoint;
use crate::stepper::Stepper;
use crate::turning::rebound;
use restitution::End;
use restitution_real::Ball;
use rug::Float;

/// Where the error is put in.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Place {
    /// Before the turning point.
    Inward,
    /// After it.
    Outward,
}

/// The same point with another speed and the energy between the two.
fn moved(point: &PhasePoint, part: f64) -> PhasePoint {
    let v = Float::with_val(point.v.prec(), &point.v * (1.0 + part));
    let (old, new) = (Ball::exact(point.v.clone()), Ball::exact(v.clone()));
    let between = (&old * &old - &new * &new).abs().with_prec(BOUND_BITS);
    PhasePoint { z: point.z.clone(), v, energy: upper_bound(&(between + &point.energy)) }
}

/// The enclosure of `epsilon` that is found after an error.
fn with_error(equation: &Equation, end: End, place: Place, part: f64) -> Result<Ball, DirectError> {
    let mut stepper = Stepper::new(equation.prec, equation.order);
    let at = |here: Place, point: PhasePoint| if here == place { moved(&point, part) } else { point };
    let compressed = at(Place::Inward, compress(equation, &mut stepper)?);
    let rebounding = at(Place::Outward, rebound(equation, &mut stepper, &compressed)?);
    match end {
        End::ZeroCompression => to_zero_compression(equation, &mut stepper, rebounding),
        End::ZeroForce => to_zero_force(equation, &mut stepper, rebounding),
    }
}

#[test]
fn an_error_on_the_way_is_in_the_enclosure() {
    let cases = [
        ("3/2,1/2", &[0.1, 1.0, 3.0][..]),
        ("1,0", &[0.5, 1.5]),
        ("2,1", &[0.01, 2.0]),
        ("1/2,3/2", &[1.0]),
        ("1,1", &[5.0]),
        ("13/11,1/11", &[1.0]),
        ("3/4,3/5", &[0.3]),
        ("3,-1/2", &[0.1]),
    ];
    let (mut closest, mut finite) = ([0.0_f64; 2], 0);
    for (law, dampings) in cases {
        for end in [End::ZeroCompression, End::ZeroForce] {
            let Ok(collision) = Collision::new(&law.parse().unwrap(), end) else { continue };
            for u in dampings {
                let u = Ball::from_f64(*u, 80);
                let truth = collision.enclose(&u, 100).unwrap();
                let equation = Equation::new(collision.law(), &u, 80);
                for place in [Place::Inward, Place::Outward] {
                    for part in [1e-3, -1e-8] {
                        let found = with_error(&equation, end, place, part);
                        let Some(found) = found.ok().filter(Ball::is_finite) else { continue };
                        finite += 1;
                        let off =
                            (Float::with_val(100, found.mid() - truth.mid()).abs() / found.rad()).to_f64();
                        // |V - v| is the energy over |V| + |v|, taken for energy/|v|: half is left.
                        assert!(
                            off <= 0.501,
                            "{law} {end:?} {u:?} {place:?} {part}: {found:?}, not {truth:?}"
                        );
                        let closest = &mut closest[usize::from(place == Place::Outward)];
                        *closest = closest.max(off);
                    }
                }
            }
        }
    }
    assert!(closest[0] > 0.24 && closest[1] > 0.499 && finite > 55, "{closest:?} {finite}");
}
