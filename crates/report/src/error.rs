use std::fmt::Display;

/// Why a report could not be made: what a library said, or what is wrong with the report of another build.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct ReportError(String);

impl ReportError {
    pub(crate) fn failure(said: impl Display) -> Self {
        Self(said.to_string())
    }
}

macro_rules! said_by {
    ($($error:ty),*) => {$(
        impl From<$error> for ReportError {
            fn from(error: $error) -> Self {
                Self::failure(error)
            }
        }
    )*};
}

said_by!(
    restitution_direct::DirectError,
    restitution_law::LawError,
    restitution_pade::PadeError,
    restitution_real::RealError,
    restitution_series::SeriesError
);
