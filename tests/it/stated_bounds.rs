//! Documents and doc comments state the bounds of `restitution::bounds`, and no others.

use restitution::bounds::{ALL, Bound, Evidence, Unit};
use std::fmt::Write as _;

fn read(path: &str) -> String {
    std::fs::read_to_string(format!("{}/{path}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn table() -> String {
    let mut text = String::from(
        "| what | where | bound | largest seen | why not less | kept by |\n|---|---|---|---|---|---|\n",
    );
    for bound in ALL {
        let Bound { quantity, domain, observed, reason, test, .. } = bound;
        let seen = match bound.unit {
            Unit::Ulp => format!("{observed}"),
            Unit::Relative => format!("{observed:e}"),
        };
        let _ = writeln!(text, "| {quantity} | {domain} | {bound} | {seen} | {reason} | `{test}` |");
    }
    text
}

#[test]
fn the_table_of_the_document_is_the_table_of_the_code() {
    let document = read("docs/evaluator.md");
    let table = table();
    assert!(document.contains(&table), "docs/evaluator.md must contain\n\n{table}");
}

/// Every "at most N … (proved|measured)" of a source file is one of the bounds, with the name that it stands beside.
#[test]
fn doc_comments_state_the_bounds_they_name() {
    let mut statements = 0;
    let source = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("crates/restitution/src");
    let room = std::fs::read_dir(source.join("evaluator")).unwrap().map(|file| file.unwrap().path());
    for path in room.chain([source.join("lib.rs")]) {
        if path.extension().is_none_or(|extension| extension != "rs") || path.ends_with("bounds.rs") {
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap().replace("\n/// ", " ").replace("\n//! ", " ");
        for (start, _) in text.match_indices("crate::bounds::") {
            let rest = &text[start + "crate::bounds::".len()..];
            let name = rest.split(')').next().unwrap();
            let Some((_, after)) = rest.split_once("at most ") else { continue };
            if rest.len() - after.len() > 200 {
                continue; // a reference without a figure
            }
            let stated = format!("at most {}", after.split_inclusive(')').next().unwrap());
            let bound = read("crates/restitution/src/evaluator/bounds.rs");
            assert!(bound.contains(&format!("pub const {name}: Bound")), "{}: {name}", path.display());
            assert!(ALL.iter().any(|bound| bound.to_string() == stated), "{}: {stated}", path.display());
            statements += 1;
        }
        for (start, _) in text.match_indices("At most") {
            let sentence = text[start..].split('.').next().unwrap();
            assert!(!sentence.contains(" ulp"), "{}: a bound beside the table: {sentence}", path.display());
        }
    }
    assert!(statements >= 8, "{statements}");
}

#[test]
fn the_readme_states_them_too() {
    let readme = read("README.md");
    let [epsilon, _, velocity, ..] = ALL;
    let (of_u, of_velocity) = (epsilon.size, velocity.size);
    let word = |bound: &Bound| if bound.evidence == Evidence::Proved { "proved" } else { "measured" };
    let text = readme.replace('\n', " ");
    assert!(text.contains(&format!(
        "within {of_u} ulp of the exact ε(u) ({}) and within {of_velocity} from a velocity ({};",
        word(&epsilon),
        word(&velocity)
    )));
}

#[test]
fn what_was_seen_is_below_what_is_stated() {
    for bound in ALL {
        assert!(bound.observed > 0.0 && bound.observed <= bound.size, "{bound}: {}", bound.observed);
    }
}
