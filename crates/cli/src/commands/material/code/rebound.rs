//! The callback of REBOUND.

use super::request::{Dissipation, Request, nothing_dissipates};
use crate::CliError;
use crate::commands::material::end_of;
use crate::progress;
use restitution::{End, characteristic_velocity_from_loss};
use restitution_export::{Beyond, CharacteristicVelocity, InterpolatedCurve, Language, Listing};

/// The largest relative error of the function.
const TOLERANCE: f64 = 1e-9;
/// What REBOUND calls.
const CALLBACK: &str = r#"def coefficient_of_restitution(simulation, velocity):
    """For simulation.coefficient_of_restitution, with lengths in m and times in s.

    REBOUND passes the relative velocity with its sign, negative for bodies that meet; its size is taken here.
    """
    return float(restitution_epsilon_at_m_per_s(velocity))


"#;
const MAIN: &str = "if __name__ == \"__main__\":";

/// A Python module with the function of this material and the callback.
pub(super) fn lines(request: &Request) -> Result<String, CliError> {
    let end = end_of(request.end.unwrap_or_default());
    let (g_star, origin) = characteristic_velocity(request, end)?;
    progress::during("certified values", || {
        let asked =
            restitution_export::Request { tolerance: TOLERANCE, range: (0.0, 8.0), beyond: Beyond::Law };
        let reference = InterpolatedCurve::up_to(end, asked.reach()).map_err(CliError::failure)?;
        let velocity = CharacteristicVelocity::of(g_star, origin)?;
        let listing = Listing::new(&reference, asked)?.with_velocity(velocity);
        let source = Language::of("python")?.write(&listing, "restitution")?;
        Ok(source.replacen(MAIN, &format!("{CALLBACK}{MAIN}"), 1))
    })
}

fn characteristic_velocity(request: &Request, end: End) -> Result<(f64, String), CliError> {
    match &request.dissipation {
        Dissipation::Fitted { g_star, says, .. } => Ok((*g_star, says.clone())),
        Dissipation::Given(args) => {
            if let Some(measured) = args.measured()? {
                let (velocity, lost) = (measured.loss.velocity(), measured.loss.lost());
                let g_star = characteristic_velocity_from_loss(velocity, lost, end);
                return Ok((g_star.map_err(CliError::usage)?, measured.text));
            }
            if let Some(g_star) = args.g_star() {
                return Ok((g_star.to_f64(), format!("given as {g_star}")));
            }
            if !args.is_given()? {
                return Err(nothing_dissipates());
            }
            let pair = args.pair(request.bodies, end)?.ok_or_else(nothing_dissipates)?;
            let g_star = pair.characteristic_velocity().map_err(CliError::usage)?;
            let contact = pair.contact();
            let (radius, mass) = (contact.effective_radius(), contact.effective_mass());
            Ok((g_star, format!("{}, R_eff = {radius:?} m, m_eff = {mass:?} kg", request.bodies.scope())))
        }
    }
}
