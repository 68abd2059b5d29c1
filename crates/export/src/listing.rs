//! What every exported source says, whatever its language.

use crate::design::{Beyond, Request, design};
use crate::loss::Loss;
use crate::pieces::{Bound, Pieces};
use crate::{ExportError, InterpolatedCurve};
use num_rational::BigRational;
use restitution::End;
use restitution_direct::VelocityScale;
use rug::Float;
use rug::float::Constant;
use rug::ops::Pow;

/// Points of the self-check.
const CHECKS: usize = 12;
/// Points between which the observed error is looked for in every piece, besides its ends.
const PROBES: u32 = 12;
/// Bits of the reference at a point.
const PREC: u32 = 160;
/// Half the distance over which the slope of the reference is taken, relative to `u`.
const STEP: f64 = f64::from_bits((1023 - 40) << 52);
/// From here on the loss is a normal number.
const SMALLEST: f64 = 4.0 * f64::MIN_POSITIVE;
/// Where a self-check goes without an end of the range.
const FAR: f64 = 100.0;

/// A characteristic velocity that a source is written for.
#[derive(Clone, Debug, PartialEq)]
pub struct CharacteristicVelocity {
    /// `g*`, in m/s.
    pub metres_per_second: f64,
    /// Where it comes from, for the head of the source.
    pub origin: String,
}

/// Returns `u` at the characteristic velocity, `1/|C_1|`.
///
/// ```text
/// C_1 = -sqrt(pi) Gamma(3/5)/(2^(1/5) 5^(2/5) Gamma(21/10))
/// ```
///
/// (\[RPBS1999\], eqs. 30 and A30.)
pub(crate) fn u_at_g_star() -> Float {
    let gamma = |n: u32, d: u32| (Float::with_val(PREC, n) / d).gamma();
    let powers = Float::with_val(PREC, 50).pow(Float::with_val(PREC, 1) / 5u32); // 2 5^2
    let root = Float::with_val(PREC, Constant::Pi).sqrt();
    powers * gamma(21, 10) / gamma(3, 5) / root
}

impl CharacteristicVelocity {
    /// From the characteristic velocity in m/s.
    ///
    /// # Errors
    ///
    /// [`ExportError::Velocity`] if that is not a positive number.
    pub fn of(metres_per_second: f64, origin: String) -> Result<Self, ExportError> {
        if !metres_per_second.is_normal() || metres_per_second < 0.0 {
            return Err(ExportError::Velocity);
        }
        Ok(Self { metres_per_second, origin })
    }

    /// From the damping at a velocity of 1 m/s, as `u = 0.866… (g/g*)^(1/5)`.
    ///
    /// # Errors
    ///
    /// [`ExportError::Velocity`] if that is not a positive number that an f64 holds, [`ExportError::Direct`] if there is no damping.
    pub fn of_scale(scale: &VelocityScale, origin: String) -> Result<Self, ExportError> {
        let damping = scale.damping(&BigRational::from_integer(1.into())).map_err(ExportError::Direct)?;
        let ratio = u_at_g_star() / damping.at(PREC).mid();
        Self::of(Float::with_val(PREC, ratio.pow(5u32)).to_f64(), origin)
    }
}

/// The largest relative errors observed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Observed {
    /// Of `epsilon`.
    pub epsilon: f64,
    /// Of `1 - epsilon`.
    pub loss: f64,
    /// Of `d epsilon/d u`.
    pub slope: f64,
    /// The number of points.
    pub points: usize,
}

/// An evaluator ready to be written down.
#[derive(Clone, Debug)]
pub struct Listing {
    /// The end of contact.
    pub end: End,
    /// What was asked for.
    pub request: Request,
    /// The table.
    pub pieces: Pieces,
    /// What is lost, near 0.
    pub loss: Loss,
    /// Measured against certified values.
    pub observed: Observed,
    /// `u`, `epsilon`, `1 - epsilon`, from certified values.
    pub checks: Vec<[f64; 3]>,
    /// `g*`, if the source shall have a function of a velocity in m/s.
    pub velocity: Option<CharacteristicVelocity>,
}

impl Listing {
    /// Designs an evaluator and measures it: at the breakpoints, their neighbours, and between them.
    ///
    /// # Errors
    ///
    /// Those of [`design`].
    pub fn new(reference: &InterpolatedCurve, request: Request) -> Result<Self, ExportError> {
        let pieces = design(reference, &request)?;
        let loss = Loss::fit(reference, &pieces, request.range, request.tolerance)?;
        let mut listing = Self {
            end: reference.end(),
            request,
            pieces,
            loss,
            observed: Observed::default(),
            checks: Vec::new(),
            velocity: None,
        };
        for u in listing.probes() {
            listing.observe(reference, u);
        }
        let (low, high) = (request.range.0, listing.last().min(request.range.1.max(FAR)));
        let spaced = |i: usize| low + (high - low) * (i as f64 / (CHECKS - 1) as f64).powi(3);
        listing.checks = (0..CHECKS)
            .map(|i| spaced(i).clamp(low, high))
            .map(|u| [u, exact(reference, u).to_f64(), exact_loss(reference, u).to_f64()])
            .collect();
        Ok(listing)
    }

    /// Adds functions of a velocity in m/s.
    #[must_use]
    pub fn with_velocity(self, velocity: CharacteristicVelocity) -> Self {
        Self { velocity: Some(velocity), ..self }
    }

    /// The largest `u` that has a value.
    pub fn last(&self) -> f64 {
        if self.pieces.law.is_some() { f64::INFINITY } else { self.request.range.1 }
    }

