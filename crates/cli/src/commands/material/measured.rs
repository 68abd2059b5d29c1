//! One measured collision, as people measure it.

use crate::CliError;
use crate::exact::{Exact, NumberError};
use crate::units::{self, Dimension, Quantity};
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};
use restitution_fit::STANDARD_GRAVITY;

/// Arguments that say what was measured of one collision.
#[derive(Debug, clap::Args)]
#[group(id = "measurement", multiple = true)]
pub(in crate::commands) struct MeasuredArgs {
    /// Impact velocity and coefficient, such as 1cm/s,0.55
    #[arg(long, value_name = "G,EPSILON", value_parser = measured, allow_hyphen_values = true, conflicts_with_all = ["heights", "speeds", "bounce_times"])]
    measured: Option<(Quantity, Exact)>,
    /// Heights of a drop and of its rebound, such as 30cm,12cm
    #[arg(long, value_name = "DROP,REBOUND", value_parser = heights, allow_hyphen_values = true, conflicts_with_all = ["speeds", "bounce_times"])]
    heights: Option<[Quantity; 2]>,
    /// Speeds before and after, such as 1.2m/s,0.7m/s
    #[arg(long, value_name = "BEFORE,AFTER", value_parser = speeds, allow_hyphen_values = true, conflicts_with = "bounce_times")]
    speeds: Option<[Quantity; 2]>,
    /// Times of three successive impacts of a bouncing ball, such as 0s,0.42s,0.75s
    #[arg(long, value_name = "T1,T2,T3", value_parser = bounce_times, allow_hyphen_values = true)]
    bounce_times: Option<[Quantity; 3]>,
    /// How long that contact lasted, such as 60us: gives stiffness and damping, in place of elastic constants
    #[arg(long, value_name = "T", value_parser = units::time, allow_hyphen_values = true, requires = "measurement", conflicts_with_all = ["young", "young2", "poisson2", "effective_modulus"])]
    pub(super) duration: Option<Quantity>,
    /// Acceleration of gravity, for heights and times [default: 9.80665m/s^2]
    #[arg(long, value_name = "A", value_parser = units::acceleration)]
    gravity: Option<Quantity>,
}

/// What a measurement says.
pub(super) struct Measured {
    /// The impact velocity, in m/s.
    pub(super) velocity: f64,
    /// `1 - epsilon`, from the numbers as they were typed.
    pub(super) lost: f64,
    /// In words, as `epsilon = 0.5 at 1cm/s`.
    pub(super) text: String,
}

impl MeasuredArgs {
    /// Whether any quantity was given with a unit.
    pub(super) fn has_units(&self) -> bool {
        let one =
            self.measured.iter().map(|(velocity, _)| velocity).chain(&self.duration).chain(&self.gravity);
        let pairs =
            self.heights.iter().chain(&self.speeds).flatten().chain(self.bounce_times.iter().flatten());
        one.chain(pairs).any(|quantity| quantity.unit().is_some())
    }

    /// The measured collision, if one was given.
    pub(super) fn get(&self) -> Result<Option<Measured>, CliError> {
        if let Some((velocity, epsilon)) = &self.measured {
            let lost = BigRational::one() - epsilon.value();
            let text = format!("epsilon = {epsilon} at {velocity}");
            return Measured::new(velocity.to_f64(), to_f64(&lost), text).map(Some);
        }
        if let Some([before, after]) = &self.speeds {
            let before_si = positive("speed before", before)?;
            let ratio = after.si().abs() / before_si;
            let velocity = before.to_f64().abs();
            return self.derived(
                velocity,
                to_f64(&(BigRational::one() - ratio)),
                format!("of speeds {before} before, {after} after"),
            );
        }
        if let Some([drop, rebound]) = &self.heights {
            let ratio = positive("height of the rebound", rebound)? / positive("height of the drop", drop)?;
            let velocity = (2.0 * self.acceleration()? * drop.to_f64()).sqrt();
            let lost = to_f64(&(BigRational::one() - &ratio)) / (1.0 + to_f64(&ratio).sqrt()); // 1 - sqrt(ratio)
            return self.derived(velocity, lost, format!("of a drop from {drop} and a rebound to {rebound}"));
        }
        if let Some([one, two, three]) = &self.bounce_times {
            let (first, second) = (two.si() - one.si(), three.si() - two.si());
            if !first.is_positive() || !second.is_positive() {
                return Err(CliError::usage(
                    "the times of impacts do not increase: give three, each later than the one before",
                ));
            }
            let velocity = 0.5 * self.acceleration()? * to_f64(&first);
            let lost = to_f64(&(BigRational::one() - second / first));
            return self.derived(velocity, lost, format!("of impacts at {one}, {two} and {three}"));
        }
        Ok(None)
    }

    fn derived(&self, velocity: f64, lost: f64, origin: String) -> Result<Option<Measured>, CliError> {
        let text = format!("epsilon = {:.6} at {velocity:.6} m/s, {origin}", 1.0 - lost);
        Measured::new(velocity, lost, text).map(Some)
    }

    fn acceleration(&self) -> Result<f64, CliError> {
        let gravity = self.gravity.as_ref().map_or(STANDARD_GRAVITY, Quantity::to_f64);
        if gravity > 0.0 && gravity.is_finite() {
            return Ok(gravity);
        }
        Err(CliError::usage("the acceleration of gravity must be positive: give one such as 9.81m/s^2"))
    }
}

impl Measured {
    fn new(velocity: f64, lost: f64, text: String) -> Result<Self, CliError> {
        if lost > 0.0 && lost < 1.0 {
            return Ok(Self { velocity, lost, text });
        }
        Err(CliError::usage(restitution::MaterialError::Epsilon { value: 1.0 - lost }))
    }
}

fn to_f64(value: &BigRational) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}

fn positive(what: &str, quantity: &Quantity) -> Result<BigRational, CliError> {
    let size = quantity.si().abs();
    if size.is_positive() && (quantity.si().is_positive() || what.starts_with("speed")) {
        return Ok(size);
    }
    Err(CliError::usage(format!("the {what} is {quantity}: give a positive one")))
}

fn measured(text: &str) -> Result<(Quantity, Exact), String> {
    let (velocity, epsilon) = text.split_once(',').ok_or_else(|| {
        format!("'{text}' is not a measured pair: write it as velocity,epsilon, such as 1cm/s,0.55")
    })?;
    let velocity = Quantity::parse(velocity, Dimension::Velocity).map_err(|error| error.to_string())?;
    Ok((velocity, epsilon.parse().map_err(|error: NumberError| error.to_string())?))
}

fn several<const N: usize>(text: &str, dimension: Dimension, example: &str) -> Result<[Quantity; N], String> {
    let read = |part: &str| Quantity::parse(part, dimension).map_err(|error| error.to_string());
    let values = text.split(',').map(read).collect::<Result<Vec<_>, _>>()?;
    units::all_or_none(&values).map_err(|error| error.to_string())?;
    let number = values.len();
    values.try_into().map_err(|_| {
        let more = if N == 3 && number > 3 { ", or give all times to restitution fit in a file" } else { "" };
        format!("'{text}' has {number} values instead of {N}: write them as {example}{more}")
    })
}

fn heights(text: &str) -> Result<[Quantity; 2], String> {
    several(text, Dimension::Length, "30cm,12cm")
}

fn speeds(text: &str) -> Result<[Quantity; 2], String> {
    several(text, Dimension::Velocity, "1.2m/s,0.7m/s")
}

fn bounce_times(text: &str) -> Result<[Quantity; 3], String> {
    several(text, Dimension::Time, "0s,0.42s,0.75s")
}
