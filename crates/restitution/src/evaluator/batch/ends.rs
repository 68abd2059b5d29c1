//! What the two ends of contact have of their own: which row of the table serves an argument.

use crate::evaluator::pieces::Rows;
use crate::evaluator::{zero_compression, zero_force};

/// A row, the distance from its centre, and what its value is multiplied by.
pub(super) type Place = (u64, f64, f64);

/// The table of one end of contact: most arguments are placed in `u`, the others in another variable.
pub(super) trait Table<const N: usize> {
    const ROWS: &'static Rows<N>;
    /// Below, `1 - epsilon` has a form of its own.
    const NEAR_END: f64;
    /// Below, `epsilon` is 1.
    const NOTHING_LOST: f64 = f64::EPSILON / 16.0;
    /// From here on arguments are evaluated one by one.
    const END: f64;

    /// Whether the other variable serves.
    fn is_other(u: f64) -> bool;
    /// The row and its centre.
    fn place(u: f64) -> (u64, f64);
    /// `u + low` in the other variable.
    fn place_other(u: f64, low: f64) -> Place;
    /// Whether a place in the other variable has a factor.
    const HAS_POWER: bool;
    fn near(u: f64) -> f64;
    fn epsilon(u: f64) -> f64;
    fn one_minus_epsilon(u: f64) -> f64;
}

pub(super) struct Compression;
pub(super) struct Force;

impl Table<{ zero_compression::ROWS }> for Compression {
    const ROWS: &'static Rows<{ zero_compression::ROWS }> = &zero_compression::TABLE;
    const NEAR_END: f64 = zero_compression::NEAR_END;
    const END: f64 = zero_compression::LARGE;
    const HAS_POWER: bool = true;

    #[inline(always)]
    fn is_other(u: f64) -> bool {
        u >= zero_compression::TABLE_END
    }

    #[inline(always)]
    fn place(u: f64) -> (u64, f64) {
        let (index, centre) = zero_compression::GRID.locate(u);
        (index as u64, centre)
    }

    #[inline(always)]
    fn place_other(u: f64, low: f64) -> Place {
        zero_compression::place_beyond(u, low)
    }

    #[inline(always)]
    fn near(u: f64) -> f64 {
        zero_compression::near(u)
    }

    fn epsilon(u: f64) -> f64 {
        zero_compression::epsilon(u)
    }

    fn one_minus_epsilon(u: f64) -> f64 {
        zero_compression::one_minus_epsilon(u)
    }
}

impl Table<{ zero_force::ROWS }> for Force {
    const ROWS: &'static Rows<{ zero_force::ROWS }> = &zero_force::TABLE;
    const NEAR_END: f64 = zero_force::NEAR_END;
    const END: f64 = zero_force::TABLE_END;
    const HAS_POWER: bool = false;

    #[inline(always)]
    fn is_other(u: f64) -> bool {
        u < zero_force::NEAR_END
    }

    #[inline(always)]
    fn place(u: f64) -> (u64, f64) {
        zero_force::place(u)
    }

    #[inline(always)]
    fn place_other(u: f64, _: f64) -> Place {
        let (index, t) = zero_force::place_near(u);
        (index, t, 1.0)
    }

    #[inline(always)]
    fn near(u: f64) -> f64 {
        zero_force::near(u)
    }

    fn epsilon(u: f64) -> f64 {
        zero_force::epsilon(u)
    }

    fn one_minus_epsilon(u: f64) -> f64 {
        zero_force::one_minus_epsilon(u)
    }
}
