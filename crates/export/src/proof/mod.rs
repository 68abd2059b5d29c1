//! The errors of the evaluator, proved for every argument and not at points.
//!
//! A form is followed in two ways by the functions that evaluate it ([`restitution::forms`]). In exact arithmetic it is a
//! polynomial, whose distance from `epsilon` the certified interpolant of [`restitution_direct`] bounds on the whole interval; in
//! bounds of errors every operation adds half a unit of its largest result. docs/evaluator.md has the parts.

mod cover;
mod polynomial;
mod rounded;
mod tiers;

use polynomial::{PREC, Polynomial};
use restitution::End;
use restitution::forms::{self, Form, Number};
use restitution_direct::{Collision, DirectError, Interpolant, Variable, saturation_speed};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use rounded::{Rounded, half_unit};
use rug::Float;

pub use cover::{Group, groups};
pub use tiers::tier_near_zero;

/// Parts of a piece, each with its own bounds.
const PARTS: u32 = 16;
/// Digits of `R^5`.
const DIGITS: usize = 40;

/// A bound that is proved, and where it is largest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    /// The bound.
    pub bound: f64,
    /// The start of the part of a piece in which it is reached.
    pub at: f64,
}

impl Worst {
    const NONE: Self = Self { bound: 0.0, at: 0.0 };

    fn or(self, bound: f64, at: f64) -> Self {
        if bound <= self.bound { self } else { Self { bound, at } } // NaN wins
    }
}

/// What was proved for every argument of some forms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proof {
    /// Of `epsilon(u)`, in units in the last place.
    pub epsilon: Worst,
    /// Of `one_minus_epsilon(u)`, in units in the last place.
    pub one_minus_epsilon: Worst,
    /// Of the forms in exact arithmetic without the rounding of their constants, relative to `epsilon`.
    pub approximation: Worst,
}

impl Proof {
    const NONE: Self =
        Self { epsilon: Worst::NONE, one_minus_epsilon: Worst::NONE, approximation: Worst::NONE };

    /// What holds for the arguments of both.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        let or = |a: Worst, b: Worst| a.or(b.bound, b.at);
        Self {
            epsilon: or(self.epsilon, other.epsilon),
            one_minus_epsilon: or(self.one_minus_epsilon, other.one_minus_epsilon),
            approximation: or(self.approximation, other.approximation),
        }
    }
}

/// An interval of `u` in the variable of an interpolant, from -1 to 1.
struct Span {
    /// `u` as a polynomial.
    u: Polynomial,
    root: Option<Polynomial>,
    /// `epsilon` as a polynomial, within `remainder`.
    epsilon: Polynomial,
    remainder: f64,
}

impl Span {
    /// The part from `low` to `high` of the interval of an interpolant.
    fn new(interpolant: &Interpolant, low: f64, high: f64) -> Self {
        let exact = |x: f64| Float::with_val(PREC, x);
        let variable = |x: f64, round| match interpolant.variable() {
            Variable::Damping => exact(x),
            Variable::Root => Float::with_val_round(PREC, exact(x).sqrt_ref(), round).0,
        };
        let (from, to) = (variable(low, rug::float::Round::Down), variable(high, rug::float::Round::Up));
        // A little wider than asked for: what rounding takes off the ends.
        let middle = Float::with_val(PREC, &from + &to) / 2u32;
        let half = Float::with_val(PREC, &to - &from) * (0.5 + f64::EPSILON);
        let line = Polynomial::line(&middle, &half);
        let width = Ball::from_integer(1, PREC) / Ball::exact(interpolant.half_width().clone());
        let inner =
            line.plus(&Polynomial::constant(&Float::with_val(PREC, -interpolant.center()))).scaled(&width);
        let remainder = interpolant.remainder().upper().to_f64_round(rug::float::Round::Up);
        let (u, root) = match interpolant.variable() {
            Variable::Damping => (line, None),
            Variable::Root => (line.clone() * line.clone(), Some(line)),
        };
        Self { u, root, epsilon: Polynomial::composed(interpolant.coefficients(), &inner), remainder }
    }

