//! `restitution trajectory`: the exact power series of the trajectory.

use crate::args::{self, LawArgs};
use crate::exact::{Exact, NumberError};
use crate::output::Format;
use crate::progress::Progress;
use crate::{Cell, CliError, OutputArgs, Table, memory};
use restitution_series::{TimeOrder, Trajectories};

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
        let within = TimeOrder::new(&self.law.law, self.time_order.value());
        let orders = self.damping_order;
        let dense = if self.output.format == Format::Text { within.series_memory_estimate() } else { 0.0 };
        let bytes = [within.memory_estimate(orders), dense].iter().sum();
        memory::require(bytes, "lower --damping-order or --time-order")?;
        let progress = Progress::steps("primes", 1000);
        let trajectories = within.trajectories(orders, &|share| {
            progress.set((share.numer() * 1000 / share.denom()) as u64);
        });
        drop(progress);
        match self.output.format {
            Format::Text => self.output.target.write(&self.series(&within, &trajectories)?),
            _ => self.output.print(&table(&within, &trajectories)?),
        }
    }

    /// One line for each order, with the first power that is not given.
    fn series(&self, within: &TimeOrder, trajectories: &Trajectories) -> Result<String, CliError> {
        let mut out = String::new();
        for n in 0..=self.damping_order {
            if n > trajectories.damping_order() {
                let first = trajectories.exponent(n, 0);
                let first = if first.is_integer() { first.to_string() } else { format!("({first})") };
                out += &format!("x_{n}(t) = O(t^{first})\n");
            } else {
                out += &format!("x_{n}(t) = {}\n", within.series(trajectories, n)?);
            }
        }
        Ok(out)
    }
}

fn table(within: &TimeOrder, trajectories: &Trajectories) -> Result<Table, CliError> {
    let mut table = Table::new(&["n", "exponent", "coefficient"]);
    for n in 0..=trajectories.damping_order() {
        for (j, fraction) in within.fractions(trajectories, n)?.into_iter().enumerate() {
            let exponent = Cell::digits(trajectories.exponent(n, j));
            table.push(vec![n.into(), exponent, Cell::digits(fraction)]);
        }
    }
    Ok(table)
}

fn time_order(text: &str) -> Result<Exact, String> {
    let order: Exact = text.parse().map_err(|error: NumberError| error.to_string())?;
    if order > 0 && order <= LARGEST_TIME_ORDER {
        return Ok(order);
    }
    Err(format!("a power of time is a number above 0: give one up to {LARGEST_TIME_ORDER}"))
}
