//! Command lines as the command declares them: subcommands, options, how many values they take.

use super::values::value;
use crate::random::{Source, choose};
use clap::{Arg, ArgAction};
use rand::RngExt;
use std::ffi::OsString;

/// The whole command line, as clap knows it.
#[derive(Debug)]
pub struct Grammar {
    command: clap::Command,
}

/// Subcommands that take seconds by themselves.
const SLOW: [&str; 3] = ["report", "audit", "export"];
/// One in how many of their lines is run.
const SLOW_RATIO: u32 = 100;

impl Grammar {
    /// Reads the grammar of a command.
    pub fn of(mut command: clap::Command) -> Self {
        command.build();
        Self { command }
    }

    /// The subcommands, by name.
    pub fn subcommands(&self) -> Vec<&clap::Command> {
        self.command.get_subcommands().filter(|command| command.get_name() != "help").collect()
    }

    /// Returns the arguments of a random request, often a sound one.
    pub fn line(&self, random: &mut Source) -> Vec<OsString> {
        let command = loop {
            let command = *choose(random, &self.subcommands());
            if !is_slow(command.get_name()) || random.random_ratio(1, SLOW_RATIO) {
                break command;
            }
        };
        let mut line = vec![command.get_name().into()];
        let arguments: Vec<&Arg> = command.get_arguments().collect();
        // Few options at once are often a sound request, many seldom.
        let likelihood = *choose(random, &[0.05, 0.15, 0.15, 0.3]);
        for argument in arguments {
            let unwanted = matches!(argument.get_id().as_str(), "help" | "version");
            let wanted = argument.is_required_set() || argument.is_positional() && random.random_bool(0.7);
            if wanted || random.random_bool(if unwanted { 0.005 } else { likelihood }) {
                line.extend(occurrence(argument, command.get_name(), random));
            }
        }
        line
    }
}

/// Whether a subcommand takes seconds by itself.
pub fn is_slow(subcommand: &str) -> bool {
    SLOW.contains(&subcommand)
}

/// An option with its values, in one of the ways to write it.
fn occurrence(argument: &Arg, command: &str, random: &mut Source) -> Vec<OsString> {
    let mut words = Vec::new();
    let long = argument.get_long().map(|name| format!("--{name}"));
    let short = argument.get_short().map(|letter| format!("-{letter}"));
    let name = if random.random_bool(0.5) { short.or(long) } else { long.or(short) };
    let takes_values = matches!(argument.get_action(), ArgAction::Set | ArgAction::Append);
    if !takes_values {
        words.extend(name.map(OsString::from));
        return words;
    }
    let range = argument.get_num_args().unwrap_or(1.into());
    let most = range.max_values().min(4);
    let count = random.random_range(range.min_values().min(most)..=most);
    let mut values: Vec<String> = (0..count.max(1)).map(|_| value(argument, command, random)).collect();
    if let Some(delimiter) = argument.get_value_delimiter().filter(|_| random.random_bool(0.5)) {
        values = vec![values.join(&delimiter.to_string())];
    }
    match name {
        Some(name) if range.min_values() == 0 || random.random_bool(0.2) => {
            words.push(format!("{name}={}", values.join(",")).into());
        }
        name => {
            words.extend(name.map(OsString::from));
            words.extend(values.into_iter().map(OsString::from));
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::source;

    #[test]
    fn every_subcommand_and_option_comes_up() {
        let grammar = Grammar::of(restitution_cli::commands::command());
        let lines: Vec<String> = (0..4000)
            .map(|i| {
                let line = grammar.line(&mut source(1, "grammar", i));
                line.into_iter().map(|word| word.into_string().unwrap()).collect::<Vec<_>>().join(" ")
            })
            .collect();
        for command in grammar.subcommands() {
            let own: Vec<_> = lines.iter().filter(|line| line.starts_with(command.get_name())).collect();
            assert!(!own.is_empty(), "{}", command.get_name());
            for long in command.get_arguments().filter_map(Arg::get_long) {
                let seldom = long == "help" || is_slow(command.get_name());
                let short = command.get_arguments().find(|a| a.get_long() == Some(long)).unwrap().get_short();
                let found = own.iter().any(|line| {
                    line.contains(&format!(" --{long}"))
                        || short.is_some_and(|s| line.contains(&format!(" -{s}")))
                });
                assert!(found || seldom, "{} --{long}", command.get_name());
            }
        }
    }
}
