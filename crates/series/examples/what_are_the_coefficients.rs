//! What are the coefficients of `eps = 1 + C_1 u + C_2 u^2 + ...` for a law? usage: `what_are_the_coefficients [LAW]`, spheres by default.
//!
//! ```sh
//! cargo run --package restitution-series --example what_are_the_coefficients 2,1
//! ```

use restitution_law::ForceLaw;
use restitution_series::{Quantity, Trajectories, coefficients};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let law: ForceLaw = std::env::args().nth(1).unwrap_or_else(|| "3/2,1/2".to_owned()).parse()?;
    println!("x_0(t) = {}", Trajectories::exact(&law, 0, 4).order_n(0)?);
    for (k, c) in coefficients(Quantity::Restitution, &law, 6, 25)?.iter().enumerate() {
        println!("C_{k} = {}", c.to_digits(25).ok_or("the digits were promised")?);
    }
    Ok(())
}
