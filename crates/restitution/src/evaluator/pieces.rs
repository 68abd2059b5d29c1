//! Piecewise polynomials on grids that the exponent and leading bits of a shifted argument number.

use super::rounding::{Divided, Number};

/// By so many places the bits of `c_6` stand too low in the word that it shares with `c_5`.
pub(crate) const LIFT_SIXTH: u32 = 36;
/// By so many those of `c_7`, in the word of `c_4`.
pub(crate) const LIFT_SEVENTH: u32 = 43;
/// Words of a row.
pub(crate) const WORDS: u64 = 8;
/// Rows of a table of the evaluator.
pub(crate) const ROWS: usize = 2048;
/// Coefficients of a piece.
pub(crate) const LENGTH: usize = 8;

/// A polynomial of degree 7 about the centre of its piece, in one cache line with its complement.
///
/// `c_0 + c_1 t + … + c_7 t^7` is the coefficient of restitution at `centre + t`. The words are the bits of `c_0` to `c_3`; of `c_4` and
/// `c_5` as they stand, with those of `c_7` and `c_6` at their ends; of `1 - c_0`, rounded on its own; nothing. As `|t|` is at most 2^-7 of
/// what `epsilon` varies over, `c_4` needs 31 bits, `c_5` 24, `c_6` 16 and `c_7` 9: two of them share a word.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub(crate) struct Piece([u64; 8]);

/// Two numbers in a word: the second [`LIFT_SIXTH`] or [`LIFT_SEVENTH`] places lower, the first rounded to what that leaves of it.
const fn shared(first: f64, second: f64, lift: u32) -> u64 {
    let low = (second.to_bits() + (1 << (lift - 1))) >> lift;
    let high = (first.to_bits() - low + (1 << (63 - lift))) >> (64 - lift) << (64 - lift);
    high | low
}

/// Reads a row of a table: eight coefficients and the complement.
pub(crate) const fn piece(c: [f64; LENGTH], complement: f64) -> Piece {
    let (fourth, fifth) = (shared(c[4], c[7], LIFT_SEVENTH), shared(c[5], c[6], LIFT_SIXTH));
    Piece([
        c[0].to_bits(),
        c[1].to_bits(),
        c[2].to_bits(),
        c[3].to_bits(),
        fourth,
        fifth,
        complement.to_bits(),
        0,
    ])
}

/// A table whose number of rows is a power of two, so that no index needs to be compared with it; zeros beyond its pieces.
#[derive(Debug)]
#[repr(align(64))]
pub(crate) struct Rows<const N: usize>([[u64; 8]; N]);

impl<const N: usize> Rows<N> {
    pub(crate) const fn of(pieces: &[Piece]) -> Self {
        assert!(N.is_power_of_two() && pieces.len() <= N);
        let (mut rows, mut index) = ([[0; 8]; N], 0);
        while index < pieces.len() {
            rows[index] = pieces[index].0;
            index += 1;
        }
        Self(rows)
    }

    /// Returns `c_0` of a piece.
    pub(crate) const fn constant(&self, piece: usize) -> f64 {
        f64::from_bits(self.0[piece][0])
    }

    /// Returns the piece whose row starts at a word, whatever other for one beyond the table.
    #[inline(always)]
    pub(crate) fn row(&self, start: u64) -> Piece {
        Piece(*self.words(start))
    }

    /// Rows of another width, up to as many as there are.
    #[inline(always)]
    pub(crate) fn copied<const WIDTH: usize>(rows: &[[f64; WIDTH]]) -> Self {
        let mut copy = [[0; WORDS as usize]; N];
        for (copy, row) in copy.iter_mut().zip(rows) {
            for (copy, c) in copy.iter_mut().zip(row) {
                *copy = c.to_bits();
            }
        }
        Self(copy)
    }

    /// Returns the row that starts at a word, whatever other for one beyond the table.
    #[inline(always)]
    pub(crate) fn words(&self, start: u64) -> &[u64; 8] {
        let all = self.0.as_flattened();
        all[start as usize & (WORDS as usize * (N - 1))..].first_chunk().unwrap_or(&self.0[0])
    }
}

