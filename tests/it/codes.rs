//! The conventions of the codes against what the codes did when they were run, and the way there and back.
//!
//! The figures are those of LAMMPS 22Jul2025, LIGGGHTS 3.8.0 and YADE 2025.2.0, extrapolated to zero time step.

use crate::support::{cases, generator};
use proptest::prelude::*;
use restitution::codes::{
    Chrono, ConstantCode, ConstantRestitution, EsysParticle, LammpsGranular, LammpsHertzHistory, Liggghts,
    MercuryDpm, Yade,
};
use restitution::{Contact, End, MaterialError, ViscoelasticContact};

/// `u`, then what all codes gave to zero compression and to zero force, to the digits given.
const RUNS: [(f64, f64, f64); 3] =
    [(0.5, 0.5738246287, 0.5952515011), (1.0, 0.3311648105, 0.3939306032), (2.0, 0.0953303654, 0.2116460546)];

/// Effective radius 2.5 mm, mass 1e-4 kg, modulus 7.5 MPa.
fn contact() -> Contact {
    Contact::new(2.5e-3, 1e-4, 7.5e6).unwrap()
}

/// The `A` that makes `u` at velocity `g`, by the definition.
fn a_of(u: f64, g: f64) -> f64 {
    let contact = contact();
    u / (1.5 * (contact.force_prefactor() / contact.effective_mass()).powf(0.4) * g.powf(0.2))
}

fn close(a: f64, b: f64, ulps: f64) -> bool {
    (a - b).abs() <= ulps * f64::EPSILON * b.abs()
}

#[test]
fn inputs_mean_what_the_codes_did() {
    let (g, k_n, m) = (0.3, 1e7, 1e-4); // k_n = (4/3) E
    for (u, zero_compression, zero_force) in RUNS {
        let eta = 1.5 * a_of(u, g) * k_n / m;
        for (end, wanted) in [(End::ZeroCompression, zero_compression), (End::ZeroForce, zero_force)] {
            let lammps = LammpsGranular { k_n, eta_n0: eta, end }.contact(2.5e-3, m).unwrap();
            let liggghts = Liggghts { kn: k_n, gamman: eta, end }.contact(2.5e-3, m).unwrap();
            for pair in [lammps, liggghts] {
                assert!((pair.epsilon(g, end).unwrap() - wanted).abs() < 6e-11, "u = {u}, {end:?}");
            }
        }
        let classic = LammpsHertzHistory { kn: k_n, gamma_n: eta }.contact(2.5e-3, m).unwrap();
        assert!((classic.epsilon(g, End::ZeroCompression).unwrap() - zero_compression).abs() < 6e-11);
        let mercury = MercuryDpm { effective_elastic_modulus: 7.5e6, dissipation: a_of(u, g) };
        let esys = EsysParticle { a: 1.5 * a_of(u, g), young: 2.0 * 7.5e6 * 0.91, poisson: 0.3 };
        for pair in [mercury.contact(2.5e-3, m).unwrap(), esys.contact(2.5e-3, m).unwrap()] {
            assert!((pair.epsilon(g, End::ZeroForce).unwrap() - zero_force).abs() < 6e-11, "u = {u}");
        }
    }
}

#[test]
fn yade_means_its_six_digit_formula() {
    for (u, _, zero_force) in RUNS {
        let pair = ViscoelasticContact::new(contact(), a_of(u, 0.3)).unwrap();
        let input = Yade::new(&pair, 0.3).unwrap();
        assert!(close(input.u(0.3).unwrap(), u, 40.0));
        assert!((input.epsilon(0.3).unwrap() - zero_force).abs() < 6e-11);
        // en is the printed formula at v = sqrt(u)
        let v = u.sqrt();
        let numerator = 1.0 + 1.07232 * v + 0.574198 * v.powi(2) + 0.141552 * v.powi(3);
        let denominator = 1.0
            + 1.07232 * v
            + 1.72765 * v.powi(2)
            + 1.37842 * v.powi(3)
            + 1.19449 * v.powi(4)
            + 0.467273 * v.powi(5)
            + 0.235585 * v.powi(6);
        assert!(close(input.en, numerator / denominator, 8.0));
        assert!((input.formula_error().unwrap() - (zero_force - input.en)).abs() < 1e-10);
        assert!(input.formula_error().unwrap().abs() > 1e-9, "the formula is not epsilon");
    }
}

