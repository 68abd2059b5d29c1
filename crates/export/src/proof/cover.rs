//! The intervals on which one certified interpolant serves.

use super::{Proof, collision, near, piece};
use num_rational::BigRational;
use restitution::forms::{Form, near_end, table};
use restitution::{End, epsilon};
use restitution_direct::{DirectError, Interpolant, Variable};
use std::sync::OnceLock;

/// Degrees of the interpolants, the next one where the remainder of the one before is not small.
const DEGREES: [usize; 4] = [14, 17, 20, 24];
/// What remains of `epsilon`, or of `1 - epsilon` near 0, at most: nothing that counts.
const SMALL: f64 = 2e-18;
/// Their precision in bits, and how many more for each factor of two that `u` is below 1: the compression at which the force
/// vanishes is of the order of `u^2`.
const PREC: u32 = 100;
const BITS: f64 = 1.2;
/// Widest interval below [`WIDER`] and beyond, in pieces.
const PIECES: [usize; 2] = [4, 8];
/// Parts of a factor of two near 0, from [`SMALLER`] on and below.
const PARTS: [i32; 2] = [4, 1];
const SMALLER: i32 = 8;
/// `log2` of the `u` below which the first term is enough (docs/evaluator.md, the lemma).
pub(super) const LEAST: i32 = 60;

/// By so much, relatively, pieces reach beyond their group: where the estimate of a fifth root puts them.
const MARGIN: f64 = 2e-7;
/// From here on the pieces at zero compression are compared with the power law.
pub(super) const SATURATED: f64 = 8.0;

/// Forms that one interpolant judges.
#[derive(Clone, Debug)]
pub struct Group {
    end: End,
    low: f64,
    high: f64,
    /// The pieces; none near 0.
    pieces: Vec<Form>,
    /// The interpolant, once it is needed.
    known: OnceLock<Interpolant>,
}

/// Everything there is to prove at one end of contact, from the smallest `u` to the end of the table; at zero compression to 8,
/// where [`saturated`](super::saturated) goes on.
pub fn groups(end: End) -> Vec<Group> {
    let mut groups = near_groups(end);
    let pieces: Vec<Form> = table(end)
        .filter(|form| form.high > near_end(end) && (end == End::ZeroForce || form.low < SATURATED))
        .collect();
    let mut rest = &pieces[..];
    while let Some(first) = rest.first() {
        let wide = match end {
            End::ZeroCompression => first.low >= 1.0,
            End::ZeroForce => first.low < 8.0,
        };
        let count = PIECES[usize::from(wide)].min(rest.len());
        let (own, others) = rest.split_at(count);
        groups.push(Group {
            end,
            low: own[0].low.max(near_end(end)),
            high: own[count - 1].high,
            pieces: own.to_vec(),
            known: OnceLock::new(),
        });
        rest = others;
    }
    groups
}

fn near_groups(end: End) -> Vec<Group> {
    let last = -(near_end(end).log2() as i32);
    let mut groups = Vec::new();
    for k in (last..LEAST).rev() {
        let parts = PARTS[usize::from(k >= SMALLER)];
        let high = f64::from(-k).exp2();
        let at = |part: i32| high * (0.5 + f64::from(part) / f64::from(2 * parts));
        groups.extend((0..parts).map(|part| Group {
            end,
            low: at(part),
            high: at(part + 1),
            pieces: Vec::new(),
            known: OnceLock::new(),
        }));
    }
    groups
}

impl Group {
    /// From which `u` on.
    pub fn low(&self) -> f64 {
        self.low
    }

    /// Up to which `u`.
    pub fn high(&self) -> f64 {
        self.high
    }

    /// The same with other forms in place of its own, to see that a proof notices it.
    #[must_use]
    pub fn map(mut self, change: impl Fn(Form) -> Form) -> Self {
        self.pieces.iter_mut().for_each(|form| *form = change(*form));
        self
    }

    /// Proves the bounds of its forms; takes about a second.
    ///
    /// # Errors
    ///
    /// A [`DirectError`] if there is no interpolant.
    pub fn prove(&self) -> Result<Proof, DirectError> {
        let interpolant = self.interpolant()?;
        if self.pieces.is_empty() {
            return Ok(near(interpolant, self.low, self.high, self.end));
        }
        let (low, high) = self.reach();
        let proofs = self.pieces.iter().map(|form| piece(interpolant, form, low, high, self.end));
        Ok(proofs.fold(Proof::NONE, Proof::and))
    }

    /// From where to where its pieces are asked.
    pub(super) fn reach(&self) -> (f64, f64) {
        (self.low * (1.0 - MARGIN), self.high * (1.0 + MARGIN))
    }

    pub(super) fn end(&self) -> End {
        self.end
    }

    pub(super) fn interpolant(&self) -> Result<&Interpolant, DirectError> {
        if let Some(known) = self.known.get() {
            return Ok(known);
        }
        let margin = (self.high - self.low) / 64.0; // pieces reach a little beyond
        let (from, to) = ((self.low - margin).max(0.0), self.high + margin);
        let exact = |x: f64| BigRational::from_float(x).unwrap_or_default();
        let variable = match self.end {
            End::ZeroCompression => Variable::Damping,
            End::ZeroForce => Variable::Root,
        };
        let prec = precision(self.high);
        let collision = collision(self.end)?;
        let least = if self.pieces.is_empty() { self.low } else { epsilon(self.high, self.end) };
        let find = |degree| collision.interpolant(&exact(from), &exact(to), variable, degree, prec);
        let mut own = find(DEGREES[0])?;
        for degree in &DEGREES[1..] {
            if counts(own.remainder().to_f64(), least) {
                own = find(*degree)?;
            }
        }
        Ok(self.known.get_or_init(|| own))
    }
}

/// Bits for an interval up to `high`.
fn precision(high: f64) -> u32 {
    PREC + (BITS * (1.0 / high).log2().max(0.0)) as u32
}

/// Whether a remainder counts beside the least value of an interval.
fn counts(remainder: f64, least: f64) -> bool {
    remainder > SMALL * least
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_reach_as_far_as_their_pieces() {
        for end in [End::ZeroCompression, End::ZeroForce] {
            for group in groups(end).into_iter().filter(|group| !group.pieces.is_empty()) {
                let (low, high) = group.reach();
                assert_eq!((low, high), (group.low * (1.0 - 2e-7), group.high * (1.0 + 2e-7)));
                for form in &group.pieces {
                    let margin = super::super::margin(form);
                    assert!(form.low <= near_end(end) || low <= form.low - margin, "{}", group.low);
                    assert!(high >= form.high + margin, "{}", group.high);
                }
            }
        }
    }

    #[test]
    fn interpolants_have_bits_for_small_dampings() {
        assert_eq!([1e-5, 0.25, 1.0, 300.0].map(precision), [119, 102, 100, 100]);
        assert_eq!(
            [(2e-18, 1.0), (2.1e-18, 1.0), (1.1e-20, 0.005)].map(|(r, least)| counts(r, least)),
            [false, true, true]
        );
    }
}
