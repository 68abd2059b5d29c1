//! What every subcommand shares: wrong input, formats, `-o`, pipes, Ctrl-C.

use crate::support::{fail, files, one_line, restitution, succeed};
use std::fs;
use std::io::Read;
use std::process::Stdio;

#[test]
fn wrong_input_is_named_with_its_remedy() {
    let cases = [
        ("tabel", "a similar subcommand exists: 'table'"),
        ("table --ordre 4", "a similar argument exists: '--order'"),
        ("table --order 0", "give one from 1 to 100000"),
        ("table --order 1000000000", "give one from 1 to 100000"),
        ("table --order 99999999999999999999999", "give one from 1 to 100000"),
        ("table --order -3", "give one from 1 to 100000"),
        ("table --order 1.5", "give one from 1 to 100000"),
        ("table --order four", "give one from 1 to 100000"),
        ("table --order", "a value is required for '--order <K>'"),
        ("table --digits 0", "give one from 1 to 1000000"),
        ("table --digits 1000000000", "give one from 1 to 1000000"),
        ("table --digits -1", "give one from 1 to 1000000"),
        ("table --order 100000 --digits 1000000", "lower --order or --digits"),
        ("table --format xml", "[possible values: text, csv, json, latex, markdown, lookup]"),
        ("table --quantity x", "[possible values: C, a, y"),
        ("table --law 3/2", "write it as A,GAMMA"),
        ("table --law -1,0", "give A > 0"),
        ("table --law 1,-2", "give GAMMA > -1"),
        ("table extra", "see 'restitution table --help'"),
        ("trajectory --time-order 0", "give one up to 1000000"),
        (
            "table --order",
            "a value is required for '--order <K>' but none was supplied; see 'restitution table --help'",
        ),
        ("epsilon", "give --u <U>, --velocity <G> or --saturation"),
        ("epsilon --velocity 1cm/s", "give --g-star, or --dissipative-constant"),
        ("epsilon --velocity -1cm/s --g-star 1cm/s", "'-1cm/s' for --velocity is negative: give its size"),
        ("epsilon --velocity 1cm/s --g-star 0", "--g-star is 0: give --g-star with a positive value"),
        (
            "epsilon --velocity 1 --dissipative-constant 1us --radius 1cm",
            "give --young, --poisson and --density",
        ),
        ("epsilon --u 1 --g-star 1cm/s", "give --velocity, or leave them out"),
        ("epsilon --velocity 1 cm/s --g-star 1cm/s", "write 1cm/s, without a blank"),
        ("export --lang c --dissipative-constant 1us", "give --young, --poisson, --density and --radius"),
        ("material --young 1 GPa", "write 1GPa, without a blank"),
        ("pade", "give <L> <M> such as 3 8, or --table N, or --list"),
        ("pade 1", "give <L> <M>"),
        ("pade 1 6 --at-infinity 1", "write --at-infinity=1"),
        ("pade 1 11 --end zero-force --at-infinity", "leave --at-infinity out, or end the contact"),
        ("audit A99", "no claim is called A99"),
        ("trajectory --time-order -7/2", "'-7/2' for --time-order is negative"),
        ("trajectory --time-order 1e999999999", "give it with fewer"),
        ("trajectory --time-order 2/0", "write it as 0.1, 1e-12 or 1/3"),
        ("trajectory --damping-order 100001", "give one from 0 to 100000"),
        ("trajectory --damping-order 100000 --time-order 1000000", "lower --damping-order or --time-order"),
    ];
    for (line, remedy) in cases {
        let (code, message) = fail(line);
        assert_eq!(code, 2, "{line}: {message}");
        assert!(message.contains(remedy), "{line}: {message}");
    }
}

#[test]
fn the_command_alone_prints_its_help() {
    let help = succeed("");
    assert!(help.contains("Usage: restitution <COMMAND>") && help.contains("closed-form"), "{help}");
}

#[test]
fn what_does_not_fit_is_refused_with_the_estimate() {
    let (_, message) = fail("table --order 100000 --digits 1000000");
    assert!(message.starts_with("this needs about ") && message.contains("B of memory"), "{message}");
}

#[test]
fn hostile_arguments_stay_on_one_short_line() {
    for text in ["\n\n\x1b[31m", &"9".repeat(50_000), "\u{202e}", "%s%n", ""] {
        let (code, message) = one_line(&restitution("table --order").arg(text).output().unwrap());
        assert_eq!(code, 2);
        assert!(message.len() < 1000 && !message.contains('\x1b'), "{message}");
    }
}

#[test]
fn an_output_file_is_written_whole_and_alone() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("table.csv");
    let line = format!("table --quantity C --order 2 --format csv -o {}", file.display());
    assert_eq!(succeed(&line), "");
    let written = fs::read_to_string(&file).unwrap();
    assert_eq!(written, succeed("table --quantity C --order 2 --format csv"));
    fs::write(&file, "old").unwrap();
    assert_eq!(succeed(&line), "");
    assert_eq!(fs::read_to_string(&file).unwrap(), written);
    assert_eq!(files(folder.path()), ["table.csv"]);
    assert_eq!(succeed("table --quantity C --order 2 --format csv -o -"), written);
}

