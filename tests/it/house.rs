//! The house as it stands: rooms and arrows, no import circle, no file too long to be one thing.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The most lines of a source file that is no table.
const LONGEST: usize = 400;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn the_picture_of_the_rooms_is_that_of_the_code() {
    let check = Command::new("python3").arg(root().join("scripts/rooms.py")).arg("--check").output();
    let check = check.expect("python3 runs");
    assert!(check.status.success(), "{}", String::from_utf8_lossy(&check.stderr));
}

/// The sources of each crate, by the path of their module.
fn modules(source: &Path) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    let mut folders = vec![source.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder of sources") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = fs::read_to_string(&path).expect("a source");
                let text = text.split("#[cfg(test)]").next().unwrap_or_default().to_owned();
                found.insert(module(&path, source), text);
            }
        }
    }
    found
}

fn module(path: &Path, source: &Path) -> String {
    let inside = path.strip_prefix(source).expect("inside the crate").with_extension("");
    let mut parts = inside.iter().map(|part| part.to_string_lossy().into_owned()).collect::<Vec<_>>();
    if parts.last().is_some_and(|last| ["mod", "lib", "main"].contains(&last.as_str())) {
        parts.pop();
    }
    parts.join("::")
}

/// The modules of the crate that a module takes names from: `use crate::a::b`, `use super::a`, and paths written out.
fn taken(name: &str, text: &str, all: &BTreeMap<String, String>) -> BTreeSet<String> {
    let parts = name.split("::").filter(|part| !part.is_empty()).collect::<Vec<_>>();
    let mut found = BTreeSet::new();
    for line in text.lines().filter(|line| !line.trim_start().starts_with("//")) {
        let starts = line.match_indices("crate::").map(|(at, _)| (Vec::new(), &line[at + "crate::".len()..]));
        let above = parts[..parts.len().saturating_sub(1)].to_vec();
        let supers = line.match_indices("super::").filter(|(at, _)| !line[..*at].ends_with("super::"));
        let supers = supers.map(|(at, _)| {
            let (mut from, mut rest) = (above.clone(), &line[at + "super::".len()..]);
            while let Some(next) = rest.strip_prefix("super::") {
                from.pop();
                rest = next;
            }
            (from, rest)
        });
        for (from, rest) in starts.chain(supers) {
            let words = rest.split("::").map(|word| {
                word.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>()
            });
            let path = from.iter().map(|part| (*part).to_owned()).chain(words).collect::<Vec<_>>();
            let longest =
                (1..=path.len()).rev().map(|n| path[..n].join("::")).find(|path| all.contains_key(path));
            found.extend(longest.filter(|taken| taken != name));
        }
    }
    found
}

/// A circle that a depth-first walk meets, if there is one.
fn circle(arrows: &BTreeMap<String, BTreeSet<String>>) -> Option<Vec<String>> {
    fn walk(
        at: &str,
        arrows: &BTreeMap<String, BTreeSet<String>>,
        way: &mut Vec<String>,
        done: &mut BTreeSet<String>,
    ) -> Option<Vec<String>> {
        if let Some(start) = way.iter().position(|known| known == at) {
            return Some(way[start..].to_vec());
        }
        if !done.contains(at) {
            way.push(at.to_owned());
            for next in &arrows[at] {
                let found = walk(next, arrows, way, done);
                if found.is_some() {
                    return found;
                }
            }
            way.pop();
            done.insert(at.to_owned());
        }
        None
    }
    let mut done = BTreeSet::new();
    arrows.keys().find_map(|start| walk(start, arrows, &mut Vec::new(), &mut done))
}

fn crates() -> Vec<PathBuf> {
    let folders = fs::read_dir(root().join("crates")).expect("the crates");
    folders.map(|entry| entry.expect("a crate").path()).filter(|path| path.join("src").is_dir()).collect()
}

#[test]
fn no_module_imports_in_a_circle() {
    let mut circles = Vec::new();
    for folder in crates() {
        let modules = modules(&folder.join("src"));
        let arrows = modules.iter().map(|(name, text)| (name.clone(), taken(name, text, &modules)));
        if let Some(circle) = circle(&arrows.collect()) {
            circles.push(format!("{}: {}", folder.display(), circle.join(" -> ")));
        }
    }
    assert!(circles.is_empty(), "modules that import each other:\n{}", circles.join("\n"));
}

