//! The errors of the evaluator, proved for every argument and not at points.
//!
//! A form is followed in two ways by the functions that evaluate it (`restitution::forms`). In exact arithmetic it is a
//! polynomial, whose distance from `epsilon` the certified interpolant of [`restitution_direct`] bounds on the whole interval; in
//! bounds of errors every operation adds half a unit of its largest result. docs/evaluator.md has the parts.

mod cover;
#[cfg(test)]
mod figures;
mod polynomial;
mod rounded;
mod tiers;

use cover::SATURATED;
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
        let bound = if bound.is_nan() { f64::INFINITY } else { bound }; // nothing is proved
        if bound <= self.bound { self } else { Self { bound, at } }
    }
}

/// What was proved for every argument of some forms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proof {
    /// Of `epsilon(u)`, in units in the last place.
    pub epsilon: Worst,
    /// Of `one_minus_epsilon(u)`, in units in the last place.
    pub one_minus_epsilon: Worst,
    /// Of `Restitution::epsilon(g)`, in units in the last place, where `f g` is an ordinary number.
    pub of_velocity: Worst,
    /// Of the forms in exact arithmetic without the rounding of their constants, relative to `epsilon`.
    pub approximation: Worst,
}

impl Proof {
    const NONE: Self = Self {
        epsilon: Worst::NONE,
        one_minus_epsilon: Worst::NONE,
        of_velocity: Worst::NONE,
        approximation: Worst::NONE,
    };