    fn probes(&self) -> Vec<f64> {
        let Pieces { grid, first, law_row, .. } = self.pieces;
        let mut points = vec![self.request.range.0, self.request.range.1];
        for number in first..first + law_row as u64 {
            let (start, next) = (grid.start(number), grid.start(number + 1));
            points.extend([start.next_down(), start, start.next_up()]);
            points.extend(
                (0..PROBES).map(|i| start + (next - start) * (f64::from(i) + 0.37) / f64::from(PROBES)),
            );
        }
        if let Some(law) = self.pieces.law {
            let rows = (self.pieces.rows.len() - law_row) as i32;
            points.extend((0..4 * PROBES as i32 * rows).map(|i| law.from * 1.001_f64.powi(i)));
        }
        points.retain(|u| (self.request.range.0..=self.last()).contains(u));
        points
    }

    fn observe(&mut self, reference: &InterpolatedCurve, u: f64) {
        let relative =
            |value: f64, exact: Float| (Float::with_val(PREC, value - &exact) / exact).to_f64().abs();
        let (pieces, observed) = (&self.pieces, &mut self.observed);
        observed.points += 1;
        observed.epsilon = observed.epsilon.max(relative(pieces.epsilon(u), exact(reference, u)));
        if u > SMALLEST {
            observed.loss = observed.loss.max(relative(self.loss.at(pieces, u), exact_loss(reference, u)));
            observed.slope = observed.slope.max(relative(pieces.slope(u), exact_slope(reference, u)));
        }
    }

    /// The lines of the head: what it is, its range, its bounds and how they were found.
    pub fn head(&self) -> Vec<String> {
        let Bound { approximation, argument, evaluation, law } = self.pieces.bound;
        let Observed { epsilon, loss, slope, points } = self.observed;
        let mut lines = vec![
            format!("Coefficient of restitution of viscoelastic spheres; the contact ends at {}.", self.end_words()),
            String::new(),
            "    x'' + u sqrt(x) x' + x^(3/2) = 0,  x(0) = 0,  x'(0) = 1,  epsilon(u) = -x'(end)".into(),
            format!("    u = (3/2) A (rho/m_eff)^(2/5) g^(1/5) = {} (g/g*)^(1/5)", u_at_g_star().to_f64()),
            String::new(),
            self.promise(),
            "There epsilon(0) = 1 exactly, 0 <= epsilon <= 1, and epsilon never rises: by construction, for all f64,".into(),
            "with fused multiply-add or without.".into(),
            String::new(),
            format!("The bound kept for epsilon is {:.2e} =", self.pieces.bound.total()),
            format!("    {approximation:.2e} approximation (the Chebyshev coefficients of the error)"),
            format!("  + {argument:.2e} rounding of the argument"),
            format!("  + {evaluation:.2e} rounding of the evaluation (Higham 2002, sec. 5.1)"),
        ];
        if self.pieces.law.is_some() {
            lines.push(format!("  + {law:.2e} departure from the law at infinity"));
        }
        lines.extend([
            format!("each in the piece where it is worst; for 1 - epsilon it is {:.2e}.", self.loss.bound),
            format!("Largest relative errors observed at {points} points, the ends of all pieces and their neighbours"),
            format!("among them: {epsilon:.2e} of epsilon, {loss:.2e} of 1 - epsilon, {slope:.2e} of the slope,"),
            "against certified integration of the equation of motion.".into(),
            String::new(),
        ]);
        if let Some(velocity) = &self.velocity {
            lines.extend([
                format!("g* = {:e} m/s: {}", velocity.metres_per_second, velocity.origin),
                String::new(),
            ]);
        }
        lines
    }

    fn promise(&self) -> String {
        let (low, high) = self.request.range;
        let tolerance = self.request.tolerance;
        match self.request.beyond {
            Beyond::NotANumber => format!(
                "For u from {low} to {high} the relative error is at most {tolerance:e}; outside, the result is NaN."
            ),
            Beyond::Law => format!(
                "For every u from {low} on the relative error is at most {tolerance:e} while epsilon is no subnormal number; else NaN."
            ),
        }
    }

    /// The options of `restitution export` that write this table.
    pub fn options(&self) -> String {
        let Request { tolerance, range: (low, high), beyond } = self.request;
        let end = self.end_words().replace(' ', "-");
        let beyond = if beyond == Beyond::Law { " --beyond law" } else { "" };
        format!("--tolerance {tolerance:e} --range {low},{high} --end {end}{beyond}")
    }

    fn end_words(&self) -> &'static str {
        match self.end {
            End::ZeroCompression => "zero compression",
            End::ZeroForce => "zero force",
        }
    }
}

fn exact(reference: &InterpolatedCurve, u: f64) -> Float {
    if u == 0.0 { Float::with_val(PREC, 1) } else { reference.epsilon(&Float::with_val(PREC, u)) }
}

fn exact_loss(reference: &InterpolatedCurve, u: f64) -> Float {
    if u == 0.0 { Float::new(PREC) } else { reference.one_minus_epsilon(&Float::with_val(PREC, u)) }
}

/// The difference quotient about `u`, over 2^-39 of it: within 2^-75 of the derivative.
fn exact_slope(reference: &InterpolatedCurve, u: f64) -> Float {
    let step = Float::with_val(PREC, u) * STEP;
    let (before, after) = (Float::with_val(PREC, u - &step), Float::with_val(PREC, u + &step));
    (reference.one_minus_epsilon(&before) - reference.one_minus_epsilon(&after)) / (step * 2u32)
}
