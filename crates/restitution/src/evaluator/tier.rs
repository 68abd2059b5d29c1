//! One cheaper evaluator: polynomials on pieces that keep a tolerance.

use super::end::End;
use super::epsilon::epsilon;
use super::rounding::Number;

/// Polynomials of degree `WIDTH - 1` on `ROWS` pieces that keep a tolerance.
///
/// A piece is where `u + shift` has the same leading bits; the bits behind say how far its end is, as a part `s` of its
/// width, and `epsilon = c_0 + s (c_1 + s (c_2 + …))`.
///
/// # Error bound
///
/// The relative error is at most [`Tier::tolerance`] for every `u >= 0`: below [`Tier::far`] by the table,
/// from there on by [`epsilon`]. `tests/it/tiers.rs` checks it.
///
/// # Guarantees
///
/// `epsilon(0) = 1` exactly, `0 <= epsilon <= 1`, and a larger `u` never gives a larger `epsilon` below [`Tier::far`] and
/// across it, with fused multiply-add or without: the exporter checks each row for it in exact arithmetic
/// (docs/export.md). Beyond, what is said of [`epsilon`] holds.
///
/// # Examples
///
/// ```
/// use restitution::{End, epsilon, tiers};
///
/// let rough = tiers::ZERO_FORCE_1E6.epsilon(0.7);
/// assert!((rough / epsilon(0.7, End::ZeroForce) - 1.0).abs() <= 1e-6);
/// assert_eq!(tiers::ZERO_FORCE_1E6.epsilon(0.0), 1.0);
/// assert!(tiers::ZERO_FORCE_1E6.epsilon(-0.7).is_nan());
/// ```
#[derive(Debug)]
pub struct Tier<const ROWS: usize, const WIDTH: usize> {
    end: End,
    tolerance: f64,
    far: f64,
    shift: f64,
    bits: u32,
    rows: [[f64; WIDTH]; ROWS],
}

impl<const ROWS: usize, const WIDTH: usize> Tier<ROWS, WIDTH> {
    pub(crate) const fn new(
        end: End,
        tolerance: f64,
        far: f64,
        shift: f64,
        bits: u32,
        rows: [[f64; WIDTH]; ROWS],
    ) -> Self {
        Self { end, tolerance, far, shift, bits, rows }
    }

    /// Where the contact ends.
    #[must_use]
    pub const fn end(&self) -> End {
        self.end
    }

    /// The largest relative error.
    #[must_use]
    pub const fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Where the table ends and [`epsilon`] takes over.
    #[must_use]
    pub const fn far(&self) -> f64 {
        self.far
    }

    /// Returns `epsilon(u)` within the tolerance; NaN for NaN and below zero.
    #[inline]
    #[must_use]
    pub fn epsilon(&self, u: f64) -> f64 {
        if (0.0..self.far).contains(&u) { self.within(u) } else { epsilon(u, self.end) }
    }

    /// Returns the row of an argument inside of the table, and how far its end is, as a part of its width.
    #[inline(always)]
    pub(crate) fn place(&self, u: f64) -> (u64, f64) {
        let (bits, rest) = ((u + self.shift).to_bits(), 52 - self.bits);
        let fraction = (bits << self.bits) & (u64::MAX >> 12);
        let distance = 2.0 - f64::from_bits(1.0_f64.to_bits() | fraction);
        ((bits >> rest).wrapping_sub(self.shift.to_bits() >> rest), distance)
    }

    #[inline(always)]
    fn within(&self, u: f64) -> f64 {
        let (row, distance) = self.place(u);
        self.form(row as usize, distance)
    }

    /// The coefficients of every row.
    pub(crate) fn rows(&self) -> &[[f64; WIDTH]; ROWS] {
        &self.rows
    }

    /// Where the polynomial of a row holds, for proofs.
    #[doc(hidden)]
    pub fn ends(&self, row: usize) -> (f64, f64) {
        let first = self.shift.to_bits() >> (52 - self.bits);
        let start = |row: usize| f64::from_bits((first + row as u64) << (52 - self.bits)) - self.shift;
        (start(row), start(row + 1))
    }

    /// The value of a row so far before the end of it, as a part of the width, for proofs; that of the last beyond.
    #[doc(hidden)]
    #[inline(always)]
    pub fn form<T: Number>(&self, row: usize, distance: T) -> T {
        value(&self.rows[row.min(ROWS - 1)].map(|c| distance.of(c)), distance)
    }

    /// What is added to `u` to find its row.
    #[doc(hidden)]
    pub fn shift(&self) -> f64 {
        self.shift
    }
}

