//! Names: several sources in one program, and names that are none.

use super::listings;
use super::tools::{command, compiled, run, rustc};
use restitution_export::{CharacteristicVelocity, ExportError, LANGUAGES, Language};
use std::fs;
use std::path::Path;

/// Writes both ends of contact, as `near` and as `far`, for ice with `g* = 0.0032 m/s`.
fn write_two(language: &str, folder: &Path) -> [String; 2] {
    let language = Language::of(language).unwrap();
    let ice = CharacteristicVelocity { metres_per_second: 0.0032, origin: "given".into() };
    ["near", "far"].map(|name| {
        let listing = &listings()[usize::from(name == "far")];
        let source = language.write(&listing.clone().with_velocity(ice.clone()), name).unwrap();
        let file = language.file.replace("NAME", name);
        fs::write(folder.join(&file), source).unwrap();
        file
    })
}

/// The same five values in every language, of the size of a velocity.
fn expected() -> Vec<f64> {
    let of = |listing: usize, g: f64| {
        let u = 0.866_965_182_705_471_4 * (g / 0.0032).powf(0.2);
        listings()[listing].pieces.epsilon(u)
    };
    vec![of(0, 0.001), of(1, 0.001), of(1, 0.001), of(0, 0.05), of(1, 0.05)]
}

fn agrees(output: Option<String>) {
    let Some(output) = output else { return };
    let values: Vec<f64> = output.split_whitespace().map(|word| word.parse().unwrap()).collect();
    assert_eq!(values.len(), 5, "{output}");
    for (value, expected) in values.iter().zip(expected()) {
        assert!((value / expected - 1.0).abs() <= 1e-14, "{output}");
    }
}

#[test]
fn two_in_a_rust_file() {
    let folder = tempfile::tempdir().unwrap();
    let [near, far] = write_two("rust", folder.path());
    let main = format!(
        "include!({near:?});\ninclude!({far:?});\nfn main() {{\n    println!(\"{{:e}} {{:e}} {{:e}} {{:e}} {{:e}}\", \
         near_epsilon_at_m_per_s(-0.001), far_epsilon_at_m_per_s(0.001), far_epsilon_of_velocity(-0.1, 0.32), \
         near_epsilon_at_m_per_s(0.05), far_epsilon(far_u_at_m_per_s(0.05)));\n}}\n"
    );
    fs::write(folder.path().join("main.rs"), main).unwrap();
    let flags = ["--edition=2021", "-Dwarnings"];
    agrees(
        compiled(folder.path(), &rustc(), &flags, &[(&["main.rs"], "main")])
            .and_then(|mut main| run(&mut main, None)),
    );
}

#[test]
fn two_in_a_c_and_a_cpp_file() {
    for (compiler, language) in [("gcc", "c"), ("g++", "c++")] {
        let folder = tempfile::tempdir().unwrap();
        let [near, far] = write_two("c", folder.path());
        let main = format!(
            "#include \"{near}\"\n#include \"{far}\"\n#include \"{near}\"\n#include <stdio.h>\nint main(void)\n{{\n    \
             printf(\"%.17g %.17g %.17g %.17g %.17g\\n\", near_epsilon_at_m_per_s(-0.001), \
             far_epsilon_at_m_per_s(0.001), far_epsilon_of_velocity(-0.1, 0.32), near_epsilon_at_m_per_s(0.05), \
             far_epsilon(far_u_at_m_per_s(0.05)));\n    return 0;\n}}\n"
        );
        fs::write(folder.path().join("main.c"), main).unwrap();
        let flags = ["-x", language, "-Wall", "-Wextra", "-Werror"];
        agrees(
            compiled(folder.path(), compiler, &flags, &[(&["main.c", "-lm"], "main")])
                .and_then(|mut main| run(&mut main, None)),
        );
    }
}

