//! Materials, contacts and fits: a result is a sound number or an error, whatever is put in.

use super::ENDS;
use super::arguments::quantity;
use crate::Tally;
use crate::random::{Source, choose};
use rand::{Rng, RngExt};
use restitution::codes::ConstantRestitution;
use restitution::{
    Contact, DissipationFormula, End, Material, Plane, Sphere, Validity, ViscoelasticContact,
    characteristic_velocity_from, dissipative_constant, time_step_error, time_step_for,
};
use restitution_fit::{Loss, Measurement, fit};

pub(super) fn attack(random: &mut Source, tally: &mut Tally) {
    for _ in 0..16 {
        tally.count("materials and contacts", 1);
        constant_law(random, tally);
        bodies(random, tally);
        let end = *choose(random, &ENDS);
        let number = |random: &mut Source| quantity(random, 1e-6, 1e6);
        let (one, other, third) = (number(random), number(random), number(random));
        let asked = format!("({one:e}, {other:e}, {third:e}, {end:?})");
        let Ok(solid) = Material::new(third, 0.3, 1000.0) else { continue };
        let formula = *choose(random, &[DissipationFormula::Equation4, DissipationFormula::Goldobin2015]);
        positive(
            dissipative_constant(&solid, one, other, formula),
            "dissipative_constant",
            &asked,
            tally,
            true,
        );
        positive(
            characteristic_velocity_from(one, random.random(), end),
            "characteristic_velocity_from",
            &asked,
            tally,
            false,
        );
        positive(time_step_error(one, other), "time_step_error", &asked, tally, true);
        positive(time_step_for(one, other), "time_step_for", &asked, tally, false);
    }
    measurements(random, tally);
}

/// An `Ok` must hold a positive finite number, or zero where that is allowed.
fn positive<E>(result: Result<f64, E>, name: &str, asked: &str, tally: &mut Tally, or_zero: bool) {
    if let Ok(value) = result {
        let sound = value.is_finite() && (value > 0.0 || (or_zero && value == 0.0));
        tally.expect(sound, "an Ok holds a sound number", || format!("{name}{asked} = {value:e}"));
    }
}

fn constant_law(random: &mut Source, tally: &mut Tally) {
    let x = quantity(random, 1e-6, 1e3);
    let laws =
        [("of_betan", ConstantRestitution::of_betan(x)), ("of_epsilon", ConstantRestitution::of_epsilon(x))];
    for (name, law) in laws {
        let Ok(law) = law else { continue };
        for end in ENDS {
            let value = law.epsilon(end);
            tally.expect((0.0..=1.0).contains(&value), "0 <= epsilon <= 1", || {
                format!("ConstantRestitution::{name}({x:e}).epsilon({end:?}) = {value:e}")
            });
        }
        tally.expect(
            law.epsilon(End::ZeroForce) >= law.epsilon(End::ZeroCompression),
            "attraction costs speed",
            || format!("ConstantRestitution::{name}({x:e})"),
        );
    }
}

/// Random bodies, their contact, and what it does.
fn bodies(random: &mut Source, tally: &mut Tally) {
    let poisson = *choose(random, &[0.3, 0.0, -0.5, 0.49, 0.4999999999999999, 0.5, f64::NAN]);
    let material = Material::new(quantity(random, 1e5, 1e12), poisson, quantity(random, 1.0, 2e4));
    let radius = quantity(random, 1e-6, 10.0);
    let contact = match random.next_u32() % 3 {
        0 => material.and_then(|m| Sphere::new(m, radius)).and_then(|s| Contact::of_spheres(&s, &s)),
        1 => material.and_then(|m| Contact::with_plane(&Sphere::new(m, radius)?, Plane::Of(m))),
        _ => Contact::new(radius, quantity(random, 1e-9, 1e3), quantity(random, 1e5, 1e12)),
    };
    let Ok(contact) = contact else { return };
    let asked = format!("{contact:?}");
    let parts = [contact.effective_radius(), contact.effective_mass(), contact.effective_modulus()];
    for part in parts.into_iter().chain([contact.force_prefactor()]) {
        positive(Ok::<_, ()>(part), "a part of ", &asked, tally, false);
    }
    let pair = match random.next_u32() % 3 {
        0 => ViscoelasticContact::new(contact, quantity(random, 1e-9, 1.0)),
        1 => ViscoelasticContact::from_characteristic_velocity(contact, quantity(random, 1e-6, 1e6)),
        _ => ViscoelasticContact::from_measurement(
            contact,
            quantity(random, 1e-6, 1e2),
            random.random(),
            *choose(random, &ENDS),
        ),
    };
    if let Ok(pair) = pair {
        collisions(&pair, material.ok(), quantity(random, 1e-6, 1e2), tally);
    }
}

/// What a pair of bodies does at an impact velocity.
fn collisions(pair: &ViscoelasticContact, material: Option<Material>, velocity: f64, tally: &mut Tally) {
    let asked = format!("({velocity:e}) of {pair:?}");
    positive(pair.characteristic_velocity(), "characteristic_velocity", &asked, tally, false);
    positive(pair.u(velocity), "u", &asked, tally, true);
    positive(pair.delta(velocity), "delta", &asked, tally, true);
    positive(pair.elastic_duration(velocity), "elastic_duration", &asked, tally, false);
    positive(pair.elastic_compression(velocity), "elastic_compression", &asked, tally, false);
    for end in ENDS {
        if let Ok(value) = pair.epsilon(velocity, end) {
            tally.expect((0.0..=1.0).contains(&value), "0 <= epsilon <= 1", || {
                format!("epsilon{asked} = {value:e}")
            });
        }
    }
    // A course takes some hundred steps: not for every pair.
    if velocity.to_bits().is_multiple_of(8)
        && let Some(Ok(validity)) = material.map(|material| Validity::of(pair, &material, velocity))
    {
        for (name, ratio) in validity.ratios() {
            tally.expect(ratio >= 0.0, "an Ok holds a sound number", || format!("{name}{asked} = {ratio:e}"));
        }
    }
}

/// A fit of a few rows, sound or absurd.
fn measurements(random: &mut Source, tally: &mut Tally) {
    tally.count("fits", 1);
    let count = random.random_range(0..12);
    let absurd = random.random_bool(0.3);
    let (low, high) = if absurd { (1e-300, 1e300) } else { (1e-3, 1e1) };
    let row = |random: &mut Source| {
        Measurement::new(quantity(random, low, high), quantity(random, if absurd { low } else { 0.1 }, 1.0))
    };
    let rows: Vec<Measurement> = (0..count).filter_map(|_| row(random).ok()).collect();
    let end = *choose(random, &ENDS);
    let loss = *choose(random, &[Loss::Squares, Loss::Huber]);
    if let Ok(found) = fit(&rows, end, loss) {
        let sound = found.characteristic_velocity > 0.0
            && found.characteristic_velocity.is_finite()
            && !found.log_error.is_nan()
            && !found.scatter.is_nan();
        tally.expect(sound, "an Ok holds a sound number", || {
            format!("fit({rows:?}, {end:?}, {loss:?}) = {found:?}")
        });
    }
}
