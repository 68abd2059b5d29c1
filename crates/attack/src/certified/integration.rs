//! Direct integration against itself at other digits, between its own quantities, and against the energy.

use super::decimal::within_a_unit;
use super::energy::{Nodes, solve};
use super::laws::{Request, law, request};
use super::refused;
use crate::Tally;
use crate::random::{Source, by_ratio};
use num_rational::BigRational;
use rand::RngExt;
use restitution_direct::{Collision, DirectError, End};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use rug::Float;

/// What the integrator answers, or `None` with the refusal noted.
pub fn integrated(request: &Request, digits: usize, tally: &mut Tally) -> Option<Ball> {
    let found = Collision::new(&request.law, request.end).and_then(|c| c.epsilon(&request.u, digits));
    match found {
        Ok(value) => Some(value),
        Err(DirectError::Overdamped { .. }) => {
            tally.count("bodies that do not separate", 1);
            None
        }
        Err(error) => {
            refused(&request.to_string(), &error.to_string(), tally);
            None
        }
    }
}

/// Checks that the digits of `value` are there, that `other` agrees with them, and that both overlap.
pub fn confirmed(what: &dyn Fn() -> String, value: &Ball, other: &Ball, digits: usize, tally: &mut Tally) {
    let Some(shown) = value.to_digits(digits) else {
        return tally.fault("digits are proved or refused", what());
    };
    tally.count("numbers confirmed by another way", 1);
    tally.expect(within_a_unit(other, &shown), "a printed digit is right", || {
        format!("{} prints {shown}, but {}", what(), other.mid().to_string_radix(10, Some(digits + 10)))
    });
    tally.expect(value.overlaps(other), "enclosures contain the value", || {
        format!("{}: {value:?}, but {other:?}", what())
    });
}

/// The same request at more digits.
pub fn other_digits(random: &mut Source, tally: &mut Tally) {
    let request = request(random);
    let more = request.digits + random.random_range(1..20);
    let first = integrated(&request, request.digits, tally);
    let second = integrated(&request, more, tally);
    match (first, second) {
        (Some(first), Some(second)) => {
            confirmed(&|| request.to_string(), &first, &second, request.digits, tally);
        }
        (None, None) => {}
        _ => tally.fault(
            "the same request at other digits is answered or refused alike",
            format!("{request} and {more}"),
        ),
    }
}

/// `1 - epsilon` against `epsilon` with the digits that cancel.
pub fn loss(random: &mut Source, tally: &mut Tally) {
    let request = request(random);
    let Ok(collision) = Collision::new(&request.law, request.end) else { return };
    let Ok(loss) = collision.one_minus_epsilon(&request.u, request.digits) else { return };
    let lost = -loss.to_f64().abs().log10().floor();
    let Some(epsilon) = integrated(&request, request.digits + 5 + lost.max(0.0) as usize, tally) else {
        return tally.fault("a loss has a coefficient", request);
    };
    let one = Ball::from_integer(1, epsilon.prec());
    confirmed(&|| format!("{request} --quantity loss"), &loss, &(one - &epsilon), request.digits, tally);
}

/// The enclosure over an interval of dampings contains the values inside.
pub fn interval(random: &mut Source, tally: &mut Tally) {
    let request = request(random);
    let Ok(collision) = Collision::new(&request.law, request.end) else { return };
    let middle = Ball::from_rational(&request.u, 128);
    let width = Float::with_val(64, middle.mid() * by_ratio(random, 1e-30, 1e-3));
    let wide = middle.clone().widened(&width);
    let Ok(enclosure) = collision.enclose(&wide, 128) else { return };
    for _ in 0..2 {
        let off = Float::with_val(128, &width * (2.0 * random.random::<f64>() - 1.0));
        let inside = Float::with_val(128, middle.mid() + &off);
        match collision.enclose(&Ball::exact(inside.clone()), 160) {
            Ok(value) => {
                tally.count("values inside an enclosure of an interval", 1);
                tally.expect(
                    value.overlaps(&enclosure),
                    "an enclosure over an interval contains its values",
                    || format!("{request}, {wide:?}: {enclosure:?} and {value:?} at {inside}"),
                );
            }
            Err(error) => tally
                .fault("an enclosure over an interval contains its values", format!("{request}: {error}")),
        }
    }
}

