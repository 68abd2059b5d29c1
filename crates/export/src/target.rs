//! The function that is tabulated, and how it goes on where the table ends.

use crate::chebyshev::PREC;
use crate::{ExportError, InterpolatedCurve};
use restitution::End;
use rug::Float;
use rug::ops::Pow;

/// The part of the tolerance that the law at infinity may leave.
const SHARE: f64 = 1.0 / 16.0;
/// The largest power of two at which it is looked for.
const LARGEST_EXPONENT: i32 = 36;

/// The law at infinity, where it takes over and what it leaves.
///
/// ```text
/// epsilon(2^octaves u) = epsilon(u)/32
/// ```
///
/// as `epsilon ~ R^5/u^5` where the contact ends at zero compression (one octave) and
/// `(3/2)^(2/3) u^(-5/3)` where it ends at zero force (three).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    /// From this `u` on it is used: a power of two.
    pub from: f64,
    /// Octaves of `u` in which `epsilon` falls to 1/32.
    pub octaves: u32,
    /// The largest departure of `epsilon` from it, relative to `epsilon`.
    pub departure: f64,
}

impl Law {
    /// Finds where the law at infinity may take over, so that it leaves at most 1/16 of `tolerance`.
    ///
    /// # Errors
    ///
    /// [`ExportError::Law`] if that is nowhere below 2^36.
    pub fn within(reference: &InterpolatedCurve, tolerance: f64) -> Result<Self, ExportError> {
        let octaves = if reference.end() == End::ZeroCompression { 1 } else { 3 };
        let departure = |exponent: i32| departure(reference, 2.0_f64.powi(exponent));
        let mut last = LARGEST_EXPONENT;
        if departure(last) > tolerance * SHARE {
            return Err(ExportError::Law { tolerance });
        }
        while last > 1 && departure(last - 1) <= tolerance * SHARE {
            last -= 1;
        }
        Ok(Self { from: 2.0_f64.powi(last), octaves, departure: departure(last) })
    }

    /// Where the first period ends.
    pub fn period_end(&self) -> f64 {
        self.from * 2.0_f64.powi(self.octaves as i32)
    }

    /// Returns `u` brought back to the first period, and how many periods that were.
    pub fn reduce(&self, u: f64) -> (f64, u32) {
        if u < self.from {
            return (u, 0);
        }
        let octaves = ((u.to_bits() - self.from.to_bits()) >> 52) as u32;
        let periods = octaves / self.octaves;
        (f64::from_bits(u.to_bits() - (u64::from(periods * self.octaves) << 52)), periods)
    }

    /// Returns the law through `value` at its start.
    pub(crate) fn at(&self, value: f64, u: &Float) -> Float {
        let ratio = Float::with_val(PREC, self.from / u);
        ratio.pow(Float::with_val(PREC, 5) / self.octaves) * value
    }
}

/// The departure of `epsilon` from the law at infinity, relative to `epsilon`.
fn departure(reference: &InterpolatedCurve, u: f64) -> f64 {
    let u = Float::with_val(PREC, u);
    let epsilon = reference.epsilon(&u);
    (reference.power_law(&u) / epsilon - 1u32).to_f64().abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_argument_is_brought_back_by_whole_periods() {
        let law = Law { from: 16.0, octaves: 3, departure: 0.0 };
        assert_eq!(law.reduce(5.0), (5.0, 0));
        assert_eq!(law.reduce(127.0), (127.0, 0));
        assert_eq!(law.reduce(128.0), (16.0, 1));
        assert_eq!(law.reduce(128.0_f64.next_down()), (128.0_f64.next_down(), 0));
        assert_eq!(law.reduce(100.0 * 64.0 * 64.0), (100.0, 4));
        let value = law.at(0.5, &Float::with_val(PREC, 128));
        assert_eq!(value.to_f64(), 0.5 / 32.0);
    }
}
