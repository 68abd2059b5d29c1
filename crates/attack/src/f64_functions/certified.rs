//! Errors in units of the last place, against certified values.

use super::limits::{EPSILON_ULP, INVERSE, LOSS_ULP, VELOCITY_ULP};
use crate::Tally;
use crate::random::{Source, by_ratio, near};
use rand::{Rng, RngExt};
use restitution::{End, Restitution, epsilon, one_minus_epsilon, u_of_epsilon};
use restitution_direct::Collision;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use rug::Float;
use rug::float::Round;
use std::sync::OnceLock;

/// Bits of the certified values, before a small loss takes its own.
const PREC: u32 = 160;

/// Digits of a certified value whose size is not known beforehand.
const DIGITS: usize = 25;

fn collision(end: End) -> &'static Collision {
    static COLLISIONS: [OnceLock<Collision>; 2] = [OnceLock::new(), OnceLock::new()];
    let slot = &COLLISIONS[usize::from(end == End::ZeroForce)];
    slot.get_or_init(|| {
        Collision::new(&ForceLaw::viscoelastic_spheres(), end).expect("spheres end their contact either way")
    })
}

/// The error of `value` in units of the last place of `exact`: of the numbers below it, where it lies just below a power of two.
fn ulps(value: f64, exact: &Ball) -> f64 {
    let size = exact.mid().to_f64_round(Round::Zero).abs();
    let ulp = (size.next_up() - size).max(5e-324);
    (Float::with_val(PREC, value - exact.mid()) / ulp).to_f64().abs()
}

pub(super) fn attack(random: &mut Source, end: End, tally: &mut Tally) {
    let u = match random.next_u32() % 8 {
        0 => by_ratio(random, 1e-30, 1e-2),
        1 => f64::from(random.random_range(0..512)) / 64.0,
        2 => by_ratio(random, 250.0, 275.0),
        3 => by_ratio(random, 8.0, 1e4),
        _ => by_ratio(random, 1e-2, 10.0),
    };
    let u = near(random, u, 2);
    if u <= 0.0 {
        return;
    }
    let prec = PREC + u.log2().abs().ceil() as u32;
    let Ok(exact) = collision(end).enclose(&Ball::from_f64(u, prec), prec) else {
        return tally.fault("spheres collide at every u", format!("u = {u:e}, {end:?}"));
    };
    tally.expect(exact.relative_bits().is_some_and(|bits| bits > 70), "enclosures are narrow", || {
        format!("u = {u:e}, {end:?}: {exact:?}")
    });
    tally.count("values compared with certified ones", 3);
    let mut judge = |what: &str, value: f64, exact: &Ball, bound: f64| {
        let error = ulps(value, exact);
        tally.measure(&format!("error of {what}, {end:?}, ulp"), error);
        tally.expect(error <= bound, what, || {
            format!("at u = {u:e} = {:#018x}, {end:?}: off by {error} ulp", u.to_bits())
        });
    };
    judge("epsilon", epsilon(u, end), &exact, EPSILON_ULP);
    judge("1 - epsilon", one_minus_epsilon(u, end), &(Ball::from_integer(1, prec) - &exact), LOSS_ULP);
    from_a_velocity(random, end, tally);
    inverse(random, end, tally);
}

/// The exact coefficient at the inverse against the one asked for.
fn inverse(random: &mut Source, end: End, tally: &mut Tally) {
    let wanted = by_ratio(random, 1e-40, 1.0);
    let u = u_of_epsilon(wanted, end);
    if let Ok(exact) = collision(end).epsilon_of(|prec| Ball::from_f64(u, prec), DIGITS) {
        let off = Float::with_val(PREC, exact.mid() - wanted).to_f64().abs() / wanted;
        tally.measure(&format!("relative distance of the exact coefficient at the inverse, {end:?}"), off);
        tally.expect(off <= INVERSE, "the exact coefficient at the inverse is the one asked for", || {
            format!("u_of_epsilon({wanted:e}, {end:?}) = {u:e}: off by {off:e}")
        });
    }
}

/// `u_1` a power of two: then `u = (u_1^5 g)^(1/5)` is known to any precision.
fn from_a_velocity(random: &mut Source, end: End, tally: &mut Tally) {
    let (k, g) = (random.random_range(-12..12), by_ratio(random, 1e-12, 1e6));
    let curve = Restitution::from_u_at_unit_velocity(2f64.powi(k), end);
    let u = Ball::from_f64(g, PREC + 60).fifth_root().shifted(k);
    if let Ok(exact) = collision(end).enclose(&u, PREC + 60) {
        let error = ulps(curve.epsilon(g), &exact);
        tally.measure(&format!("error of epsilon from a velocity, {end:?}, ulp"), error);
        tally.expect(error <= VELOCITY_ULP, "epsilon from a velocity", || {
            format!("u_1 = 2^{k}, g = {g:e}, {end:?}: off by {error} ulp")
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_those_of_the_exact_value() {
        let exact = |off: f64| Ball::exact(Float::with_val(PREC, 1) + off);
        // Just below 1 numbers are twice as close as above.
        assert_eq!(ulps(1.0, &exact(-(2f64.powi(-55)))), 0.25);
        assert_eq!(ulps(1.0, &exact(2f64.powi(-54))), 0.25);
        assert_eq!(ulps(1.0 - 2f64.powi(-53), &exact(-(2f64.powi(-55)))), 0.75);
    }
}
