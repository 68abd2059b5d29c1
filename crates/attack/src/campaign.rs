//! Runs parts case by case over all cores, with one line of progress, and sums up.

use crate::random;
use crate::state::{Progress, State};
use crate::{Part, Tally};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};

/// How long a round of cases should last: the state is written after each.
const ROUND: Duration = Duration::from_secs(5);

/// Attacks one case; a panic is a fault of its own.
pub fn attack_case(part: &dyn Part, seed: u64, number: u64) -> Tally {
    let mut tally = Tally::default();
    let mut random = random::source(seed, part.name(), number);
    if let Err(panic) = catch_unwind(AssertUnwindSafe(|| part.attack(&mut random, &mut tally))) {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("a panic");
        tally.fault("no panic", text);
    }
    tally
}

/// Attacks the cases up to `cases` that have not been attacked yet, saving `state` to `file` in between.
///
/// # Errors
///
/// If the state cannot be written.
pub fn run(part: &dyn Part, cases: u64, state: &mut State, file: Option<&Path>) -> io::Result<()> {
    let seed = state.seed;
    let bar = bar(part.name(), cases);
    let mut round = 1;
    loop {
        let progress = state.parts.entry(part.name().to_owned()).or_default();
        bar.set_position(progress.done);
        bar.set_message(format!("{} faults", progress.tally.faults_found()));
        let next = cases.min(progress.done + round);
        if progress.done >= next {
            break;
        }
        let started = Instant::now();
        one_round(part, seed, progress, next);
        let spent = started.elapsed();
        progress.seconds += spent.as_secs_f64();
        round = (round * 2)
            .min((round as f64 * (ROUND.as_secs_f64() / spent.as_secs_f64().max(1e-6))).ceil() as u64)
            .max(1);
        if let Some(file) = file {
            state.save(file)?;
        }
    }
    bar.finish_and_clear();
    Ok(())
}

fn one_round(part: &dyn Part, seed: u64, progress: &mut Progress, next: u64) {
    let attacked = |number: u64| {
        let started = Instant::now();
        (number, attack_case(part, seed, number), started.elapsed().as_secs_f64())
    };
    let numbers = progress.done..next;
    let found: Vec<_> = if part.alone() {
        numbers.map(attacked).collect()
    } else {
        numbers.into_par_iter().map(attacked).collect()
    };
    for (number, tally, seconds) in found {
        if seconds > progress.slowest.1 {
            progress.slowest = (number, seconds);
        }
        progress.tally.add(number, tally);
    }
    progress.done = next;
}

fn bar(name: &'static str, cases: u64) -> ProgressBar {
    let style =
        ProgressStyle::with_template("{prefix:10} {bar:30} {pos}/{len} {msg} {elapsed} of {duration}");
    ProgressBar::new(cases)
        .with_prefix(name)
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Size;
    use crate::random::Source;

    struct Odd;

    impl Part for Odd {
        fn name(&self) -> &'static str {
            "odd"
        }
        fn about(&self) -> &'static str {
            "panics once and finds a fault once"
        }
        fn cases(&self, _: Size) -> u64 {
            10
        }
        fn attack(&self, random: &mut Source, tally: &mut Tally) {
            use rand::Rng;
            tally.count("cases", 1);
            tally.measure("value", (random.next_u64() % 1000) as f64);
        }
    }

    struct Panics;

    impl Part for Panics {
        fn name(&self) -> &'static str {
            "panics"
        }
        fn about(&self) -> &'static str {
            "panics"
        }
        fn cases(&self, _: Size) -> u64 {
            1
        }
        fn attack(&self, _: &mut Source, _: &mut Tally) {
            panic!("as expected")
        }
    }

    #[test]
    fn a_campaign_in_two_runs_is_one() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("state");
        let mut whole = State::open(&file, 1).unwrap();
        run(&Odd, 100, &mut whole, None).unwrap();
        run(&Odd, 30, &mut State::open(&file, 1).unwrap(), Some(&file)).unwrap();
        let mut resumed = State::open(&file, 1).unwrap();
        assert_eq!(resumed.parts["odd"].done, 30);
        run(&Odd, 100, &mut resumed, Some(&file)).unwrap();
        assert_eq!(resumed.parts["odd"].tally, whole.parts["odd"].tally);
        assert_eq!(resumed.parts["odd"].tally.counts["cases"], 100);
    }

    #[test]
    fn a_panic_is_a_fault() {
        let tally = attack_case(&Panics, 1, 0);
        assert_eq!((tally.faults_found(), tally.faults[0].seen.as_str()), (1, "as expected"));
    }
}
