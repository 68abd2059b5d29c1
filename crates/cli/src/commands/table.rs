//! `restitution table`: expansion coefficients with proved digits.

use crate::args::{self, LawArgs};
use crate::progress::Progress;
use crate::{Cell, CliError, OutputArgs, Table, memory};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::coefficients_watched;
use rug::Float;
use rug::float::Round;

/// Arguments of `restitution table`.
#[derive(Debug, clap::Args)]
pub struct TableArgs {
    /// Which coefficients: C of eps = 1 + C_1 u + ..., a of eps = 1 - a_1 s + ..., y of the largest compression [default: C,a]
    #[arg(long, value_enum, value_delimiter = ',', default_values = ["C", "a"], hide_default_value = true, hide_possible_values = true)]
    quantity: Vec<Quantity>,
    /// The largest order
    #[arg(long, value_name = "K", default_value = "8", value_parser = args::order)]
    order: usize,
    /// Significant digits of every coefficient
    #[arg(long, value_name = "D", default_value = "20", value_parser = args::digits)]
    digits: usize,
    #[command(flatten)]
    law: LawArgs,
    #[command(flatten)]
    output: OutputArgs,
}

/// A family of expansion coefficients, by the paper's letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Quantity {
    #[value(name = "C")]
    C,
    #[value(name = "a")]
    A,
    #[value(name = "y")]
    Y,
}

impl Quantity {
    fn letter(self) -> &'static str {
        match self {
            Self::C => "C",
            Self::A => "a",
            Self::Y => "y",
        }
    }

    fn meaning(self) -> &'static str {
        match self {
            Self::C => "eps(u) = 1 + C_1 u + C_2 u^2 + ...",
            Self::A => "eps = 1 - a_1 s + a_2 s^2 - ..., s = -C_1 u",
            Self::Y => "largest compression = y_0 + y_1 u + y_2 u^2 + ...",
        }
    }

    /// The first order that is not 1 by definition.
    fn first(self) -> usize {
        usize::from(self != Self::Y)
    }

    fn in_series(self) -> restitution_series::Quantity {
        match self {
            Self::C => restitution_series::Quantity::Restitution,
            Self::A => restitution_series::Quantity::ScaledRestitution,
            Self::Y => restitution_series::Quantity::Compression,
        }
    }
}

impl TableArgs {
    /// Computes and prints the coefficients.
    ///
    /// # Errors
    ///
    /// Usage if they need more memory than there is; what the expansion and the output say.
    pub fn run(&self) -> Result<(), CliError> {
        self.output.check()?;
        memory::require(memory_estimate(self.order, self.digits), "lower --order or --digits")?;
        let quantities = self.quantities();
        let columns = ["quantity", "k", "value", "radius"];
        let mut table = Table::new(&columns[usize::from(quantities.len() == 1)..]);
        for &quantity in &quantities {
            for (k, value) in self.values(quantity)?.iter().enumerate().skip(quantity.first()) {
                let (shown, radius) = certified(value, self.digits)?;
                let row = [quantity.letter().into(), k.into(), Cell::Digits(shown), Cell::Digits(radius)];
                table.push(row[usize::from(quantities.len() == 1)..].to_vec());
            }
        }
        for quantity in quantities {
            table.note(format!("{}: {}", quantity.letter(), quantity.meaning()));
        }
        table.note("radius: the true value differs from the one shown by no more than this");
        self.output.print(&table.titled(title(&self.law.law)))
    }

    /// The quantities that were asked for, each once.
    fn quantities(&self) -> Vec<Quantity> {
        let mut seen = Vec::new();
        for &quantity in &self.quantity {
            if !seen.contains(&quantity) {
                seen.push(quantity);
            }
        }
        seen
    }

    fn values(&self, quantity: Quantity) -> Result<Vec<Ball>, CliError> {
        let progress = Progress::steps(&format!("{}_k", quantity.letter()), self.order as u64);
        let watch = &mut |k: usize| progress.set(k as u64);
        Ok(coefficients_watched(quantity.in_series(), &self.law.law, self.order, self.digits, watch)?)
    }
}

fn title(law: &ForceLaw) -> String {
    if *law == ForceLaw::viscoelastic_spheres() {
        return "Viscoelastic spheres, x'' + u sqrt(x) x' + x^(3/2) = 0".to_owned();
    }
    format!("Force law x'' + u x^({}) x' + x^({}) = 0", law.gamma(), law.a())
}

/// Returns the value with its digits, and how far the true value is from what is shown, at most.
fn certified(value: &Ball, digits: usize) -> Result<(String, String), CliError> {
    let unproved = || CliError::failure(format!("{digits} digits could not be proved: ask for fewer"));
    let shown = value.to_digits(digits).ok_or_else(unproved)?;
    let text = Float::parse(&shown).map_err(CliError::failure)?;
    let (number, ordering) = Float::with_val_round(value.prec() + 64, text, Round::Nearest);
    let ulp = Float::with_val(64, number.clone().abs() >> (value.prec() + 63));
    let rounding = if ordering.is_eq() { Float::new(64) } else { ulp };
    let difference = Ball::new(number, &rounding) - value;
    let radius = Ball::new(Float::new(64), &difference.abs_up()).radius_text();
    Ok((shown, radius))
}

/// Bytes at the peak: each trajectory, its powers and sums in balls of the working precision, and the
/// large integers of a product under way. Never below what was measured, and at most twice that, for
/// (order, digits) = (4, 1000), (1, 3000), (40, 300), (100, 30): 48, 297, 40, 41 MB.
fn memory_estimate(order: usize, digits: usize) -> f64 {
    let bits = 3.33 * digits as f64 + 5.0 * order as f64 + 50.0;
    let terms = bits / 2.45 + order as f64 + 10.0;
    (5.0 * order as f64 + 70.0) * terms * (bits / 8.0 + 128.0)
}