/// Returns `c_0 + c_1 s + …`, by pairs from `c_1` on.
#[inline(always)]
pub(crate) fn value<T: Number, const WIDTH: usize>(c: &[T; WIDTH], s: T) -> T {
    let s2 = s.clone() * s.clone();
    let at = |k: usize| c[k].clone();
    let pair = |k: usize| at(k + 1).multiply_add(s.clone(), at(k));
    let (mut slope, mut k) =
        if WIDTH.is_multiple_of(2) { (at(WIDTH - 1), WIDTH - 1) } else { (pair(WIDTH - 2), WIDTH - 2) };
    while k > 1 {
        k -= 2;
        slope = slope.multiply_add(s2.clone(), pair(k));
    }
    s.multiply_add(slope, at(0))
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::*;
    use crate::tiers;

    /// Against the full evaluator, alone and in batches with arguments inside and outside of the pieces.
    fn keeps_its_tolerance<const ROWS: usize, const WIDTH: usize>(tier: &Tier<ROWS, WIDTH>) {
        let even = (0..6000).map(|i| f64::from(i) / 6000.0 * tier.far());
        let odd =
            [tier.far().next_down(), tier.far(), 8.5, 1e9, 0.0, -0.0, -1e-9, f64::NAN, f64::INFINITY, 5e-324];
        let points: Vec<f64> = even.chain(odd).collect();
        let mut worst = 0.0_f64;
        for length in [0, 5, 31, 32, 127, 128, 129, 511, 512, 513, points.len()] {
            for part in [&points[..length], &points[points.len() - length..]] {
                let mut batch = vec![2.0; length + 1];
                tier.epsilon_batch(part, &mut batch);
                assert_eq!(batch.pop(), Some(2.0));
                assert!(part.iter().zip(&batch).all(|(u, out)| tier.epsilon(*u).to_bits() == out.to_bits()));
            }
        }
        for u in points {
            let (cheap, full) = (tier.epsilon(u), epsilon(u, tier.end()));
            if (0.0..tier.far()).contains(&u) {
                worst = worst.max((cheap / full - 1.0).abs());
            } else {
                assert_eq!(cheap.to_bits(), full.to_bits(), "{u}");
            }
        }
        assert!(worst <= tier.tolerance() && worst > tier.tolerance() / 1000.0, "{worst:e}");
    }

    /// Pieces follow each other from 0 to the end; on each the distance falls from 1 to 0.
    fn covers_its_range<const ROWS: usize, const WIDTH: usize>(tier: &Tier<ROWS, WIDTH>) {
        assert_eq!((tier.ends(0).0, tier.rows().len()), (0.0, ROWS));
        let mut row = 0;
        while tier.ends(row).1 < tier.far() {
            let (start, end) = tier.ends(row);
            assert_eq!(tier.ends(row + 1).0, end);
            for part in [0.0, 0.25, 0.5, 0.96875] {
                let u = start + part * (end - start);
                let (found, distance) = tier.place(u);
                assert!(
                    found as usize == row && (distance - (1.0 - part)).abs() < 1e-9,
                    "{row} {part} {found} {distance}"
                );
                // Cheap sums of powers, and the constant term of all: the value at the end.
                let powers: f64 = (0..WIDTH).map(|k| tier.rows()[row][k] * distance.powi(k as i32)).sum();
                assert!((tier.form(row, distance) - powers).abs() < 1e-15);
                assert_eq!(tier.epsilon(u), tier.form(row, distance));
            }
            row += 1;
        }
        assert!(row + 2 >= ROWS, "{row} of {ROWS}");
        assert_eq!(tier.form(ROWS + 7, 0.5), tier.form(ROWS - 1, 0.5));
    }

    #[test]
    fn every_tier_is_near_the_full_evaluator() {
        macro_rules! check {
            ($($tier:ident),*) => {$(
                keeps_its_tolerance(&tiers::$tier);
                covers_its_range(&tiers::$tier);
            )*};
        }
        check!(
            ZERO_COMPRESSION_1E3,
            ZERO_COMPRESSION_1E6,
            ZERO_COMPRESSION_1E9,
            ZERO_FORCE_1E3,
            ZERO_FORCE_1E6,
            ZERO_FORCE_1E9
        );
        assert_eq!(
            (tiers::ZERO_COMPRESSION_1E6.end(), tiers::ZERO_FORCE_1E3.end()),
            (End::ZeroCompression, End::ZeroForce)
        );
        assert_eq!((tiers::ZERO_FORCE_1E9.shift(), tiers::ZERO_COMPRESSION_1E3.shift()), (0.125, 8.0));
    }
}