impl Piece {
    /// Returns `c_0` to `c_7`.
    #[inline(always)]
    pub(crate) fn all(&self) -> [f64; LENGTH] {
        let [c0, c1, c2, c3, c4, c5, ..] = self.0;
        [c0, c1, c2, c3, c4, c5, c5 << LIFT_SIXTH, c4 << LIFT_SEVENTH].map(f64::from_bits)
    }

    /// The row with the bits of one word increased.
    pub(crate) fn with_mistake(mut self, word: usize, units: u64) -> Self {
        if let Some(bits) = self.0.get_mut(word) {
            *bits = bits.wrapping_add(units);
        }
        self
    }

    /// Returns `c_0`, the coefficient of restitution at the centre.
    #[inline(always)]
    pub(crate) fn constant(&self) -> f64 {
        f64::from_bits(self.0[0])
    }

    /// Returns `1 - c_0`, rounded on its own.
    #[inline(always)]
    pub(crate) fn complement(&self) -> f64 {
        f64::from_bits(self.0[6])
    }

    /// Returns the coefficient of restitution at `centre + t`.
    #[inline(always)]
    pub(crate) fn value<T: Number>(&self, t: T) -> T {
        polynomial(&self.all().map(|c| t.of(c)), t)
    }

    /// Returns one less that.
    #[inline(always)]
    pub(crate) fn one_minus<T: Number>(&self, t: T) -> T {
        one_minus(&self.all().map(|c| t.of(c)), t.of(self.complement()), t)
    }

    /// Returns the `t` at which the coefficient of restitution is `c_0 + change`.
    #[inline(always)]
    pub(crate) fn distance(&self, change: f64) -> f64 {
        distance(&self.all(), change)
    }
}

/// Returns the `t` at which `c_1 t + … + c_7 t^7` is `change`: three terms of the inverse series, then two steps of Newton's iteration.
///
/// With `q = |c_2 t/c_1|` the start is off by some `5 q^3`, then by `q^4` of that and of that again: nothing for the pieces of the tables,
/// where `q` is below `2^-6` (`every_distance_has_settled`).
#[inline(always)]
pub(crate) fn distance<T: Divided>(c: &[T; LENGTH], change: T) -> T {
    let one = change.of(1.0);
    let reciprocal = one.clone().over(c[1].clone());
    let x = change.clone() * reciprocal.clone();
    let bend = c[2].clone() * reciprocal.clone() * x.clone();
    let twist = c[3].clone() * reciprocal * (x.clone() * x.clone());
    let second = (bend.clone() * bend.of(2.0)).multiply_add(bend.clone(), twist.negated());
    let mut t = x.clone().multiply_add(second.multiply_add(one, bend.negated()), x);
    for _ in 0..2 {
        let missing = t.clone().negated().multiply_add(slope(c, t.clone()), change.clone());
        t = missing.over(tangent(c, t.clone())).multiply_add(t.of(1.0), t);
    }
    t
}

/// Returns `c_1 + 2 c_2 t + 3 c_3 t^2 + 4 c_4 t^3`, the slope of the tangent but for what Newton's iteration doesn't need.
#[inline(always)]
fn tangent<T: Number>(c: &[T; LENGTH], t: T) -> T {
    let term = |k: usize| c[k].clone() * t.of(k as f64);
    let high = t.clone().multiply_add(term(4), term(3));
    let high = t.clone().multiply_add(high, term(2));
    t.multiply_add(high, c[1].clone())
}

/// Returns one less the polynomial, from one less its constant.
#[inline(always)]
pub(crate) fn one_minus<T: Number>(c: &[T; LENGTH], complement: T, t: T) -> T {
    t.clone().negated().multiply_add(slope(c, t), complement)
}

/// Returns `c_0 + c_1 t + … + c_7 t^7`.
#[inline(always)]
pub(crate) fn polynomial<T: Number>(c: &[T; LENGTH], t: T) -> T {
    t.clone().multiply_add(slope(c, t), c[0].clone())
}

