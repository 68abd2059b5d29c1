//! Does the coefficient of restitution depend on the velocity? Asks it of the laws given as arguments.
//!
//! ```sh
//! cargo run --package restitution-law --example does_epsilon_depend_on_velocity 3/2,1/2 1,0 3/2,1/4
//! ```

use restitution_law::{ForceLaw, LawError};

fn main() -> Result<(), LawError> {
    let given = std::env::args().skip(1).collect::<Vec<_>>();
    let laws = if given.is_empty() { vec!["3/2,1/2".to_owned(), "1,0".to_owned()] } else { given };
    for law in laws {
        let law: ForceLaw = law.parse()?;
        let p = law.velocity_exponent();
        let kind = if law.is_viscoelastic() { "viscoelastic bodies" } else { "no viscoelastic bodies" };
        println!("{law}: the damping grows as g^({p}); {kind}");
    }
    Ok(())
}