/// More damping costs more speed; the spell of attraction costs speed; time runs both ways.
pub fn order(random: &mut Source, tally: &mut Tally) {
    let request = Request { digits: 12, ..request(random) };
    let more = Request { u: &request.u * BigRational::new(1001.into(), 1000.into()), ..request.clone() };
    let (Some(one), Some(two)) = (integrated(&request, 12, tally), integrated(&more, 12, tally)) else {
        return;
    };
    tally.count("pairs in order", 1);
    let text = || format!("{request}: {one:?}, then {two:?}");
    tally.expect(!(&two - &one).is_positive(), "epsilon falls with u", text);
    tally.expect(
        one.is_positive() && !(&one - &Ball::from_integer(1, 64)).is_positive(),
        "0 < epsilon <= 1",
        text,
    );
    if request.law.a() > request.law.gamma() {
        let [compression, force] = [End::ZeroCompression, End::ZeroForce]
            .map(|end| integrated(&Request { end, ..request.clone() }, 12, tally));
        if let (Some(compression), Some(force)) = (compression, force) {
            tally.expect(!(&compression - &force).is_positive(), "attraction costs speed", || {
                format!("{request}: {compression:?} at zero compression, {force:?} at zero force")
            });
        }
    }
}

/// The collocation of the energy: another kind of integration at a random damping of its own.
pub fn energy(random: &mut Source, tally: &mut Tally) {
    let law = law(random);
    let kappa = by_ratio(random, 1e-3, 6.0);
    let counts = if random.random_bool(0.1) { (110, 140) } else { (32, 44) };
    let reach = if counts.0 > 100 { 4.2 } else { 3.6 };
    let run = |count| solve(&law, kappa, Nodes { count, reach });
    let (Some(coarse), Some(fine)) = (run(counts.0), run(counts.1)) else {
        return tally.count("collocations that do not converge", 1);
    };
    let off = |one: &Float, other: &Float| Float::with_val(64, one - other).abs().to_f64() / other.to_f64();
    let in_u = off(&coarse.u, &fine.u);
    let pairs = [
        (End::ZeroCompression, &coarse.zero_compression, &fine.zero_compression),
        (End::ZeroForce, &coarse.zero_force, &fine.zero_force),
    ];
    for (end, coarse, value) in pairs {
        let (Some(coarse), Some(value)) = (coarse, value) else { continue };
        // The finer run is better than their difference; how u errs reaches epsilon by its slope, which is at most
        // some units; a hundred covers both.
        let tolerance = (100.0 * (off(coarse, value) + in_u)).max(1e-48);
        if tolerance < 1e-6 {
            against_energy(&law, &fine.u, end, value, tolerance, tally);
        } else {
            tally.count("collocations that converge to fewer than six digits", 1);
        }
    }
}

fn against_energy(law: &ForceLaw, u: &Float, end: End, value: &Float, tolerance: f64, tally: &mut Tally) {
    let Ok(collision) = Collision::new(law, end) else { return };
    let text = || format!("law {law}, {end:?}, u = {}", u.to_string_radix(10, Some(25)));
    let integrated = match collision.enclose(&Ball::exact(u.clone()), 192) {
        Ok(integrated) => integrated,
        Err(DirectError::Overdamped { .. }) if *value < 1e-4 => return,
        Err(DirectError::Overdamped { .. }) => {
            return tally.fault("bodies that separate are said to", format!("{} has {value}", text()));
        }
        Err(error) => return refused(&text(), &error.to_string(), tally),
    };
    tally.count("numbers confirmed by the energy", 1);
    tally.measure("digits confirmed by the energy", -tolerance.log10());
    let off = Float::with_val(64, integrated.mid() - value).abs().to_f64() / value.to_f64();
    tally.expect(off <= tolerance, "a printed digit is right", || {
        format!(
            "{}: {}, by the energy {}, off by {off:e}",
            text(),
            integrated.mid().to_string_radix(10, Some(30)),
            value.to_string_radix(10, Some(30))
        )
    });
}
