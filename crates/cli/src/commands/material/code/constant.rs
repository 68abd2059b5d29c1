//! The lines of codes that make the coefficient the same at every velocity.

use super::request::{Dissipation, Request};
use crate::CliError;
use restitution::codes::{ConstantBodies, ConstantCode, ConstantRestitution, Elastic};
use restitution::{Contact, End};

/// The law that rebounds as measured.
pub(super) fn law(request: &Request, end: End) -> Result<ConstantRestitution, CliError> {
    let Dissipation::Given(args) = &request.dissipation else {
        return Err(not_measured());
    };
    let measured = args.measured()?.ok_or_else(not_measured)?;
    ConstantRestitution::that_gives(measured.loss.epsilon(), end).map_err(CliError::usage)
}

fn not_measured() -> CliError {
    CliError::usage(
        "a constant coefficient is one that was measured: give --measured, --heights, --speeds or --bounce-times",
    )
}

/// The lines for one code.
pub(super) fn lines(
    code: ConstantCode,
    request: &Request,
    law: &ConstantRestitution,
    contact: &Contact,
    end: End,
) -> Result<String, CliError> {
    let materials = if code.names_materials() { Some(materials(request, contact, code)?) } else { None };
    let bodies = ConstantBodies { contact: *contact, materials, is_plane: request.bodies.is_plane() };
    code.lines(law, end, &bodies).map_err(CliError::usage)
}

/// The materials of both bodies; those of two equal bodies that make the contact, if the bodies are not given one by one.
fn materials(
    request: &Request,
    contact: &Contact,
    code: ConstantCode,
) -> Result<(Elastic, Option<Elastic>), CliError> {
    let elastic =
        |material: restitution::Material| Elastic { young: material.young(), poisson: material.poisson() };
    if let Some((one, other)) = request.bodies.two_materials()? {
        return Ok((elastic(one), other.map(elastic)));
    }
    let poisson = request
        .bodies
        .poisson()
        .ok_or_else(|| CliError::usage(format!("{} wants Poisson's ratio: give --poisson", code.name())))?;
    Ok((Elastic::of_equal_bodies(contact, poisson).map_err(CliError::usage)?, None))
}
