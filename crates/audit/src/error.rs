use restitution_law::LawError;
use restitution_series::SeriesError;
use std::fmt::Display;

/// Why a claim could not be judged.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AuditError {
    /// No claim has this name or begins with it.
    #[error("no claim is called {name}: run 'restitution audit' for a list, or give an equation such as A26")]
    UnknownClaim {
        /// The name that was given.
        name: String,
    },
    /// A computation under a claim failed, or does not decide it.
    #[error("{0}")]
    Undecided(String),
}

impl AuditError {
    /// What a computation, or the comparison after it, says.
    pub(crate) fn failure(said: impl Display) -> Self {
        Self::Undecided(said.to_string())
    }
}

impl From<SeriesError> for AuditError {
    fn from(error: SeriesError) -> Self {
        Self::failure(error)
    }
}

impl From<LawError> for AuditError {
    fn from(error: LawError) -> Self {
        Self::failure(error)
    }
}
