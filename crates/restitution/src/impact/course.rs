//! The course of one damped collision: how deep, how long.

use crate::End;

/// The largest damping parameter whose course is followed; beyond it the coefficient is below 2e-6 or, at
/// zero force, 9e-3.
pub const LARGEST_FOLLOWED_U: f64 = 20.0;

/// The order of the Taylor polynomials.
const ORDER: usize = 24;
/// Far more steps than any `u` up to the largest needs (it takes some hundreds).
const MOST_STEPS: usize = 100_000;

/// The course of the scaled collision `x'' + u sqrt(x) x' + x^(3/2) = 0`, `x(0) = 0`, `x'(0) = 1`.
///
/// Times are in units of `tau = (m_eff/rho)^(2/5) g^(-1/5)`, lengths in units of `g tau`.
///
/// # Accuracy
///
/// Not proved: f64 Taylor steps of order 24. Against the certified integration the largest relative difference
/// seen is written in docs/materials.md ("The course of a collision").
///
/// # Examples
///
/// ```
/// use restitution::{Course, End};
///
/// let elastic = Course::follow(0.0, End::ZeroCompression).unwrap();
/// assert!((elastic.duration - 2.0 * elastic.time_to_turning).abs() < 1e-13);
/// assert!((elastic.time_to_turning - 1.6090327298595215).abs() < 1e-13);
///
/// assert!(Course::follow(-1.0, End::ZeroCompression).is_none());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Course {
    /// The time from first touch to the turning point.
    pub time_to_turning: f64,
    /// The compression at the turning point.
    pub maximal_compression: f64,
    /// The time from first touch to the end of contact.
    pub duration: f64,
}

impl Course {
    /// Follows the collision with damping parameter `u`; `None` outside `0..=20`.
    ///
    /// With `z = sqrt(x)`, `p = x'` and a parameter `s` with `dt = 2 z ds` the equation is polynomial, and so
    /// analytic at both ends and at the turning point:
    ///
    /// ```text
    /// z' = p,   p' = -2 z^2 (u p + z^2),   t' = 2 z
    /// ```
    pub fn follow(u: f64, end: End) -> Option<Self> {
        if !(0.0..=LARGEST_FOLLOWED_U).contains(&u) {
            return None;
        }
        let mut state = State { z: 0.0, p: 1.0, t: 0.0 };
        let mut turning = None;
        for _ in 0..MOST_STEPS {
            let step = Step::new(u, state);
            let next = step.at(step.length);
            let (time_to_turning, maximal_compression) = match turning {
                Some(found) => found,
                None if next.p > 0.0 => {
                    state = next;
                    continue;
                }
                None => {
                    let top = step.at(step.root(|state| state.p));
                    *turning.insert((top.t, top.z * top.z))
                }
            };
            let distance = |state: State| match end {
                End::ZeroForce if state.z > 0.0 => state.z * state.z + u * state.p,
                _ => state.z,
            };
            if next.p < 0.0 && distance(next) <= 0.0 {
                let exit = step.at(step.root(|state| if state.p < 0.0 { distance(state) } else { 1.0 }));
                return Some(Self { time_to_turning, maximal_compression, duration: exit.t });
            }
            state = next;
        }
        None
    }
}

/// A point of the course.
#[derive(Clone, Copy)]
struct State {
    z: f64,
    p: f64,
    t: f64,
}

/// One step: the Taylor polynomials of `z`, `p`, `t` and how far they reach.
struct Step {
    z: [f64; ORDER + 1],
    p: [f64; ORDER + 1],
    t: [f64; ORDER + 1],
    length: f64,
}

impl Step {
    fn new(u: f64, start: State) -> Self {
        let (mut z, mut p, mut t) = ([0.0; ORDER + 1], [0.0; ORDER + 1], [0.0; ORDER + 1]);
        let (mut square, mut force) = ([0.0; ORDER], [0.0; ORDER]);
        (z[0], p[0], t[0]) = (start.z, start.p, start.t);
        for n in 0..ORDER {
            square[n] = product(&z, &z, n);
            force[n] = u * p[n] + square[n];
            let next = (n + 1) as f64;
            z[n + 1] = p[n] / next;
            p[n + 1] = -2.0 * product(&square, &force, n) / next;
            t[n + 1] = 2.0 * z[n] / next;
        }
        let length = reach(&z).min(reach(&p));
        Self { z, p, t, length }
    }

    fn at(&self, s: f64) -> State {
        State { z: horner(&self.z, s), p: horner(&self.p, s), t: horner(&self.t, s) }
    }

    /// Returns where `distance` falls through zero within the step, by bisection to the last bit.
    fn root(&self, distance: impl Fn(State) -> f64) -> f64 {
        let (mut low, mut high) = (0.0, self.length);
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                return high;
            }
            if distance(self.at(middle)) > 0.0 { low = middle } else { high = middle }
        }
    }
}

/// The coefficient of degree `n` of a product.
fn product(a: &[f64], b: &[f64], n: usize) -> f64 {
    (0..=n).map(|k| a[k] * b[n - k]).sum()
}

fn horner(coefficients: &[f64], s: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * s + c)
}

/// How far the last terms stay below a quarter of an ulp of the first; at the start only every fifth is not zero.
fn reach(coefficients: &[f64; ORDER + 1]) -> f64 {
    let size = coefficients[0].abs().max(coefficients[1].abs());
    let bound = |n: usize| match coefficients[n].abs() {
        0.0 => f64::INFINITY,
        c => (0.25 * f64::EPSILON * size / c).powf(1.0 / n as f64),
    };
    (ORDER - 5..=ORDER).map(bound).fold(1.0, f64::min)
}
