//! Arguments that several subcommands share.

use restitution_law::ForceLaw;

/// The largest order of an expansion that is accepted.
pub const LARGEST_ORDER: usize = 100_000;
/// The largest number of digits that is accepted.
pub const LARGEST_DIGITS: usize = 1_000_000;

/// Where the contact ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum EndOfContact {
    /// At zero compression, after a spell of attraction: the paper's definition.
    #[default]
    ZeroCompression,
    /// Where the force vanishes on the way out.
    ZeroForce,
}

impl From<EndOfContact> for restitution::End {
    fn from(end: EndOfContact) -> Self {
        match end {
            EndOfContact::ZeroCompression => Self::ZeroCompression,
            EndOfContact::ZeroForce => Self::ZeroForce,
        }
    }
}

/// The argument `--law`.
#[derive(Clone, Debug, clap::Args)]
pub struct LawArgs {
    /// Exponents of the law x'' + u x^GAMMA x' + x^A = 0, as fractions or decimals [default: 3/2,1/2]
    #[arg(long, value_name = "A,GAMMA", default_value_t = ForceLaw::viscoelastic_spheres(), hide_default_value = true, allow_hyphen_values = true)]
    pub law: ForceLaw,
}

/// The argument `--end`.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub struct EndArgs {
    /// Where the contact ends
    #[arg(long, value_enum, default_value_t, value_name = "END")]
    pub end: EndOfContact,
}

/// Reads an order, 1 to [`LARGEST_ORDER`]; for clap's `value_parser`.
///
/// # Errors
///
/// The line to print.
pub fn order(text: &str) -> Result<usize, String> {
    count(text, "an order", 1, LARGEST_ORDER)
}

/// Reads an order that may be 0; for clap's `value_parser`.
///
/// # Errors
///
/// The line to print.
pub fn order_from_zero(text: &str) -> Result<usize, String> {
    count(text, "an order", 0, LARGEST_ORDER)
}

/// Reads a number of digits, 1 to [`LARGEST_DIGITS`]; for clap's `value_parser`.
///
/// # Errors
///
/// The line to print.
pub fn digits(text: &str) -> Result<usize, String> {
    count(text, "a number of digits", 1, LARGEST_DIGITS)
}

/// Reads a whole number between `least` and `largest`.
///
/// # Errors
///
/// The line to print, with `what` as the name of the number.
pub fn count(text: &str, what: &str, least: usize, largest: usize) -> Result<usize, String> {
    let value = text.trim().parse::<usize>().ok().filter(|n| (least..=largest).contains(n));
    value.ok_or_else(|| format!("{what} is a whole number: give one from {least} to {largest}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_and_digits_have_limits() {
        assert_eq!(order("40"), Ok(40));
        assert_eq!(order("0"), Err("an order is a whole number: give one from 1 to 100000".into()));
        assert_eq!(order_from_zero("0"), Ok(0));
        for text in ["", "-1", "1.5", "1e3", "x", "1000000000", "99999999999999999999999"] {
            assert!(order(text).is_err() && digits(text).is_err() || text == "1000000000", "{text}");
        }
    }
}