#[test]
fn circles_are_found() {
    let arrows = |pairs: &[(&str, &[&str])]| {
        let arrow = |(from, to): &(&str, &[&str])| {
            ((*from).to_owned(), to.iter().map(|to| (*to).to_owned()).collect::<BTreeSet<_>>())
        };
        pairs.iter().map(arrow).collect::<BTreeMap<_, _>>()
    };
    assert_eq!(circle(&arrows(&[("a", &["b", "c"]), ("b", &["c"]), ("c", &[])])), None);
    let found = circle(&arrows(&[("a", &["b"]), ("b", &["c"]), ("c", &["b"])]));
    assert_eq!(found, Some(vec!["b".to_owned(), "c".to_owned()]));
    let sources =
        [("a", "use crate::b::f;"), ("b", "fn f() { super::a::g() }"), ("c::d", "use super::super::a;")];
    let all = sources.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
    assert_eq!(taken("a", sources[0].1, &all), BTreeSet::from(["b".to_owned()]));
    assert_eq!(taken("b", sources[1].1, &all), BTreeSet::from(["a".to_owned()]));
    assert_eq!(taken("c::d", sources[2].1, &all), BTreeSet::from(["a".to_owned()]));
}

/// What cargo says that a package always depends on directly, outside of tests; nothing is fetched for the answer.
fn dependencies(package: &str) -> BTreeSet<String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let arguments = ["metadata", "--offline", "--no-deps", "--format-version=1"];
    let metadata = Command::new(cargo).args(arguments).current_dir(root()).output().expect("cargo runs");
    assert!(metadata.status.success(), "{}", String::from_utf8_lossy(&metadata.stderr));
    let metadata: serde_json::Value = serde_json::from_slice(&metadata.stdout).expect("JSON");
    let packages = metadata["packages"].as_array().expect("packages");
    let own = packages.iter().find(|own| own["name"] == package).expect("a package");
    let all = own["dependencies"].as_array().expect("dependencies").iter();
    let always = all.filter(|one| one["kind"].is_null() && one["optional"] == false);
    always.map(|one| one["name"].as_str().expect("a name").to_owned()).collect()
}

/// The libraries that the command calls. Those of numbers are not among them: `restitution-real` and whatever computes (`rug`, `num-*`, ...) are
/// for the libraries; an argument's number is `restitution_law::exact`, a result is text.
const CALLED: [&str; 14] = [
    "restitution",
    "restitution-approximate",
    "restitution-audit",
    "restitution-closed",
    "restitution-direct",
    "restitution-export",
    "restitution-fit",
    "restitution-law",
    "restitution-pade",
    "restitution-page",
    "restitution-report",
    "restitution-series",
    "restitution-table",
    "restitution-units",
];

/// What the command needs of others: arguments, output and the system.
const OTHERS: [&str; 11] = [
    "clap",
    "clap_complete",
    "clap_mangen",
    "ctrlc",
    "indicatif",
    "rayon",
    "serde_json",
    "signal-hook",
    "sysinfo",
    "tempfile",
    "thiserror",
];

#[test]
fn the_command_computes_nothing_itself() {
    let allowed = CALLED.iter().chain(&OTHERS).map(|name| (*name).to_owned()).collect::<BTreeSet<_>>();
    let needed = dependencies("restitution-cli");
    let strange = needed.difference(&allowed).collect::<Vec<_>>();
    assert!(strange.is_empty(), "{strange:?}: whatever needs them is work of a library");
    assert!(dependencies("restitution-approximate").contains("rug"), "dependencies are read");
}

#[test]
fn the_picture_has_what_cargo_lists_of_the_command() {
    let page = fs::read_to_string(root().join("docs/architecture.md")).expect("a page");
    let row = |name: &str| {
        let line = page.lines().find_map(|line| line.strip_prefix(&format!("    {name} ")));
        line.expect("a row").split_whitespace().map(str::to_owned).collect::<Vec<_>>()
    };
    let libraries = row("libraries").into_iter().map(|name| match name.as_str() {
        "restitution" => name,
        _ => format!("restitution-{name}"),
    });
    let shown = libraries.chain(row("others")).collect::<BTreeSet<_>>();
    assert_eq!(shown, dependencies("restitution-cli"));
}

#[test]
fn integration_takes_one_word_from_the_evaluator() {
    let modules = modules(&root().join("crates/direct/src"));
    for (name, text) in modules {
        for line in text.lines().filter(|line| !line.trim_start().starts_with("//")) {
            let others = line
                .match_indices("restitution::")
                .filter(|(at, _)| !line[*at..].starts_with("restitution::End"));
            assert_eq!(others.count(), 0, "{name}: {line}");
        }
    }
}

#[test]
fn no_source_is_too_long_to_be_one_thing() {
    let mut long = Vec::new();
    for folder in crates() {
        let mut folders = vec![folder.join("src")];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(&folder).expect("a folder of sources") {
                let path = entry.expect("an entry").path();
                if path.is_dir() {
                    if path.file_name().is_none_or(|name| name != "tables") {
                        folders.push(path);
                    }
                } else if path.extension().is_some_and(|extension| extension == "rs") {
                    let lines = fs::read_to_string(&path).expect("a source").lines().count();
                    if lines > LONGEST {
                        long.push(format!("{}: {lines} lines", path.display()));
                    }
                }
            }
        }
    }
    assert!(long.is_empty(), "more than {LONGEST} lines:\n{}", long.join("\n"));
}

