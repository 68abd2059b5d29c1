//! The forms of the evaluator, for proofs about them: what is evaluated where, and by which operations.
//!
//! The functions here are the ones that [`epsilon`](crate::epsilon), [`one_minus_epsilon`](crate::one_minus_epsilon) and the
//! tiers run, open to any [`Number`]: in polynomials over exact numbers they show what is evaluated, in bounds of errors how
//! well.

pub use super::rounding::Number;

use super::end::End;
use super::pieces::{Grid, Piece};
use super::tables::{zero_compression as compression, zero_force as force};
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
/// let form = forms::table(End::ZeroCompression).nth(64).unwrap();
/// assert_eq!((form.low, form.high, form.centre), (1.0, 1.0 + 1.0 / 64.0, 1.0 + 1.0 / 128.0));
/// assert_eq!(form.epsilon(0.0), epsilon(form.centre, End::ZeroCompression));
/// ```
pub fn table(end: End) -> impl Iterator<Item = Form> {
    match end {
        End::ZeroCompression => forms(&compression::GRID, &compression::PIECES[..compression::INNER]),
        End::ZeroForce => forms(&force::GRID, &force::PIECES[force::ROOT_PIECES..]),
    }
}

/// The table of small `u` at zero force, in the square root of `u`.
pub fn table_of_roots() -> impl Iterator<Item = Form> {
    forms(&force::ROOT_GRID, &force::PIECES[..force::ROOT_PIECES])
}

/// The table of `R^5/m^5`, `1 <= m < 2`, which serves large `u = 2^k m` at zero compression: `epsilon` is `2^(-5k)` times that.
pub fn table_beyond() -> impl Iterator<Item = Form> {
    forms(&compression::OUTER_GRID, &compression::PIECES[compression::INNER..])
}

fn forms(grid: &'static Grid, pieces: &'static [Piece]) -> impl Iterator<Item = Form> {
    pieces.iter().enumerate().map(|(index, piece)| {
        let (low, high) = (grid.start(index), grid.start(index + 1));
        Form { piece: *piece, low, high, centre: grid.centre(index) }
    })
}

/// Below, [`one_minus_epsilon`](crate::one_minus_epsilon) is [`near`]; at zero force [`epsilon`](crate::epsilon)
/// is [`table_of_roots`].
#[must_use]
pub fn near_end(end: End) -> f64 {
    match end {
        End::ZeroCompression => compression::NEAR_END,
        End::ZeroForce => force::NEAR_END,
    }
}

/// `1 - epsilon(u)` of a small `u`, whose square root is given.
pub fn near<T: Number>(root: T, u: T, end: End) -> T {
    match end {
        End::ZeroCompression => zero_compression::near(u),
        End::ZeroForce => zero_force::near_by_root(root, u),
    }
}