/// Returns `c_1 + c_2 t + … + c_7 t^6` by Estrin's scheme.
#[inline(always)]
fn slope<T: Number>(c: &[T; LENGTH], t: T) -> T {
    let pair = |k: usize| t.clone().multiply_add(c[k + 1].clone(), c[k].clone());
    let (low, middle, high) = (pair(1), pair(3), pair(5));
    let t2 = t.clone() * t;
    let t4 = t2.clone() * t2.clone();
    let high = t2.clone().multiply_add(c[7].clone(), high);
    t4.multiply_add(high, t2.multiply_add(middle, low))
}

/// Pieces of `2^-bits` of a factor of two each, in `x + shift`.
///
/// For `x + shift` in `[2^e, 2^(e+1))` a piece is `2^(e - bits)` wide; adding the shift makes the
/// pieces as even as the function asks for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid {
    shift: f64,
    bits: u32,
    first: u64,
}

impl Grid {
    /// Returns the grid whose piece 0 starts at `start`.
    pub(crate) const fn new(shift: f64, bits: u32, start: f64) -> Self {
        Self { shift, bits, first: (start + shift).to_bits() >> (52 - bits) }
    }

    /// Returns the number of the piece that `x` lies in, beyond every table if `x` lies below the
    /// first or is NaN, and the centre of that piece.
    #[inline(always)]
    pub(crate) const fn locate(&self, x: f64) -> (usize, f64) {
        let bits = (x + self.shift).to_bits();
        let width = 52 - self.bits;
        let centre = f64::from_bits(((bits >> width) << width) | (1 << (width - 1))) - self.shift;
        ((bits >> width).wrapping_sub(self.first) as usize, centre)
    }

    /// Returns the least number that [`locate`](Self::locate) puts beyond a table of `pieces`.
    ///
    /// The sum with the shift is rounded, so this may lie below the end of the last piece.
    pub(crate) const fn end(&self, pieces: usize) -> f64 {
        let width = 52 - self.bits;
        let mut end = f64::from_bits((self.first + pieces as u64) << width) - self.shift;
        while self.locate(end.next_down()).0 >= pieces {
            end = end.next_down();
        }
        end
    }

    /// Returns where piece `index` starts.
    pub(crate) fn start(&self, index: usize) -> f64 {
        f64::from_bits((self.first + index as u64) << (52 - self.bits)) - self.shift
    }

    /// Returns the centre of piece `index`.
    #[inline]
    pub(crate) fn centre(&self, index: usize) -> f64 {
        let width = 52 - self.bits;
        f64::from_bits(((self.first + index as u64) << width) | (1 << (width - 1))) - self.shift
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is read back lies within half a unit of the last bit that the packing leaves: 21, 28, 36 and 43 bits of 64 are cut.
    #[test]
    fn packed_coefficients_are_rounded_to_nearest() {
        let mut largest = [0; 4];
        for step in 0..1000_u32 {
            let c: [f64; LENGTH] = core::array::from_fn(|k| {
                let size = 1.0 + f64::from(step * 7919 % 1009) / 1009.0 + f64::from(step) * 1e-9;
                if (step >> k) & 1 == 0 { size } else { -size / 3.0 }
            });
            let read = piece(c, 0.5).all();
            assert_eq!(read[..4], c[..4]);
            for (k, cut) in [(4, 21), (5, 28), (6, 36), (7, 43)] {
                let error = read[k].to_bits().abs_diff(c[k].to_bits());
                assert!(error <= 1 << (cut - 1), "{k} {step}");
                largest[k - 4] = error.max(largest[k - 4]);
            }
        }
        for (error, cut) in largest.into_iter().zip([21, 28, 36, 43]) {
            assert!(error > 1 << (cut - 2), "the test has seen no rounding of {cut} bits");
        }
    }

    #[test]
    fn the_end_of_a_table_is_where_locate_says() {
        for (grid, pieces, end) in [
            (Grid::new(8.0, 9, 0.0), 448, 7.0_f64.next_down()), // 7 - 2^-50 + 8 rounds to 15
            (Grid::new(1.0 / 512.0, 6, 0.0), 1216, 1024.0 - 1.0 / 512.0),
            (Grid::new(8.0, 9, 0.0), 64, 1.0 - 4.0 * f64::EPSILON),
        ] {
            assert_eq!(grid.end(pieces), end);
            assert!(grid.locate(end).0 >= pieces && grid.locate(end.next_down()).0 < pieces);
        }
    }
}
