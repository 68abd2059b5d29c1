//! What is epsilon to forty digits, for spheres and for a linear spring and dashpot, at both ends of contact?

use num_rational::BigRational;
use restitution_direct::{Collision, DirectError, End};
use restitution_law::ForceLaw;

fn main() -> Result<(), DirectError> {
    let u = BigRational::new(1.into(), 2.into());
    for law in ["3/2,1/2", "1,0"] {
        let law: ForceLaw = law.parse().expect("a law that is written here");
        for end in [End::ZeroCompression, End::ZeroForce] {
            let epsilon = Collision::new(&law, end)?.epsilon(&u, 40)?;
            println!("{law} at u = {u}, {end:?}: {}", epsilon.to_digits(40).unwrap_or_default());
        }
    }
    Ok(())
}
