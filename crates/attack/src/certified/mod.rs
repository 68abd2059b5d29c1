//! Certified values: independent ways contradict each other on random laws, dampings, ends and digits.

mod closed_form;
mod decimal;
pub mod energy;
mod expansion;
mod integration;
mod laws;

use crate::random::Source;
use crate::{Part, Size, Tally};
use rand::RngExt;

/// One attack.
type Way = fn(&mut Source, &mut Tally);

/// How often each way comes up: the cheap ones most.
const WAYS: [(u32, Way); 9] = [
    (30, integration::other_digits),
    (25, closed_form::attack),
    (10, integration::order),
    (8, integration::loss),
    (5, integration::interval),
    (2, integration::energy),
    (6, expansion::other_digits),
    (7, expansion::identity),
    (7, expansion::against_integration),
];

/// Integration, expansion, closed forms and the energy against each other.
#[derive(Debug)]
pub struct Certified;

impl Part for Certified {
    fn name(&self) -> &'static str {
        "certified"
    }

    fn about(&self) -> &'static str {
        "a law, a damping, an end, digits: integration, expansion, closed form, energy and other digits agree"
    }

    fn cases(&self, size: Size) -> u64 {
        match size {
            Size::Slice => 60,
            Size::Minutes => 2_000,
            Size::Full => 100_000,
        }
    }

    fn attack(&self, random: &mut Source, tally: &mut Tally) {
        tally.count("certified requests", 1);
        let mut at = random.random_range(0..WAYS.iter().map(|(weight, _)| weight).sum());
        let chosen = WAYS.iter().find(|(weight, _)| {
            let here = at < *weight;
            at = at.saturating_sub(*weight);
            here
        });
        let (_, way) = chosen.unwrap_or(&WAYS[0]);
        way(random, tally);
    }
}

/// Notes a refusal by its kind: the message without its numbers.
fn refused(request: &str, message: &str, tally: &mut Tally) {
    let mut kind = String::new();
    for word in message.split(' ') {
        let numeric = word.contains(|c: char| c.is_ascii_digit());
        kind.push_str(if numeric { "#" } else { word });
        kind.push(' ');
    }
    tally.example(&format!("refused: {}", kind.trim_end()), request);
}