#[test]
fn an_output_that_cannot_be_written_is_a_failure_before_the_work_starts() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().display();
    let cases = [
        (format!("{path}"), "it is a directory: give -o the name of a file"),
        (format!("{path}/missing/table"), "make it first"),
    ];
    for (target, remedy) in cases {
        // An hour's work that must not begin.
        let (code, message) = fail(&format!("table --order 300 --digits 300 -o {target}"));
        assert_eq!(code, 1, "{message}");
        assert!(message.contains(remedy), "{message}");
    }
    assert!(files(folder.path()).is_empty());
}

#[test]
fn a_request_that_fails_leaves_the_old_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("table");
    fs::write(&file, "old").unwrap();
    fail(&format!("table --order 100000 --digits 1000000 -o {}", file.display()));
    assert_eq!(fs::read_to_string(&file).unwrap(), "old");
    assert_eq!(files(folder.path()), ["table"]);
}

#[cfg(unix)]
#[test]
fn an_output_file_keeps_its_permissions_and_links() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    let (file, link) = (folder.path().join("table"), folder.path().join("link"));
    fs::write(&file, "old").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    std::os::unix::fs::symlink(&file, &link).unwrap();
    succeed(&format!("table --order 1 -o {}", link.display()));
    assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o640);
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert_ne!(fs::read_to_string(&file).unwrap(), "old");
    succeed("table --order 1 -o /dev/null");
    assert!(!fs::metadata("/dev/null").unwrap().is_file());
}

#[test]
fn a_closed_pipe_ends_quietly() {
    // More than a pipe holds, so that the command notices.
    let line = "trajectory --damping-order 3 --time-order 300 --format csv";
    let mut child = restitution(line).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut stdout = child.stdout.take().unwrap();
    stdout.read_exact(&mut [0; 10]).unwrap();
    drop(stdout);
    let output = child.wait_with_output().unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    assert_eq!(output.status.code(), Some(0));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_a_failure() {
    let full = || fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = restitution("table --order 1").stdout(full()).output().unwrap();
    assert_eq!(one_line(&output), (1, "cannot write to stdout: no space left on device".to_owned()));
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_with_130_and_keeps_the_old_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("table");
    fs::write(&file, "old").unwrap();
    let line = format!("table --order 300 --digits 300 -o {}", file.display());
    let child = restitution(&line).stderr(Stdio::piped()).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(300));
    let kill = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(kill.unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{output:?}");
    assert_eq!(fs::read_to_string(&file).unwrap(), "old");
    assert_eq!(files(folder.path()), ["table"]);
}

#[test]
fn every_format_shows_the_same_numbers() {
    let line = |format: &str| succeed(&format!("table --quantity y --order 3 --digits 15 --format {format}"));
    let csv = line("csv");
    let values = csv.lines().skip(1).map(|row| row.split(',').nth(1).unwrap()).collect::<Vec<_>>();
    assert_eq!(values.len(), 4);
    for format in ["text", "json", "latex", "markdown"] {
        let shown = line(format);
        assert!(values.iter().all(|value| shown.contains(value)), "{format}: {shown}");
    }
    let json: serde_json::Value = serde_json::from_str(&line("json")).unwrap();
    assert_eq!(json[0]["value"], values[0]);
}

#[test]
fn help_and_completions_are_there() {
    for line in ["--help", "help table", "table -h", "--version", "completions bash", "completions man"] {
        assert!(succeed(line).contains("restitution"), "{line}");
    }
}

#[test]
fn values_are_as_long_as_asked_in_every_format() {
    for format in ["text", "csv", "json", "latex", "markdown"] {
        let text = succeed(&format!("table --quantity C --order 1 --digits 70000 --format {format}"));
        let digits = text.split(|c: char| !c.is_ascii_digit()).map(str::len).max();
        assert_eq!(digits, Some(69_999), "{format}");
    }
}

#[test]
fn closed_forms_give_the_digits_of_the_table() {
    for (order, value) in
        [(3, "0.34072902713580812231"), (5, "0.11416870530319278960"), (6, "0.066531829882492741785")]
    {
        for format in ["text", "json", "latex"] {
            let text = succeed(&format!("closed-form --order {order} --format {format}"));
            assert!(text.contains(value), "{text}");
        }
    }
    let text = succeed("closed-form --order 3");
    assert!(text.starts_with("a_3 = 7/25 + 575/1452 B(9/5, 3/2)/B(3/5, 3/2)^3\n"), "{text}");
    for (line, remedy) in [
        ("closed-form --order 13", "ask for a lower order"),
        ("closed-form --order 0", "give one from 1"),
        ("closed-form", "--order"),
        ("closed-form --order 4 --law -1,0", "give A > 0"),
        ("closed-form --order 4 --quantity h --law 1,2", "A > GAMMA"),
        ("closed-form --order 4 --digits 100000000", "give one from 1 to 1000000"),
    ] {
        let (_, message) = fail(line);
        assert!(message.contains(remedy), "{line}: {message}");
    }
}