    /// From 0 on, where `epsilon` is 1 within `remainder`.
    fn of_nothing_lost(high: f64, remainder: f64) -> Self {
        let half = Float::with_val(PREC, high) / 2u32;
        let u = Polynomial::line(&half, &half);
        Self { epsilon: u.of(1.0), root: None, u, remainder }
    }

    /// A bound of what a polynomial differs from `epsilon` by; the constant part of it goes first.
    fn missed(&self, ours: &Polynomial) -> (f64, f64) {
        let (constant, all) = ours.plus(&self.epsilon.clone().negated()).size();
        (constant, all + self.remainder)
    }

    /// The same for `1 - epsilon`.
    fn missed_by_loss(&self, ours: &Polynomial) -> f64 {
        let kept = ours.clone().negated().plus(&ours.of(1.0));
        self.missed(&kept).1
    }
}

/// Proves a piece of the table.
fn piece(interpolant: &Interpolant, form: &Form, end: End) -> Proof {
    let margin = (form.high + 8.0) * f64::EPSILON; // the place of u is found by a rounded sum with 8 or 1/2
    let (low, high) = ((form.low - margin).max(0.0), form.high + margin);
    let span = Span::new(interpolant, low, high);
    let t = span.u.plus(&span.u.of(-form.centre));
    let (constant, missed) = span.missed(&form.epsilon(t.clone()));
    let missed_by_loss = span.missed_by_loss(&form.one_minus_epsilon(t));
    let mut proof = Proof::NONE;
    for part in 0..PARTS {
        let at = |part: u32| low + (high - low) * (f64::from(part) / f64::from(PARTS));
        let (from, to) = (at(part).next_down() - form.centre, at(part + 1).next_up() - form.centre);
        let exact = form.low >= form.centre / 2.0; // Sterbenz
        let error = if exact { 0.0 } else { half_unit(from.abs().max(to.abs())) };
        let t = Rounded::new(from.next_down(), to.next_up(), error);
        let kept: Rounded = form.epsilon(t);
        proof.epsilon = proof.epsilon.or(kept.units(missed), at(part));
        proof.approximation = proof.approximation.or((missed - constant) / kept.low, at(part));
        if at(part + 1) >= forms::near_end(end) {
            let lost: Rounded = form.one_minus_epsilon(t);
            proof.one_minus_epsilon = proof.one_minus_epsilon.or(lost.units(missed_by_loss), at(part));
        }
    }
    proof
}

/// The parts of a piece between two ends, as distances from its centre that are computed within an error.
fn parts(
    low: f64,
    high: f64,
    centre: f64,
    error: impl Fn(f64) -> f64,
) -> impl Iterator<Item = (f64, Rounded)> {
    (0..PARTS).map(move |part| {
        let at = |part: u32| low + (high - low) * (f64::from(part) / f64::from(PARTS));
        let (from, to) = (at(part).next_down() - centre, at(part + 1).next_up() - centre);
        (at(part), Rounded::new(from.next_down(), to.next_up(), error(from.abs().max(to.abs()))))
    })
}

/// Proves `epsilon` near 0 at zero force: the pieces in the square root of `u`.
fn by_root(interpolant: &Interpolant, low: f64, high: f64) -> Proof {
    let (from, to) = (low.sqrt().next_down(), high.sqrt().next_up());
    let mut proof = Proof::NONE;
    if forms::table_of_roots().all(|form| form.high <= to) {
        proof.epsilon.bound = f64::INFINITY; // a root is rounded beyond the table
    }
    for form in forms::table_of_roots().filter(|form| form.low < to && from < form.high) {
        let margin = f64::EPSILON; // of the sum of the root with 1
        let (first, last) = ((form.low - margin).max(from), (form.high + margin).min(to));
        let span = Span::new(interpolant, (first * first).next_down(), (last * last).next_up());
        let Some(root) = &span.root else { continue };
        let t = root.plus(&root.of(-form.centre));
        let (constant, missed) = span.missed(&form.epsilon(t));
        let of_root = 2.0 * half_unit(last);
        for (at, t) in parts(first, last, form.centre, |t| of_root + half_unit(t)) {
            let kept: Rounded = form.epsilon(t);
            proof.epsilon = proof.epsilon.or(kept.units(missed), at * at);
            proof.approximation = proof.approximation.or((missed - constant) / kept.low, at * at);
        }
    }
    proof
}

