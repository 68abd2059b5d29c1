//! The units of the certified way, and the two constants that the equation of motion has in them.

use crate::turning_time;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};
use restitution_law::{ForceLaw, Lattice};
use restitution_real::Ball;
use rug::{Float, Integer};

/// Lengths and times in units of the undamped turning time `T`, dampings in units of `lambda`:
///
/// ```text
/// x'' + d v x^gamma x' + e x^a = 0,    e = T^(a+1),  d = lambda T^(gamma+1),  v = u/lambda
/// ```
///
/// Every series is then summed at 1. Where both forces share their powers (`gamma = a - 1`, eq. 13)
/// `lambda` is chosen so that `d/e` is a short fraction.
#[derive(Clone, Debug)]
pub(crate) struct Scale {
    pub lattice: Lattice,
    /// Whether `gamma = a - 1`.
    pub shared: bool,
    /// `e` and `d`.
    pub elastic: Ball,
    pub damping: Ball,
    pub lambda: Ball,
    pub time: Ball,
    /// `d/e` exactly, where the powers are shared.
    pub ratio: (i64, i64),
}

impl Scale {
    /// The scale with a `lambda` near the one given, with `bits` right bits.
    pub fn new(law: &ForceLaw, lambda: f64, bits: u32) -> Self {
        let bits = bits + 64;
        let time = turning_time(law, bits);
        let shared = law.is_viscoelastic();
        let one = BigRational::one();
        let unit = if shared { time.pow(&(law.a() - law.gamma())) } else { Ball::from_rational(&one, bits) };
        let (numerator, denominator) = short_fraction(lambda / unit.to_f64());
        let lambda = unit * Ball::from_ratio(numerator, denominator, bits);
        Self {
            lattice: law.lattice(),
            shared,
            elastic: time.pow(&law.elastic_step()),
            damping: time.pow(&law.damping_step()) * &lambda,
            lambda,
            time,
            ratio: (numerator, denominator),
        }
    }

    /// `a` and `gamma + 1` in lattice steps; their unit is `lattice.unit`.
    pub fn powers(&self) -> [i64; 2] {
        [self.lattice.elastic - self.lattice.unit, self.lattice.damping]
    }

    /// `a - 1` and `gamma` as doubles next to them: a difference of doubles would be off by more than a rounding.
    pub fn lower_powers(&self) -> [f64; 2] {
        self.powers().map(|steps| (steps - self.lattice.unit) as f64 / self.lattice.unit as f64)
    }

    /// Whether the integers that weigh rows of so many orders and terms are words.
    pub fn has_words(&self, orders: usize, terms: usize) -> bool {
        let (numerator, denominator) = self.ratio;
        let fits = |x: i64, y: i64| x.checked_mul(y).is_some();
        !self.shared || fits(self.index(orders, terms), numerator) && fits(self.lattice.damping, denominator)
    }

    /// The exponent `e` of `q_(n,j)`, in lattice steps.
    pub fn index(&self, n: usize, j: usize) -> i64 {
        self.lattice.elastic * j as i64 + self.lattice.damping * n as i64
    }
}

/// A fraction with six bits in the numerator, near a positive number.
fn short_fraction(value: f64) -> (i64, i64) {
    let exponent = value.log2().floor().clamp(-40.0, 40.0) as i32 - 5;
    let numerator = (value / 2f64.powi(exponent)).round() as i64;
    let numerator = numerator.max(1);
    if exponent >= 0 { (numerator << exponent, 1) } else { (numerator, 1i64 << -exponent) }
}

/// The integer nearest to `x 2^bits`.
pub(crate) fn fixed(x: &Ball, bits: u32) -> Integer {
    let scaled = Float::with_val(x.prec(), x.mid()) << bits;
    scaled.to_integer().unwrap_or_default()
}

/// `log2` of the ratio `(t/T)^(a+1)` at the singularity nearest to 0 (`docs/error-bounds.md`, proposition 2).
pub(crate) fn log_singular_ratio(law: &ForceLaw) -> f64 {
    let step = law.elastic_step().to_f64().unwrap_or(f64::MAX);
    let cosine = (std::f64::consts::PI / step).cos();
    -step * cosine.max(0.5).log2()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_are_short_and_near() {
        for exponent in -34..=34 {
            for value in [1.0, 1.37, 1.5, 1.99].map(|x| x * 2f64.powi(exponent)) {
                let (numerator, denominator) = short_fraction(value);
                let off = numerator as f64 / denominator as f64 / value - 1.0;
                assert!(off.abs() <= 1.0 / 64.0, "{value}: {numerator}/{denominator}");
                assert!(numerator >> numerator.trailing_zeros() <= 64, "{value}: {numerator}/{denominator}");
            }
        }
        // Nothing overflows where a fraction cannot be near.
        assert_eq!(short_fraction(1e-30), (1, 1 << 45));
        assert!(short_fraction(1e18).0 > 1 << 59);
    }
}
