//! Constants of the undamped collision, each the f64 closest to its closed form.
// Written by `make tables`; compared by tests/it/tables_fresh.rs.

/// `-C_1`, the slope of `1 - epsilon` at `u = 0` (eqs. 31, A32 of \[RPBS1999\]).
#[rustfmt::skip]
#[allow(dead_code)]
pub(crate) const SLOPE: f64 = 1.1534488580952889;

/// `(5/4)^(3/5)`, which leads from `u` to `delta` of eq. (14).
#[rustfmt::skip]
#[allow(dead_code)]
pub(crate) const DELTA_OVER_U: f64 = 1.143262629818316;

/// `2 T`, the duration in units of `tau`.
#[rustfmt::skip]
#[allow(dead_code)]
pub(crate) const ELASTIC_DURATION: f64 = 3.218065459719043;

/// `(5/4)^(2/5)`, the maximal compression in units of `g tau`.
#[rustfmt::skip]
#[allow(dead_code)]
pub(crate) const ELASTIC_COMPRESSION: f64 = 1.0933620739432781;
