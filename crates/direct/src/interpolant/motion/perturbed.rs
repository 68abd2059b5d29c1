//! Errors of known size, put into the motion of an interpolant: its remainder has to hold the true coefficient.

use super::super::ends::Found;
use super::super::{Dampings, Variable};
use super::*;
use crate::collision::Collision;
use restitution_real::Ball;
use rug::Float;

/// The same state with all velocities `1 + part` times as large, and the energy between the two.
fn moved(motion: &Motion, state: &State, part: f64) -> State {
    let bits = motion.flow.bits;
    let factor = Integer::from_f64((1.0 + part) * f64::exp2(52.0)).unwrap();
    let v: Vec<Integer> = state.v.iter().map(|c| Integer::from(c * &factor) >> 52).collect();
    let missed: Vec<Integer> = v.iter().zip(&state.v).map(|(new, old)| Integer::from(new - old)).collect();
    let both: Vec<Integer> = v.iter().zip(&state.v).map(|(new, old)| Integer::from(new + old)).collect();
    let size = |c: &[Integer]| crate::fixed::size(c, bits);
    let energy = upper_bound(&(&state.energy + size(&missed) * size(&both)));
    State { v, energy, ..state.clone() }
}

/// The enclosure that is found with an error before the turning point or after it; the loop is that of `Motion::rebound`.
fn with_error(motion: &Motion, outward: bool, part: f64) -> Option<Ball> {
    let (mut stepper, mut state, mut slow) = (motion.stepper(), motion.impact(), false);
    loop {
        if state.measure == Measure::Speed && motion.range(&state.v).high.mid() < &SLOW {
            if !slow && !outward {
                state = moved(motion, &state, part);
            }
            slow = true;
            state = motion.by_force_from(&state).unwrap_or(state);
        }
        if state.measure == Measure::Force
            && motion.serves_speed(&state)
            && let Some(by_speed) = motion.by_speed_from(&state)
        {
            state = if outward { moved(motion, &by_speed, part) } else { by_speed };
            break;
        }
        state = stepper.step(f64::INFINITY, |length| motion.step(&state, length)).ok()?.reached;
    }
    loop {
        let (reached, found) = stepper
            .step(f64::INFINITY, |length| {
                let (leg, slope) = motion.step(&state, length)?;
                let found = motion.end_of_contact(&leg)?;
                Some(((leg.reached, found), slope))
            })
            .ok()?;
        match found {
            Found::Here(exit) => {
                let middle = exit.velocity.row(0)[0].clone();
                let middle = crate::fixed::from_fixed(&middle, exit.velocity.bits, 200);
                return Some((-middle).widened(&exit.error.upper()));
            }
            Found::Beyond => state = reached,
        }
    }
}

#[test]
fn an_error_on_the_way_is_in_the_remainder() {
    let (mut closest, mut finite) = ([0.0_f64; 2], 0);
    for (law, n, d) in
        [("3/2,1/2", 1, 16), ("3/2,1/2", 1, 1), ("2,1", 3, 2), ("1,0", 1, 2), ("1/2,3/2", 1, 1)]
    {
        for end in [End::ZeroCompression, End::ZeroForce] {
            let Ok(collision) = Collision::new(&law.parse().unwrap(), end) else { continue };
            let u = BigRational::new(n.into(), d.into());
            let truth = collision.enclose(&Ball::from_rational(&u, 100), 100).unwrap();
            let damping = Dampings::of(&u, &u, Variable::Damping, 96);
            let motion = collision.motion(&damping, 1, 64).unwrap();
            for outward in [false, true] {
                for part in [1e-5, -1e-8] {
                    let Some(found) = with_error(&motion, outward, part) else { continue };
                    finite += 1;
                    let off = Float::with_val(100, found.mid() - truth.mid()).abs() / found.rad();
                    let closest = &mut closest[usize::from(outward)];
                    *closest = closest.max(off.to_f64());
                    // |V - v| is the energy over |V| + |v|, taken for energy/|v|: half is left.
                    assert!(off <= 0.501, "{law} {end:?} {outward} {part}: {found:?}, not {truth:?}");
                }
            }
        }
    }
    assert!(closest[0] > 0.2 && closest[1] > 0.48 && finite > 30, "{closest:?} {finite}");
}
