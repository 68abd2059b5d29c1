//! `restitution trajectory`: the exact power series of the trajectory.

use crate::args::{self, LawArgs};
use crate::exact::{Exact, NumberError};
use crate::output::Format;
use crate::progress::Progress;
use crate::{Cell, CliError, OutputArgs, Table, memory};
use num_rational::{BigRational, Ratio};
use num_traits::{One, Signed, ToPrimitive};
use rayon::prelude::*;
use restitution_real::convert::fraction;
use restitution_series::Trajectories;

/// The largest power of time that is accepted.
const LARGEST_TIME_ORDER: i64 = 1_000_000;

/// Arguments of `restitution trajectory`.
#[derive(Debug, clap::Args)]
pub struct TrajectoryArgs {
    /// The largest order N in the damping
    #[arg(long, value_name = "N", default_value = "3", value_parser = args::order_from_zero)]
    damping_order: usize,
    /// The largest power P of time, a number or a fraction
    #[arg(long, value_name = "P", default_value = "11", value_parser = time_order)]
    time_order: Exact,
    #[command(flatten)]
    law: LawArgs,
    #[command(flatten)]
    output: OutputArgs,
}

impl TrajectoryArgs {
    /// Computes and prints `x_0 .. x_N` to the power `P` of time.
    ///
    /// # Errors
    ///
    /// Usage if they need more memory than there is; what the series and the output say.
    pub fn run(&self) -> Result<(), CliError> {
        self.output.check()?;
        let terms = self.terms();
        memory::require(self.memory_estimate(terms), "lower --damping-order or --time-order")?;
        let progress = Progress::steps("primes", 1000);
        let watch = |share: Ratio<usize>| progress.set((share.numer() * 1000 / share.denom()) as u64);
        let trajectories = Trajectories::exact_watched(&self.law.law, self.orders(), terms, &watch);
        drop(progress);
        match self.output.format {
            Format::Text => self.output.target.write(&self.series(&trajectories)?),
            _ => self.output.print(&self.table(&trajectories)?),
        }
    }

    /// How many coefficients of `x_0` belong to powers of time up to `P`; the others have fewer.
    fn terms(&self) -> usize {
        let last = (self.time_order.value() - BigRational::one()) / self.law.law.elastic_step();
        last.floor().to_integer().to_usize().map_or(1, |last| last + 1)
    }

    /// The largest order with a power of time up to `P`, `1 + (gamma+1) n <= P`; those above only print `O(...)`.
    fn orders(&self) -> usize {
        let last = (self.time_order.value() - BigRational::one()) / self.law.law.damping_step();
        last.floor().to_integer().to_usize().unwrap_or(0).min(self.damping_order)
    }

    /// How many coefficients of `x_n` belong to powers of time up to `P`.
    fn within(&self, trajectories: &Trajectories, n: usize) -> usize {
        let beyond = |j: &usize| big(trajectories.exponent(n, *j)) > *self.time_order.value();
        (0..trajectories.terms()).find(beyond).unwrap_or(trajectories.terms())
    }

    fn table(&self, trajectories: &Trajectories) -> Result<Table, CliError> {
        let mut table = Table::new(&["n", "exponent", "coefficient"]);
        for n in 0..=trajectories.damping_order() {
            let coefficients = &trajectories.coefficients(n)?[..self.within(trajectories, n)];
            let fractions: Vec<String> = coefficients.par_iter().map(fraction).collect();
            for (j, fraction) in fractions.into_iter().enumerate() {
                let exponent = Cell::digits(trajectories.exponent(n, j));
                table.push(vec![n.into(), exponent, Cell::digits(fraction)]);
            }
        }
        Ok(table)
    }

    /// One line for each order, with the first power that is not given.
    fn series(&self, trajectories: &Trajectories) -> Result<String, CliError> {
        let mut out = String::new();
        for n in 0..=self.damping_order {
            if n > trajectories.damping_order() {
                let first = trajectories.exponent(n, 0);
                let first = if first.is_integer() { first.to_string() } else { format!("({first})") };
                out += &format!("x_{n}(t) = O(t^{first})\n");
                continue;
            }
            let series = trajectories.order_n(n)?;
            let end = trajectories.exponent(n, self.within(trajectories, n)) * series.unit();
            let series = series.truncated(end.to_usize().unwrap_or(usize::MAX));
            out += &format!("x_{n}(t) = {series}\n");
        }
        Ok(out)
    }

    /// Bytes at the peak: numerator and denominator of coefficient `j` have about `20 j` bits each, and
    /// are held as residues, as integers and as text. Two to four times what was measured for
    /// (N, P) = (3, 2000), (0, 5000): 45, 68 MB.
    fn memory_estimate(&self, terms: usize) -> f64 {
        let (orders, terms) = (self.orders() as f64 + 2.0, terms as f64);
        let dense = terms * self.law.law.lattice().elastic as f64 * 64.0;
        orders * terms * (30.0 * terms + 300.0) + if self.output.format == Format::Text { dense } else { 0.0 }
    }
}

fn big(exponent: Ratio<i64>) -> BigRational {
    BigRational::new((*exponent.numer()).into(), (*exponent.denom()).into())
}

fn time_order(text: &str) -> Result<Exact, String> {
    let order: Exact = text.parse().map_err(|error: NumberError| error.to_string())?;
    let value = order.value();
    if value.is_positive() && *value <= BigRational::from_integer(LARGEST_TIME_ORDER.into()) {
        return Ok(order);
    }
    Err(format!("a power of time is a number above 0: give one up to {LARGEST_TIME_ORDER}"))
}
