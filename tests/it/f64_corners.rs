//! Every public f64 function of `restitution` over extreme, subnormal, infinite and missing numbers: an error or a
//! number that is one, never `Ok` with NaN or infinity.

use restitution::codes::{
    ConstantRestitution, EsysParticle, LammpsGranular, LammpsHertzHistory, Liggghts, MercuryDpm, Yade,
};
use restitution::*;
use std::fmt::Debug;

const ENDS: [End; 2] = [End::ZeroCompression, End::ZeroForce];
const CORNERS: [f64; 24] = [
    0.0,
    -0.0,
    5e-324,
    -5e-324,
    1e-310,
    f64::MIN_POSITIVE,
    1e-300,
    1e-160,
    1e-100,
    1e-20,
    f64::EPSILON / 2.0,
    0.3,
    0.499_999_999_999_999_94,
    0.999_999_999_999_999_9,
    1.0,
    1.000_000_000_000_000_2,
    7.0,
    1e20,
    1e100,
    1e160,
    1e273,
    f64::MAX,
    f64::INFINITY,
    f64::NAN,
];

/// The number of an answer is a number.
fn sound<E: Debug>(value: Result<f64, E>, what: impl Fn() -> String) {
    if let Ok(value) = value {
        assert!(value.is_finite(), "{}: Ok({value})", what());
    }
}

/// `f` of every pair of corners.
fn pairs(f: impl Fn(f64, f64)) {
    CORNERS.iter().for_each(|a| CORNERS.iter().for_each(|b| f(*a, *b)));
}

#[test]
fn the_evaluator() {
    pairs(|scale, g| {
        for end in ENDS {
            let laws =
                [Restitution::from_g_star(scale, end), Restitution::from_u_at_unit_velocity(scale, end)];
            for law in laws {
                let (kept, lost) = (law.epsilon(g), law.one_minus_epsilon(g));
                assert_eq!(kept.is_nan(), law.u(1.0).is_nan() || g.is_nan() || g < 0.0, "{scale:e} {g:e}");
                assert!(kept.is_nan() || (0.0..=1.0).contains(&kept) && (0.0..=1.0).contains(&lost));
                let mut out = [0.0];
                law.epsilon_batch(&[g], &mut out);
                assert_eq!(out[0].to_bits(), kept.to_bits());
            }
        }
    });
    for x in CORNERS {
        for end in ENDS {
            assert_eq!(epsilon(x, end).is_nan(), !(0.0..=f64::INFINITY).contains(&x), "{x:e}");
            assert_eq!(one_minus_epsilon(x, end).is_nan(), !(0.0..=f64::INFINITY).contains(&x), "{x:e}");
            assert_eq!(u_of_epsilon(x, end).is_nan(), !(0.0..=1.0).contains(&x), "{x:e}");
        }
        assert_eq!(fifth_root(x).is_nan(), x.is_nan());
    }
}

#[test]
fn the_constant_law() {
    for x in CORNERS {
        for law in
            [ConstantRestitution::of_betan(x), ConstantRestitution::of_epsilon(x)].into_iter().flatten()
        {
            for end in ENDS {
                let kept = law.epsilon(end);
                assert!((0.0..=1.0).contains(&kept), "{x:e}: {kept}");
            }
            assert!(law.zeta().is_finite() && law.betan().is_finite());
        }
    }
    // The overdamped dashpot, epsilon = exp(-(2 zeta/w) ln(zeta + w)), w = sqrt(zeta^2 - 1): (2 zeta)^-2 for large zeta.
    let law = ConstantRestitution::of_betan(1e100).unwrap();
    assert!((law.epsilon(End::ZeroForce) * (2.0 * law.zeta()).powi(2) - 1.0).abs() < 1e-12);
}

#[test]
fn materials_and_contacts() {
    let solids = || {
        CORNERS.iter().flat_map(|young| [1e-3, 2e3].map(|density| (*young, 0.3, density))).chain(
            CORNERS.iter().flat_map(|x| [(1e9, 0.3, *x), (1e9, *x, 1e3), (1e9, -*x, 1e3), (*x, *x, *x)]),
        )
    };
    for (young, poisson, density) in solids() {
        let Ok(material) = Material::new(young, poisson, density) else { continue };
        assert!(material.compliance().is_normal() && material.sound_speed().is_normal(), "{material:?}");
        pairs(|a, b| {
            for formula in [DissipationFormula::Equation4, DissipationFormula::Goldobin2015] {
                sound(dissipative_constant(&material, a, b, formula), || format!("{material:?} {a:e} {b:e}"));
            }
            let soft = Material::new(1e-200, 0.3, 1e-200).unwrap();
            sound(combined_dissipative_constant((&material, a), (&soft, b)), || format!("{a:e} {b:e}"));
        });
        for radius in CORNERS.into_iter().step_by(3) {
            let Ok(sphere) = Sphere::new(material, radius) else { continue };
            assert!(sphere.mass().is_normal());
            for contact in [
                Contact::of_spheres(&sphere, &sphere),
                Contact::with_plane(&sphere, Plane::Rigid),
                Contact::with_plane(&sphere, Plane::Of(material)),
            ] {
                contact.into_iter().for_each(|contact| collisions(contact, &material));
            }
        }
    }
    for radius in CORNERS.into_iter().step_by(3) {
        pairs(|mass, modulus| {
            for contact in
                [Contact::new(radius, mass, modulus), Contact::with_prefactor(radius, mass, modulus)]
            {
                contact
                    .into_iter()
                    .for_each(|contact| collisions(contact, &Material::new(1e9, 0.3, 1e3).unwrap()));
            }
        });
    }
}

