//! What an attack counted, measured and found.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt::{Display, Write};

/// Faults of one promise that are kept word by word; all are counted.
const FAULTS_KEPT: u64 = 10;

/// Counts, largest errors and faults; sums of tallies do not depend on the order of their parts but for the faults kept.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Tally {
    /// How often something happened.
    pub counts: BTreeMap<String, u64>,
    /// The largest value of something measured.
    pub largest: BTreeMap<String, f64>,
    /// Examples of what is counted, the first of each kind.
    pub examples: BTreeMap<String, Vec<String>>,
    /// How often each promise was broken.
    pub broken: BTreeMap<String, u64>,
    /// The first faults of each promise.
    pub faults: Vec<Fault>,
}

/// Examples of one kind that are kept.
const EXAMPLES_KEPT: usize = 4;

/// A promise that was broken.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fault {
    /// The number of the case, by which it is repeated.
    pub case: u64,
    /// The promise.
    pub promise: String,
    /// What was seen.
    pub seen: String,
}

impl Tally {
    /// Counts `n` more of something.
    pub fn count(&mut self, what: &str, n: u64) {
        match self.counts.get_mut(what) {
            Some(count) => *count += n,
            None => drop(self.counts.insert(what.to_owned(), n)),
        }
    }

    /// Keeps the larger of `value` and what was measured before.
    pub fn measure(&mut self, what: &str, value: f64) {
        match self.largest.get_mut(what) {
            Some(largest) => *largest = largest.max(value),
            None => drop(self.largest.insert(what.to_owned(), value)),
        }
    }

    /// Counts one more of something and keeps an example of it.
    pub fn example(&mut self, what: &str, seen: impl Display) {
        self.count(what, 1);
        let kept = self.examples.entry(what.to_owned()).or_default();
        if kept.len() < EXAMPLES_KEPT {
            kept.push(seen.to_string());
        }
    }

    /// Notes a broken promise.
    pub fn fault(&mut self, promise: &str, seen: impl Display) {
        let found = self.broken.entry(promise.to_owned()).or_default();
        *found += 1;
        if *found <= FAULTS_KEPT {
            self.faults.push(Fault { case: 0, promise: promise.to_owned(), seen: seen.to_string() });
        }
    }

    /// How many faults were found.
    pub fn faults_found(&self) -> u64 {
        self.broken.values().sum()
    }

    /// Notes a broken promise unless `kept`.
    pub fn expect<S: Display>(&mut self, kept: bool, promise: &str, seen: impl FnOnce() -> S) {
        if !kept {
            self.fault(promise, seen());
        }
    }

    /// Adds what case `number` found.
    pub fn add(&mut self, number: u64, other: Self) {
        for (what, n) in other.counts {
            self.count(&what, n);
        }
        for (what, value) in other.largest {
            self.measure(&what, value);
        }
        for (what, examples) in other.examples {
            let kept = self.examples.entry(what).or_default();
            kept.extend(examples.into_iter().take(EXAMPLES_KEPT.saturating_sub(kept.len())));
        }
        for fault in other.faults {
            let kept = self.faults.iter().filter(|known| known.promise == fault.promise).count() as u64;
            if kept < FAULTS_KEPT {
                self.faults.push(Fault { case: number, ..fault });
            }
        }
        for (promise, n) in other.broken {
            *self.broken.entry(promise).or_default() += n;
        }
    }

    /// Returns counts, largest values and faults, a line each.
    pub fn lines(&self) -> String {
        let mut text = String::new();
        for (what, n) in &self.counts {
            let _ = writeln!(text, "  {n:>12}  {what}");
            for example in self.examples.get(what).into_iter().flatten() {
                let _ = writeln!(text, "                e.g. {example}");
            }
        }
        for (what, value) in &self.largest {
            let _ = writeln!(text, "  {value:>12.3e}  {what}, largest");
        }
        let _ = writeln!(text, "  {:>12}  faults", self.faults_found());
        for (promise, n) in &self.broken {
            let _ = writeln!(text, "  {n:>12}  times broken: {promise}");
            for fault in self.faults.iter().filter(|fault| fault.promise == *promise) {
                let _ = writeln!(text, "                case {}: {}", fault.case, fault.seen);
            }
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_keep_counts_maxima_and_faults() {
        let mut one = Tally::default();
        one.count("arguments", 3);
        one.measure("error", 2.0);
        let mut other = one.clone();
        other.measure("error", 5.0);
        other.fault("in [0, 1]", 1.5);
        one.add(7, other);
        assert_eq!((one.counts["arguments"], one.largest["error"], one.faults_found()), (6, 5.0, 1));
        assert_eq!(one.faults[0].case, 7);
        assert!(one.lines().contains("case 7: 1.5"));
    }

    #[test]
    fn many_faults_are_counted_and_few_are_kept() {
        let mut tally = Tally::default();
        (0..1000).for_each(|i| tally.fault("promise", i));
        assert_eq!((tally.faults_found(), tally.faults.len() as u64), (1000, FAULTS_KEPT));
    }
}
