//! Exported sources are compiled, run, and compared with certified values.

use crate::certified::{exact, reference};
use restitution::End;
use restitution_export::{Language, Listing, design};
use rug::Float;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::sync::OnceLock;

/// Points of each comparison.
const POINTS: usize = 10_000;
/// Tolerance, range and end of contact of the sources that are tried.
const REQUESTS: [(f64, (f64, f64), End); 4] = [
    (1e-3, (0.0, 2.0), End::ZeroCompression),
    (1e-9, (0.0, 8.0), End::ZeroForce),
    (1e-14, (0.01, 40.0), End::ZeroCompression),
    (2e-15, (0.0, 10.0), End::ZeroForce),
];

/// Reads arguments, one a line, and prints values, for each language.
const RUST_DRIVER: &str = r#"
mod evaluator;
fn main() {
    for line in std::io::stdin().lines() {
        println!("{:e}", evaluator::epsilon(line.unwrap().trim().parse().unwrap()));
    }
}
"#;
const C_DRIVER: &str = r#"
#include "evaluator.h"
#include <stdio.h>
int main(void)
{
    double u, single, array;
    while (scanf("%lf", &u) == 1) {
        single = restitution_epsilon(u);
        restitution_epsilon_array(&u, &array, 1);
        if (memcmp(&single, &array, sizeof single))
            return 1;
        printf("%.17e\n", single);
    }
    return 0;
}
"#;
const FORTRAN_DRIVER: &str = r"
program driver
    use, intrinsic :: iso_fortran_env, only: dp => real64
    use restitution, only: restitution_epsilon
    implicit none
    real(dp) :: u
    integer :: status
    do
        read (*, *, iostat=status) u
        if (status /= 0) exit
        print '(es25.17e3)', restitution_epsilon(u)
    end do
end program
";
const PYTHON_DRIVER: &str = r"
import sys
import numpy as np
from evaluator import epsilon
numbers = [float(line) for line in sys.stdin]
single = [epsilon(u) for u in numbers]
several = epsilon(np.array(numbers))
assert several.shape == (len(numbers),) and all(several == np.array(single))
assert np.isnan(epsilon(np.array([-1.0, np.nan, 1e9]))).all()
for value in single:
    print(repr(value))
";

fn listings() -> &'static [Listing] {
    static LISTINGS: OnceLock<Vec<Listing>> = OnceLock::new();
    LISTINGS.get_or_init(|| {
        let listing = |(tolerance, range, end)| {
            let reference = reference(end);
            Listing::new(reference, design(reference, tolerance, range).unwrap(), tolerance, range)
        };
        REQUESTS.map(listing).into()
    })
}

/// Runs `command`; `None`, with a line that says so, if the tool is missing, which continuous
/// integration does not allow.
fn run(command: &mut Command, input: Option<&Path>) -> Option<String> {
    if let Some(input) = input {
        command.stdin(fs::File::open(input).unwrap());
    }
    let tool = command.get_program().to_string_lossy().into_owned();
    match command.output() {
        Ok(output) => {
            let error = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{command:?}: {error}");
            Some(String::from_utf8(output.stdout).unwrap())
        }
        Err(error) => skip(&tool, &error.to_string()),
    }
}

fn skip(tool: &str, reason: &str) -> Option<String> {
    assert!(std::env::var_os("CI").is_none(), "{tool} is missing ({reason}): make test-tools installs it");
    eprintln!("skipped: {tool} is missing ({reason}); make test-tools installs it");
    None
}

/// Writes the source and what drives it, runs the self-check and the driver, compares.
fn check(language: Language, source: &str, driver: (&str, &str), build: impl Fn(&Path) -> Option<Command>) {
    for listing in listings() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::write(at(source), language.write(listing)).unwrap();
        fs::write(at(driver.0), driver.1).unwrap();
        let arguments = arguments(listing.range);
        fs::write(at("arguments"), arguments.iter().map(|u| format!("{u:e}\n")).collect::<String>()).unwrap();
        let Some(mut evaluator) = build(folder.path()) else { return };
        let Some(output) = run(&mut evaluator, Some(&at("arguments"))) else { return };
        compare(listing, &arguments, &output, language);
    }
}

