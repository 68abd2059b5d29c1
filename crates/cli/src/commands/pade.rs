//! `restitution pade`: approximants of any type, their constants and what they are good for.

mod judgement;
mod literature;
mod map;
mod recommended;
mod series;

use crate::args::{EndArgs, LawArgs, count};
use crate::exact::Exact;
use crate::progress::Progress;
use crate::{Cell, CliError, OutputArgs, Table, args};
use judgement::report;
use restitution_approximate::{Expansion, Judged, Request, Variable, constants, judge, links};
use restitution_direct::End;
use restitution_pade::PadeType;
use std::path::PathBuf;

/// The largest degree that is accepted.
const LARGEST_DEGREE: usize = 300;
/// The largest side of a map.
const LARGEST_SIDE: usize = 40;

/// Arguments of `restitution pade`.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  restitution pade 3 8\n  restitution pade 3 6 --end zero-force --digits 40\n  \
    restitution pade 20 25 --at-infinity=17 --range 0,7.5\n  restitution pade --table 8\n  \
    restitution pade --list recommended --format markdown\n  \
    restitution pade 2 2 --series coefficients.txt"
)]
pub struct PadeArgs {
    /// Degree of the numerator
    #[arg(value_name = "L", value_parser = degree)]
    numerator: Option<usize>,
    /// Degree of the denominator
    #[arg(value_name = "M", value_parser = degree)]
    denominator: Option<usize>,
    /// Take the coefficients from a file, constant term first, exact: decimals or fractions; - is stdin
    #[arg(long, value_name = "FILE", requires = "numerator", conflicts_with_all = ["variable", "at_infinity", "law", "end", "table", "list"])]
    series: Option<PathBuf>,
    /// Map the table of all approximants up to [N/N], with verdicts
    #[arg(long, value_name = "N", value_parser = side, conflicts_with_all = ["numerator", "list", "at_infinity"])]
    table: Option<usize>,
    /// Print a list instead
    #[arg(long, value_enum, value_name = "LIST", conflicts_with_all = ["numerator", "at_infinity"])]
    list: Option<List>,
    /// The variable [default: u, or sqrt-u with the end of contact at zero force]
    #[arg(long, value_enum, value_name = "VARIABLE")]
    variable: Option<Variable>,
    /// Meet the law at infinity too, with K conditions instead of the last K coefficients
    #[arg(long, value_name = "K", num_args = 0..=1, require_equals = true, default_missing_value = "1", value_parser = conditions)]
    at_infinity: Option<usize>,
    /// How the constants are arranged
    #[arg(long, value_enum, default_value_t, hide_default_value = true, value_name = "FORM", conflicts_with_all = ["table", "list"])]
    form: Form,
    /// Proved digits of the constants
    #[arg(long, value_name = "D", default_value_t = 17, value_parser = args::digits)]
    digits: usize,
    /// The range of u on which the largest error is looked for
    #[arg(long, value_name = "LOW,HIGH", default_value = "0,2", value_parser = range, allow_hyphen_values = true)]
    range: Range,
    /// The relative error whose reach is wanted
    #[arg(long, value_name = "ERROR", default_value = "1e-3", value_parser = level)]
    error: Exact,
    #[command(flatten)]
    law: LawArgs,
    #[command(flatten)]
    end: EndArgs,
    #[command(flatten)]
    output: OutputArgs,
}

/// A list that can be printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum List {
    /// The cheapest sound approximants for given errors and ranges of u, for spheres.
    Recommended,
    /// Published constants beside the regenerated ones.
    Literature,
}

/// How the constants of an approximant are arranged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
enum Form {
    /// Coefficients of numerator and denominator.
    #[default]
    Quotient,
    /// Links c x^power of the continued fraction c_0 + c_1 x^p_1/(1 + c_2 x^p_2/(1 + ...)).
    ContinuedFraction,
}

/// A range of `u`.
#[derive(Clone, Debug)]
struct Range(Exact, Exact);

fn degree(text: &str) -> Result<usize, String> {
    count(text, "a degree", 0, LARGEST_DEGREE)
}

fn side(text: &str) -> Result<usize, String> {
    count(text, "the side of a table", 0, LARGEST_SIDE)
}

fn conditions(text: &str) -> Result<usize, String> {
    count(text, "a number of conditions", 1, LARGEST_DEGREE)
}

/// The largest end of a range.
const FARTHEST: i64 = 1_000_000;

