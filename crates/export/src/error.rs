use restitution_direct::DirectError;

/// Why an evaluator could not be exported.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// No double-precision evaluator keeps this tolerance.
    #[error(
        "no evaluator of at most 64 KiB keeps {tolerance:e}, the best one {reached:.1e}: give --tolerance from 1e-15 to 0.1, or a shorter --range"
    )]
    Tolerance {
        /// The tolerance that was asked for.
        tolerance: f64,
        /// The bound of what was tried last.
        reached: f64,
    },
    /// The integrator could not prove a value.
    #[error(transparent)]
    Direct(#[from] DirectError),
}