#[test]
fn two_in_a_fortran_program_of_either_extension() {
    for extension in ["f90", "F90"] {
        let folder = tempfile::tempdir().unwrap();
        for file in write_two("fortran", folder.path()) {
            fs::rename(folder.path().join(&file), folder.path().join(file.replace("f90", extension)))
                .unwrap();
        }
        let main = "program main\n    use near\n    use far\n    implicit none\n    call near_self_check()\n    \
                    print '(5(es24.16, 1x))', near_epsilon_at_m_per_s(-0.001d0), far_epsilon_at_m_per_s(0.001d0), &\n    \
                    far_epsilon_of_velocity(-0.1d0, 0.32d0), near_epsilon_at_m_per_s(0.05d0), &\n    \
                    far_epsilon(far_u_at_m_per_s(0.05d0))\nend program\n";
        fs::write(folder.path().join("main.f90"), main).unwrap();
        let files = [&format!("near.{extension}"), &format!("far.{extension}"), "main.f90"];
        let output = compiled(folder.path(), "gfortran", &["-Wall", "-Werror"], &[(&files, "main")])
            .and_then(|mut main| run(&mut main, None));
        agrees(output.map(|output| output.lines().skip(1).collect::<Vec<_>>().join(" ")));
    }
}

#[test]
fn two_in_a_python_file() {
    let folder = tempfile::tempdir().unwrap();
    let text: String = write_two("python", folder.path())
        .map(|file| fs::read_to_string(folder.path().join(file)).unwrap())
        .concat();
    fs::write(
        folder.path().join("both.py"),
        text.replace("raise SystemExit(0 if kept else 1)", "assert kept"),
    )
    .unwrap();
    let code = "import both as b; print(b.near_epsilon_at_m_per_s(-0.001), b.far_epsilon_at_m_per_s(0.001), \
                b.far_epsilon_of_velocity(-0.1, 0.32), b.near_epsilon_at_m_per_s(0.05), b.far_epsilon(b.far_u_at_m_per_s(0.05)))";
    run(&mut command("python3", folder.path(), &["both.py"]), None);
    agrees(run(&mut command("python3", folder.path(), &["-c", code]), None));
}

#[test]
fn two_in_an_octave_folder() {
    let folder = tempfile::tempdir().unwrap();
    write_two("matlab", folder.path());
    let code = "printf('%.17g ', near_epsilon(-0.001, 'm/s'), far_epsilon(0.001, 'm/s'), far_epsilon(-0.1, 0.32), \
                near_epsilon(0.05, 'm/s'), far_epsilon(0.05, 'm/s'))";
    let arguments = ["--no-gui", "--quiet", "--no-init-file", "--no-history", "--eval", code];
    agrees(run(&mut command("octave-cli", folder.path(), &arguments), None));
}

#[test]
fn a_name_is_an_identifier_that_the_source_does_not_use() {
    for language in LANGUAGES {
        for name in ["", "1st", "_x", "a-b", "a b", "é", "x;y", "a*/b", &"n".repeat(41)] {
            assert!(
                matches!(language.check(name), Err(ExportError::Name { .. })),
                "{}: {name}",
                language.name
            );
        }
        for name in ["restitution", "Ice_2", "n", &"n".repeat(40)] {
            language.check(name).unwrap();
        }
    }
    let error = Language::of("f90").unwrap().check("DP").unwrap_err().to_string();
    assert_eq!(
        error,
        "\"DP\" is no name in fortran: the language or the source itself uses it, choose another"
    );
}

#[test]
fn every_field_of_every_template_is_filled() {
    let field = |text: &str| {
        let mut rest = text;
        while let Some((_, after)) = rest.split_once('{') {
            let word: String = after.chars().take_while(|c| c.is_ascii_uppercase() || *c == '_').collect();
            if word.len() > 1 && after[word.len()..].starts_with('}') {
                return Some(word);
            }
            rest = after;
        }
        None
    };
    for language in LANGUAGES {
        for listing in listings() {
            let text = language.write(listing, "tried").unwrap();
            assert_eq!(field(&text), None, "{}", language.name);
            let conditions = ["?LAW", "!LAW", "?NEAR", "!NEAR", "?ROOT", "!ROOT", "?VELOCITY"];
            assert!(conditions.iter().all(|mark| !text.contains(mark)), "{}", language.name);
        }
    }
}
