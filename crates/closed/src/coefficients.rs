//! The coefficients of a law, by the cheaper of two ways.

use crate::{ClosedError, Family, low_orders, memory_estimate};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{Quantity, coefficients_watched};

/// Returns the coefficients `0 ..= order`, each enclosed so narrowly that `digits` decimals are proved.
///
/// Where closed forms in Beta values reach the order ([`Family::largest_index`]) they give all of them ([`low_orders`]), at any number of
/// digits in less time; beyond, the engine does ([`coefficients_watched`]), and tells `watch` each order in the damping as it is done. Error bound:
/// the balls.
///
/// # Errors
///
/// [`ClosedError::Series`] for what the engine says and for a law without the end of contact, [`ClosedError::Precision`] if the digits cannot be
/// proved.
///
/// # Examples
///
/// ```
/// use restitution_closed::{ClosedError, coefficients};
/// use restitution_law::ForceLaw;
/// use restitution_series::Quantity;
///
/// let spheres = ForceLaw::viscoelastic_spheres();
/// let c = coefficients(Quantity::Restitution, &spheres, 4, 20, &mut |_| ())?; // closed forms
/// assert_eq!(c[3].to_digits(20).as_deref(), Some("-0.52288256808841496390"));
/// let c = coefficients(Quantity::Restitution, &spheres, 5, 20, &mut |_| ())?; // the engine
/// assert_eq!(c[3].to_digits(20).as_deref(), Some("-0.52288256808841496390"));
///
/// let no_end = coefficients(Quantity::DelayedRecovery, &"1,2".parse().unwrap(), 2, 20, &mut |_| ());
/// assert!(matches!(no_end, Err(ClosedError::Series(_))));
/// # Ok::<(), ClosedError>(())
/// ```
pub fn coefficients(
    quantity: Quantity,
    law: &ForceLaw,
    order: usize,
    digits: usize,
    watch: &mut dyn FnMut(usize),
) -> Result<Vec<Ball>, ClosedError> {
    match family(quantity, law, order)? {
        Some(family) => low_orders(family, law, order, digits),
        None => Ok(coefficients_watched(quantity, law, order, digits, watch)?),
    }
}

/// Returns about how many bytes [`coefficients`] needs at its peak, decimals included.
///
/// # Errors
///
/// [`ClosedError::Series`] for a law without the end of contact.
///
/// # Examples
///
/// ```
/// use restitution_closed::{ClosedError, coefficients_memory};
/// use restitution_law::ForceLaw;
/// use restitution_series::Quantity;
///
/// let spheres = ForceLaw::viscoelastic_spheres();
/// let bytes = |order| coefficients_memory(Quantity::Restitution, &spheres, order, 1_000_000);
/// assert!(bytes(4)? < 1e9 && bytes(5)? > 1e10);
/// assert!(coefficients_memory(Quantity::DelayedRecovery, &"1,2".parse().unwrap(), 2, 20).is_err());
/// # Ok::<(), ClosedError>(())
/// ```
pub fn coefficients_memory(
    quantity: Quantity,
    law: &ForceLaw,
    order: usize,
    digits: usize,
) -> Result<f64, ClosedError> {
    Ok(match family(quantity, law, order)? {
        Some(_) => memory_estimate(digits),
        None => restitution_series::memory_estimate(law, order, digits),
    })
}

/// The family of closed forms of a quantity if they reach the order.
fn family(quantity: Quantity, law: &ForceLaw, order: usize) -> Result<Option<Family>, ClosedError> {
    let family = match quantity {
        Quantity::Restitution => Family::Restitution,
        Quantity::ScaledRestitution => Family::Scaled,
        Quantity::DelayedRecovery => Family::DelayedRecovery,
        Quantity::Compression => return Ok(None),
    };
    Ok((order <= family.largest_index(law)?).then_some(family))
}
