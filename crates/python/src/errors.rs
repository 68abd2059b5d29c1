//! The libraries' errors as Python's, with the same sentences.

use pyo3::PyErr;
use pyo3::exceptions::PyValueError;
use std::fmt::Display;

/// A request that cannot be met, whatever library says so.
pub fn value(error: impl Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// The end of contact by its name.
pub fn end(name: &str) -> Result<restitution::End, PyErr> {
    match name {
        "zero-compression" => Ok(restitution::End::ZeroCompression),
        "zero-force" => Ok(restitution::End::ZeroForce),
        _ => Err(value(format!("'{name}' is no end of contact: give 'zero-compression' or 'zero-force'"))),
    }
}

/// The name of an end of contact.
pub fn name(end: restitution::End) -> &'static str {
    match end {
        restitution::End::ZeroCompression => "zero-compression",
        restitution::End::ZeroForce => "zero-force",
    }
}
