//! What the two ends of contact share: pieces in `u`, with other forms for `u` near 0 and for large `u`.

use super::fifth_root::Root;
use super::pieces::{Piece, Rows};
use super::rounding::Rooted;

/// Rows of the table of one end.
pub(crate) const ROWS: usize = 1024;

/// `epsilon(u)` of one end of contact: most arguments are placed in `u`, some in another variable, the rest is beyond the table.
pub(crate) trait Curve {
    /// The pieces in both variables, for batches.
    const TABLE: &'static Rows<ROWS>;
    /// Below, `1 - epsilon` has a form of its own.
    const NEAR_END: f64;
    /// Below, `epsilon` is 1; the table gives that but for its rounding.
    const NOTHING_LOST: f64 = f64::EPSILON / 16.0;
    /// From here on a batch evaluates one by one.
    const END: f64;
    /// Whether a place in the other variable has a factor.
    const HAS_POWER: bool;

    /// Whether the other variable serves.
    fn is_other(u: f64) -> bool;
    /// The row in `u`, and its centre.
    fn place(u: f64) -> (u64, f64);
    /// The row of `u + low` in the other variable, the distance from its centre, and what its value is multiplied by.
    fn place_other(u: f64, low: f64) -> (u64, f64, f64);
    /// The piece for about `u`, and the distance from its centre; none where `epsilon` is 1, beyond the table, and below zero.
    ///
    /// `distance` says how far the argument is from a number.
    fn piece(u: f64, distance: impl Fn(f64) -> f64) -> Option<(&'static Piece, f64)>;
    /// `epsilon(u + low)` where there is no piece.
    fn beyond(u: f64, low: f64) -> f64;
    /// `1 - epsilon` on `[0, NEAR_END)`.
    fn near<T: Rooted>(u: T) -> T;

    /// `epsilon` of an argument that is about `u`, and at a known distance from every number.
    #[inline(always)]
    fn at(u: f64, distance: impl Fn(f64) -> f64) -> f64 {
        match Self::piece(u, &distance) {
            Some((piece, t)) => piece.value(t),
            None => {
                let u = distance(0.0);
                Self::beyond(u, distance(u))
            }
        }
    }

    #[inline(always)]
    fn epsilon(u: f64) -> f64 {
        Self::at(u, |from| u - from)
    }

    #[inline(always)]
    fn epsilon_of_root(root: Root) -> f64 {
        Self::at(root.estimate(), |from| root.distance(from))
    }

    #[inline(always)]
    fn one_minus_epsilon(u: f64) -> f64 {
        if u < Self::NEAR_END {
            return if u >= 0.0 { Self::near(u) } else { f64::NAN };
        }
        match Self::piece(u, |from| u - from) {
            Some((piece, t)) => piece.one_minus(t),
            None => 1.0 - Self::beyond(u, 0.0),
        }
    }
}
