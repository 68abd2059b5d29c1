//! docs/notation.md is true: every name of its third column is a public one in the code, every option one of the command.

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The names between back ticks in the third column.
fn names(page: &str) -> Vec<String> {
    let rows = page.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| paper"));
    let cells = rows.filter_map(|row| row.split('|').nth(3));
    cells.flat_map(|cell| cell.split('`').skip(1).step_by(2)).map(str::to_owned).collect()
}

fn sources(folder: &Path, found: &mut Vec<String>) {
    for entry in fs::read_dir(folder).expect("a folder of sources") {
        let path: PathBuf = entry.expect("an entry").path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(fs::read_to_string(path).expect("a source"));
        }
    }
}

/// Whether some source defines `Type::item`, or the function `item`, for everybody.
fn is_public(name: &str, sources: &[String]) -> bool {
    let (of, item) = name.rsplit_once("::").map_or((None, name), |(of, item)| (Some(of), item));
    let public = |text: &str| {
        let starts = |line: &str| {
            let rest = line
                .strip_prefix("pub fn ")
                .or(line.strip_prefix("pub const fn "))
                .or(line.strip_prefix("pub "));
            let variant = of.is_some().then_some(line);
            rest.or(variant)
                .and_then(|rest| rest.strip_prefix(item))
                .is_some_and(|rest| rest.starts_with(['(', '<', ':', ',', ' ']))
        };
        text.lines().map(str::trim_start).any(starts)
    };
    let of_type = |text: &str| {
        of.is_none_or(|of| {
            ["pub struct ", "pub enum ", "impl "].iter().any(|word| text.contains(&format!("{word}{of} ")))
        })
    };
    sources.iter().any(|text| of_type(text) && public(text))
}

/// Whether the command has this option, and the option this value.
fn is_offered(text: &str) -> bool {
    let (option, value) = text.split_once(' ').unwrap_or((text, ""));
    let command = restitution_cli::commands::command();
    let options = command.get_subcommands().flat_map(|sub| sub.get_arguments());
    options.filter(|argument| argument.get_long() == option.strip_prefix("--")).any(|argument| {
        value.is_empty() || argument.get_possible_values().iter().any(|known| known.matches(value, false))
    })
}

#[test]
fn every_name_of_the_notation_is_in_the_code() {
    let page = fs::read_to_string(root().join("docs/notation.md")).expect("the notation");
    let mut all = Vec::new();
    for folder in fs::read_dir(root().join("crates")).expect("the crates") {
        sources(&folder.expect("a crate").path().join("src"), &mut all);
    }
    let command = restitution_cli::commands::command();
    let (names, mut strange) = (names(&page), Vec::new());
    for name in &names {
        let known = match name.strip_prefix("restitution ") {
            Some(sub) => command.find_subcommand(sub).is_some(),
            None if name.starts_with("--") => is_offered(name),
            None => is_public(name, &all),
        };
        if !known {
            strange.push(name);
        }
    }
    assert!(strange.is_empty(), "docs/notation.md has names that the code has not: {strange:?}");
    assert!(names.len() > 30, "the table is read: {names:?}");
}

#[test]
fn names_that_are_not_there_are_missed() {
    let sources = ["impl Ball {\n    pub fn prec(&self)\n}\npub enum End {\n    ZeroForce,\n}\n".to_owned()];
    for (name, known) in [
        ("Ball::prec", true),
        ("End::ZeroForce", true),
        ("prec", true),
        ("Ball::precision", false),
        ("Field::prec", false),
        ("End::Zero", false),
    ] {
        assert_eq!(is_public(name, &sources), known, "{name}");
    }
    assert!(is_offered("--end zero-force") && !is_offered("--end never") && !is_offered("--ends"));
    assert_eq!(names("| a | b | `c`, `--d e` | f `g` |"), ["c", "--d e"]);
}