fn arguments((low, high): (f64, f64)) -> Vec<f64> {
    let spaced = |i: usize| low + (high - low) * (i as f64 / (POINTS - 1) as f64).powi(2);
    (0..POINTS).map(|i| spaced(i).clamp(low, high)).collect()
}

fn compare(listing: &Listing, arguments: &[f64], output: &str, language: Language) {
    let values: Vec<f64> = output.lines().map(|line| line.trim().parse().unwrap()).collect();
    assert_eq!(values.len(), arguments.len());
    let mut worst = 0.0_f64;
    for (u, value) in arguments.iter().zip(&values) {
        let (_, kept) = exact(reference(listing.end), *u);
        worst = worst.max((Float::with_val(112, value - &kept) / kept).to_f64().abs());
    }
    println!("{language:?}, {:e}, {:?}: {worst:.2e}", listing.tolerance, listing.end);
    assert!(worst <= listing.tolerance && worst <= 1.01 * listing.pieces.bound.total());
}

fn command(program: &str, folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(program);
    command.current_dir(folder).args(arguments);
    command
}

/// Builds and runs the self-check, then builds the driver.
fn compiled(folder: &Path, compiler: &str, self_check: &[&str], driver: &[&str]) -> Option<Command> {
    run(&mut command(compiler, folder, self_check), None)?;
    run(&mut Command::new(folder.join("check")), None)?;
    run(&mut command(compiler, folder, driver), None)?;
    Some(Command::new(folder.join("driver")))
}

#[test]
fn rust() {
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    check(Language::Rust, "evaluator.rs", ("driver.rs", RUST_DRIVER), |folder| {
        let flags = ["--edition=2021", "-O", "-Dwarnings", "-Adead_code", "-o"];
        compiled(
            folder,
            &rustc,
            &[&flags[..], &["check", "--test", "evaluator.rs"]].concat(),
            &[&flags[..], &["driver", "driver.rs"]].concat(),
        )
    });
}

#[test]
fn c_and_cpp() {
    for (compiler, standard, language) in [("gcc", "-std=c99", "c"), ("g++", "-std=c++11", "c++")] {
        check(Language::C, "evaluator.h", ("driver.c", C_DRIVER), |folder| {
            let flags = [standard, "-O2", "-Wall", "-Wextra", "-pedantic", "-Werror", "-x", language];
            compiled(
                folder,
                compiler,
                &[&flags[..], &["-DRESTITUTION_SELF_CHECK", "evaluator.h", "-o", "check", "-lm"]].concat(),
                &[&flags[..], &["driver.c", "-o", "driver", "-lm"]].concat(),
            )
        });
    }
}

#[test]
fn fortran() {
    check(Language::Fortran, "evaluator.f90", ("driver.f90", FORTRAN_DRIVER), |folder| {
        let flags = ["-std=f2008", "-O2", "-Wall", "-Werror", "-cpp"];
        compiled(
            folder,
            "gfortran",
            &[&flags[..], &["-DRESTITUTION_SELF_CHECK", "evaluator.f90", "-o", "check"]].concat(),
            &[&flags[..], &["evaluator.f90", "driver.f90", "-o", "driver"]].concat(),
        )
    });
}

/// A Python that has NumPy: the first on the path, or the system's, for which packages install it.
fn python_with_numpy() -> Option<&'static str> {
    let has_numpy = |python: &&str| {
        let import = Command::new(python).args(["-c", "import numpy"]).output();
        import.is_ok_and(|output| output.status.success())
    };
    ["python3", "/usr/bin/python3"].into_iter().find(has_numpy)
}

#[test]
fn python() {
    let Some(python) = python_with_numpy() else {
        skip("numpy", "no python3 can import it");
        return;
    };
    check(Language::Python, "evaluator.py", ("driver.py", PYTHON_DRIVER), |folder| {
        run(&mut command(python, folder, &["evaluator.py"]), None)?;
        Some(command(python, folder, &["driver.py"]))
    });
}

#[test]
fn what_cannot_be_kept_is_refused() {
    let refusal = design(reference(End::ZeroForce), 1e-16, (0.0, 8.0)).unwrap_err().to_string();
    assert!(refusal.starts_with("no evaluator of at most 64 KiB keeps 1e-16"), "{refusal}");
}
