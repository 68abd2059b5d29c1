//! Piecewise polynomials on grids that the exponent and leading bits of a shifted argument number.

use crate::rounding::multiply_add;

/// A polynomial of degree 6 about the centre of its piece, one cache line with its complement.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub(crate) struct Piece {
    /// `c_0 + c_1 t + … + c_6 t^6` is the coefficient of restitution at `centre + t`.
    pub(crate) coefficients: [f64; 7],
    /// `1 - c_0`, rounded on its own.
    pub(crate) complement: f64,
}

/// Reads a row of a table: seven coefficients and the complement.
pub(crate) const fn piece(coefficients: [f64; 7], complement: f64) -> Piece {
    Piece { coefficients, complement }
}

impl Piece {
    /// Returns the coefficient of restitution at `centre + t`.
    #[inline(always)]
    pub(crate) fn value(&self, t: f64) -> f64 {
        polynomial(&self.coefficients, t)
    }

    /// Returns one less that.
    #[inline(always)]
    pub(crate) fn one_minus(&self, t: f64) -> f64 {
        multiply_add(-t, slope(&self.coefficients, t), self.complement)
    }

    /// Returns the mean slope from the centre to `centre + t`, `(value(t) - c_0)/t`.
    #[inline(always)]
    pub(crate) fn slope(&self, t: f64) -> f64 {
        slope(&self.coefficients, t)
    }
}

/// Returns `c_0 + c_1 t + … + c_6 t^6`.
#[inline(always)]
pub(crate) fn polynomial(c: &[f64; 7], t: f64) -> f64 {
    multiply_add(t, slope(c, t), c[0])
}

/// Returns `c_1 + c_2 t + … + c_6 t^5` by Estrin's scheme.
#[inline(always)]
fn slope(c: &[f64; 7], t: f64) -> f64 {
    let t2 = t * t;
    let low = multiply_add(t, c[2], c[1]);
    let middle = multiply_add(t, c[4], c[3]);
    let high = multiply_add(t, c[6], c[5]);
    multiply_add(t2, multiply_add(t2, high, middle), low)
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
    pub(crate) fn locate(&self, x: f64) -> (usize, f64) {
        let bits = (x + self.shift).to_bits();
        let width = 52 - self.bits;
        let centre = f64::from_bits(((bits >> width) << width) | (1 << (width - 1))) - self.shift;
        ((bits >> width).wrapping_sub(self.first) as usize, centre)
    }

    /// Returns the centre of piece `index`.
    #[inline]
    pub(crate) fn centre(&self, index: usize) -> f64 {
        let width = 52 - self.bits;
        f64::from_bits(((self.first + index as u64) << width) | (1 << (width - 1))) - self.shift
    }
}