fn range(text: &str) -> Result<Range, String> {
    let (low, high) =
        text.split_once(',').ok_or("a range is two numbers: write it as LOW,HIGH such as 0,2")?;
    let read = |text: &str| text.parse::<Exact>().map_err(|error| error.to_string());
    let (low, high) = (read(low)?, read(high)?);
    if low < 0 || low.value() >= high.value() || high > FARTHEST {
        return Err(format!(
            "the range '{text}' is empty or not between 0 and {FARTHEST}: give 0 <= LOW < HIGH such as 0,2"
        ));
    }
    Ok(Range(low, high))
}

fn level(text: &str) -> Result<Exact, String> {
    let error: Exact = text.parse().map_err(|error: crate::exact::NumberError| error.to_string())?;
    if (1e-24..1.0).contains(&error.to_f64()) {
        return Ok(error);
    }
    Err(format!("'{text}' is no relative error to reach: give one from 1e-24 to below 1"))
}

impl PadeArgs {
    /// Prints the constants and the verdict, the map or the list.
    ///
    /// # Errors
    ///
    /// Usage for degrees, ranges and conditions that go together with no approximant; failure where
    /// digits or certified values cannot be had.
    pub fn run(&self) -> Result<(), CliError> {
        self.output.check()?;
        if self.list.is_none() && self.table.is_none() && self.denominator.is_none() {
            return Err(CliError::usage(
                "an approximant has two degrees: give <L> <M> such as 3 8, or --table N, or --list",
            ));
        }
        let table = match (self.list, self.table) {
            (Some(List::Literature), _) => literature::table(self.digits)?,
            (Some(List::Recommended), _) => recommended::table()?,
            (None, Some(side)) => {
                let request = self.request(PadeType::new(side, side));
                map::table(&self.expansion()?, &request)?
            }
            (None, None) => match &self.series {
                Some(path) => {
                    let _progress = Progress::unknown("approximant");
                    series::table(path, self.asked(), self.form, self.digits)?
                }
                None => self.constants()?,
            },
        };
        self.output.print(&table)
    }

    fn expansion(&self) -> Result<Expansion, CliError> {
        Ok(Expansion::new(&self.law.law, self.end.end.into(), self.variable)?)
    }

    fn request(&self, asked: PadeType) -> Request {
        Request {
            asked,
            at_infinity: self.at_infinity.unwrap_or(0),
            digits: self.digits,
            range: (self.range.0.value().clone(), self.range.1.value().clone()),
            level: self.error.value().clone(),
        }
    }

    fn asked(&self) -> PadeType {
        PadeType::new(self.numerator.unwrap_or(0), self.denominator.unwrap_or(0))
    }

    fn constants(&self) -> Result<Table, CliError> {
        let _progress = Progress::unknown("approximant");
        let (expansion, request) = (self.expansion()?, self.request(self.asked()));
        let judged = judge(&expansion, &request)?;
        let mut table = match self.form {
            Form::Quotient => quotient(&judged, request.digits)?,
            Form::ContinuedFraction => continued_fraction(&judged, request.digits)?,
        };
        table = table.titled(title(&expansion, &request, &self.law.law.to_string()));
        report(&mut table, &expansion, &request, &judged)?;
        Ok(table)
    }
}

fn title(expansion: &Expansion, request: &Request, law: &str) -> String {
    let end = match expansion.end() {
        End::ZeroCompression => "zero compression",
        End::ZeroForce => "zero force",
    };
    let kind = if request.at_infinity > 0 { "two-point Padé" } else { "Padé" };
    let x = expansion.variable().name();
    format!("{} {kind} approximant of eps in {x}, contact ends at {end}, law {law}", request.asked)
}

fn quotient(judged: &Judged, digits: usize) -> Result<Table, CliError> {
    let mut table = Table::new(&["part", "k", "value"]);
    for (part, k, value) in constants(judged.approximant.function(), digits)? {
        table.push(vec![part.into(), k.into(), Cell::Digits(value)]);
    }
    Ok(table)
}

fn continued_fraction(judged: &Judged, digits: usize) -> Result<Table, CliError> {
    let mut table = Table::new(&["link", "power", "value"]);
    for (k, (power, value)) in links(&judged.approximant, digits)?.into_iter().enumerate() {
        table.push(vec![k.into(), power.into(), Cell::Digits(value)]);
    }
    Ok(table)
}
