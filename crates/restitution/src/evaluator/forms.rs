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
