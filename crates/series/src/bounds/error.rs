/// Why no bound on the tails of the trajectories could be proved.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BoundError {
    /// No disc that reaches beyond the turning point passed the test of the theorem.
    #[error(
        "no convergence beyond the turning point could be proved for the law {law} with {terms} leading terms: \
         choose exponents A,GAMMA nearer to 3/2,1/2"
    )]
    TurningPointNotReached {
        /// The law, as `A,GAMMA`.
        law: String,
        /// The leading terms of the undamped trajectory that were enclosed.
        terms: usize,
    },
}
