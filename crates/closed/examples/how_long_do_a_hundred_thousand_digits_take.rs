//! How long do the coefficients of spheres to a given number of digits take? `digits [DIGITS]`

use restitution_closed::{Family, low_orders};
use restitution_law::ForceLaw;
use std::time::Instant;

fn main() {
    let digits = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(100_000);
    let start = Instant::now();
    let c = low_orders(Family::Restitution, &ForceLaw::viscoelastic_spheres(), 4, digits).expect("spheres");
    let balls = start.elapsed();
    for (k, c) in c.iter().enumerate().skip(1) {
        let (value, radius) = c.to_digits_and_radius(digits).expect("proved digits");
        println!("C_{k}: {} +- {radius}", &value[..30]);
    }
    println!("{digits} digits: {balls:.2?}, with conversion to decimals {:.2?}", start.elapsed());
}
