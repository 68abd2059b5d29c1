//! Materials against closed forms, limits and an integration of the equation of motion in physical units.

use crate::support::{cases, generator};
use proptest::prelude::*;
use restitution::{
    Contact, Course, DissipationFormula, End, Material, MaterialError, Plane, Sphere, Validity, Verdict,
    ViscoelasticContact, characteristic_velocity_from, combined_dissipative_constant, dissipative_constant,
};

const ENDS: [End; 2] = [End::ZeroCompression, End::ZeroForce];

fn material() -> impl Strategy<Value = Material> {
    let logarithms = (4.0..12.0_f64, -0.9..0.49_f64, 1.0..4.5_f64);
    logarithms.prop_map(|(y, nu, d)| Material::new(10_f64.powf(y), nu, 10_f64.powf(d)).unwrap())
}

fn contact() -> impl Strategy<Value = Contact> {
    (-6.0..3.0_f64, -15.0..6.0_f64, 3.0..12.0_f64)
        .prop_map(|(r, m, e)| Contact::new(10_f64.powf(r), 10_f64.powf(m), 10_f64.powf(e)).unwrap())
}

fn close(a: f64, b: f64, ulps: f64) -> bool {
    (a - b).abs() <= ulps * f64::EPSILON * b.abs()
}

#[test]
fn equal_spheres_have_the_prefactor_of_equation_2() {
    let strategy = (material(), -4.0..1.0_f64);
    generator(1, cases(300))
        .run(&strategy, |(material, log_r)| {
            let sphere = Sphere::new(material, 10_f64.powf(log_r)).unwrap();
            let pair = Contact::of_spheres(&sphere, &sphere).unwrap();
            let (y, nu) = (material.young(), material.poisson());
            let rho = 2.0 * y * (sphere.radius() / 2.0).sqrt() / (3.0 * (1.0 - nu * nu));
            // 1 - nu^2 is written in two ways
            prop_assert!(close(pair.force_prefactor(), rho, 20.0));
            prop_assert!(close(pair.effective_mass(), sphere.mass() / 2.0, 4.0));
            Ok(())
        })
        .unwrap();
}

#[test]
fn a_large_and_heavy_sphere_is_a_plane() {
    let glass = Material::new(63e9, 0.23, 2500.0).unwrap();
    let bead = Sphere::new(glass, 1e-3).unwrap();
    let huge = Sphere::new(glass, 1e13).unwrap();
    let plane = Contact::with_plane(&bead, Plane::Of(glass)).unwrap();
    let limit = Contact::of_spheres(&bead, &huge).unwrap();
    assert!(close(limit.force_prefactor(), plane.force_prefactor(), 4.0));
    assert!(close(limit.effective_mass(), plane.effective_mass(), 4.0));
    let rigid = Contact::with_plane(&bead, Plane::Rigid).unwrap();
    assert!(close(rigid.effective_modulus(), 2.0 * plane.effective_modulus(), 4.0));
}

#[test]
fn both_formulas_give_the_relaxation_time_of_a_proportional_material() {
    let strategy = (material(), -9.0..0.0_f64);
    generator(2, cases(300))
        .run(&strategy, |(m, log_tau)| {
            let (y, nu, tau) = (m.young(), m.poisson(), 10_f64.powf(log_tau));
            let (eta_1, eta_2) = (tau * y / (1.0 + nu), tau * y / (3.0 * (1.0 - 2.0 * nu)));
            let corrected = dissipative_constant(&m, eta_1, eta_2, DissipationFormula::Goldobin2015).unwrap();
            prop_assert!(close(corrected, tau, 60.0), "{corrected} {tau}");
            if nu.abs() > 0.05 {
                // 3 eta_2 - eta_1 cancels as nu goes to 0
                let paper = dissipative_constant(&m, eta_1, eta_2, DissipationFormula::Equation4).unwrap();
                prop_assert!(close(paper, tau, 2000.0), "{paper} {tau}");
            }
            Ok(())
        })
        .unwrap();
}

#[test]
fn equation_4_diverges_and_vanishes_where_the_formula_of_2015_does_neither() {
    let a =
        |nu, formula| dissipative_constant(&Material::new(1e9, nu, 1e3).unwrap(), 1e4, 1e4, formula).unwrap();
    let (paper, corrected) = (DissipationFormula::Equation4, DissipationFormula::Goldobin2015);
    assert!(a(1e-6, paper) > 1e10 * a(0.1, paper) / 1e3);
    assert!(a(0.5 - 1e-9, paper) < 1e-7 * a(0.1, paper));
    assert!(close(a(1e-12, corrected), (2.0 / 3.0 + 1.0) * 1e4 / 1e9, 1e5));
    assert!(a(0.5 - 1e-9, corrected) > 0.1 * a(0.1, corrected));
}

