//! The audit: its page, its verdicts against what is known, and that verdicts come from comparing.

use crate::support::in_snapshots;
use restitution_audit::{Claim, Judged, TrueValues, Verdict, audit, count, markdown, sections};
use restitution_real::Ball;
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs;
use std::sync::OnceLock;

fn truth() -> &'static TrueValues {
    static TRUTH: OnceLock<TrueValues> = OnceLock::new();
    TRUTH.get_or_init(|| TrueValues::new().expect("the truth can be computed"))
}

fn judged() -> &'static [(&'static str, Vec<Judged>)] {
    static JUDGED: OnceLock<Vec<(&'static str, Vec<Judged>)>> = OnceLock::new();
    JUDGED.get_or_init(|| audit(truth(), &[], &mut || ()).expect("every claim can be judged"))
}

fn all() -> impl Iterator<Item = &'static Judged> {
    judged().iter().flat_map(|(_, judged)| judged)
}

fn finding(id: &str) -> &'static Judged {
    all().find(|judged| judged.claim.id == id).expect("a claim of this name")
}

#[test]
fn the_page_is_up_to_date() {
    let page = markdown(judged());
    in_snapshots("audit", || insta::assert_snapshot!("page", page));
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/audit.md");
    let committed = fs::read_to_string(path).expect("docs/audit.md can be read");
    assert!(
        page == committed,
        "write docs/audit.md afresh: restitution audit --format markdown -o docs/audit.md"
    );
}

/// The printed figures that are known to be wrong, each in every place where the paper prints it.
const WRONG: [&str; 16] = [
    "33.a3",
    "33.a4",
    "34.C3",
    "34.C4",
    "A14.x1.t10",
    "A26",
    "A27",
    "A32.C3",
    "A32.C4",
    "A35",
    "A36",
    "TableI.d1",
    "TableI.d2",
    "TableI.d3",
    "TableI.d4",
    "TableI.d5",
];

/// True in a sense that is not stated: the divergence, closed forms that another method gives, Table I's silent `a_5 = 0`, the fit of Fig. 1, and the unit
/// in which (A6) to (A10) count the `b_k`.
const IMPRECISE: [&str; 9] =
    ["32.divergence", "35.standard", "6.closed", "A10", "A36.closed", "A6", "A7", "A9", "Fig1.dashed"];

#[test]
fn nothing_else_is_wrong() {
    let named = |word: &str| {
        let named = all().filter(|judged| judged.finding.verdict.word() == word);
        named.map(|judged| judged.claim.id).collect::<BTreeSet<_>>()
    };
    assert_eq!(named("wrong"), BTreeSet::from(WRONG));
    assert_eq!(named("imprecise"), BTreeSet::from(IMPRECISE));
    let (claims, rest) = (all().count(), all().count() - WRONG.len() - IMPRECISE.len());
    assert_eq!(count(judged()), format!("{claims} claims: {rest} hold, 16 wrong, 9 imprecise."));
}

#[test]
fn every_wrong_figure_has_the_slip_that_gives_it() {
    for judged in all() {
        assert!(judged.finding.verdict != Verdict::Wrong(None), "{}", judged.claim.id);
    }
}

/// The halved corrections, carried from `y_2` to Table I, against the print by plain rounding.
#[test]
fn one_slip_gives_all_printed_figures() {
    let halved = &truth().halved;
    let rounded = |x: &Ball, digits| x.to_digits(digits).expect("digits");
    let six = [&halved.y2, &halved.y3, &halved.c[3], &halved.c[4], &halved.a[3], &halved.a[4]];
    let printed = ["0.260542", "-0.136769", "-0.483582", "0.285279", "0.315119", "0.161167"];
    assert_eq!(six.map(|x| rounded(x, 6)), printed);
    assert_eq!(rounded(&halved.table.num()[1], 5), "2.5839");
    let den = halved.table.den()[1..].iter().map(|x| format!("{:.4}", x.to_f64()));
    assert_eq!(den.collect::<Vec<_>>(), ["3.5839", "2.9839", "1.1487", "0.3265"]);
}

