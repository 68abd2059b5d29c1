//! The algebra of iterated integrals in which every coefficient lies (`docs/closed-forms.md`, sections 2 and 7).

mod forms;
mod polynomial;
mod relations;
mod restitution;
mod word;

pub use forms::Reduction;
pub(crate) use polynomial::{Monomial, Polynomial, times};
pub(crate) use restitution::Restitution;
pub(crate) use word::Word;
