//! Every work that is cited by key is in docs/references.md, and every key there is cited.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

#[test]
fn cited_works_are_in_the_references() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let listed = keys(&fs::read_to_string(root.join("docs/references.md")).unwrap());
    assert!(listed.contains("RPBS1999"), "the references are read");
    let mut files = Vec::new();
    for folder in ["crates", "docs", "tests", "bench/peers"] {
        sources(&root.join(folder), &mut files);
    }
    assert!(files.len() > 20, "the sources are read");
    for file in files {
        let missing = &keys(&fs::read_to_string(&file).unwrap()) - &listed;
        assert!(missing.is_empty(), "{} cites {missing:?}, not in docs/references.md", file.display());
    }
}

/// Returns what stands in brackets and looks like a key: letters, then a year.
fn keys(text: &str) -> BTreeSet<String> {
    let inside = text.split('[').skip(1).filter_map(|rest| rest.split(']').next());
    let is_key = |key: &&str| {
        let key = key.trim_end_matches('\\');
        let letters = key.chars().take_while(char::is_ascii_alphabetic).count();
        let year = &key[letters..];
        (1..=5).contains(&letters)
            && year.len() == 4
            && year.parse().is_ok_and(|year: u16| (1800..2100).contains(&year))
    };
    inside.filter(is_key).map(|key| key.trim_end_matches('\\').to_owned()).collect()
}

fn sources(folder: &Path, out: &mut Vec<std::path::PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
        if path.is_dir() {
            sources(&path, out);
        } else if ["rs", "md", "py"].contains(&extension) {
            out.push(path);
        }
    }
}
