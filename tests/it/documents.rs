//! The documents are one place: every page is in the book and reachable from its front page, and every link leads somewhere.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The targets of the links of a page, without anchors and addresses of other places.
fn links(text: &str) -> Vec<String> {
    let targets = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let inside = targets.filter(|target| !target.contains("://") && !target.starts_with('#'));
    inside.filter_map(|target| target.split('#').next()).map(str::to_owned).collect()
}

fn pages() -> Vec<PathBuf> {
    let files = fs::read_dir(root().join("docs"))
        .expect("the documents")
        .map(|entry| entry.expect("an entry").path());
    files.filter(|path| path.extension().is_some_and(|extension| extension == "md")).collect()
}

#[test]
fn every_link_leads_somewhere() {
    let fronts = ["README.md", "CONTRIBUTING.md"].map(|name| root().join(name));
    let mut broken = Vec::new();
    for page in pages().into_iter().chain(fronts) {
        let text = fs::read_to_string(&page).expect("a page");
        let folder = page.parent().expect("a folder");
        let missing = links(&text).into_iter().filter(|target| !folder.join(target).exists());
        broken.extend(missing.map(|target| format!("{}: {target}", page.display())));
    }
    assert!(broken.is_empty(), "links that lead nowhere:\n{}", broken.join("\n"));
}

#[test]
fn every_page_is_in_the_book_and_reachable() {
    let read = |name: &str| fs::read_to_string(root().join("docs").join(name)).expect("a page");
    let all = pages();
    let all = all.iter().map(|page| page.file_name().expect("a name").to_string_lossy().into_owned());
    let all = all.filter(|name| name != "SUMMARY.md").collect::<BTreeSet<_>>();
    let book = links(&read("SUMMARY.md")).into_iter().collect::<BTreeSet<_>>();
    assert_eq!(book, all, "docs/SUMMARY.md lists every page once");
    let (mut reached, mut open) = (BTreeSet::new(), vec!["README.md".to_owned()]);
    while let Some(page) = open.pop() {
        if all.contains(&page) && reached.insert(page.clone()) {
            open.extend(links(&read(&page)));
        }
    }
    assert_eq!(reached, all, "every page is reachable from docs/README.md");
}
