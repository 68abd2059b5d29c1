//! Tables of velocities for codes that interpolate.

use super::EpsilonArgs;
use crate::list;
use crate::progress::Progress;
use crate::units;
use crate::{Cell, CliError};
use restitution_direct::{Collision, VelocityScale};

impl EpsilonArgs {
    /// By how much linear interpolation between the rows misses the law, in a sentence.
    ///
    /// # Errors
    ///
    /// Failure for what cannot be integrated between two rows.
    pub(super) fn interpolation(
        &self,
        collision: &Collision,
        scale: &VelocityScale,
    ) -> Result<String, CliError> {
        let velocities = list::flat(&self.velocity).iter().map(|g| g.si().clone()).collect::<Vec<_>>();
        let progress = Progress::steps("between the rows", velocities.len().saturating_sub(1) as u64);
        let error =
            collision.table_error(&velocities, self.digits, |g| scale.damping(g), || progress.advance(1));
        drop(progress);
        Ok(match error {
            Ok(Some(error)) => format!(
                "linear interpolation in the velocity between neighbouring rows is off by at most {} where epsilon bends one way, as it was seen to (docs/codes.md); nothing is said beyond the first and last row",
                Cell::upper_bound(error, 2).plain()
            ),
            Ok(None) => "one velocity: nothing to interpolate".to_owned(),
            Err(error) => format!("no bound of interpolation between the rows: {error}"),
        })
    }
}

/// A velocity as a number in m/s.
pub(super) fn in_si(text: &str) -> Result<String, CliError> {
    let velocity = units::velocity(text).map_err(CliError::usage)?.to_f64();
    Ok(if (1e-4..1e6).contains(&velocity) { velocity.to_string() } else { format!("{velocity:e}") })
}
