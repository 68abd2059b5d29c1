//! Functions of one f64, applied to a number or to every element of an array.

use crate::errors::end;
use numpy::{PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyFloat, PyInt};
use rayon::prelude::*;
use restitution::{Course, End};

/// Elements from which an array is shared out to all cores, and how many a piece has.
const PIECE: usize = 16_384;

/// Applies `batch` to a number (which gives a float) or to an array of any shape (which gives a new one).
///
/// `batch` reads float64 and writes as many; contiguous arrays are read where they are, others are copied
/// first. The interpreter's lock is released, and large arrays are shared out to all cores.
pub fn apply<'py>(
    argument: &Bound<'py, PyAny>,
    batch: impl Fn(&[f64], &mut [f64]) + Sync,
) -> PyResult<Bound<'py, PyAny>> {
    let py = argument.py();
    if argument.is_instance_of::<PyFloat>() || argument.is_instance_of::<PyInt>() {
        let mut out = [0.0];
        batch(&[argument.extract()?], &mut out);
        return Ok(PyFloat::new(py, out[0]).into_any());
    }
    let array = contiguous(argument)?;
    let read = array.readonly();
    let input = read.as_slice()?;
    let output = PyArrayDyn::<f64>::zeros(py, read.shape(), false);
    {
        let mut write = output.readwrite();
        let out = write.as_slice_mut()?;
        py.detach(|| match input.len() > 2 * PIECE {
            true => out.par_chunks_mut(PIECE).zip(input.par_chunks(PIECE)).for_each(|(out, x)| batch(x, out)),
            false => batch(input, out),
        });
    }
    like(argument, output)
}

/// The numbers of anything that NumPy makes a real array of, in the order of C.
pub fn contiguous<'py>(argument: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let py = argument.py();
    if let Ok(read) = argument.extract::<PyReadonlyArrayDyn<'py, f64>>()
        && read.is_c_contiguous()
        && read.as_slice().is_ok()
    {
        return Ok(argument.cast::<PyArrayDyn<f64>>()?.clone());
    }
    if argument.is_none() {
        return Err(PyTypeError::new_err("None is no real number: give a number or an array"));
    }
    let numpy = py.import("numpy")?;
    let any = numpy.call_method1("asarray", (argument,))?;
    let kind: String = any.getattr("dtype")?.getattr("kind")?.extract()?;
    if !matches!(kind.as_str(), "b" | "i" | "u" | "f" | "O") {
        let dtype = any.getattr("dtype")?.str()?;
        return Err(PyTypeError::new_err(format!("an array of {dtype} has no real numbers: give float64")));
    }
    let array = numpy.call_method1("require", (&any, "float64", ["C", "A"]))?;
    Ok(array.cast_into::<PyArrayDyn<f64>>()?)
}

/// The result in the container that the argument came in: masked arrays keep their mask, series and frames
/// their index, and what has no dimension becomes a scalar, as NumPy's own functions have it.
fn like<'py>(argument: &Bound<'py, PyAny>, out: Bound<'py, PyArrayDyn<f64>>) -> PyResult<Bound<'py, PyAny>> {
    let py = argument.py();
    if argument.hasattr("iloc")? {
        let keywords = [("index", argument.getattr("index")?)].into_py_dict(py)?;
        for label in ["columns", "name"] {
            if argument.hasattr(label)? && !(label == "name" && argument.hasattr("columns")?) {
                keywords.set_item(label, argument.getattr(label)?)?;
            }
        }
        return argument.get_type().call((out,), Some(&keywords));
    }
    if argument.hasattr("mask")? && argument.hasattr("fill_value")? {
        let keywords = [("mask", argument.getattr("mask")?)].into_py_dict(py)?;
        return py.import("numpy")?.getattr("ma")?.call_method("array", (out,), Some(&keywords));
    }
    if out.ndim() == 0 { out.get_item(()) } else { Ok(out.into_any()) }
}

/// epsilon(u, end="zero-compression")
/// --
///
/// The coefficient of restitution of viscoelastic spheres as a function of the damping parameter.
///
/// u = (3/2) A (rho/m_eff)^(2/5) g^(1/5) of x'' + u sqrt(x) x' + x^(3/2) = 0, x'(0) = 1 (Ramirez et al. 1999,
/// eqs. 5, 6, with the velocity scaled to 1).
///
/// Parameters
/// ----------
/// u : float or array_like of any shape
///     Dimensionless, at least 0; NaN below zero and for NaN.
/// end : {"zero-compression", "zero-force"}
///     Where the contact ends: where the spheres are undeformed again (the paper), or where the force between
///     them vanishes (no attraction; Schwager and Poeschel 2008).
///
/// Returns
/// -------
/// float or numpy.ndarray of float64, of the shape of u
///     The bound of its error stands in docs/evaluator.md of the project.
///
/// Raises
/// ------
/// ValueError for an unknown end, TypeError for what is not real numbers.
///
/// Examples
/// --------
/// >>> import restitution
/// >>> round(restitution.epsilon(1.0), 12)
/// 0.331164810467
/// >>> restitution.epsilon([0.0, 0.5], end="zero-force").round(6)
/// array([1.      , 0.595252])
/// >>> restitution.epsilon(1.0, end="never")
/// Traceback (most recent call last):
/// ValueError: 'never' is no end of contact: give 'zero-compression' or 'zero-force'
#[pyfunction]
#[pyo3(signature = (u, end="zero-compression"), text_signature = "(u, end='zero-compression')")]
pub fn epsilon<'py>(u: &Bound<'py, PyAny>, end: &str) -> PyResult<Bound<'py, PyAny>> {
    let end = self::end(end)?;
    apply(u, |u, out| restitution::epsilon_batch(u, out, end))
}

