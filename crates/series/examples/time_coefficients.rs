//! How long does it take to find C_1 .. C_K to D digits? Usage: time_coefficients K D

use restitution_law::ForceLaw;
use restitution_series::{Quantity, coefficients};
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut next = |default| arguments.next().map_or(Ok(default), |text| text.parse::<usize>());
    let (order, digits) = (next(40)?, next(100)?);
    let start = Instant::now();
    let c = coefficients(Quantity::Restitution, &ForceLaw::viscoelastic_spheres(), order, digits)?;
    let seconds = start.elapsed().as_secs_f64();
    println!("{seconds:.4} s K={order} D={digits}");
    println!("{}", c[order].to_digits(digits).unwrap_or_default());
    Ok(())
}