/// Proves `epsilon` at zero compression from the end of the table on.
///
/// `epsilon u^5` grows to `R^5` (docs/direct-integration.md, section 7), so that its value at one `u` bounds it for all larger
/// ones. In the significand `m` of `u` the pieces differ from `R^5/m^5` by `(form(m) m^5 - R^5)/m^5`; a power of two does the rest.
///
/// # Errors
///
/// A [`DirectError`] if the integrator cannot prove the two values.
pub fn beyond() -> Result<Proof, DirectError> {
    let exit_speed = saturation_speed(&ForceLaw::viscoelastic_spheres(), DIGITS)?;
    let end = forms::table(End::ZeroCompression).last().map_or(0.0, |form| form.high);
    let u = Ball::from_f64(end * (1.0 - f64::from(f32::EPSILON)), PREC); // the table may end a rounding before
    let reached = collision(End::ZeroCompression)?.enclose(&u, PREC)? * u.powi(5);
    let departure = (Ball::from_integer(1, PREC) - reached / &exit_speed).upper().to_f64();
    let mut proof = Proof::NONE;
    let limit = exit_speed.upper().to_f64_round(rug::float::Round::Up);
    for form in forms::table_beyond() {
        let exact = |x: f64| Float::with_val(PREC, x);
        let (middle, half) = (exact(form.centre), exact((form.high - form.low) / 2.0));
        let m = Polynomial::line(&middle, &half);
        let power = m.clone() * m.clone() * m.clone() * m.clone() * m.clone();
        let ours: Polynomial = form.epsilon(m.plus(&m.of(-form.centre)));
        let (constant, all) = (ours * power).plus(&Polynomial::ball(-&exit_speed)).size();
        let missed = (all + limit * departure) / form.low.powi(5);
        for (at, t) in parts(form.low, form.high, form.centre, |_| 0.0) {
            let kept: Rounded = form.epsilon(t);
            proof.epsilon = proof.epsilon.or(kept.units(missed), at);
            proof.approximation = proof.approximation.or((all - constant) / limit, at);
        }
    }
    Ok(proof)
}

/// Proves the form near 0 from `low` to `high`.
fn near(interpolant: &Interpolant, low: f64, high: f64, end: End) -> Proof {
    let span = Span::new(interpolant, low, high);
    let root = span.root.clone().unwrap_or_else(|| span.u.clone()); // used at zero force alone
    let missed = span.missed_by_loss(&forms::near(root, span.u.clone(), end));
    let mut proof = Proof::NONE;
    for part in 0..PARTS {
        let at = |part: u32| low + (high - low) * (f64::from(part) / f64::from(PARTS));
        let (from, to) = (at(part).next_down(), at(part + 1).next_up());
        let root = (from.sqrt().next_down(), to.sqrt().next_up());
        let root = Rounded::new(root.0, root.1, 2.0 * half_unit(root.1));
        let lost: Rounded = forms::near(root, Rounded::new(from, to, 0.0), end);
        proof.one_minus_epsilon = proof.one_minus_epsilon.or(lost.units(missed), at(part));
    }
    if end == End::ZeroForce { proof.and(by_root(interpolant, low, high)) } else { proof }
}

fn collision(end: End) -> Result<Collision, DirectError> {
    Collision::new(&ForceLaw::viscoelastic_spheres(), end)
}
