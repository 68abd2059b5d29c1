//! The command `restitution`.

fn main() -> std::process::ExitCode {
    restitution_cli::interrupt::install();
    let run = || restitution_cli::run(std::env::args_os());
    restitution_cli::unexpected::caught(run).map_or_else(|error| error.report(), |()| 0.into())
}
