use crate::error::DirectError;
use rug::Float;

/// Attempts that one collision may take at `FULL_PRECISION` and more bits before it is given up.
const ATTEMPTS: u32 = 20_000;
/// Bits below which more attempts are allowed, in inverse proportion: along a slow manifold steps are as many times shorter,
/// and cheaper, so that the same motions are followed to their ends at any digits.
const FULL_PRECISION: u32 = 256;
/// Halvings of one step before it is given up.
const HALVINGS: u32 = 200;

/// Chooses the lengths of the steps: a proof that fails is tried again with a shorter one.
///
/// The choice has no part in any proof. A Taylor coefficient scales like `length^k`, so a step that
/// lost `slope` bits a degree where `wanted` are enough could have been `2^(slope - wanted)` times as
/// long.
pub(crate) struct Stepper {
    length: f64,
    /// Bits a coefficient should lose from one degree to the next.
    wanted: f64,
    attempts: u32,
    allowed: u32,
}

impl Stepper {
    /// For Taylor polynomials of degree `order` at `prec` bits.
    pub(crate) fn new(prec: u32, order: usize) -> Self {
        let wanted = f64::from(prec + 4) / order as f64;
        let allowed = ATTEMPTS * FULL_PRECISION / prec.clamp(1, FULL_PRECISION);
        Self { length: 0.0, wanted, attempts: 0, allowed }
    }

    /// Sets the length to try first on a new stretch.
    pub(crate) fn start_with(&mut self, length: f64) {
        self.length = length;
    }

    /// The error of a motion that cannot be followed any further.
    pub(crate) fn vanished(&self) -> DirectError {
        DirectError::StepVanished { length: format!("{:.1e}", self.length) }
    }

    /// Takes one step: `attempt` gets a length, not above `limit`, and returns what was reached with the slope seen.
    pub(crate) fn step<T>(
        &mut self,
        limit: f64,
        mut attempt: impl FnMut(f64) -> Option<(T, f64)>,
    ) -> Result<T, DirectError> {
        for _ in 0..HALVINGS {
            self.attempts += 1;
            if self.attempts > self.allowed {
                return Err(DirectError::Stiff { steps: self.allowed });
            }
            let length = self.length.min(limit);
            if !length.is_normal() {
                break;
            }
            if let Some((reached, slope)) = attempt(length) {
                let factor = (0.7 * (slope - self.wanted).exp2()).clamp(0.3, 3.0);
                self.length = length * factor;
                return Ok(reached);
            }
            self.length = length * 0.6;
        }
        Err(self.vanished())
    }
}

/// Rounds `x` to a multiple of `2^-40` of the power of two next to `length`.
pub(crate) fn rounded_to_step(x: &Float, length: f64) -> Float {
    let exponent = Float::with_val(53, length).get_exp().unwrap_or(0) - 40;
    let mut scaled = Float::with_val(x.prec(), x);
    scaled >>= exponent;
    scaled.round_mut();
    scaled <<= exponent;
    scaled
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_motion_is_given_up_after_so_many_attempts() {
        for (prec, attempts) in [(1000, 20_000), (256, 20_000), (128, 40_000), (64, 80_000)] {
            let mut stepper = Stepper::new(prec, prec as usize + 4);
            stepper.start_with(1.0);
            let mut failed = false;
            // Every other attempt fails, and shortens the step that the next one lengthens again.
            let mut attempt = |_: f64| {
                failed = !failed;
                (!failed).then_some(((), 2.25))
            };
            for _ in 0..attempts / 2 {
                stepper.step(f64::INFINITY, &mut attempt).unwrap();
            }
            let last = stepper.step(f64::INFINITY, &mut attempt);
            assert_eq!(last, Err(DirectError::Stiff { steps: attempts }));
        }
    }

    #[test]
    fn a_step_that_always_fails_vanishes() {
        let (mut stepper, mut lengths) = (Stepper::new(64, 68), Vec::new());
        stepper.start_with(4.0);
        let none = stepper.step(2.0, |length| {
            lengths.push(length);
            None::<((), f64)>
        });
        assert!(matches!(none, Err(DirectError::StepVanished { .. })));
        assert_eq!((lengths.len(), lengths[0]), (HALVINGS as usize, 2.0));
        assert!(lengths.windows(2).all(|two| (two[1] / two[0] - 0.6).abs() < 1e-12));
    }
}