/// The crates whose functions others call one by one.
const LOWER: [&str; 10] =
    ["real", "series", "pade", "direct", "law", "closed", "approximate", "fit", "units", "table"];

/// The functions outside of `impl` that are public and have no example.
fn without_example(text: &str) -> Vec<String> {
    let (mut found, mut has_example) = (Vec::new(), false);
    for line in text.lines() {
        if line.starts_with("/// ```") {
            has_example |= line.trim_end() == "/// ```" || line.starts_with("/// ```no_run");
        } else if let Some(rest) = line.strip_prefix("pub fn ") {
            let name = rest.split(['(', '<']).next().unwrap_or_default();
            found.extend((!has_example).then(|| name.to_owned()));
            has_example = false;
        } else if !line.starts_with("///") && !line.starts_with("#[") {
            has_example = false;
        }
    }
    found
}

/// The public methods of the types of a crate that no example in it calls.
fn methods_without_example(modules: &BTreeMap<String, String>, shown: &BTreeSet<&str>) -> Vec<String> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let example = |text: &String| {
        let lines = text.lines().map(str::trim_start).filter(|line| line.starts_with("///"));
        lines.map(str::to_owned).collect::<Vec<_>>().join("\n")
    };
    let examples = modules.values().map(example).collect::<Vec<_>>().join("\n");
    let called = examples.split("```").skip(1).step_by(2).flat_map(|code| {
        let calls = code.match_indices(['.', ':']).map(|(at, _)| &code[at + 1..]);
        calls.map(|rest| rest.chars().take_while(|c| is_word(*c)).collect::<String>()).collect::<Vec<_>>()
    });
    let called = called.collect::<BTreeSet<_>>();
    let mut bare = Vec::new();
    for text in modules.values() {
        let mut of = "";
        for line in text.lines() {
            if line.starts_with("impl") {
                let name = line.split(" for ").last().unwrap_or_default().trim_start_matches("impl");
                let name = if name.starts_with('<') {
                    name.split_once("> ").map_or(name, |parts| parts.1)
                } else {
                    name
                };
                of = name.trim_start().split(|c: char| !is_word(c)).next().unwrap_or_default();
            }
            let method = line.strip_prefix("    pub fn ").or_else(|| line.strip_prefix("    pub const fn "));
            if let Some(name) =
                method.map(|rest| rest.split(|c: char| !is_word(c)).next().unwrap_or_default())
            {
                bare.extend((shown.contains(of) && !called.contains(name)).then(|| format!("{of}::{name}")));
            }
        }
    }
    bare
}

#[test]
fn every_method_of_the_lower_crates_is_called_in_an_example() {
    let mut bare = Vec::new();
    for name in LOWER.iter().filter(|name| **name != "fit") {
        let folder = root().join("crates").join(name).join("src");
        let shown = fs::read_to_string(folder.join("lib.rs")).expect("the front page of a crate");
        let shown = shown.split(|c: char| !c.is_alphanumeric() && c != '_').collect::<BTreeSet<_>>();
        bare.extend(
            methods_without_example(&modules(&folder), &shown)
                .into_iter()
                .map(|method| format!("{name}: {method}")),
        );
    }
    assert!(bare.is_empty(), "methods without an example:\n{}", bare.join("\n"));
    let source = "/// ```\n/// Set::new().first()\n/// ```\nimpl<T: Ord> Set<T> {\n    pub fn first() {}\n    pub fn last() {}\n}";
    let modules = BTreeMap::from([(String::new(), source.to_owned())]);
    assert_eq!(methods_without_example(&modules, &BTreeSet::from(["Set"])), ["Set::last"]);
}

#[test]
fn every_function_of_the_lower_crates_has_an_example() {
    let mut bare = Vec::new();
    for name in LOWER {
        let folder = root().join("crates").join(name).join("src");
        let shown = fs::read_to_string(folder.join("lib.rs")).expect("the front page of a crate");
        let shown = shown.split(|c: char| !c.is_alphanumeric() && c != '_').collect::<BTreeSet<_>>();
        for text in modules(&folder).values() {
            let functions =
                without_example(text).into_iter().filter(|function| shown.contains(function.as_str()));
            bare.extend(functions.map(|function| format!("{name}: {function}")));
        }
    }
    assert!(bare.is_empty(), "functions without an example:\n{}", bare.join("\n"));
    assert_eq!(
        without_example(
            "/// A.\n/// ```text\n/// x\n/// ```text\npub fn a() {}\n/// ```\npub fn b() {}\npub fn c() {}"
        ),
        ["a", "c"]
    );
}
