//! `restitution export`: what it writes and what it refuses.

use crate::support::{fail, succeed};

#[test]
fn a_source_says_what_it_keeps_and_how_to_get_it_again() {
    let source = succeed("export --lang c --tolerance 1e-4 --range 0.5,1 --end zero-force");
    assert!(source.contains("double restitution_epsilon(double u)"));
    assert!(source.contains("For u from 0.5 to 1 the relative error is at most 1e-4"));
    assert!(source.contains("restitution export --tolerance 1e-4 --range 0.5,1 --end zero-force"));
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
