//! Closed forms of the coefficients of restitution, and their values to a million digits.
//!
//! For every law `x'' + u x^gamma x' + x^a = 0` the coefficients `C_k`, `a_k`, `h_k` are rational expressions in
//! iterated integrals over the undamped collision; up to order 4, in two Beta values. The derivation is in
//! `docs/closed-forms.md`. The crate shares no formula with the engine of `restitution-series` but the exact
//! factor between the two ends of contact, so that each can test the other; [`coefficients`] takes the cheaper of the two.

mod algebra;
mod beta;
mod closed_form;
mod coefficients;
mod error;
mod iterated;
mod language;
mod low_orders;
mod root;
mod splitting;

pub use algebra::Reduction;
pub use beta::beta;
pub use closed_form::{Base, ClosedForm, Constant, LARGEST_ORDER, Term, closed_form};
pub use coefficients::{coefficients, coefficients_memory};
pub use error::ClosedError;
pub use iterated::iterated_beta;
pub use language::Language;
pub use low_orders::{Family, LARGEST_BETA_ORDER, low_orders, memory_estimate};

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
