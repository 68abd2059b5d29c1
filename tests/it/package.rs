//! Packages: what each states of itself, that `restitution` includes nothing from outside, that the version is one.

use std::path::Path;

fn sources(folder: &Path, found: &mut Vec<std::path::PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() { sources(&path, found) } else { found.push(path) }
    }
}

#[test]
fn no_file_of_the_package_reaches_outside() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/crates/restitution");
    let mut found = Vec::new();
    ["src", "benches"].iter().for_each(|folder| sources(&Path::new(root).join(folder), &mut found));
    assert!(found.len() > 20);
    for path in found {
        let depth = path.strip_prefix(root).unwrap().components().count() - 1;
        let outside = "../".repeat(depth + 1);
        assert!(!std::fs::read_to_string(&path).unwrap().contains(&outside), "{}", path.display());
    }
}

fn manifest(of: &str) -> String {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/crates");
    std::fs::read_to_string(format!("{root}/{of}/Cargo.toml")).unwrap()
}

#[test]
fn every_crate_for_others_says_what_it_is() {
    let crates = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/crates")).unwrap();
    let mut published = 0;
    for folder in crates.map(|entry| entry.unwrap().path()) {
        let name = folder.file_name().unwrap().to_str().unwrap();
        let manifest = manifest(name);
        if manifest.contains("publish = false") {
            continue;
        }
        published += 1;
        for key in [
            "description",
            "readme",
            "documentation",
            "keywords",
            "categories",
            "include.workspace",
            "[package.metadata.docs.rs]",
        ] {
            assert!(manifest.contains(&format!("\n{key}")), "{name} states no {key}");
        }
        let readme = std::fs::read_to_string(folder.join("README.md")).unwrap();
        assert!(readme.contains("```rust"), "the README of {name} shows no code");
        let lib = std::fs::read_to_string(folder.join("src/lib.rs")).unwrap();
        assert!(lib.contains("include_str!(\"../README.md\")"), "the README of {name} is not tested");
        let examples = std::fs::read_dir(folder.join("examples")).unwrap().map(|entry| entry.unwrap().path());
        assert!(examples.into_iter().any(|path| path.extension().is_some_and(|e| e == "rs")), "{name}");
    }
    assert_eq!(published, 16, "attack and python stay here, all else is published");
}

#[test]
fn the_version_is_one() {
    let read =
        |name: &str| std::fs::read_to_string(format!("{}/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let version = env!("CARGO_PKG_VERSION");
    assert!(read("CITATION.cff").contains(&format!("\nversion: {version}\n")));
    assert!(read("CHANGELOG.md").contains(&format!("\n## {version} - ")));
    let manifest = read("Cargo.toml");
    let crates = manifest.lines().filter(|line| line.contains("path = \"crates/")).collect::<Vec<_>>();
    assert!(
        crates.len() > 10 && crates.iter().all(|line| line.contains(&format!("version = \"{version}\"")))
    );
}
