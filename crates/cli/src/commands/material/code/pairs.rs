//! Which pairs of bodies there are, each with its own contact.

use super::request::Request;
use crate::CliError;
use restitution::ViscoelasticContact;

/// A pair of types, counted from 1, and its contact.
pub(super) struct Pair {
    pub(super) types: [usize; 2],
    pub(super) contact: ViscoelasticContact,
}

/// The pairs of two unlike spheres: 1 1, 1 2 and 2 2, or 1 2 alone if what was measured there says nothing about the
/// others; `None` if all spheres are alike or the second body is a plane.
pub(super) fn of(request: &Request, met: &ViscoelasticContact) -> Result<Option<Vec<Pair>>, CliError> {
    let Some([one, other]) = request.bodies.unlike_contacts(met.contact())? else { return Ok(None) };
    let constants = match request.bodies.has_two_materials() {
        false => Some((met.dissipative_constant(), met.dissipative_constant())),
        true => request.dissipation.constants(),
    };
    let mut pairs = vec![Pair { types: [1, 2], contact: *met }];
    if let Some((a_1, a_2)) = constants {
        let contact = |contact, a| ViscoelasticContact::new(contact, a).map_err(CliError::usage);
        pairs.insert(0, Pair { types: [1, 1], contact: contact(one, a_1)? });
        pairs.push(Pair { types: [2, 2], contact: contact(other, a_2)? });
    }
    Ok(Some(pairs))
}
