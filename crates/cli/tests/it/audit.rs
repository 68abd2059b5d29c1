//! `restitution audit`, run as its users run it.

use crate::support::{fail, succeed};

#[test]
fn one_line_for_each_claim_and_a_count() {
    let output = succeed("audit");
    let claims = output.lines().filter(|line| line.starts_with("  ")).collect::<Vec<_>>();
    let of = |word: &str| claims.iter().filter(|line| line.split_whitespace().nth(1) == Some(word)).count();
    let (holds, wrong, imprecise) = (of("holds"), of("wrong"), of("imprecise"));
    let total = claims.len();
    assert_eq!(holds + wrong + imprecise, total);
    let count = format!("{total} claims: {holds} hold, {wrong} wrong, {imprecise} imprecise.");
    assert!(output.lines().any(|line| line == count), "{output}");
}

#[test]
fn a_claim_is_found_by_its_equation() {
    for name in ["A26", "(A26)"] {
        let output = succeed(&format!("audit {name} --format csv"));
        let ids = output.lines().skip(1).map(|line| line.split(',').next().unwrap()).collect::<Vec<_>>();
        assert_eq!(ids, ["A26.formula", "A26"]);
    }
}

#[test]
fn wrong_input_is_refused_before_the_work() {
    let (code, line) = fail("audit A99");
    assert_eq!(code, 2);
    assert_eq!(
        line,
        "no claim is called A99: run 'restitution audit' for a list, or give an equation such as A26"
    );
    assert_eq!(fail("audit --format pdf").0, 2);
    assert_eq!(fail("audit -o /nonexistent/folder/file").0, 1);
}
