//! What the two ends of contact share: one table of pieces in `u`, a form for `1 - epsilon` near 0 and one for large `u`.

use super::fifth_root::Root;
use super::index::Index;
use super::pieces::{Grid, Piece, ROWS, Rows, WORDS};
use super::rounding::Rooted;

/// `epsilon(u)` of one end of contact.
pub(crate) trait Curve {
    /// The pieces.
    const TABLE: &'static Rows<ROWS>;
    /// Which of them a coefficient belongs to.
    const INDEX: &'static Index;
    /// Where they lie.
    const GRID: Grid;
    /// How many they are.
    const COUNT: usize;
    /// Below, `1 - epsilon` has a form of its own.
    const NEAR_END: f64;
    /// Below, `epsilon` is 1; the table gives that but for its rounding.
    const NOTHING_LOST: f64 = f64::EPSILON / 16.0;
    /// From here on an argument is rounded beyond the table.
    const END: f64 = Self::GRID.end(Self::COUNT);

    /// `epsilon(u + low)` beyond the table.
    fn beyond(u: f64, low: f64) -> f64;
    /// `1 - epsilon` on `[0, NEAR_END)`.
    fn near<T: Rooted>(u: T) -> T;
    /// The first two coefficients of [`near`](Self::near) in powers of `u`.
    const NEAR: [f64; 2];
    /// The derivative of [`near`](Self::near), to 1e-5.
    fn near_slope(u: f64) -> f64;
    /// The `u` beyond the last centre of the table at which `epsilon` is `kept > 0`.
    fn inverse_beyond(kept: f64) -> f64;

    /// The piece for about `u` and its centre; none below zero, where nothing is lost, and beyond the table.
    #[inline(always)]
    fn piece(u: f64) -> Option<(Piece, f64)> {
        let (index, centre) = Self::GRID.locate(u);
        let inside = index < Self::COUNT && u >= Self::NOTHING_LOST;
        inside.then(|| (Self::TABLE.row(index as u64 * WORDS), centre))
    }

    #[inline(always)]
    fn epsilon(u: f64) -> f64 {
        match Self::piece(u) {
            Some((piece, centre)) => piece.value(u - centre),
            None => outside::<Self>(u, 0.0),
        }
    }

    #[inline(always)]
    fn epsilon_of_root(root: Root) -> f64 {
        match Self::piece(root.estimate()) {
            Some((piece, centre)) => piece.value(root.distance(centre)),
            None => {
                let u = root.distance(0.0);
                outside::<Self>(u, root.distance(u))
            }
        }
    }

    #[inline(always)]
    fn one_minus_epsilon(u: f64) -> f64 {
        if u < Self::NEAR_END {
            return if u >= 0.0 { Self::near(u) } else { f64::NAN };
        }
        match Self::piece(u) {
            Some((piece, centre)) => piece.one_minus(u - centre),
            None => 1.0 - outside::<Self>(u, 0.0),
        }
    }
}

/// `epsilon(u + low)` where there is no piece.
fn outside<C: Curve + ?Sized>(u: f64, low: f64) -> f64 {
    if u < C::NEAR_END {
        return if u >= 0.0 { 1.0 } else { f64::NAN };
    }
    if u.is_nan() { u } else { C::beyond(u, low) }
}
