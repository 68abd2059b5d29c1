//! Every command line of the README runs, and its table is what the command prints.

use crate::support::{restitution, succeed};
use std::fs;
use std::path::Path;
use std::process::Command;

fn readme() -> String {
    fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../README.md")).unwrap()
}

/// The lines of the blocks marked `sh`, without comments.
fn command_lines(text: &str) -> Vec<String> {
    let blocks = text.split("```sh\n").skip(1).filter_map(|rest| rest.split("```").next());
    let lines = blocks.flat_map(str::lines).map(|line| line.split(" #").next().unwrap_or(line).trim());
    lines.filter(|line| !line.is_empty()).map(str::to_owned).collect()
}

#[test]
fn every_command_line_runs() {
    let folder = tempfile::tempdir().unwrap();
    let data = "crates/cli/examples/data/ice_bridges.csv";
    fs::create_dir_all(folder.path().join(data).parent().unwrap()).unwrap();
    fs::copy(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(data), folder.path().join(data))
        .unwrap();
    let lines = command_lines(&readme());
    assert!(lines.len() >= 4, "{lines:?}");
    for line in lines {
        match line.split_once(' ') {
            Some(("restitution", arguments)) => {
                let output = restitution(arguments).current_dir(&folder).output().unwrap();
                assert!(output.status.success() && output.stderr.is_empty(), "{line}: {output:?}");
            }
            Some(("make", target)) => {
                let makefile = concat!(env!("CARGO_MANIFEST_DIR"), "/../../Makefile");
                let rules = fs::read_to_string(makefile).unwrap();
                assert!(rules.lines().any(|rule| rule.starts_with(&format!("{target}:"))), "{line}");
            }
            _ => panic!("a command line of the README that no test runs: {line}"),
        }
    }
}

#[test]
fn the_table_is_what_the_command_prints() {
    let readme = readme();
    let csv = succeed("table --order 8 --digits 20 --format csv");
    for row in csv.lines().skip(1) {
        let cells = row.split(',').collect::<Vec<_>>();
        let (quantity, k, value) = (cells[0], cells[1], cells[2]);
        let column = if quantity == "C" { 2 } else { 3 };
        let line = readme.lines().find(|line| line.starts_with(&format!("| {k} | "))).unwrap();
        let shown = line.split('|').nth(column).unwrap().trim();
        let exact = [("1", "1.0000000000000000000"), ("3/5", "0.60000000000000000000")];
        let expected = exact.iter().find(|(text, _)| *text == shown).map_or(shown, |(_, digits)| digits);
        assert_eq!(expected, value, "{row}");
    }
}

#[test]
fn the_c_program_compiles_and_gives_what_the_evaluator_gives() {
    let folder = tempfile::tempdir().unwrap();
    let readme = readme();
    let program = readme.split("```c\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    fs::write(folder.path().join("main.c"), program).unwrap();
    let header = command_lines(&readme).into_iter().find(|line| line.contains("--lang c")).unwrap();
    let export =
        restitution(header.strip_prefix("restitution ").unwrap()).current_dir(&folder).status().unwrap();
    assert!(export.success());
    let compile =
        Command::new("cc").args(["-o", "main", "main.c", "-lm"]).current_dir(&folder).status().unwrap();
    assert!(compile.success());
    let output = Command::new(folder.path().join("main")).output().unwrap();
    let ice = restitution::Restitution::from_g_star(0.0032, restitution::End::ZeroCompression);
    let line = |g: f64| format!("{g} m/s: {:.6}", ice.epsilon(g));
    let expected = [0.0001, 0.001, 0.01].map(line).join("\n");
    assert_eq!(String::from_utf8(output.stdout).unwrap().trim(), expected);
}
