//! What is the [2/2] Padé approximant of the exponential function, and how far does it agree?

use num_rational::BigRational;
use restitution_pade::{PadeError, PadeType, approximant};
use restitution_real::Rationals;

fn main() -> Result<(), PadeError> {
    let factorials = (0..8).scan(1_i64, |factorial, k: i64| {
        *factorial *= k.max(1);
        Some(*factorial)
    });
    let exp = factorials.map(|f| BigRational::new(1.into(), f.into())).collect::<Vec<_>>();
    let found = approximant(&Rationals, &exp, PadeType::new(2, 2))?;
    let shown = |part: &[BigRational]| part.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    println!("numerator    {}", shown(found.num()));
    println!("denominator  {}", shown(found.den()));
    println!("first power of x in exp(x) - P/Q: {}", found.contact().order());
    Ok(())
}
