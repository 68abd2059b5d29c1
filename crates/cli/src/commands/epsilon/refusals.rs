//! Requests of a list that have no value, and one line that says so.

use crate::CliError;
use restitution_direct::DirectError;

/// As many names as are listed in a message.
const NAMED: usize = 5;

/// Requests without a value, grouped by what is wrong with them.
#[derive(Default)]
pub(super) struct Refusals {
    /// The first error of a kind, and who else has met it.
    groups: Vec<(DirectError, Vec<String>)>,
}

impl Refusals {
    /// Adds what a request, as it was typed, met instead of a value.
    pub(super) fn add(&mut self, name: &str, error: DirectError) {
        let same = |(known, _): &&mut (DirectError, Vec<String>)| {
            std::mem::discriminant(known) == std::mem::discriminant(&error)
        };
        match self.groups.iter_mut().find(same) {
            Some((_, names)) => names.push(name.to_owned()),
            None => self.groups.push((error, vec![name.to_owned()])),
        }
    }

    /// How many requests have no value.
    pub(super) fn count(&self) -> usize {
        self.groups.iter().map(|(_, names)| names.len()).sum()
    }

    /// Whether nothing failed: that bodies do not separate is a fact about them.
    pub(super) fn all_are_facts(&self) -> bool {
        let fact = |error: &DirectError| {
            matches!(error, DirectError::Overdamped { .. } | DirectError::Vanishing { .. })
        };
        self.groups.iter().all(|(error, _)| fact(error))
    }

    /// The line to print, for a column of this name with so many rows; `None` if every request has a value.
    pub(super) fn error(&self, column: &str, rows: usize) -> Option<CliError> {
        let reason = |(error, names): &(DirectError, Vec<String>)| {
            if rows == 1 {
                return error.to_string();
            }
            let more = names.len().saturating_sub(NAMED);
            let others = if more > 0 { format!(" and {more} more") } else { String::new() };
            format!("no value for {column} = {}{others}: {error}", names[..names.len() - more].join(", "))
        };
        let reasons = self.groups.iter().map(reason).collect::<Vec<_>>().join("; ");
        (!reasons.is_empty()).then(|| CliError::failure(reasons))
    }
}