/// Everything that a contact answers.
fn collisions(contact: Contact, material: &Material) {
    let numbers = [
        contact.effective_radius(),
        contact.effective_mass(),
        contact.effective_modulus(),
        contact.force_prefactor(),
    ];
    assert!(numbers.iter().all(|x| x.is_finite() && *x > 0.0), "{contact:?}");
    for g in CORNERS.into_iter().step_by(2) {
        sound(contact.time_unit(g), || format!("{contact:?} {g:e}"));
        let pairs = [1e-300, 1e-5, 1e300].into_iter().flat_map(|a| {
            [
                ViscoelasticContact::new(contact, a),
                ViscoelasticContact::from_characteristic_velocity(contact, a),
                ViscoelasticContact::from_measurement(contact, a, 0.5, End::ZeroForce),
            ]
        });
        for pair in pairs.flatten() {
            let what = || format!("{pair:?} at {g:e}");
            sound(pair.u(g), what);
            sound(pair.delta(g), what);
            sound(pair.characteristic_velocity(), what);
            sound(pair.elastic_duration(g), what);
            sound(pair.elastic_compression(g), what);
            ENDS.iter().for_each(|end| sound(pair.epsilon(g, *end), what));
            if !pair.u(g).is_ok_and(|u| (1e-3..1.0).contains(&u)) {
                continue; // following a course takes its time
            }
            if let Ok(Some(course)) = pair.course(g, End::ZeroForce) {
                sound::<()>(Ok(course.duration + course.maximal_compression), what);
            }
            if let Ok(validity) = Validity::of(&pair, material, g) {
                validity.ratios().iter().for_each(|(_, ratio)| sound::<()>(Ok(*ratio), what));
            }
        }
    }
}

#[test]
fn measurements_and_time_steps() {
    pairs(|a, b| {
        let what = || format!("{a:e} {b:e}");
        for end in ENDS {
            sound(characteristic_velocity_from(a, b, end), what);
        }
        sound(time_step_error(a, b), what);
        sound(time_step_for(a, b), what);
        if let Ok(row) = restitution_fit::Measurement::new(a, b) {
            assert!(row.velocity().is_finite() && row.epsilon().is_finite());
        }
    });
}

#[test]
fn inputs_of_codes() {
    pairs(|a, b| {
        let what = || format!("{a:e} {b:e}");
        let check = |pair: Result<ViscoelasticContact, MaterialError>| {
            sound(pair.map(|pair| pair.dissipative_constant()), what);
        };
        for (radius, mass) in [(1e-3, 1e-6), (1e-150, 1e150), (1e150, 1e-150)] {
            check(LammpsGranular { k_n: a, eta_n0: b, end: ENDS[0] }.contact(radius, mass));
            check(LammpsHertzHistory { kn: a, gamma_n: b }.contact(radius, mass));
            check(Liggghts { kn: a, gamman: b, end: ENDS[1] }.contact(radius, mass));
            check(MercuryDpm { effective_elastic_modulus: a, dissipation: b }.contact(radius, mass));
            check(EsysParticle { a, young: b, poisson: 0.3 }.contact(radius, mass));
            check(Yade { en: 0.5, vn: a, effective_modulus: b }.contact(radius, mass));
        }
        if let Ok(input) = LammpsGranular::of_material(a, 0.3, b, ENDS[0]) {
            assert!(input.k_n.is_finite() && input.eta_n0.is_finite(), "{}", what());
        }
        if let Ok(input) = Yade::measured(a, b, 1e9) {
            for g in CORNERS {
                sound(input.u(g), what);
                sound(input.epsilon(g), what);
            }
            sound(input.formula_error(), what);
        }
        if let Ok(contact) = Contact::new(1e-3, 1e-6, a)
            && let Ok(pair) = ViscoelasticContact::new(contact, b)
        {
            if let Ok(input) = EsysParticle::new(&pair, 0.3) {
                assert!(input.a.is_finite() && input.young.is_finite(), "{}", what());
            }
            if let Ok(input) = LammpsGranular::new(&pair, ENDS[0]) {
                assert!(input.k_n.is_finite() && input.eta_n0.is_finite(), "{}", what());
            }
            if let Ok(input) = Yade::new(&pair, 0.1) {
                assert!(input.en.is_finite(), "{}", what());
            }
        }
    });
}
