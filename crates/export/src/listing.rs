//! What every exported source says, whatever its language.

use super::pieces::{Bound, Pieces, Variable};
use super::reference::Reference;
use restitution::End;
use rug::Float;

/// Points of the self-check.
const CHECKS: usize = 12;
/// Points between which the observed error is looked for in every piece, besides its ends.
const PROBES: u32 = 12;
/// Bits of the reference at a point.
const PREC: u32 = 128;

/// An evaluator ready to be written down.
#[derive(Clone, Debug)]
pub struct Listing {
    /// The end of contact.
    pub end: End,
    /// The largest relative error asked for.
    pub tolerance: f64,
    /// The range of `u`.
    pub range: (f64, f64),
    /// The constants.
    pub pieces: Pieces,
    /// The largest relative error observed.
    pub observed: f64,
    /// The number of points at which it was looked for.
    pub points: usize,
    /// Certified values.
    pub checks: Vec<(f64, f64)>,
}

impl Listing {
    /// Measures the evaluator at the breakpoints, their neighbours, and between them.
    pub fn new(reference: &Reference, pieces: Pieces, tolerance: f64, range: (f64, f64)) -> Self {
        let mut listing = Self {
            end: reference.end(),
            tolerance,
            range,
            pieces,
            observed: 0.0,
            points: 0,
            checks: Vec::new(),
        };
        for u in listing.probes() {
            let exact = exact(reference, u);
            let error = Float::with_val(PREC, listing.pieces.epsilon(u) - &exact) / exact;
            let error = error.to_f64().abs();
            listing.observed = listing.observed.max(error);
            listing.points += 1;
        }
        let (low, high) = range;
        let spaced = |i: usize| low + (high - low) * (i as f64 / (CHECKS - 1) as f64).powi(3);
        listing.checks = (0..CHECKS)
            .map(|i| spaced(i).clamp(low, high))
            .map(|u| (u, exact(reference, u).to_f64()))
            .collect();
        listing
    }

    fn probes(&self) -> Vec<f64> {
        let Pieces { grid, first, ref rows, variable, .. } = self.pieces;
        let u_of = |x: f64| if variable == Variable::U { x } else { x * x };
        let mut points = vec![self.range.0, self.range.1];
        for number in first..=first + rows.len() as u64 {
            let (start, next) = (grid.start(number), grid.start(number + 1));
            let edge = u_of(start);
            points.extend([edge.next_down(), edge, edge.next_up()]);
            points.extend(
                (0..PROBES).map(|i| u_of(start + (next - start) * (f64::from(i) + 0.37) / f64::from(PROBES))),
            );
        }
        points.retain(|u| (self.range.0..=self.range.1).contains(u));
        points
    }

    /// The lines of the head: what it is, its range, its bound and how that was found.
    pub fn head(&self) -> Vec<String> {
        let Bound { approximation, constants, evaluation } = self.pieces.bound;
        let (end, option) = match self.end {
            End::ZeroCompression => ("zero compression", "zero-compression"),
            End::ZeroForce => ("zero force", "zero-force"),
        };
        let (low, high) = self.range;
        vec![
            format!("Coefficient of restitution of viscoelastic spheres; the contact ends at {end}."),
            String::new(),
            "    x'' + u sqrt(x) x' + x^(3/2) = 0,  x(0) = 0,  x'(0) = 1,  epsilon(u) = -x'(end)".into(),
            "    u = (3/2) A (rho/m_eff)^(2/5) g^(1/5) = 0.8669651827054714 (g/g*)^(1/5)".into(),
            String::new(),
            format!(
                "For u from {low} to {high} the relative error is at most {:e}; outside, the result is NaN.",
                self.tolerance
            ),
            format!("The bound kept is {:.2e} =", self.pieces.bound.total()),
            format!("    {approximation:.2e} approximation (twice the neglected Chebyshev coefficients)"),
            format!("  + {constants:.2e} rounding of the constants"),
            format!("  + {evaluation:.2e} rounding of the evaluation (Higham 2002, sec. 5.1)"),
            format!(
                "each in the piece where it is worst. Largest error observed: {:.2e} at {} points, the ends of all pieces and",
                self.observed, self.points
            ),
            "their neighbours among them, against certified integration of the equation of motion.".into(),
            String::new(),
            format!(
                "Written by: restitution export --tolerance {:e} --range {low},{high} --end {option}",
                self.tolerance
            ),
        ]
    }

    /// The number of coefficients of a piece.
    pub fn width(&self) -> usize {
        self.pieces.rows.first().map_or(0, Vec::len)
    }
}

fn exact(reference: &Reference, u: f64) -> Float {
    if u == 0.0 { Float::with_val(PREC, 1) } else { reference.epsilon(&Float::with_val(PREC, u)) }
}
