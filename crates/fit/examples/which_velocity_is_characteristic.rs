//! Which characteristic velocity do these measurements have, and do they follow the law? Reads a file of them, in whatever
//! form it comes, or takes four rows that are written here.
//!
//! ```sh
//! cargo run --package restitution-fit --example which_velocity_is_characteristic measured.csv
//! ```

use restitution::End;
use restitution_fit::{Data, DataOptions, Loss, adequacy, fit};
use std::error::Error;

const FOUR_ROWS: &str = "velocity (cm/s),epsilon\n0.01,0.70\n0.1,0.58\n1,0.40\n10,0.23\n";

fn main() -> Result<(), Box<dyn Error>> {
    let bytes = std::env::args().nth(1).map_or_else(|| Ok(FOUR_ROWS.into()), std::fs::read)?;
    let data = Data::read(bytes, &DataOptions::default())?;
    let found = fit(&data.rows, End::ZeroCompression, Loss::Squares)?;
    let (low, high) = found.interval;
    let unit = &data.unit;
    println!(
        "g* = {:.3} {unit}, with 95 % confidence {low:.3} to {high:.3} {unit}",
        found.characteristic_velocity
    );
    let doubtful = adequacy(&data.rows, &found)?.is_doubtful();
    println!("the measurements {} the law", if doubtful { "do not follow" } else { "are in keeping with" });
    Ok(())
}
