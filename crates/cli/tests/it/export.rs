//! `restitution export`: what it writes and what it refuses.

use crate::support::{fail, succeed};

#[test]
fn a_source_says_what_it_keeps_and_how_to_get_it_again() {
    let source = succeed("export --lang c --tolerance 1e-4 --range 0.5,1 --end zero-force");
    assert!(source.contains("double restitution_epsilon(double u)"));
    assert!(source.contains("For u from 0.5 to 1 the relative error is at most 1e-4"));
    assert!(source.contains(
        "restitution export --lang c --tolerance 1e-4 --range 0.5,1 --end zero-force --name restitution"
    ));
}

#[test]
fn languages_have_the_names_that_people_give_them() {
    let options = "--tolerance 1e-2 --range 0,1";
    for (name, sign) in [
        ("cpp", "static inline"),
        ("F90", "end module"),
        ("Octave", "function [epsilon, loss, slope] = restitution_epsilon(u, g_star)"),
    ] {
        assert!(succeed(&format!("export --lang {name} {options}")).contains(sign), "{name}");
    }
    assert!(!succeed("export --help").contains("evaluator-t"));
}

#[test]
fn a_source_is_written_for_a_velocity_and_under_a_name() {
    let options = "--tolerance 1e-2 --range 0,1 --name ice --beyond law";
    let source = succeed(&format!("export --lang c {options} --g-star 0.32cm/s"));
    assert!(source.contains("double ice_epsilon_at_m_per_s(double velocity)"));
    assert!(source.contains("g* = 3.2e-3 m/s: given as 0.32cm/s"));
    assert!(source.contains("For every u from 0 on"));
    let material =
        "--dissipative-constant 1e-6s --young 9.4GPa --poisson 0.33 --density 917kg/m3 --radius 2.75cm";
    let source = succeed(&format!("export --lang c {options} {material}"));
    assert!(source.contains(
        "m/s: two equal spheres, A = 1e-6s, Y = 9.4GPa, nu = 0.33, density 917kg/m3, radius 2.75cm"
    ));
    assert!(!succeed(&format!("export --lang c {options}")).contains("at_m_per_s"));
}

#[test]
fn wrong_exports_are_named_with_their_remedy() {
    let cases = [
        ("export", "--lang"),
        ("export --lang basic", "[possible values: rust, c, fortran, python"),
        ("export --lang c --tolerance 0", "give one from 1e-15 to 0.1"),
        ("export --lang c --tolerance -1e-3", "give one from 1e-15 to 0.1"),
        ("export --lang c --tolerance small", "give one from 1e-15 to 0.1"),
        ("export --lang c --range 2,1", "give 0 <= LO < HI <= 1e6"),
        ("export --lang c --range -1,1", "give 0 <= LO < HI <= 1e6"),
        ("export --lang c --range 0,NaN", "give 0 <= LO < HI <= 1e6"),
        ("export --lang c --range 1", "give 0 <= LO < HI <= 1e6"),
        ("export --lang c --name 1st", "start with a letter from a to z"),
        ("export --lang c --name -x", "start with a letter from a to z"),
        ("export --lang fortran --name dp", "choose another"),
        ("export --lang c --beyond the-sea", "[possible values: nan, law]"),
        ("export --lang c --g-star 0m/s", "give --g-star with a positive value"),
        ("export --lang c --g-star 1e400m/s", "beyond what a double can hold"),
        ("export --lang c --dissipative-constant 1e-6s", "give --young, --poisson, --density and --radius"),
        ("export --lang c --end never", "[possible values: zero-compression, zero-force]"),
    ];
    for (line, remedy) in cases {
        let (code, message) = fail(line);
        assert_eq!(code, 2, "{line}: {message}");
        assert!(message.contains(remedy), "{line}: {message}");
    }
    let (code, message) = fail("export --lang c -o /no/such/folder/evaluator.h");
    assert_eq!((code, message.contains("make it first")), (1, true), "{message}");
}
