//! How long do proved coefficients take? usage: time_coefficients K D
//!
//! Prints the seconds for `C_1 .. C_K` to `D` digits, then `k,value,radius`.

use restitution_law::ForceLaw;
use restitution_series::{Quantity, coefficients};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let sizes = std::env::args().skip(1).map(|size| size.parse()).collect::<Result<Vec<usize>, _>>()?;
    let [order, digits] = sizes[..] else { return Err("usage: time_coefficients K D".into()) };
    let _ = rayon::ThreadPoolBuilder::new().use_current_thread().build_global(); // as the command does
    let start = std::time::Instant::now();
    let c = coefficients(Quantity::Restitution, &ForceLaw::viscoelastic_spheres(), order, digits)?;
    println!("{}", start.elapsed().as_secs_f64());
    for (k, value) in c.iter().enumerate().skip(1) {
        let shown = value.to_digits(digits).ok_or("the digits were promised")?;
        let unit = shown.find('e').map_or(0, |e| shown[e + 1..].parse().unwrap_or(0));
        let behind_point =
            shown.split('e').next().and_then(|m| m.split_once('.')).map_or(0, |(_, f)| f.len());
        println!("{k},{shown},1e{}", unit - i64::try_from(behind_point)?); // a unit of the last digit
    }
    Ok(())
}