#[test]
fn two_materials_combine_by_compliance() {
    let strategy = (material(), material(), -9.0..0.0_f64, -9.0..0.0_f64);
    generator(3, cases(300))
        .run(&strategy, |(one, other, a, b)| {
            let (a, b) = (10_f64.powf(a), 10_f64.powf(b));
            let both = combined_dissipative_constant((&one, a), (&other, b)).unwrap();
            let swapped = combined_dissipative_constant((&other, b), (&one, a)).unwrap();
            prop_assert!(close(both, swapped, 8.0) || (both - swapped).abs() < 4.0 * f64::EPSILON * a.max(b));
            prop_assert!(both >= a.min(b) * (1.0 - 1e-15) && both <= a.max(b) * (1.0 + 1e-15));
            prop_assert_eq!(combined_dissipative_constant((&one, a), (&one, a)).unwrap(), a);
            Ok(())
        })
        .unwrap();
}

#[test]
fn a_measurement_fixes_the_curve_and_comes_back() {
    let strategy = (contact(), -6.0..3.0_f64, 0.001..0.9999_f64);
    let mut worst = 0.0_f64;
    generator(4, cases(500))
        .run(&strategy, |(contact, log_g, epsilon)| {
            let g = 10_f64.powf(log_g);
            for end in ENDS {
                let pair = ViscoelasticContact::from_measurement(contact, g, epsilon, end).unwrap();
                let back = pair.epsilon(g, end).unwrap();
                prop_assert!(close(back, epsilon, 12.0), "{back} {epsilon}");
                let g_star = pair.characteristic_velocity().unwrap();
                prop_assert!(close(g_star, characteristic_velocity_from(g, epsilon, end).unwrap(), 60.0));
                let again = ViscoelasticContact::from_characteristic_velocity(contact, g_star).unwrap();
                prop_assert!(close(again.dissipative_constant(), pair.dissipative_constant(), 12.0));
            }
            Ok(())
        })
        .unwrap();
    for k in 1..1000 {
        let epsilon = f64::from(k) / 1000.0;
        for end in ENDS {
            let contact = Contact::new(0.01, 1.0, 1e9).unwrap();
            let pair = ViscoelasticContact::from_measurement(contact, 0.1, epsilon, end).unwrap();
            worst = worst.max((pair.epsilon(0.1, end).unwrap() / epsilon - 1.0).abs() / f64::EPSILON);
        }
    }
    println!("largest error of a round trip through A: {worst} epsilon");
    assert!(worst <= 12.0);
}

#[test]
fn characteristic_velocity_is_where_the_first_term_is_one() {
    // eqs. (31), (32): s = (g/g*)^(1/5) = 1.1534... u
    let contact = Contact::new(0.01, 0.1, 1e9).unwrap();
    let pair = ViscoelasticContact::from_characteristic_velocity(contact, 0.0032).unwrap();
    let u = pair.u(0.0032).unwrap();
    assert!(close(u * 1.153_448_858_095_288, 1.0, 8.0));
    // and delta of eq. (14) is (3/2) (5/4)^(3/5) A (rho/m_eff)^(2/5) g^(1/5)
    let rate = (contact.force_prefactor() / contact.effective_mass()).powf(0.4) * 0.0032_f64.powf(0.2);
    let delta = 1.5 * 1.25_f64.powf(0.6) * pair.dissipative_constant() * rate;
    assert!(close(pair.delta(0.0032).unwrap(), delta, 8.0));
}

/// `y_k` of (A24)-(A27) and the next, exact (tests/data of the series engine hold them to more digits).
const Y: [f64; 5] = [
    1.093_362_073_943_278,
    -0.504_454_894_269_828_3,
    0.284_043_018_901_854_44,
    -0.170_220_778_497_264_93,
    0.105_500_709_054_154_38,
];

#[test]
fn the_turning_point_has_the_expansion_of_the_appendix() {
    for k in 1..=20 {
        let u = f64::from(k) * 1e-3;
        let expansion = Y.iter().rev().fold(0.0, |sum, y| sum * u + y);
        let course = Course::follow(u, End::ZeroForce).unwrap();
        // the next term is y_5 u^5 with |y_5| < |y_4|
        assert!((course.maximal_compression - expansion).abs() < 0.11 * u.powi(5) + 4e-16, "u = {u}");
    }
}

/// Maximal compression, time to it, and durations to zero compression and to zero force, from
/// `tests/data/course.csv`.
#[test]
fn courses_agree_with_another_integration() {
    let mut worst = 0.0_f64;
    let mut rows = 0;
    for line in include_str!("../data/course.csv").lines().filter(|line| line.starts_with(char::is_numeric)) {
        let values = line.split(',').map(|cell| cell.parse().unwrap()).collect::<Vec<f64>>();
        let [u, compression, turning, zero_compression, zero_force] = values[..] else { panic!("{line}") };
        let slow = Course::follow(u, End::ZeroCompression).unwrap();
        let quick = Course::follow(u, End::ZeroForce).unwrap();
        for (found, wanted) in [
            (slow.maximal_compression, compression),
            (slow.time_to_turning, turning),
            (slow.duration, zero_compression),
            (quick.duration, zero_force),
        ] {
            worst = worst.max((found / wanted - 1.0).abs());
        }
        rows += 1;
    }
    println!("largest relative error of a course: {worst:.2e} over {rows} values of u");
    assert!(rows >= 10 && worst < 1e-13);
}

