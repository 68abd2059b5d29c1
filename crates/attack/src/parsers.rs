//! The readers of numbers, quantities, laws, lists and files, in this process: the same checks for random texts here and
//! for coverage-guided ones (`fuzz/`).

use crate::data_files::{Written, mutate};
use crate::random::{Source, choose};
use crate::{Part, Size, Tally};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use rand::RngExt;
use restitution_cli::list;
use restitution_fit::{Data, DataOptions, LARGEST_MEASURED_EPSILON, Measurement};
use restitution_law::ForceLaw;
use restitution_law::exact::{Exact, NumberError};
use restitution_units::{Dimension, Quantity};

/// Texts of one case.
const TEXTS: u64 = 100;
/// The longest text; files may be longer.
const LONGEST: usize = 30_000;

/// What people type, as a start.
const SEEDS: [&str; 36] = [
    "0.32cm/s",
    "5 mm",
    "9.1 GPa",
    "0.9g/cm3",
    "2Pa s",
    "18km/h",
    "1/3mm",
    "1e-3 cm·s⁻¹",
    "m s^-1",
    "-.5",
    "+2/6",
    "0.1/0.3",
    "1E-2",
    "5e-324",
    "1.7976931348623157e308",
    "2.2250738585072011e-308",
    "9007199254740993",
    "1e10000",
    "1e10001",
    "3/2,1",
    "3/2,-1/2",
    "1,0",
    "1.001, -0.25",
    "1e-1,0",
    "1/2,3",
    "1cm/s:10m/s:50log",
    "1:2:5",
    "0, 5",
    "0,5",
    "1cm/s,2cm/s",
    "1:2:100000",
    "1,203",
    "1.203,5",
    "ft/min",
    "1 m / s",
    "12 kg m^-3",
];

/// A reader of text that comes from outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parser {
    /// [`Exact`].
    Number,
    /// [`Quantity`].
    Quantity,
    /// [`ForceLaw`].
    Law,
    /// `restitution_cli::list::velocities`.
    List,
    /// [`Data`].
    Data,
}

impl Parser {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Number, Self::Quantity, Self::Law, Self::List, Self::Data];

    /// Reads `bytes`; `Ok(true)` if they were understood.
    ///
    /// # Errors
    ///
    /// The promise that was broken.
    pub fn check(self, bytes: &[u8]) -> Result<bool, String> {
        let text = || std::str::from_utf8(bytes).ok();
        match self {
            Self::Number => text().map_or(Ok(false), number),
            Self::Quantity => text().map_or(Ok(false), quantity),
            Self::Law => text().map_or(Ok(false), law),
            Self::List => text().map_or(Ok(false), velocities),
            Self::Data => data(bytes),
        }
    }
}

fn promise(kept: bool, what: &str) -> Result<(), String> {
    if kept { Ok(()) } else { Err(what.to_owned()) }
}

/// What the standard library makes of a decimal, which knows nothing of rationals.
fn number(text: &str) -> Result<bool, String> {
    let read = text.parse::<Exact>();
    let plain = text.trim();
    let decimal = plain.bytes().all(|b| b.is_ascii_digit() || b"+-.eE".contains(&b));
    let nearest = plain.parse::<f64>().ok().filter(|_| decimal);
    match (&read, nearest) {
        (Ok(exact), Some(nearest)) => {
            promise(exact.to_f64() == nearest, "the f64 of a decimal is the nearest one")?;
        }
        (Err(error), Some(_)) => {
            promise(*error == NumberError::TooLong, "every decimal that is not too long is read")?
        }
        (Ok(_), None) => {
            promise(plain.contains('/'), "what is neither a decimal nor a fraction is no number")?
        }
        (Err(_), None) => {}
    }
    let Ok(exact) = read else { return Ok(false) };
    let again = exact.to_string().parse::<Exact>();
    promise(
        again.is_ok_and(|again| again.value() == exact.value()),
        "a number is read again as it is shown",
    )?;
    if let Some((above, below)) = plain.split_once('/') {
        let parts = above.parse::<Exact>().and_then(|above| Ok((above, below.parse::<Exact>()?)));
        let equal = parts.is_ok_and(|(above, below)| exact.value() * below.value() == *above.value());
        promise(equal, "a fraction times its denominator is its numerator")?;
    }
    Ok(true)
}

