//! The command `restitution`.

fn main() -> std::process::ExitCode {
    restitution_cli::interrupt::install();
    // The main thread computes too, instead of waiting for others to wake up where the cores are busy. What fails here
    // fails where threads are first needed, in words.
    let _ = rayon::ThreadPoolBuilder::new().use_current_thread().build_global();
    let run = || restitution_cli::run(std::env::args_os());
    restitution_cli::unexpected::caught(run).map_or_else(|error| error.report(), |()| 0.into())
}
