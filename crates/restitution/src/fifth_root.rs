//! The fifth root: what leads from a velocity to `u`.

use crate::rounding::multiply_add;

/// Pieces in each factor of two.
const PIECES: usize = 64;
/// `x^(1/5)` of the 5 x 64 pieces of `[1, 32)`.
pub(crate) static ROOTS: [Piece; 5 * PIECES] = pieces();
/// 2^500, which lifts a subnormal number, and its fifth root.
const TWO_TO_500: f64 = f64::from_bits((1023 + 500) << 52);
const TWO_TO_100: f64 = f64::from_bits((1023 + 100) << 52);
/// The largest `|z|`.
const REACH: f64 = 0.0104;
/// The first coefficient of `((1 + z)^(1/5) - 1)/z` that is left out.
const OMITTED: f64 = 6612.0 / 390_625.0;
/// Its coefficients before, with `z^6` replaced by what is closest to it on `|z| <= REACH`,
/// `(3/2) a^2 z^4 - (9/16) a^4 z^2 + a^6/32`; what remains is 1e-17 of the root.
const SERIES: [f64; 6] = [
    0.2 + OMITTED * REACH * REACH * REACH * REACH * REACH * REACH / 32.0,
    -2.0 / 25.0,
    6.0 / 125.0 - OMITTED * REACH * REACH * REACH * REACH * 9.0 / 16.0,
    -21.0 / 625.0,
    399.0 / 15_625.0 + OMITTED * REACH * REACH * 1.5,
    -1596.0 / 78_125.0,
];

/// A root of ten bits, whose fifth power is therefore exact, and the reciprocal of that power.
pub(crate) type Piece = [f64; 2];

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
    /// x^(1/5) = 2^q r (1 + z)^(1/5),   z = y/r^5 - 1,   |z| <= 0.0104
    /// ```
    #[inline(always)]
    pub(crate) fn of(x: f64) -> Self {
        let (index, y, scale) = Self::place(x);
        Self::from_piece(ROOTS[(index as usize).min(ROOTS.len() - 1)], y, scale)
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

    /// Returns the root of `scale^5 y` by the piece of `y`.
    #[inline(always)]
    pub(crate) fn from_piece([root, reciprocal]: Piece, y: f64, scale: f64) -> Self {
        let z = multiply_add(y, reciprocal, -1.0);
        let coarse = root * scale;
        Self { coarse, step: coarse * z, z }
    }

    /// Returns the root to 3e-6, early.
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
        multiply_add(self.step, multiply_add(z2, multiply_add(z2, high, middle), low), self.coarse - from)
    }
}

/// Returns `x^(1/5)`, odd in `x`, for all f64.
///
/// A look-up of ten bits and six terms of the binomial series in place of a logarithm and an
/// exponential: about half the time of `powf(0.2)`.
///
/// # Error bound
///
/// [`bounds::FIFTH_ROOT`](crate::bounds::FIFTH_ROOT): at most 1 ulp (measured). Half comes from the last addition, two fifths from the reciprocal in the table and the product
/// with it (each 2^-53 of `z + 1`, a fifth of that in the root), the rest from the correction, at most
/// 0.0021 of the root, with its own rounding. The series contributes 1e-17 of the root.
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
