//! Tables of velocities for codes that interpolate.

use super::EpsilonArgs;
use crate::CliError;
use crate::list;
use crate::progress::Progress;
use crate::units;
use rayon::prelude::*;
use restitution_direct::{Collision, DirectError};

impl EpsilonArgs {
    /// By how much linear interpolation between the rows misses the law, in a sentence.
    ///
    /// # Errors
    ///
    /// Failure for what cannot be integrated between two rows.
    pub(super) fn interpolation(&self, collision: &Collision) -> Result<String, CliError> {
        let law = &self.law.law;
        let mut velocities = list::flat(&self.velocity).iter().map(|g| g.si().clone()).collect::<Vec<_>>();
        velocities.sort();
        velocities.dedup();
        if velocities.len() < 2 {
            return Ok("one velocity: nothing to interpolate".to_owned());
        }
        let progress = Progress::steps("between the rows", velocities.len() as u64 - 1);
        let damping = |g: &_| self.damping.at(g, law).map_err(|_| DirectError::NegativeVelocity);
        let between = |pair: &[_]| {
            progress.advance(1);
            collision.interpolation_error(&pair[0], &pair[1], damping)
        };
        let errors = velocities.par_windows(2).map(between).collect::<Result<Vec<_>, _>>();
        drop(progress);
        Ok(match errors {
            Ok(errors) => {
                // what is printed is off by a unit of its last digit at most, and the velocity by a rounding
                let printed = 0.1_f64.powi(i32::try_from(self.digits).unwrap_or(i32::MAX)) + f64::EPSILON;
                let largest = errors.into_iter().fold(0.0, f64::max) + printed;
                format!(
                    "linear interpolation in the velocity between neighbouring rows is off by at most {} where epsilon bends one way, as it was seen to (docs/codes.md); nothing is said beyond the first and last row",
                    rounded_up(largest)
                )
            }
            Err(error) => format!("no bound of interpolation between the rows: {error}"),
        })
    }
}

/// Two digits that are not less.
fn rounded_up(x: f64) -> String {
    let nearest = format!("{x:.1e}");
    if nearest.parse::<f64>().is_ok_and(|shown| shown >= x) { nearest } else { format!("{:.1e}", 1.05 * x) }
}

/// A velocity as a number in m/s.
pub(super) fn in_si(text: &str) -> Result<String, CliError> {
    let velocity = units::velocity(text).map_err(CliError::usage)?.to_f64();
    Ok(if (1e-4..1e6).contains(&velocity) { velocity.to_string() } else { format!("{velocity:e}") })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shown_bounds_are_no_smaller() {
        for (x, shown) in [(1.01e-4, "1.1e-4"), (1.0e-4, "1.0e-4"), (9.99e-3, "1.0e-2"), (1.149e-7, "1.2e-7")]
        {
            let text = rounded_up(x);
            assert!(text.parse::<f64>().unwrap() >= x, "{text}");
            assert_eq!(text, shown);
        }
    }
}