#[test]
fn every_code_comes_back() {
    let strategy =
        ((-6.0..2.0_f64, -12.0..4.0_f64, 4.0..12.0_f64), -2.0..0.7_f64, -4.0..2.0_f64, -0.9..0.49_f64);
    generator(11, cases(300))
        .run(&strategy, |((r, m, e), log_u, log_g, nu)| {
            let (r, m, e) = (10_f64.powf(r), 10_f64.powf(m), 10_f64.powf(e));
            let (u, g) = (10_f64.powf(log_u), 10_f64.powf(log_g));
            let contact = Contact::new(r, m, e).unwrap();
            let a = u / (1.5 * (contact.force_prefactor() / m).powf(0.4) * g.powf(0.2));
            let pair = ViscoelasticContact::new(contact, a).unwrap();
            let end = End::ZeroForce;
            let back = [
                LammpsGranular::new(&pair, end).unwrap().contact(r, m).unwrap(),
                LammpsHertzHistory::new(&pair).unwrap().contact(r, m).unwrap(),
                Liggghts::new(&pair, end).unwrap().contact(r, m).unwrap(),
                MercuryDpm::new(&pair).contact(r, m).unwrap(),
                EsysParticle::new(&pair, nu).unwrap().contact(r, m).unwrap(),
                Chrono::new(&pair).unwrap().contact(r, m).unwrap(),
            ];
            for other in back {
                prop_assert!(close(other.dissipative_constant(), a, 8.0));
                prop_assert!(close(other.contact().force_prefactor(), contact.force_prefactor(), 8.0));
            }
            let yade = Yade::new(&pair, g).unwrap();
            let again = yade.contact(r, m).unwrap();
            // near en = 1 few digits of u are in en
            let lost = 1.0 / (1.0 - yade.en) + 1.0 / yade.en;
            prop_assert!(close(again.dissipative_constant(), a, 60.0 * lost), "u = {u}");
            Ok(())
        })
        .unwrap();
}

#[test]
fn yade_rebounds_as_measured() {
    for k in 1..100 {
        let epsilon = f64::from(k) / 100.0;
        let input = Yade::measured(epsilon, 0.2, 1e9).unwrap();
        assert!((input.epsilon(0.2).unwrap() / epsilon - 1.0).abs() < 1e-12, "epsilon = {epsilon}");
    }
}

#[test]
fn constant_laws_end_where_the_codes_end_them() {
    for (nominal, run) in [(0.9, 0.90203), (0.7, 0.71820), (0.5, 0.55028), (0.3, 0.39714)] {
        let law = ConstantRestitution::of_epsilon(nominal).unwrap();
        assert!(close(law.epsilon(End::ZeroCompression), nominal, 8.0));
        assert!((law.epsilon(End::ZeroForce) - run).abs() < 6e-6, "{nominal}");
        assert!(close(ConstantRestitution::of_betan(law.betan()).unwrap().zeta(), law.zeta(), 4.0));
    }
    // continuous and falling through critical damping
    let at = |zeta: f64| {
        ConstantRestitution::of_betan(zeta / (2.0 * 0.3_f64.sqrt())).unwrap().epsilon(End::ZeroForce)
    };
    assert!((at(1.0 - 1e-9) - at(1.0 + 1e-9)).abs() < 1e-8);
    assert!((at(1.0) - (-2.0_f64).exp()).abs() < 1e-7);
    for k in 1..400 {
        assert!(at(f64::from(k) * 0.01) < at(f64::from(k - 1) * 0.01), "zeta = {}", f64::from(k) * 0.01);
    }
}

#[test]
fn the_constant_law_solves_its_equation() {
    // x'' + c x^(1/4) x' + x^(3/2) = 0 by small steps, zeta = c/sqrt(5)
    for c in [0.2, 0.8, 1.7, 3.0] {
        let law = ConstantRestitution::of_betan(c / (2.0 * 1.5_f64.sqrt())).unwrap();
        let (mut x, mut v, dt) = (0.0_f64, 1.0_f64, 1e-5);
        let force = |x: f64, v: f64| -c * x.max(0.0).powf(0.25) * v - x.max(0.0).powf(1.5);
        while v > 0.0 || force(x, v) < 0.0 {
            let middle = v + 0.5 * dt * force(x, v);
            x += dt * middle;
            v = middle + 0.5 * dt * force(x, middle);
        }
        assert!((-v - law.epsilon(End::ZeroForce)).abs() < 1e-4, "c = {c}");
    }
}