/// loss(u, end="zero-compression")
/// --
///
/// What is lost of the velocity, 1 - epsilon(u), with full relative accuracy however small it is.
///
/// Parameters and errors as in `epsilon`.
///
/// Examples
/// --------
/// >>> import restitution
/// >>> restitution.loss(1e-300)
/// 1.153448858095289e-300
#[pyfunction]
#[pyo3(signature = (u, end="zero-compression"), text_signature = "(u, end='zero-compression')")]
pub fn loss<'py>(u: &Bound<'py, PyAny>, end: &str) -> PyResult<Bound<'py, PyAny>> {
    let end = self::end(end)?;
    apply(u, |u, out| restitution::one_minus_epsilon_batch(u, out, end))
}

/// u_of_epsilon(epsilon, end="zero-compression")
/// --
///
/// The damping parameter whose coefficient of restitution is epsilon: the inverse of `epsilon`.
///
/// Parameters
/// ----------
/// epsilon : float or array_like
///     Between 0 and 1; NaN outside.
/// end : {"zero-compression", "zero-force"}
///
/// Examples
/// --------
/// >>> import restitution
/// >>> round(restitution.epsilon(restitution.u_of_epsilon(0.5)), 14)
/// 0.5
/// >>> restitution.u_of_epsilon(1.5)
/// nan
#[pyfunction]
#[pyo3(signature = (epsilon, end="zero-compression"), text_signature = "(epsilon, end='zero-compression')")]
pub fn u_of_epsilon<'py>(epsilon: &Bound<'py, PyAny>, end: &str) -> PyResult<Bound<'py, PyAny>> {
    let end = self::end(end)?;
    apply(epsilon, |epsilon, out| restitution::u_of_epsilon_batch(epsilon, out, end))
}

/// duration(u, end="zero-compression")
/// --
///
/// How long the contact lasts, in units of tau = (m_eff/rho)^(2/5) g^(-1/5).
///
/// Followed by f64 Taylor steps (its accuracy is measured, not proved: docs/materials.md of the project);
/// NaN outside 0 <= u <= 20. Parameters and errors as in `epsilon`.
///
/// Examples
/// --------
/// >>> import restitution
/// >>> round(restitution.duration(0.0), 10)
/// 3.2180654597
#[pyfunction]
#[pyo3(signature = (u, end="zero-compression"), text_signature = "(u, end='zero-compression')")]
pub fn duration<'py>(u: &Bound<'py, PyAny>, end: &str) -> PyResult<Bound<'py, PyAny>> {
    let end = self::end(end)?;
    apply(u, each(move |u| course(u, end, |course| course.duration)))
}

/// turning_time(u)
/// --
///
/// The time from first touch to the largest compression, in units of tau; NaN outside 0 <= u <= 20.
///
/// Examples
/// --------
/// >>> import restitution
/// >>> round(restitution.turning_time(0.0), 10)
/// 1.6090327299
#[pyfunction]
pub fn turning_time<'py>(u: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    apply(u, each(|u| course(u, End::ZeroCompression, |course| course.time_to_turning)))
}

/// largest_compression(u)
/// --
///
/// The largest compression in units of g tau, y_0 + y_1 u + ... (A23); NaN outside 0 <= u <= 20.
///
/// Examples
/// --------
/// >>> import restitution
/// >>> round(restitution.largest_compression(0.0), 10)
/// 1.0933620739
#[pyfunction]
pub fn largest_compression<'py>(u: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    apply(u, each(|u| course(u, End::ZeroCompression, |course| course.maximal_compression)))
}

fn course(u: f64, end: End, what: impl Fn(Course) -> f64) -> f64 {
    Course::follow(u, end).map_or(f64::NAN, what)
}

/// A function of one number as one of a slice.
pub fn each(function: impl Fn(f64) -> f64 + Sync) -> impl Fn(&[f64], &mut [f64]) + Sync {
    move |input, output| {
        for (x, y) in input.iter().zip(output) {
            *y = function(*x);
        }
    }
}
