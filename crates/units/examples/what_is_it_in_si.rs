//! What are these velocities in m/s, exactly?

use restitution_units::{Dimension, Quantity, UnitError};

fn main() -> Result<(), UnitError> {
    for text in ["0.32cm/s", "18 km/h", "3 ft/s", "1e-3 m s-1"] {
        println!("{text} = {} m/s", Quantity::parse(text, Dimension::Velocity)?.si());
    }
    if let Err(refused) = Quantity::parse("5 mm", Dimension::Velocity) {
        println!("{refused}");
    }
    Ok(())
}