/// One text is a quantity of one kind at most, and its unit scales its number.
fn quantity(text: &str) -> Result<bool, String> {
    let read = Dimension::ALL.map(|dimension| Quantity::parse(text, dimension));
    let mut understood = 0;
    for (quantity, dimension) in read.iter().zip(Dimension::ALL) {
        let Ok(quantity) = quantity else { continue };
        understood += 1;
        let padded = Quantity::parse(&format!(" {quantity}\t"), dimension);
        promise(padded.as_ref() == Ok(quantity), "blanks around a quantity mean nothing")?;
        let unit = match quantity.unit() {
            Some(unit) => {
                restitution_units::size(unit, dimension).ok_or("the unit of a quantity has a size")?
            }
            None => BigRational::one(),
        };
        promise(unit.is_positive(), "units are positive")?;
        let number = quantity.unit().map_or(text.trim(), |unit| text.trim().trim_end_matches(unit));
        let number = number.parse::<Exact>().map_err(|_| "what stands before the unit is a number")?;
        promise(number.value() * unit == *quantity.si(), "a quantity is its number times its unit")?;
    }
    let bare = read.iter().flatten().any(|quantity| quantity.unit().is_none());
    promise(
        understood == if bare { Dimension::ALL.len() } else { understood.min(1) },
        "a unit has one dimension",
    )?;
    Ok(understood > 0)
}

fn law(text: &str) -> Result<bool, String> {
    let Ok(law) = text.parse::<ForceLaw>() else { return Ok(false) };
    promise(law.a().is_positive(), "the elastic exponent of a law is positive")?;
    promise(*law.gamma() > -BigRational::one(), "the damping exponent of a law is above -1")?;
    let two = BigRational::from_integer(BigInt::from(2));
    let exponent = law.velocity_exponent() * (law.a() + BigRational::one());
    promise(
        exponent == two * (law.gamma() - law.a()) + law.a() + BigRational::one(),
        "the power of the velocity is (2 gamma - a + 1)/(a + 1)",
    )?;
    promise(law.to_string().parse::<ForceLaw>().as_ref() == Ok(&law), "a law is read again as it is shown")?;
    Ok(true)
}

/// A list between commas is its parts, a grid keeps its ends and rises or falls.
fn velocities(text: &str) -> Result<bool, String> {
    let Ok(read) = list::velocities(text) else { return Ok(false) };
    promise(!read.0.is_empty(), "a list has an entry")?;
    if !text.contains(',') && text.contains(':') {
        let ends = text.split(':').take(2).map(|end| Quantity::parse(end, Dimension::Velocity));
        let ends = ends.collect::<Result<Vec<_>, _>>().map_err(|_| "the ends of a grid are quantities")?;
        let seen = (read.0.first(), read.0.last());
        promise(seen == (ends.first(), ends.last()), "a grid keeps its ends")?;
        let rises = ends[0].si() <= ends[1].si();
        let ordered = |pair: &[Quantity]| {
            if rises { pair[0].si() <= pair[1].si() } else { pair[0].si() >= pair[1].si() }
        };
        promise(read.0.windows(2).all(ordered), "a grid rises or falls")?;
    } else if !text.contains(':') {
        let parts = text.split(',').map(|part| Quantity::parse(part, Dimension::Velocity));
        promise(parts.collect::<Result<Vec<_>, _>>().as_ref() == Ok(&read.0), "a list is its parts")?;
    }
    Ok(true)
}

