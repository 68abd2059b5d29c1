//! What the roundings of a form add up to, a priori.

use restitution::forms::Number;
use std::ops::Mul;

/// What the bounds themselves may be rounded by.
const SLACK: f64 = 1.0 + 1e-14;

/// A number that is computed: its exact value lies between `low` and `high`, and what is computed is off by at most `error`.
///
/// An operation passes the errors of its operands on and adds half a unit in the last place of the largest result; fused or not,
/// a multiplication with an addition counts both roundings.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rounded {
    pub(super) low: f64,
    pub(super) high: f64,
    error: f64,
    /// The part of the last operation in it.
    last: f64,
}

impl Rounded {
    pub(super) fn new(low: f64, high: f64, error: f64) -> Self {
        Self { low, high, error, last: 0.0 }
    }

    fn largest(&self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// An operation with this exact range, to which the operands pass on this error.
    fn after(low: f64, high: f64, error: f64) -> Self {
        let (low, high, error) = (low.next_down(), high.next_up(), error * SLACK);
        let last = half_unit(low.abs().max(high.abs()) + error);
        Self { low, high, error: (error + last) * SLACK, last }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        Self::after(self.low + other.low, self.high + other.high, self.error + other.error)
    }

    /// A bound of the error relative to an exact result within `missed` of this one.
    pub(super) fn relative(&self, missed: f64) -> f64 {
        let least = (self.low.abs().min(self.high.abs()) - missed).next_down();
        let known = self.low * self.high > 0.0 && least > 0.0;
        if known { (self.error + missed) * SLACK / least } else { f64::INFINITY }
    }

    /// A bound of the error in units of the last place of the exact result, if that lies within `missed` of this one.
    ///
    /// The last rounding is half a unit of the result. Just below a power of two, where units are smaller than those of what
    /// is rounded, the result is that power as long as everything else is below one unit; else the rounding counts one.
    pub(super) fn units(&self, missed: f64) -> f64 {
        let least = (self.low.abs().min(self.high.abs()) - missed).next_down();
        let most = (self.largest() + missed).next_up();
        let unit = 2.0 * half_unit(least);
        let before = (self.error - self.last * (1.0 - 1e-12) + missed) * SLACK / unit;
        let straddles = half_unit(most) > half_unit(least);
        if self.low * self.high <= 0.0 || least <= 0.0 {
            f64::INFINITY
        } else if straddles && before >= 1.0 {
            before + 1.0
        } else {
            before + 0.5
        }
    }
}

/// Half a unit in the last place of a number of this size.
pub(super) fn half_unit(x: f64) -> f64 {
    let power = f64::from_bits(x.abs().to_bits() & 0x7ff0_0000_0000_0000);
    power * f64::EPSILON / 2.0
}

impl Mul for Rounded {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let products = [self.low, self.high].map(|a| [other.low, other.high].map(|b| a * b)).concat();
        let low = products.iter().copied().fold(f64::INFINITY, f64::min);
        let high = products.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let error = self.largest() * other.error + other.largest() * self.error + self.error * other.error;
        Self::after(low, high, error)
    }
}

impl Number for Rounded {
    fn of(&self, constant: f64) -> Self {
        Self::new(constant, constant, 0.0)
    }

    fn multiply_add(self, b: Self, c: Self) -> Self {
        (self * b).plus(c)
    }

    fn negated(self) -> Self {
        Self { low: -self.high, high: -self.low, ..self }
    }
}
