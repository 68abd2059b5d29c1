//! Up to which damping is the [3/8] Padé approximant of epsilon right to one part in a million?

use num_rational::BigRational;
use restitution_approximate::{ApproximateError, Expansion, Request, error_reach, judge};
use restitution_direct::End;
use restitution_law::ForceLaw;
use restitution_pade::PadeType;

fn main() -> Result<(), ApproximateError> {
    let number = |n: i64, d: i64| BigRational::new(n.into(), d.into());
    let spheres = Expansion::new(&ForceLaw::viscoelastic_spheres(), End::ZeroCompression, None)?;
    let level = number(1, 1_000_000);
    let range = (number(0, 1), number(1, 1));
    let request =
        Request { asked: PadeType::new(3, 8), at_infinity: 0, digits: 10, range, level: level.clone() };
    let found = judge(&spheres, &request)?;
    println!("{:?}", error_reach(&spheres, &found.approximant, &level, &number(5, 1))?);
    println!("poles: {}", found.verdict.poles);
    Ok(())
}
