//! Random fractions that are the same in every run.

use num_rational::BigRational;

/// A source of small nonzero fractions.
///
/// A polynomial identity that is false fails at almost every point: one of degree `d` is met by
/// accident with probability at most `d` in the number of choices (Schwartz and Zippel).
pub struct Samples(u64);

impl Samples {
    /// Returns the source, at its beginning.
    pub fn new() -> Self {
        Self(0x9E37_79B9_7F4A_7C15)
    }

    /// Returns a fraction, positive or negative.
    pub fn fraction(&mut self) -> BigRational {
        let sign = if self.below(2) == 0 { 1 } else { -1 };
        self.positive() * BigRational::from_integer(sign.into())
    }

    /// Returns a positive fraction.
    pub fn positive(&mut self) -> BigRational {
        let (numerator, denominator) = (self.below(997) + 1, self.below(97) + 1);
        BigRational::new(numerator.into(), denominator.into())
    }

    /// Returns several fractions.
    pub fn fractions(&mut self, count: usize) -> Vec<BigRational> {
        (0..count).map(|_| self.fraction()).collect()
    }

    /// Marsaglia's xorshift.
    fn below(&mut self, limit: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % limit
    }
}
