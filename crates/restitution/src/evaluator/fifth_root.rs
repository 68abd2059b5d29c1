//! The fifth root: what leads from a velocity to `u`.

use super::rounding::multiply_add;

/// Pieces in each factor of two.
const PIECES: usize = 64;
/// `x^(1/5)` of the 5 x 64 pieces of `[1, 32)`.
pub(crate) static ROOTS: [Piece; 5 * PIECES] = ROOTS_OF_PIECES;
const ROOTS_OF_PIECES: [Piece; 5 * PIECES] = pieces();
/// The fifth powers of the roots in them.
static POWERS: [f64; 5 * PIECES] = powers();
/// 2^500, which lifts a subnormal number, and its fifth root.
const TWO_TO_500: f64 = f64::from_bits((1023 + 500) << 52);
const TWO_TO_100: f64 = f64::from_bits((1023 + 100) << 52);
/// The largest `|z|`, rounded up.
const REACH: f64 = 0.01211;
const REACH2: f64 = REACH * REACH;
/// The first coefficient of `((1 + z)^(1/5) - 1)/z` that is left out.
const OMITTED: f64 = -28_101.0 / 1_953_125.0;
/// Its coefficients before, with `z^7` replaced by what is closest to it on `|z| <= REACH`,
/// `(7/4) a^2 z^5 - (7/8) a^4 z^3 + (7/64) a^6 z`; what remains is 2e-19 of the root.
const SERIES: [f64; 7] = [
    0.2,
    -2.0 / 25.0 + OMITTED * REACH2 * REACH2 * REACH2 * 7.0 / 64.0,
    6.0 / 125.0,
    -21.0 / 625.0 - OMITTED * REACH2 * REACH2 * 7.0 / 8.0,
    399.0 / 15_625.0,
    -1596.0 / 78_125.0 + OMITTED * REACH2 * 7.0 / 4.0,
    6612.0 / 390_625.0,
];

/// A root of ten bits, whose fifth power is therefore exact, and the reciprocal of that power.
pub(crate) type Piece = [f64; 2];

/// The piece at an index, the last one beyond.
#[inline(always)]
pub(crate) fn piece_at(index: u64) -> usize {
    (index as usize).min(5 * PIECES - 1)
}

/// A fifth root that is known better than one f64: `x^(1/5) = coarse + step p(z)`.
#[derive(Clone, Copy)]
pub(crate) struct Root {
    /// Ten bits of it.
    pub(crate) coarse: f64,
    step: f64,
    z: f64,
}

impl Root {
    /// Splits a positive, normal and finite `x`.
    ///
    /// With `x = 2^(5q) y`, `1 <= y < 32`, and `r` a ten-bit number close to the root of `y`:
    ///
    /// ```text
    /// x^(1/5) = 2^q r (1 + z)^(1/5),   z = y/r^5 - 1,   |z| <= 0.01211
    /// ```
    #[inline(always)]
    pub(crate) fn of(x: f64) -> Self {
        let (index, y, scale) = Self::place(x);
        let index = piece_at(index);
        Self::from_piece(ROOTS[index], POWERS[index], y, scale)
    }

    /// Returns the number of the piece that `y` lies in, `y`, and `2^q`.
    #[inline(always)]
    pub(crate) fn place(x: f64) -> (u64, f64, f64) {
        let bits = x.to_bits();
        let exponent = (bits >> 52) + 2; // 1025 = 5 * 205 is that of 1
        let q = (exponent * 52429) >> 18; // exponent/5, exact below 2^16
        let rest = exponent - 5 * q;
        let index = (rest << 6) | ((bits >> 46) & 63);
        let y = f64::from_bits((bits & 0x000f_ffff_ffff_ffff) | ((1023 + rest) << 52));
        (index, y, f64::from_bits((q + 1023 - 205) << 52))
    }

    /// Returns the root of `scale^5 y` by the piece of `y` and the exact fifth power of the root in it.
    ///
    /// The difference of `y` and the power is exact, so that what `z` is off by is 2^-52 of it, not of 1.
    #[inline(always)]
    pub(crate) fn from_piece([root, reciprocal]: Piece, power: f64, y: f64, scale: f64) -> Self {
        let z = (y - power) * reciprocal;
        let coarse = root * scale;
        Self { coarse, step: coarse * z, z }
    }

    /// Returns the root to 1e-7, early: the next term is `(6/125) z^3` of it, 8.6e-8.
    #[inline(always)]
    pub(crate) fn estimate(self) -> f64 {
        multiply_add(self.step, multiply_add(self.z, SERIES[1], SERIES[0]), self.coarse)
    }

    /// Returns the root less `from`, which is close to it, without the rounding of the root.
    #[inline(always)]
    pub(crate) fn distance(self, from: f64) -> f64 {
        let z = self.z;
        let z2 = z * z;
        let low = multiply_add(z, SERIES[1], SERIES[0]);
        let middle = multiply_add(z, SERIES[3], SERIES[2]);
        let high = multiply_add(z, SERIES[5], SERIES[4]);
        let z4 = z2 * z2;
        let slope = multiply_add(z4, multiply_add(z2, SERIES[6], high), multiply_add(z2, middle, low));
        multiply_add(self.step, slope, self.coarse - from)
    }
}

