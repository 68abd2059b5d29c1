use restitution_direct::DirectError;

/// Why an evaluator could not be exported.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// A tolerance that is none.
    #[error("a tolerance is a relative error: give one from 1e-15 to 0.1")]
    WrongTolerance,
    /// A range that is none.
    #[error("a range of u is LO,HI: give 0 <= LO < HI <= 1e6")]
    WrongRange,
    /// No double-precision evaluator keeps this tolerance.
    #[error(
        "no evaluator of at most 64 KiB keeps {tolerance:e}, the best one {reached:.1e}: ask for a larger tolerance or a shorter range"
    )]
    Tolerance {
        /// The tolerance that was asked for.
        tolerance: f64,
        /// The least bound of what was tried.
        reached: f64,
    },
    /// The law at infinity keeps this tolerance only where the function is next to nothing.
    #[error(
        "the law at infinity keeps {tolerance:e} only beyond u = 6.9e10: ask for a larger tolerance, or for no value beyond the range"
    )]
    Law {
        /// The tolerance that was asked for.
        tolerance: f64,
    },
    /// A name that a language does not allow.
    #[error("{name:?} is no name in {language}: {reason}")]
    Name {
        /// The name.
        name: String,
        /// The language.
        language: &'static str,
        /// What is wrong with it, and what would be right.
        reason: &'static str,
    },
    /// A language that is not known.
    #[error("there is no language {name:?}: choose one of {known}")]
    Language {
        /// What was asked for.
        name: String,
        /// The languages that there are.
        known: String,
    },
    /// A characteristic velocity that no f64 holds.
    #[error(
        "the characteristic velocity is beyond what a double can hold: give bodies that dissipate some of their velocity"
    )]
    Velocity,
    /// The integrator could not prove a value.
    #[error(transparent)]
    Direct(#[from] DirectError),
}
