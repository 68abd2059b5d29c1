//! `restitution-attack`: runs the attacks and sums up.

use clap::Parser;
use restitution_attack::state::State;
use restitution_attack::{Part, Size, campaign, parts};
use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

/// Attack the promises of the project with random and adversarial requests
#[derive(Debug, Parser)]
#[command(name = "restitution-attack")]
struct Arguments {
    /// The parts to run [default: all]
    parts: Vec<String>,
    /// How much is attacked
    #[arg(long, value_enum, default_value = "minutes")]
    size: Size,
    /// Cases of each part, instead of what the size gives
    #[arg(long)]
    cases: Option<u64>,
    /// The seed of all random values
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Attack this case alone and say what it finds
    #[arg(long, value_name = "NUMBER")]
    case: Option<u64>,
    /// Where the state is kept, from which an interrupted run goes on [default: beside this program]
    #[arg(long)]
    state: Option<PathBuf>,
    /// Forget the state and start again
    #[arg(long)]
    fresh: bool,
    /// Threads [default: one for each core]
    #[arg(long)]
    jobs: Option<usize>,
    /// The command that is attacked [default: restitution beside this program]
    #[arg(long)]
    command: Option<PathBuf>,
    /// List the parts
    #[arg(long)]
    list: bool,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("restitution-attack: {error}");
            ExitCode::from(2)
        }
    }
}

/// Returns whether every promise held.
fn run(arguments: &Arguments) -> io::Result<bool> {
    let command = match &arguments.command {
        Some(command) => command.canonicalize()?,
        None => std::env::current_exe()?.with_file_name("restitution"),
    };
    let chosen = chosen(parts::all(command), &arguments.parts)?;
    if arguments.list {
        chosen.iter().for_each(|part| println!("{:10} {}", part.name(), part.about()));
        return Ok(true);
    }
    if let Some(jobs) = arguments.jobs {
        rayon::ThreadPoolBuilder::new().num_threads(jobs).build_global().map_err(io::Error::other)?;
    }
    match arguments.case {
        Some(case) => Ok(one_case(&chosen, arguments.seed, case)),
        None => {
            std::panic::set_hook(Box::new(|_| {})); // the tally says it
            all_cases(&chosen, arguments)
        }
    }
}

fn one_case(chosen: &[Box<dyn Part>], seed: u64, case: u64) -> bool {
    chosen.iter().fold(true, |all, part| {
        let tally = campaign::attack_case(part.as_ref(), seed, case);
        print!("{}, case {case}\n{}", part.name(), tally.lines());
        all & (tally.faults_found() == 0)
    })
}

fn all_cases(chosen: &[Box<dyn Part>], arguments: &Arguments) -> io::Result<bool> {
    let file = match &arguments.state {
        Some(file) => file.clone(),
        None => std::env::current_exe()?.with_file_name("attack.json"),
    };
    let fresh = State { seed: arguments.seed, ..State::default() };
    let mut state = if arguments.fresh { fresh } else { State::open(&file, arguments.seed)? };
    let mut all = true;
    for part in chosen {
        let cases = arguments.cases.unwrap_or_else(|| part.cases(arguments.size));
        campaign::run(part.as_ref(), cases, &mut state, Some(&file))?;
        let progress = &state.parts[part.name()];
        println!(
            "{}: {} cases in {:.0} s, seed {}; the slowest, {}, took {:.1} s",
            part.name(),
            progress.done,
            progress.seconds,
            state.seed,
            progress.slowest.0,
            progress.slowest.1
        );
        print!("{}", progress.tally.lines());
        all &= progress.tally.faults_found() == 0;
    }
    Ok(all)
}

fn chosen(all: Vec<Box<dyn Part>>, names: &[String]) -> io::Result<Vec<Box<dyn Part>>> {
    let known = all.iter().map(|part| part.name()).collect::<Vec<_>>();
    if let Some(name) = names.iter().find(|name| !known.contains(&name.as_str())) {
        return Err(io::Error::other(format!(
            "there is no part {name:?}: give some of {}",
            known.join(", ")
        )));
    }
    let wanted = |name: &str| names.is_empty() || names.iter().any(|wanted| wanted == name);
    Ok(all.into_iter().filter(|part| wanted(part.name())).collect())
}