/// The rebound of `m_eff = 1e-4 kg` at 0.3 m/s under a force of compression and its rate, by small steps of the classical Runge-Kutta method.
fn rebound(force: impl Fn(f64, f64) -> f64, end: End) -> f64 {
    const M: f64 = 1e-4;
    let (mut x, mut v) = (0.0_f64, 0.3_f64);
    let dt = 2e-9; // some 1e5 steps in a collision
    loop {
        let at = |x: f64, v: f64| (v, -force(x.max(0.0), v) / M);
        let (k1, k2, k3, k4);
        k1 = at(x, v);
        k2 = at(x + 0.5 * dt * k1.0, v + 0.5 * dt * k1.1);
        k3 = at(x + 0.5 * dt * k2.0, v + 0.5 * dt * k2.1);
        k4 = at(x + dt * k3.0, v + dt * k3.1);
        x += dt / 6.0 * (k1.0 + 2.0 * k2.0 + 2.0 * k3.0 + k4.0);
        v += dt / 6.0 * (k1.1 + 2.0 * k2.1 + 2.0 * k3.1 + k4.1);
        if x <= 0.0 || (end == End::ZeroForce && v < 0.0 && force(x, v) <= 0.0) {
            return -v / 0.3;
        }
    }
}

#[test]
fn the_forces_of_the_sources_rebound_as_promised() {
    // each force as the source of the code has it, for R_eff = 2.5 mm, m_eff = 1e-4 kg, E = 0.5 GPa, told what `input` says
    let (r, m, e_eff) = (2.5e-3_f64, 1e-4_f64, 5e8_f64);
    for wanted in [0.3, 0.6, 0.9] {
        let told = |code: ConstantCode| {
            let end = code.ends()[0];
            code.input(&ConstantRestitution::that_gives(wanted, end).unwrap()).unwrap()
        };
        let sn = |x: f64| 2.0 * e_eff * (r * x).sqrt();
        let beta = |e: f64, pi_squared: f64| e.ln() / (e.ln().powi(2) + pi_squared).sqrt();
        let pi_squared = std::f64::consts::PI.powi(2);
        let e = told(ConstantCode::Chrono);
        let chrono = rebound(
            |x, v| {
                2.0 / 3.0 * sn(x) * x
                    - 2.0 * (5.0_f64 / 6.0).sqrt() * beta(e, pi_squared) * (sn(x) * m).sqrt() * v
            },
            End::ZeroForce,
        );
        let e = told(ConstantCode::DemEngine);
        let dem_engine = rebound(
            |x, v| {
                2.0 / 3.0 * sn(x) * x
                    - 2.0 * (5.0_f64 / 6.0).sqrt() * beta(e, pi_squared) * (sn(x) * m).sqrt() * v
            },
            End::ZeroCompression,
        );
        let e = told(ConstantCode::Lethe);
        let lethe = rebound(
            |x, v| 0.66665 * sn(x) * x - 1.8257 * beta(e, 9.8696) * (sn(x) * m).sqrt() * v,
            End::ZeroCompression,
        );
        let e = told(ConstantCode::Mfix);
        let hert_kn = 4.0 / 3.0 * r.sqrt() * e_eff;
        let etan = 2.0 * (hert_kn * m).sqrt() * e.ln().abs() / (pi_squared + e.ln().powi(2)).sqrt();
        let mfix = rebound(|x, v| hert_kn * x.sqrt() * x + etan * x.sqrt().sqrt() * v, End::ZeroCompression);
        let e = told(ConstantCode::TrixiParticles);
        let per_overlap = |x: f64| 4.0 * e_eff * (r * x).sqrt() / 3.0;
        // its relative velocity along the normal is that of parting
        let trixi = rebound(
            |x, v| per_overlap(x) * x + e * 2.0 * (m * per_overlap(x)).sqrt() * -v,
            End::ZeroCompression,
        );
        let e = told(ConstantCode::Kratos);
        let h = [
            -6.918798, -16.41105, 146.8049, -796.4559, 2928.711, -7206.864, 11494.29, -11342.18, 6276.757,
            -1489.915,
        ];
        let alpha = (0..10).map(|k| h[k] * e.powi(k as i32 + 1)).sum::<f64>();
        let gamma = (1.0 / (1.0 - (1.0 + e).powi(2) * alpha.exp()) - 1.0).sqrt();
        let kratos =
            rebound(|x, v| 2.0 / 3.0 * sn(x) * x + 2.0 * gamma * (m * sn(x)).sqrt() * v, End::ZeroForce);
        assert!((e - wanted).abs() < 3e-3, "Kratos' fit is a good one: {e}");
        for (code, seen) in [
            ("Chrono", chrono),
            ("DEM-Engine", dem_engine),
            ("Lethe", lethe),
            ("MFiX", mfix),
            ("Trixi", trixi),
            ("Kratos", kratos),
        ] {
            assert!((seen - wanted).abs() < 2e-5, "{code}: {seen} instead of {wanted}");
        }
    }
    // Chrono without material properties is viscoelastic
    for (u, _, zero_force) in RUNS {
        let pair = ViscoelasticContact::new(contact(), a_of(u, 0.3)).unwrap();
        let Chrono { kn, gn } = Chrono::new(&pair).unwrap();
        let factor = |x: f64| 2.5e-3 * x.sqrt();
        let seen = rebound(|x, v| factor(x) * (kn * x + 1e-4 * gn * v), End::ZeroForce);
        assert!((seen - zero_force).abs() < 2e-5, "u = {u}: {seen}");
    }
}

