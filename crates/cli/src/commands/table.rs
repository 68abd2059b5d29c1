//! `restitution table`: expansion coefficients with proved digits.

use crate::args::{self, EndOfContact, LawArgs};
use crate::progress::Progress;
use crate::{Cell, CliError, OutputArgs, Table, memory};
use rayon::prelude::*;
use restitution_closed::{coefficients, coefficients_memory};
use restitution_law::ForceLaw;
use restitution_series::DelayedRecovery;

/// Arguments of `restitution table`.
#[derive(Debug, clap::Args)]
pub struct TableArgs {
    /// Which coefficients: C of eps = 1 + C_1 u + ..., a of eps = 1 - a_1 s + ..., y of the largest compression;
    /// for the zero-force end h of eps = 1 + h_2 u + ... in powers u^(k/2), psi of Psi(y) as fractions
    /// [default: C,a, or h with --end zero-force]
    #[arg(long, value_enum, value_delimiter = ',', hide_possible_values = true)]
    quantity: Vec<Quantity>,
    /// The largest order
    #[arg(long, value_name = "K", default_value = "8", value_parser = args::order)]
    order: usize,
    /// Significant digits of every coefficient
    #[arg(long, value_name = "D", default_value = "20", value_parser = args::digits)]
    digits: usize,
    /// Where the contact ends
    #[arg(long, value_enum, value_name = "END")]
    end: Option<EndOfContact>,
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
    #[value(name = "h")]
    H,
    #[value(name = "psi")]
    Psi,
}

impl Quantity {
    fn letter(self) -> &'static str {
        match self {
            Self::C => "C",
            Self::A => "a",
            Self::Y => "y",
            Self::H => "h",
            Self::Psi => "psi",
        }
    }

    fn meaning(self, law: &ForceLaw) -> Result<String, CliError> {
        Ok(match self {
            Self::C => "eps(u) = 1 + C_1 u + C_2 u^2 + ...".to_owned(),
            Self::A => "eps = 1 - a_1 s + a_2 s^2 - ..., s = -C_1 u".to_owned(),
            Self::Y => "largest compression = y_0 + y_1 u + y_2 u^2 + ...".to_owned(),
            Self::H => {
                let step = DelayedRecovery::new(law)?.damping_exponent();
                format!("eps(u) = sum_k h_k u^(k/{}), contact ending at zero force", step.denom())
            }
            Self::Psi => {
                let (exponent, p) = (DelayedRecovery::new(law)?.damping_exponent(), law.velocity_exponent());
                format!(
                    "eps at zero force = eps at zero compression times sum_k psi_k y^k, y = (u eps^({p}))^({exponent})"
                )
            }
        })
    }

    /// The end of contact that the coefficients belong to.
    fn end(self) -> EndOfContact {
        match self {
            Self::C | Self::A | Self::Y => EndOfContact::ZeroCompression,
            Self::H | Self::Psi => EndOfContact::ZeroForce,
        }
    }

    /// The first order that is not 1 by definition.
    fn first(self) -> usize {
        usize::from(matches!(self, Self::C | Self::A))
    }

    /// What the libraries call it; `None` for what is exact.
    fn inexact(self) -> Option<restitution_series::Quantity> {
        match self {
            Self::C => Some(restitution_series::Quantity::Restitution),
            Self::A => Some(restitution_series::Quantity::ScaledRestitution),
            Self::Y => Some(restitution_series::Quantity::Compression),
            Self::H => Some(restitution_series::Quantity::DelayedRecovery),
            Self::Psi => None,
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
        let quantities = self.quantities()?;
        memory::require(self.memory_estimate(&quantities)?, "lower --order or --digits")?;
        let columns = ["quantity", "k", "value", "radius"];
        let mut table = Table::new(&columns[usize::from(quantities.len() == 1)..]);
        for &quantity in &quantities {
            for [k, value, radius] in self.rows(quantity)? {
                let row = [quantity.letter().into(), k, value, radius];
                table.push(row[usize::from(quantities.len() == 1)..].to_vec());
            }
        }
        for quantity in quantities {
            table.note(format!("{}: {}", quantity.letter(), quantity.meaning(&self.law.law)?));
        }
        table.note("radius: the true value differs from the one shown by no more than this");
        self.output.print(&table.titled(title(&self.law.law)))
    }

    /// The quantities that were asked for, each once, or those that belong to the end of contact.
    fn quantities(&self) -> Result<Vec<Quantity>, CliError> {
        let mut seen = match (self.quantity.is_empty(), self.end.unwrap_or_default()) {
            (true, EndOfContact::ZeroCompression) => vec![Quantity::C, Quantity::A],
            (true, EndOfContact::ZeroForce) => vec![Quantity::H],
            (false, _) => Vec::new(),
        };
        for &quantity in &self.quantity {
            if self.end.is_some_and(|end| end != quantity.end()) {
                let letter = quantity.letter();
                return Err(CliError::usage(format!(
                    "{letter} belongs to the other end of contact: ask for C, a, y with zero-compression, h, psi with zero-force"
                )));
            }
            if !seen.contains(&quantity) {
                seen.push(quantity);
            }
        }
        Ok(seen)
    }

    /// Bytes at the peak of the hungriest quantity.
    fn memory_estimate(&self, quantities: &[Quantity]) -> Result<f64, CliError> {
        let (law, order, digits) = (&self.law.law, self.order, self.digits);
        let mut most = 0.0_f64;
        for quantity in quantities {
            let bytes = match quantity.inexact() {
                Some(inexact) => coefficients_memory(inexact, law, order, digits)?,
                None => restitution_series::memory_estimate(law, order, digits),
            };
            most = most.max(bytes);
        }
        Ok(most)
    }

    /// Rows of order, value and radius; conversions to decimals share the processors.
    fn rows(&self, quantity: Quantity) -> Result<Vec<[Cell; 3]>, CliError> {
        let law = &self.law.law;
        let Some(inexact) = quantity.inexact() else {
            let psi = DelayedRecovery::new(law)?.psi(self.order);
            let exact = psi.iter().map(|value| [Cell::digits(value), Cell::digits(0)]);
            return Ok(exact.enumerate().map(|(k, [value, radius])| [k.into(), value, radius]).collect());
        };
        let progress = Progress::steps(&format!("{}_k", quantity.letter()), self.order as u64);
        let watch = &mut |k: usize| progress.set(k as u64);
        let values = coefficients(inexact, law, self.order, self.digits, watch)?;
        let shown = values.par_iter().map(|value| value.to_digits_and_radius(self.digits));
        let unproved =
            || CliError::failure(format!("{} digits could not be proved: ask for fewer", self.digits));
        let shown = shown.collect::<Option<Vec<_>>>().ok_or_else(unproved)?;
        let row = |(k, (value, radius))| [usize::into(k), Cell::Digits(value), Cell::Digits(radius)];
        Ok(shown.into_iter().enumerate().skip(quantity.first()).map(row).collect())
    }
}

fn title(law: &ForceLaw) -> String {
    if *law == ForceLaw::viscoelastic_spheres() {
        return "Viscoelastic spheres, x'' + u sqrt(x) x' + x^(3/2) = 0".to_owned();
    }
    format!("Force law x'' + u x^({}) x' + x^({}) = 0", law.gamma(), law.a())
}