    /// What holds for the arguments of both.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        let or = |a: Worst, b: Worst| a.or(b.bound, b.at);
        Self {
            epsilon: or(self.epsilon, other.epsilon),
            one_minus_epsilon: or(self.one_minus_epsilon, other.one_minus_epsilon),
            of_velocity: or(self.of_velocity, other.of_velocity),
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
        let within = inner.size().1 <= 1.0; // beyond its interval an interpolant says nothing
        let remainder = interpolant.remainder().upper().to_f64_round(rug::float::Round::Up);
        let remainder = if within { remainder } else { f64::INFINITY };
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

/// By so much of itself the estimate of a root that finds the place may be off.
const ESTIMATE: f64 = 1e-7;

/// What a place can be off by: it is found by a rounded sum with 1 or less, of `u` or of the estimate of a root.
fn margin(form: &Form) -> f64 {
    (form.high + 8.0) * f64::EPSILON + form.high * ESTIMATE
}

/// What a distance from the centre is off by that comes from a fifth root: the roundings of both additions, and 0.02 of half a unit of 1 in the
/// part of the root that is added (docs/evaluator.md, the fifth root).
fn error_of_root(t: f64, u: f64) -> f64 {
    half_unit(t.abs() + 0.0025 * u) + half_unit(t) + 0.02 * u * f64::EPSILON / 2.0
}

/// What the rounding of `f g` changes `epsilon` by at most, relatively: the logarithm of `epsilon` falls no faster than that of `g` grows at zero
/// compression, and a third as fast at zero force (docs/evaluator.md, the second lemma).
fn error_of_product(end: End) -> f64 {
    let fall = match end {
        End::ZeroCompression => 1.0,
        End::ZeroForce => 1.0 / 3.0,
    };
    fall * (f64::EPSILON / 2.0)
}

/// Proves a piece of the table, as far as it lies between `low` and `high`.
fn piece(interpolant: &Interpolant, form: &Form, low: f64, high: f64, end: End) -> Proof {
    let (low, high) = ((form.low - margin(form)).max(low), (form.high + margin(form)).min(high));
    let span = Span::new(interpolant, low, high);
    let t = span.u.plus(&span.u.of(-form.centre));
    let (constant, missed) = span.missed(&form.epsilon(t.clone()));
    let missed_by_loss = span.missed_by_loss(&form.one_minus_epsilon(t));
    let exact = form.low >= form.centre / 2.0; // Sterbenz
    let error = |t: f64| if exact { 0.0 } else { half_unit(t) };
    let mut proof = Proof::NONE;
    for (at, t) in parts(low, high, form.centre, error) {
        let kept: Rounded = form.epsilon(t);
        proof.epsilon = proof.epsilon.or(kept.units(missed), at);
        proof.of_velocity = proof.of_velocity.or(of_velocity(form, t, high, missed, end), at);
        proof.approximation = proof.approximation.or((missed - constant) / kept.low, at);
        if gives_loss(form, t, end) {
            let lost: Rounded = form.one_minus_epsilon(t);
            proof.one_minus_epsilon = proof.one_minus_epsilon.or(lost.units(missed_by_loss), at);
        }
    }
    proof
}

/// Whether a piece gives `1 - epsilon` as well at some of these distances from its centre: below, the form near 0 does.
fn gives_loss(form: &Form, t: Rounded, end: End) -> bool {
    form.centre + t.high >= forms::near_end(end)
}

/// A bound of `epsilon` from a velocity, in units, of a part of a piece whose `u` is at most `high`.
fn of_velocity(form: &Form, t: Rounded, high: f64, missed: f64, end: End) -> f64 {
    let error = error_of_root(t.low.abs().max(t.high.abs()), high);
    let kept: Rounded = form.epsilon(Rounded::new(t.low, t.high, error));
    kept.units(missed + kept.high * error_of_product(end))
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

/// Proves the pieces at zero compression from `u = 8` on, and what lies beyond the table with them.
///
/// `epsilon u^5` grows to `R^5` (docs/direct-integration.md, section 7), so that its value at one `u` bounds it for all larger
/// ones. The pieces differ from `R^5/u^5` by `(form(u) u^5 - R^5)/u^5`. Beyond the table a power of two does the rest.
///
/// # Errors
///
/// A [`DirectError`] if the integrator cannot prove the two values.
pub fn saturated() -> Result<Proof, DirectError> {
    let exit_speed = saturation_speed(&ForceLaw::viscoelastic_spheres(), DIGITS)?;
    let u = Ball::from_f64(saturated_from(), PREC);
    let reached = collision(End::ZeroCompression)?.enclose(&u, PREC)? * u.powi(5);
    let departure = (Ball::from_integer(1, PREC) - reached / &exit_speed).upper().to_f64();
    let mut proof = Proof::NONE;
    let limit = exit_speed.upper().to_f64_round(rug::float::Round::Up);
    for form in forms::table(End::ZeroCompression).filter(|form| form.low >= SATURATED) {
        let exact = |x: f64| Float::with_val(PREC, x);
        let (low, high) = (form.low - margin(&form), form.high + margin(&form));
        let middle = Float::with_val(PREC, exact(low) + high) / 2u32;
        let half = Float::with_val(PREC, exact(high) - low) / 2u32;
        let u = Polynomial::line(&middle, &half);
        let power = u.clone() * u.clone() * u.clone() * u.clone() * u.clone();
        let t = u.plus(&u.of(-form.centre));
        let ours: Polynomial = form.epsilon(t.clone());
        let (constant, all) = (ours * power).plus(&Polynomial::ball(-&exit_speed)).size();
        for (at, t) in parts(low, high, form.centre, |_| 0.0) {
            let missed = missed_beyond(all, limit * departure, at);
            let (kept, lost): (Rounded, Rounded) = (form.epsilon(t), form.one_minus_epsilon(t));
            proof.epsilon = proof.epsilon.or(kept.units(missed), at);
            proof.one_minus_epsilon = proof.one_minus_epsilon.or(lost.units(missed), at);
            proof.of_velocity =
                proof.of_velocity.or(of_velocity(&form, t, high, missed, End::ZeroCompression), at);
            proof.approximation = proof.approximation.or((all - constant) / limit, at);
        }
    }
    Ok(proof)
}

/// A little before the power law is compared: a piece may start a rounding before.
fn saturated_from() -> f64 {
    SATURATED * (1.0 - f64::from(f32::EPSILON))
}

/// What `epsilon` is missed by from `u` on if `epsilon u^5` is: by the form, and by its limit.
fn missed_beyond(by_form: f64, by_limit: f64, u: f64) -> f64 {
    (by_form + by_limit) / u.powi(5) * (1.0 + 1e-14)
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
    let own = forms::table(end).filter(|form| meets(form, low, high));
    own.fold(proof, |proof, form| proof.and(piece(interpolant, &form, low, high, end)))
}

/// Whether arguments from `low` to `high` may be taken for those of a piece.
fn meets(form: &Form, low: f64, high: f64) -> bool {
    form.low < high && low < form.high + margin(form)
}

fn collision(end: End) -> Result<Collision, DirectError> {
    Collision::new(&ForceLaw::viscoelastic_spheres(), end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_proves_nothing() {
        let worst = Worst::NONE.or(1.0, 2.0).or(f64::NAN, 3.0).or(4.0, 5.0);
        assert_eq!(worst, Worst { bound: f64::INFINITY, at: 3.0 });
        let one = Rounded::new(0.75, 0.875, 0.0);
        assert!(one.units(f64::NAN).is_nan() && one.units(f64::INFINITY).is_infinite());
        assert!(one.relative(f64::NAN).is_infinite() && one.relative(f64::INFINITY).is_infinite());
    }

    #[test]
    fn a_unit_just_below_a_power_of_two_is_the_smaller_one() {
        let missed = f64::EPSILON / 8.0; // 1 - missed is 1 in f64, and its unit half of that of 1
        let one = Rounded::new(1.0, 1.0, 0.0);
        assert!((one.units(missed) - 0.75).abs() < 1e-9, "{}", one.units(missed));
    }

    #[test]
    fn an_interpolant_says_nothing_beyond_its_interval() {
        let group = groups(End::ZeroCompression).into_iter().find(|group| group.low() >= 1.0).unwrap();
        let interpolant = group.interpolant().unwrap();
        let at = |high: f64| Span::new(interpolant, group.low(), high).remainder;
        assert!(at(group.high()) < 1e-15 && at(group.high() * 1.1).is_infinite());
    }

    /// `epsilon(k g)` against `epsilon(g)`, from small velocities to large ones, where the limits of the lemmas are reached.
    #[test]
    fn a_product_is_worth_what_the_lemmas_say() {
        let k = 1.0 + 1.0 / 32.0; // of u: its fifth power of the velocity
        for end in [End::ZeroCompression, End::ZeroForce] {
            let collision = collision(end).unwrap();
            let logarithm =
                |u: f64| collision.enclose(&Ball::from_f64(u, PREC), PREC).unwrap().ln().mid().to_f64();
            let falls = [0.001, 0.1, 0.7, 1.5, 3.0, 8.0, 60.0, 900.0]
                .map(|u| (logarithm(u) - logarithm(k * u)) / (5.0 * k.ln()));
            let stated = error_of_product(end) / (f64::EPSILON / 2.0);
            let roundings = 1e-12; // of logarithms below 40, divided by 0.15
            let most = falls.iter().copied().fold(0.0, f64::max);
            assert!(falls.iter().all(|fall| *fall > 0.0), "{end:?}: {falls:?}");
            assert!(most <= stated + roundings && most > 0.97 * stated, "{end:?}: {falls:?}");
        }
    }
}
