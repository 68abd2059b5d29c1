//! The conventions of the codes against what the codes did when they were run, and the way there and back.
//!
//! The figures are those of LAMMPS 22Jul2025, LIGGGHTS 3.8.0 and YADE 2025.2.0, extrapolated to zero time step.

use crate::support::{cases, generator};
use proptest::prelude::*;
use restitution::codes::{
    ConstantRestitution, EsysParticle, LammpsGranular, LammpsHertzHistory, Liggghts, MercuryDpm, Yade,
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
