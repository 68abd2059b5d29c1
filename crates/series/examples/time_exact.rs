//! How long do exact trajectories take? usage: time_exact N J
//!
//! Prints the seconds for the coefficients `q_(n,j)`, `n <= N`, `j <= J`, then `n,j,value`.

use restitution_law::ForceLaw;
use restitution_series::Trajectories;
use std::io::Write;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let sizes = std::env::args().skip(1).map(|size| size.parse()).collect::<Result<Vec<usize>, _>>()?;
    let [order, last] = sizes[..] else { return Err("usage: time_exact N J".into()) };
    let _ = rayon::ThreadPoolBuilder::new().use_current_thread().build_global(); // as the command does
    let start = std::time::Instant::now();
    let law = ForceLaw::viscoelastic_spheres();
    let trajectories = Trajectories::exact(&law, order, last + 1);
    println!("{}", start.elapsed().as_secs_f64());
    print(&trajectories)?;
    Ok(())
}

fn print(trajectories: &Trajectories) -> Result<(), Box<dyn std::error::Error>> {
    let mut out = std::io::BufWriter::new(std::io::stdout().lock());
    for n in 0..=trajectories.damping_order() {
        for (j, q) in trajectories.coefficients(n)?.iter().enumerate() {
            writeln!(out, "{n},{j},{}/{}", q.numer(), q.denom())?;
        }
    }
    Ok(out.flush()?)
}
