//! The Python package `restitution`: every function is one that a library crate gives.
//!
//! `elementwise` carries arrays to the f64 evaluator, `curve` holds the coefficient of two given bodies,
//! `fitting` the fit, `theory` what is exact or certified, `work` runs what takes long so that Ctrl-C ends it.

mod curve;
mod elementwise;
mod errors;
mod fitting;
mod quantities;
mod rational;
mod theory;
mod work;

use pyo3::prelude::*;

/// The compiled half of the package; `restitution` re-exports what is public.
#[pymodule]
mod _core {
    #[pymodule_export]
    use crate::curve::Restitution;
    #[pymodule_export]
    use crate::elementwise::{duration, epsilon, largest_compression, loss, turning_time, u_of_epsilon};
    #[pymodule_export]
    use crate::fitting::{Fit, compare, fit};
    #[pymodule_export]
    use crate::quantities::quantity;
    #[pymodule_export]
    use crate::rational::{closed_form, pade};
    #[pymodule_export]
    use crate::theory::{coefficients, epsilon_digits, psi, saturation, trajectory};
}
