//! The package of `restitution` stands alone: its tests include nothing from outside.

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
