//! The forms of the evaluator, for proofs about them: what is evaluated where, and by which operations.
//!
//! The functions here are the ones that [`epsilon`](crate::epsilon), [`one_minus_epsilon`](crate::one_minus_epsilon) and the
//! tiers run, open to any [`Number`]: in polynomials over exact numbers they show what is evaluated, in bounds of errors how
//! well.

pub use super::rounding::Number;

use super::curve::Curve;
use super::end::End;
use super::pieces::{LENGTH, Piece, WORDS, piece};
use super::zero_compression::ZeroCompression;
use super::zero_force::ZeroForce;
use super::{zero_compression, zero_force};

/// A polynomial of the table: `epsilon` for `low <= u < high`, from `t = u - centre`.
#[derive(Clone, Copy, Debug)]
pub struct Form {
    piece: Piece,
    /// Where it starts.
    pub low: f64,
    /// Where the next one starts, but for the rounding of the place.
    pub high: f64,
    /// From where `t` counts.
    pub centre: f64,
}

impl Form {
    /// `epsilon(centre + t)`.
    pub fn epsilon<T: Number>(&self, t: T) -> T {
        self.piece.value(t)
    }

    /// The form with one of its eight numbers some units in the last place larger, which a proof must notice.
    #[must_use]
    pub fn with_mistake(self, number: usize, units: u64) -> Self {
        Self { piece: self.piece.with_mistake(number, units), ..self }
    }

    /// `1 - epsilon(centre + t)`.
    pub fn one_minus_epsilon<T: Number>(&self, t: T) -> T {
        self.piece.one_minus(t)
    }
}

/// The table of one end of contact, in the order of `u`.
///
/// # Examples
///
/// ```
/// use restitution::{End, epsilon, forms};
///
/// let form = forms::table(End::ZeroCompression).nth(128).unwrap();
/// assert_eq!((form.low, form.high, form.centre), (1.0, 1.0 + 1.0 / 64.0, 1.0 + 1.0 / 128.0));
/// assert_eq!(form.epsilon(0.0), epsilon(form.centre, End::ZeroCompression));
/// ```
pub fn table(end: End) -> impl Iterator<Item = Form> {
    let (form, count): (fn(usize) -> Form, usize) = match end {
        End::ZeroCompression => (form::<ZeroCompression>, ZeroCompression::COUNT),
        End::ZeroForce => (form::<ZeroForce>, ZeroForce::COUNT),
    };
    (0..count).map(form)
}

fn form<C: Curve>(index: usize) -> Form {
    let (low, high, centre) = (C::GRID.start(index), C::GRID.start(index + 1), C::GRID.centre(index));
    Form { piece: C::TABLE.row(index as u64 * WORDS), low, high, centre }
}

/// The coefficients that a row of the table keeps of these: `c_4` to `c_7` share words.
#[must_use]
pub fn packed(c: [f64; LENGTH]) -> [f64; LENGTH] {
    piece(c, 0.0).all()
}

/// Below, [`one_minus_epsilon`](crate::one_minus_epsilon) is [`near`].
#[must_use]
pub fn near_end(end: End) -> f64 {
    match end {
        End::ZeroCompression => ZeroCompression::NEAR_END,
        End::ZeroForce => ZeroForce::NEAR_END,
    }
}

/// `1 - epsilon(u)` of a small `u`, whose square root is given.
pub fn near<T: Number>(root: T, u: T, end: End) -> T {
    match end {
        End::ZeroCompression => zero_compression::near(u),
        End::ZeroForce => zero_force::near_by_root(root, u),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{epsilon, one_minus_epsilon};

    #[test]
    fn forms_follow_each_other_and_are_what_is_evaluated() {
        for end in [End::ZeroCompression, End::ZeroForce] {
            let mut last = 0.0;
            for form in table(end) {
                assert!(form.low == last && form.high > form.low, "{form:?}");
                assert!((form.centre - 0.5 * (form.low + form.high)).abs() <= 1e-12 * form.high);
                last = form.high;
                let t = 0.25 * (form.high - form.low);
                let u = form.centre + t;
                assert_eq!(form.epsilon(u - form.centre), epsilon(u, end));
                if u >= near_end(end) {
                    assert_eq!(form.one_minus_epsilon(u - form.centre), one_minus_epsilon(u, end));
                }
                assert_ne!(form.with_mistake(0, 1024).epsilon(t), form.epsilon(t));
            }
            assert!(last > 1000.0);
            let small = 0.9 * near_end(end);
            assert_eq!(near(small.sqrt(), small, end), one_minus_epsilon(small, end));
        }
        assert_eq!((near_end(End::ZeroCompression), near_end(End::ZeroForce)), (0.03125, 0.0625));
    }

    /// The first four numbers as they are, the others to 31, 24, 16 and 9 bits, rounded.
    #[test]
    fn a_row_keeps_the_bits_that_count() {
        let third = |sign: f64| [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0].map(|c| sign * c / 3.0);
        for c in [third(1.0), third(-1.0), [0.7, -1.1, 0.9, -0.3, 1.9, -1.3, 1.1, -1.7]] {
            let kept = packed(c);
            assert_eq!(kept[..4], c[..4]);
            for (k, bits) in [(4, 31), (5, 24), (6, 16), (7, 9)] {
                let off = (kept[k] / c[k] - 1.0).abs();
                assert!(off <= f64::powi(2.0, -bits), "{k}: {off:e}");
            }
        }
    }
}