/// Values found elsewhere by other programs.
#[test]
fn computed_figures_are_the_known_ones() {
    for (id, value) in [
        ("A26", "0.28404301890185444457"),
        ("A27", "-0.1702207784972649207"),
        ("A32.C3", "-0.5228825680884149638"),
        ("A32.C4", "0.3487426752603850347"),
        ("A35", "0.3407290271358081223"),
        ("A36", "0.1970206379901313712"),
        ("A16", "1.60903272985952"),
        ("TableI.d1", "2.266761"),
        ("TableI.d5", "0.3634365"),
        ("MP2011.14.c1", "0.501085752"),
        ("MP2011.36.b4", "1.194485709"),
        ("32.divergence", "converges for u < R = 1.3883619256158294"),
    ] {
        let computed = &finding(id).finding.computed;
        let known = value.len() - 1;
        assert!(computed.len() > known && computed[..known] == value[..known], "{id}: {computed}");
    }
    for (k, h) in [
        (2, "-1.15344885809529"),
        (5, "0.266666666666667"),
        (7, "-0.461379543238116"),
        (9, "0.452351051202051"),
    ] {
        assert_eq!(truth().h[k].to_digits(15).as_deref(), Some(h));
    }
}

/// Whether the digit at this place belongs to a number, not to a name such as `x0''` or `C2`.
fn is_of_a_number(text: &str, place: usize) -> bool {
    let before = text[..place].trim_end_matches(|c: char| c.is_ascii_digit());
    !before.ends_with(|c: char| c.is_ascii_alphabetic() || c == '_')
}

/// Everything that comes of changing one digit of what is printed: the last one of a number by five, so that it
/// leaves the neighbourhood of rounding, any one of a formula by one.
fn mutations(claim: &Claim) -> Vec<Claim> {
    let text = &claim.printed;
    let plain = !text.contains('=') && !text.contains('/');
    let places = text.char_indices().filter(|(place, c)| c.is_ascii_digit() && is_of_a_number(text, *place));
    let places = places.map(|(place, _)| place).filter(|place| !plain || place + 1 == text.len());
    let changed = |place: usize| {
        let digit = text.as_bytes()[place] - b'0';
        let other = if plain {
            (digit + 5) % 10
        } else if digit == 9 {
            8
        } else {
            digit + 1
        };
        let mut claim = claim.clone();
        claim.printed.replace_range(place..=place, &other.to_string());
        claim
    };
    places.map(changed).collect()
}

/// Statements in words, of which no figure is part: that a quoted law diverges does not hang on its digits.
const IN_WORDS: [&str; 8] = [
    "28.limit",
    "Fig1.solid",
    "32.deviate",
    "32.divergence",
    "35.monotone",
    "35.standard",
    "6.closed",
    "A36.closed",
];

#[test]
fn a_changed_digit_changes_the_verdict() {
    let mut tried = 0;
    for Judged { claim, finding } in all().filter(|judged| !IN_WORDS.contains(&judged.claim.id)) {
        let mutations = mutations(claim);
        assert!(!mutations.is_empty(), "{}: {}", claim.id, claim.printed);
        for mutation in mutations {
            tried += 1;
            // What can no longer be computed is not confirmed either.
            let Ok(changed) = mutation.judge(truth()) else { continue };
            assert_ne!(changed.verdict, finding.verdict, "{}: {}", claim.id, mutation.printed);
        }
    }
    assert!(tried > 300, "{tried}");
}

#[test]
fn names_are_unique() {
    let sections = sections();
    let names = sections.iter().flat_map(|section| &section.claims).map(|claim| claim.id).collect::<Vec<_>>();
    assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len());
}

/// Runs a command line of the audit and returns what it writes.
fn run(command: &str) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("out");
    let words = command.split_whitespace().map(OsString::from);
    let line = words.chain(["-o".into(), file.clone().into_os_string()]);
    restitution_cli::run(line).unwrap_or_else(|error| panic!("{command}: {error}"));
    fs::read_to_string(file).expect("the command wrote its file")
}

/// Every command line is one that works, and those outside the audit print the computed figure.
#[test]
fn the_commands_show_what_they_should() {
    let commands = all().map(|judged| judged.claim.command).collect::<BTreeSet<_>>();
    for command in commands {
        let claims = all().filter(|judged| judged.claim.command == command);
        if let Some(name) = command.strip_prefix("restitution audit ") {
            assert!(claims.into_iter().all(|judged| judged.claim.id.starts_with(name)), "{command}");
            continue;
        }
        let output = run(command);
        for Judged { claim, finding } in claims {
            let shown = finding.computed.rsplit(' ').next().expect("a figure");
            // The figure of Fig. 1 is the g* that the command is given; what it gives is Bridges' 0.32.
            let shown =
                if claim.id == "Fig1.dashed" { "0.3200000000" } else { shown.trim_start_matches('-') };
            let is_a_figure = shown.contains(['.', '/']);
            assert!(
                !is_a_figure || output.contains(shown),
                "{}: {command}: {shown} not in\n{output}",
                claim.id
            );
        }
    }
    let workings = run("restitution audit A26");
    assert!(workings.contains("0.237041254977 + (0.0235008819625) = 0.260542136939"), "{workings}");
}