#[test]
fn constant_codes_come_back_or_refuse() {
    use ConstantCode::{Chrono, DemEngine, Kratos, Lammps, Lethe, Liggghts, Mfix, TrixiParticles, Yade};
    for code in [Lammps, Liggghts, Chrono, DemEngine, Lethe, Mfix, Kratos, TrixiParticles, Yade] {
        for end in code.ends() {
            for k in 4..99 {
                let wanted = f64::from(k) / 100.0;
                let law = ConstantRestitution::that_gives(wanted, *end).unwrap();
                match code.input(&law) {
                    Ok(input) => {
                        let seen = code.law(input).unwrap().epsilon(*end);
                        assert!((seen - wanted).abs() < 1e-12, "{code:?} {end:?} {wanted}: {seen}");
                    }
                    // beyond critical damping there is no coefficient to tell
                    Err(error) => {
                        assert!(*end == End::ZeroForce && wanted < 0.136, "{code:?} {wanted}: {error}")
                    }
                }
            }
        }
    }
    for bad in [0.0, 1.0, -0.1, f64::NAN] {
        assert!(Mfix.law(bad).is_err() && Kratos.law(bad).is_err() && Lethe.law(bad).is_err());
    }
    assert!(TrixiParticles.law(0.1).is_err()); // drives the spheres apart
}

#[test]
fn lines_are_what_the_codes_read() {
    let (k_n, eta_n0) = (1e7, 2500.5);
    insta::assert_snapshot!(LammpsGranular { k_n, eta_n0, end: End::ZeroForce }, @r"
    pair_style granular
    pair_coeff * * hertz 1e7 2500.5 tangential linear_nohistory 0 0 damping viscoelastic limit_damping
    ");
    insta::assert_snapshot!(LammpsHertzHistory { kn: k_n, gamma_n: eta_n0 }, @r"
    pair_style gran/hertz/history 1e7 NULL 2500.5 NULL 0 0
    pair_coeff * *
    ");
    insta::assert_snapshot!(Liggghts { kn: k_n, gamman: eta_n0, end: End::ZeroCompression }, @r"
    pair_style gran model hertz/stiffness tangential no_history limitForce off
    pair_coeff * *
    fix kn all property/global kn peratomtypepair 1 1e7
    fix kt all property/global kt peratomtypepair 1 0
    fix gamman all property/global gamman peratomtypepair 1 2500.5
    fix gammat all property/global gammat peratomtypepair 1 0
    fix coefficientFriction all property/global coefficientFriction peratomtypepair 1 0
    ");
    insta::assert_snapshot!(MercuryDpm { effective_elastic_modulus: 7.5e6, dissipation: 1e-6 }, @r"
    species->setEffectiveElasticModulus(7.5e6);
    species->setDissipation(1e-6);
    ");
    insta::assert_snapshot!(
        EsysParticle { a: 1.5e-4, young: 1e7, poisson: 0.3 },
        @r#"HertzianViscoElasticPrms(name="contact", A=1.5e-4, E=1e7, nu=0.3)"#
    );
    insta::assert_snapshot!(Yade { en: 0.5, vn: 0.01, effective_modulus: 7.5e6 }, @r"
    # FrictMat: young/(2*(1 - poisson**2)) = 7.5e6
    Ip2_FrictMat_FrictMat_MindlinPhys(en=0.5, vn=0.01)
    ");
}

#[test]
fn nonsense_is_refused() {
    let pair = ViscoelasticContact::new(contact(), 0.0).unwrap();
    assert!(matches!(Yade::new(&pair, 0.1), Err(MaterialError::Epsilon { value: 1.0 })));
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(LammpsGranular { k_n: bad, eta_n0: 1.0, end: End::ZeroForce }.contact(1.0, 1.0).is_err());
        assert!(LammpsHertzHistory { kn: 1.0, gamma_n: bad }.contact(1.0, 1.0).is_err());
        assert!(Liggghts { kn: 1.0, gamman: 1.0, end: End::ZeroForce }.contact(bad, 1.0).is_err());
        assert!(MercuryDpm { effective_elastic_modulus: 1.0, dissipation: bad }.contact(1.0, 1.0).is_err());
        assert!(EsysParticle { a: 1.0, young: bad, poisson: 0.3 }.contact(1.0, 1.0).is_err());
        assert!(Yade { en: 0.5, vn: bad, effective_modulus: 1.0 }.contact(1.0, 1.0).is_err());
        assert!(ConstantRestitution::of_betan(bad).is_err());
    }
}
