//! Compilers and interpreters, which may be missing.

use std::fs;
use std::path::Path;
use std::process::Command;

/// Runs `command`; `None`, with a line that says so, if the tool is missing, which continuous
/// integration does not allow.
pub fn run(command: &mut Command, input: Option<&Path>) -> Option<String> {
    if let Some(input) = input {
        command.stdin(fs::File::open(input).unwrap());
    }
    let tool = command.get_program().to_string_lossy().into_owned();
    match command.output() {
        Ok(output) => {
            let (out, error) =
                (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
            assert!(output.status.success(), "{command:?}: {out} {error}");
            Some(out.into_owned())
        }
        Err(error) => skip(&tool, &error.to_string()),
    }
}

/// Says that a tool is missing.
pub fn skip<T>(tool: &str, reason: &str) -> Option<T> {
    assert!(std::env::var_os("CI").is_none(), "{tool} is missing ({reason}): make test-tools installs it");
    eprintln!("skipped: {tool} is missing ({reason}); make test-tools installs it");
    None
}

/// The command for a program in a folder.
pub fn command(program: &str, folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(program);
    command.current_dir(folder).args(arguments);
    command
}

/// Compiles with each list of arguments in turn and returns the last program, after running the others.
pub fn compiled(
    folder: &Path,
    compiler: &str,
    flags: &[&str],
    programs: &[(&[&str], &str)],
) -> Option<Command> {
    let mut last = None;
    for (arguments, program) in programs {
        let arguments = [flags, *arguments, &["-o", *program]].concat();
        run(&mut command(compiler, folder, &arguments), None)?;
        if let Some(before) = last.replace(folder.join(program)) {
            run(&mut Command::new(before), None)?;
        }
    }
    last.map(Command::new)
}

/// The Rust compiler of this build.
pub fn rustc() -> String {
    std::env::var("RUSTC").unwrap_or_else(|_| "rustc".into())
}

/// A Python that has NumPy: the first on the path, or the system's, for which packages install it.
pub fn python_with_numpy() -> Option<&'static str> {
    let has_numpy = |python: &&str| {
        let import = Command::new(python).args(["-c", "import numpy"]).output();
        import.is_ok_and(|output| output.status.success())
    };
    let found = ["python3", "/usr/bin/python3"].into_iter().find(has_numpy);
    found.or_else(|| skip("numpy", "no python3 can import it"))
}