#[test]
fn courses_are_refused_outside_their_range() {
    for u in [-1.0, -f64::MIN_POSITIVE, 20.1, f64::INFINITY, f64::NAN] {
        assert_eq!(Course::follow(u, End::ZeroForce), None);
    }
    for u in [0.0, f64::MIN_POSITIVE, 1e-300, 1e-17, 1e-8, 1e-4] {
        for end in ENDS {
            let course = Course::follow(u, end).unwrap();
            // first order in u: the start of the exit at zero force is earlier by about u
            assert!((course.duration - 3.218_065_459_719_043).abs() <= 2.0 * u + 1e-14, "u = {u}");
        }
    }
}

#[test]
fn a_collision_in_physical_units_is_the_scaled_one() {
    // velocity Verlet with the damping at the full step, in kg, m, s; second order
    let steel = Material::new(210e9, 0.3, 7800.0).unwrap();
    let ball = Sphere::new(steel, 0.01).unwrap();
    let contact = Contact::with_plane(&ball, Plane::Of(steel)).unwrap();
    let pair = ViscoelasticContact::new(contact, 1e-6).unwrap();
    let (g, rho, m) = (0.7, contact.force_prefactor(), contact.effective_mass());
    let dt = contact.time_unit(g).unwrap() / 20_000.0;
    let (mut x, mut v, mut t, mut deepest) = (0.0_f64, g, 0.0, 0.0_f64);
    let acceleration = |x: f64, v: f64| -rho / m * x.sqrt() * (x + 1.5 * 1e-6 * v);
    while x >= 0.0 {
        let middle = v + 0.5 * dt * acceleration(x, v);
        let reached = x + dt * middle;
        v = middle + 0.5 * dt * acceleration(reached.max(0.0), middle);
        (x, t, deepest) = (reached, t + dt, deepest.max(reached));
    }
    let course = pair.course(g, End::ZeroCompression).unwrap().unwrap();
    assert!((-v / g - pair.epsilon(g, End::ZeroCompression).unwrap()).abs() < 1e-4);
    assert!((t / course.duration - 1.0).abs() < 1e-4);
    assert!((deepest / course.maximal_compression - 1.0).abs() < 1e-4);
    assert!(deepest < pair.elastic_compression(g).unwrap());
}

#[test]
fn validity_says_what_fails() {
    let rubber = Material::new(1e6, 0.49, 1100.0).unwrap();
    let ball = Sphere::new(rubber, 0.02).unwrap();
    let contact = Contact::of_spheres(&ball, &ball).unwrap();
    let pair = ViscoelasticContact::from_measurement(contact, 1.0, 0.7, End::ZeroForce).unwrap();
    let verdicts = |g| Validity::of(&pair, &rubber, g).unwrap().ratios().map(|(_, ratio)| Verdict::of(ratio));
    assert_eq!(verdicts(1e-3), [Verdict::Holds; 3]);
    assert_eq!(verdicts(20.0)[0], Verdict::Violated);
    assert_eq!(Verdict::of(f64::NAN), Verdict::Violated);
    // A/t_c = (2/3) u/3.218 to first order
    let weak = ViscoelasticContact::new(contact, 1e-9).unwrap();
    let ratio = Validity::of(&weak, &rubber, 0.1).unwrap().relaxation_over_duration;
    assert!((ratio / (weak.u(0.1).unwrap() / 1.5 / 3.218_065_459_719_043) - 1.0).abs() < 1e-3);
}

#[test]
fn nothing_panics_and_nonsense_is_refused() {
    let odd = [
        0.0,
        -0.0,
        -1.0,
        1e-320,
        1e-200,
        0.5,
        1.0,
        1e200,
        f64::MAX,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
    ];
    let mut refused = 0;
    for a in odd {
        for b in odd {
            for c in odd {
                let Ok(contact) = Contact::new(a, b, c) else {
                    refused += 1;
                    continue;
                };
                for d in odd {
                    if let Ok(pair) = ViscoelasticContact::new(contact, d) {
                        let _ = (pair.u(a), pair.delta(b), pair.characteristic_velocity());
                        let _ = (pair.course(a, End::ZeroForce), pair.elastic_duration(b));
                    }
                    let _ = ViscoelasticContact::from_measurement(contact, d, 0.5, End::ZeroCompression);
                    let _ = ViscoelasticContact::from_characteristic_velocity(contact, d);
                }
            }
        }
    }
    assert!(refused > 1000);
    assert!(matches!(Material::new(-1.0, 0.3, 1.0), Err(MaterialError::NotPositive { .. })));
    assert_eq!(Material::new(1.0, 0.5, 1.0).unwrap().compliance(), 0.75); // incompressible, and regular
    for nu in [-1.0, 0.5 + f64::EPSILON, 0.6, f64::NAN] {
        assert!(matches!(Material::new(1.0, nu, 1.0), Err(MaterialError::PoissonRatio { .. })));
    }
    for epsilon in [0.0, 1.0, -0.5, 1.5, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            characteristic_velocity_from(1.0, epsilon, End::ZeroForce),
            Err(MaterialError::Epsilon { .. })
        ));
    }
}
