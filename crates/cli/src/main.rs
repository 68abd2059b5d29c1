//! The command `restitution`.

fn main() -> std::process::ExitCode {
    restitution_cli::interrupt::install();
    restitution_cli::run(std::env::args_os()).map_or_else(|error| error.report(), |()| 0.into())
}