/// Returns `x^(1/5)`, odd in `x`, for all f64.
///
/// A look-up of ten bits and seven terms of the binomial series in place of a logarithm and an
/// exponential: about half the time of `powf(0.2)`.
///
/// # Error bound
///
/// [`bounds::FIFTH_ROOT`](crate::bounds::FIFTH_ROOT): at most 0.6 ulp (proved). Half comes from the last addition, the rest
/// from what is added, at most 0.0025 of the root, with some roundings of its own. The series contributes 2e-19 of the root.
///
/// # Examples
///
/// ```
/// use restitution::fifth_root;
///
/// assert_eq!(fifth_root(32.0), 2.0);
/// assert_eq!(fifth_root(-1e-320 * 0.0), 0.0);
/// assert_eq!(fifth_root(f64::INFINITY), f64::INFINITY);
/// assert!(fifth_root(f64::NAN).is_nan());
/// ```
#[inline]
#[must_use]
pub fn fifth_root(x: f64) -> f64 {
    if is_ordinary(x) { Root::of(x).distance(0.0) } else { unusual(x) }
}

/// Whether `x` is positive, normal and finite.
#[inline(always)]
pub(crate) fn is_ordinary(x: f64) -> bool {
    (f64::MIN_POSITIVE..=f64::MAX).contains(&x)
}

#[cold]
fn unusual(x: f64) -> f64 {
    if x < 0.0 {
        return -fifth_root(-x);
    }
    if x == 0.0 || !x.is_finite() {
        return x;
    }
    Root::of(x * TWO_TO_500).distance(0.0) / TWO_TO_100
}

/// The fifth power of a number of ten bits, exactly.
#[inline(always)]
pub(crate) const fn fifth_power(root: f64) -> f64 {
    let square = root * root;
    square * square * root
}

const fn powers() -> [f64; 5 * PIECES] {
    let (mut table, mut index) = ([0.0; 5 * PIECES], 0);
    while index < table.len() {
        table[index] = fifth_power(ROOTS_OF_PIECES[index][0]);
        index += 1;
    }
    table
}

/// Builds the table at compile time: Newton's iteration, then rounding to multiples of 2^-9.
const fn pieces() -> [Piece; 5 * PIECES] {
    let mut table = [[0.0; 2]; 5 * PIECES];
    let mut index = 0;
    while index < table.len() {
        let centre = (1.0 + (index % PIECES) as f64 / 64.0 + 1.0 / 128.0) * (1u64 << (index / PIECES)) as f64;
        let mut root = 2.0;
        let mut step = 0;
        while step < 12 {
            root -= (root - centre / (root * root * root * root)) / 5.0;
            step += 1;
        }
        root = (root * 512.0 + 0.5) as u64 as f64 / 512.0;
        table[index] = [root, 1.0 / (root * root * root * root * root)];
        index += 1;
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_index_lies_beyond_the_pieces() {
        assert_eq!([0, 1, 318, 319, 320, u64::MAX].map(piece_at), [0, 1, 318, 319, 319, 319]);
    }

    /// The largest distance of a number from the fifth power in its piece, at the ends of all pieces.
    #[test]
    fn every_number_is_within_reach_of_its_piece() {
        let mut largest = 0.0_f64;
        for (index, power) in POWERS.iter().enumerate() {
            let octave = (1_u64 << (index / PIECES)) as f64;
            let ends = [index % PIECES, index % PIECES + 1].map(|i| (1.0 + i as f64 / 64.0) * octave);
            largest = ends.iter().fold(largest, |largest, y| largest.max((y / power - 1.0).abs()));
        }
        assert!(largest <= REACH && largest > 0.99 * REACH, "{largest}");
    }

    #[test]
    fn fifth_powers_have_their_roots() {
        for root in 1..1552_u32 {
            let power = f64::from(root).powi(5); // below 2^53, exact
            assert_eq!((fifth_root(power), fifth_root(-power)), (f64::from(root), -f64::from(root)));
            let early = Root::of(power).estimate();
            assert!((early / f64::from(root) - 1.0).abs() < 1e-7, "{root}");
            assert!(
                (Root::of(power).distance(early) - (f64::from(root) - early)).abs() < 1e-16 * f64::from(root)
            );
        }
        // The same in all powers of two, subnormal ones too.
        for k in -214..=204 {
            let power = |k: i32| f64::powi(2.0, k / 2) * f64::powi(2.0, k - k / 2);
            assert_eq!(fifth_root(power(5 * k)), power(k), "{k}");
            assert!(
                (fifth_root(3.0 * power(5 * k)) / power(k) - 1.245_730_939_615_517_3).abs() < 3e-16,
                "{k}"
            );
        }
        for same in [0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(fifth_root(same).to_bits(), same.to_bits());
        }
        assert!(
            fifth_root(f64::NAN).is_nan() && (fifth_root(5e-324) / 2.0_f64.powf(-214.8) - 1.0).abs() < 1e-13
        );
    }
}
