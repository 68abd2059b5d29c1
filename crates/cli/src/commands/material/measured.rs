//! One measured collision, as people measure it.

use crate::CliError;
use crate::exact::{Exact, NumberError};
use crate::units::{self, Dimension, Quantity};
use restitution_fit::{FitError, MeasuredLoss, STANDARD_GRAVITY};

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
    /// Velocity and loss, from the numbers as they were typed.
    pub(super) loss: MeasuredLoss,
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
            let loss =
                MeasuredLoss::of_coefficient(velocity.si(), epsilon.value()).map_err(CliError::usage)?;
            return Ok(Some(Measured { loss, text: format!("epsilon = {epsilon} at {velocity}") }));
        }
        if let Some([before, after]) = &self.speeds {
            if before.sign().is_eq() {
                return Err(not_positive("speed before", before));
            }
            let loss = MeasuredLoss::of_speeds(before.si(), after.si());
            return derived(loss, &format!("of speeds {before} before, {after} after"));
        }
        if let Some([drop, rebound]) = &self.heights {
            for (what, height) in [("height of the rebound", rebound), ("height of the drop", drop)] {
                if !height.sign().is_gt() {
                    return Err(not_positive(what, height));
                }
            }
            let loss = MeasuredLoss::of_heights(drop.si(), rebound.si(), self.acceleration()?);
            return derived(loss, &format!("of a drop from {drop} and a rebound to {rebound}"));
        }
        if let Some(times) = &self.bounce_times {
            let [one, two, three] = times;
            let loss = MeasuredLoss::of_impacts(
                &times.each_ref().map(|time| time.si().clone()),
                self.acceleration()?,
            );
            if let Err(FitError::BounceTimes { .. }) = loss {
                return Err(CliError::usage(
                    "the times of impacts do not increase: give three, each later than the one before",
                ));
            }
            return derived(loss, &format!("of impacts at {one}, {two} and {three}"));
        }
        Ok(None)
    }

    fn acceleration(&self) -> Result<f64, CliError> {
        let gravity = self.gravity.as_ref().map_or(STANDARD_GRAVITY, Quantity::to_f64);
        if gravity > 0.0 && gravity.is_finite() {
            return Ok(gravity);
        }
        Err(CliError::usage("the acceleration of gravity must be positive: give one such as 9.81m/s^2"))
    }
}

fn derived(loss: Result<MeasuredLoss, FitError>, origin: &str) -> Result<Option<Measured>, CliError> {
    let loss = loss.map_err(CliError::usage)?;
    let text = format!("epsilon = {:.6} at {:.6} m/s, {origin}", loss.epsilon(), loss.velocity());
    Ok(Some(Measured { loss, text }))
}

fn not_positive(what: &str, quantity: &Quantity) -> CliError {
    CliError::usage(format!("the {what} is {quantity}: give a positive one"))
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