/// Rows are sound numbers, and what says nothing changes nothing: a mark in front, other line ends, a comment at the end.
fn data(bytes: &[u8]) -> Result<bool, String> {
    let read = |bytes: &[u8]| Data::read(bytes.to_vec(), &DataOptions::default());
    let data = match read(bytes) {
        Ok(data) => data,
        Err(error) => {
            promise(!error.to_string().trim().is_empty(), "a refusal says why")?;
            return Ok(false);
        }
    };
    promise(data.lines.len() == data.rows.len(), "every row has its line")?;
    promise(
        data.durations.is_empty() || data.durations.len() == data.rows.len(),
        "every row has its duration",
    )?;
    promise(data.lines.is_sorted(), "lines are in order")?;
    promise(data.unit_size > 0.0 && data.unit_size.is_finite(), "a unit has a size")?;
    let sound = |row: &Measurement| {
        row.velocity() > 0.0
            && row.velocity().is_finite()
            && row.epsilon() > 0.0
            && row.epsilon() <= LARGEST_MEASURED_EPSILON
    };
    promise(data.rows.iter().all(sound), "rows are positive numbers")?;
    let Ok(text) = std::str::from_utf8(bytes) else { return Ok(true) };
    let same = |other: String, what: &str| {
        let again = read(other.as_bytes());
        promise(again.is_ok_and(|again| again.rows == data.rows && again.unit == data.unit), what)
    };
    if !text.starts_with('\u{feff}') {
        same(format!("\u{feff}{text}"), "a byte order mark changes nothing")?;
    }
    if !text.contains(['\r', '"']) {
        same(text.replace('\n', "\r\n"), "the kind of line end changes nothing")?;
    }
    Ok(true)
}

/// Reads random texts with every reader.
#[derive(Debug)]
pub struct Parsers;

impl Part for Parsers {
    fn name(&self) -> &'static str {
        "parsers"
    }

    fn about(&self) -> &'static str {
        "texts for the readers of numbers, quantities, laws, lists, files: read rightly or refused"
    }

    fn cases(&self, size: Size) -> u64 {
        match size {
            Size::Slice => 40,
            Size::Minutes => 5_000,
            Size::Full => 100_000,
        }
    }

    fn attack(&self, random: &mut Source, tally: &mut Tally) {
        for _ in 0..TEXTS {
            let parser = *choose(random, &Parser::ALL);
            let mut bytes = match parser {
                Parser::Data => Written::new(random).bytes,
                Parser::Number if random.random_bool(0.5) => digits(random).into_bytes(),
                _ => choose(random, &SEEDS).as_bytes().to_vec(),
            };
            for _ in 0..random.random_range(0..4) {
                mutate(&mut bytes, random);
                bytes.truncate(LONGEST);
            }
            tally.count(&format!("texts for {parser:?}"), 1);
            match parser.check(&bytes) {
                Ok(understood) => tally.count(&format!("understood by {parser:?}"), u64::from(understood)),
                Err(promise) => {
                    tally.fault(&promise, format!("{parser:?}: {:?}", String::from_utf8_lossy(&bytes)))
                }
            }
        }
    }
}

/// A decimal of some length, often next to the middle between two f64.
fn digits(random: &mut Source) -> String {
    let x = crate::random::bits(random).abs();
    if !x.is_finite() || x.is_zero() || random.random_bool(0.3) {
        return format!(
            "{}.{:0>3}e{}",
            random.random::<u64>(),
            random.random::<u8>(),
            random.random_range(-400..400)
        );
    }
    let exact = |x: f64| BigRational::from_float(x).unwrap_or_else(BigRational::zero);
    let between = (exact(x) + exact(x.next_up())) / BigRational::from_integer(2.into());
    let places = random.random_range(15..40);
    let exponent = between.to_f64().unwrap_or(1.0).log10().floor() as i32;
    let ten = BigRational::from_integer(10.into());
    let shifted = (between * num_traits::Pow::pow(ten, places - exponent)).round().to_integer();
    format!("{shifted}e{}", exponent - places)
}
