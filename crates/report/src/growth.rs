//! The time that coefficients take, against their order and their digits.

use crate::ReportError;
use crate::Watch;
use crate::chart::{Axis, Chart, Point, Series, Shape, Stroke};
use crate::effort::Effort;
use crate::page::{Data, Figure, Section};
use crate::speed::figures;
use crate::timing::{Task, Timing, in_turn};
use restitution_law::ForceLaw;
use restitution_series::{Quantity, coefficients};
use restitution_table::{Cell, Table};
use std::time::{Duration, Instant};

/// Digits while the order grows, and the order while the digits grow.
const DIGITS: usize = 20;
const ORDER: usize = 8;
/// The largest numbers that are tried.
const LIMIT: usize = 100_000;

/// Sizes with the times they took, and the fitted power.
struct Growth {
    sizes: Vec<usize>,
    times: Vec<Timing>,
    power: Option<Power>,
}

/// `time = c size^exponent` with the standard error of the exponent, fitted to the larger half of the sizes.
struct Power {
    exponent: f64,
    error: f64,
    /// The logarithm of `c`.
    logarithm: f64,
}

/// Measures and returns the part of the report on generating coefficients.
///
/// # Errors
///
/// What the coefficients say.
pub fn section(effort: &Effort, watch: &Watch) -> Result<Section, ReportError> {
    let by_order = grow(4, effort, watch, |order| (order, DIGITS))?;
    let by_digits = grow(10, effort, watch, |digits| (ORDER, digits))?;
    let mut table = Table::new(&["order", "digits", "seconds", "quartile_1", "quartile_3"]);
    for (growth, is_order) in [(&by_order, true), (&by_digits, false)] {
        for (size, time) in growth.sizes.iter().zip(&growth.times) {
            let (order, digits) = if is_order { (*size, DIGITS) } else { (ORDER, *size) };
            let times = [time.median, time.low, time.high].map(|t| Cell::digits(figures(t, 3)));
            table.push([vec![order.into(), digits.into()], times.to_vec()].concat());
        }
    }
    let first = Figure::new(
        by_order.chart("coefficients-by-order", "largest order K"),
        &format!(
            "Time of C₁ … C_K with {DIGITS} proved digits each, against the order K. {}",
            by_order.sentence("K")
        ),
    );
    let second = Figure::new(
        by_digits.chart("coefficients-by-digits", "proved digits D"),
        &format!("Time of C₁ … C₈ against the number D of proved digits. {}", by_digits.sentence("D")),
    );
    Ok(Section::new(
        "Generating coefficients",
        &format!(
            "From the equation of motion to proved digits, nothing stored. Sizes double until one run takes longer than {} s; times are medians of {} runs in turn, bars span the quartiles.",
            effort.longest.as_secs_f64(),
            effort.expansions
        ),
        vec![first.with(Data::new("coefficient-times.csv", table)), second],
    ))
}

fn grow(
    first: usize,
    effort: &Effort,
    watch: &Watch,
    request: impl Fn(usize) -> (usize, usize),
) -> Result<Growth, ReportError> {
    let spheres = ForceLaw::viscoelastic_spheres();
    let expand = |size: usize| {
        let (order, digits) = request(size);
        coefficients(Quantity::Restitution, &spheres, order, digits)
    };
    let mut sizes = Vec::new();
    let mut size = first;
    loop {
        let start = Instant::now();
        expand(size)?;
        sizes.push(size);
        if start.elapsed() > effort.longest || size >= LIMIT {
            break;
        }
        size *= 2;
    }
    let expand = &expand;
    let task = |size: &usize| {
        let size = *size;
        Task { values: 1, work: Box::new(move || drop(std::hint::black_box(expand(size)))) }
    };
    let mut tasks = sizes.iter().map(task).collect::<Vec<_>>();
    let times = in_turn(&mut tasks, effort.expansions, Duration::from_millis(1), watch);
    let power = Power::fit(&sizes, &times);
    drop(tasks);
    Ok(Growth { sizes, times, power })
}

impl Growth {
    fn sentence(&self, size: &str) -> String {
        let count = self.sizes.len() - self.sizes.len() / 2;
        self.power.as_ref().map_or("Too few sizes to fit an exponent.".to_owned(), |power| {
            format!(
                "Fitted to the {count} largest sizes: time grows like {size}^{:.2} (standard error {:.2}).",
                power.exponent, power.error
            )
        })
    }

    fn chart(&self, id: &str, label: &str) -> Chart {
        let (smallest, largest) =
            (self.sizes[0] as f64 * 0.8, self.sizes[self.sizes.len() - 1] as f64 * 1.25);
        let y = Axis::decades("seconds", self.times.iter().flat_map(|t| [t.low, t.high]));
        let mut chart =
            Chart::new(id, &format!("Time against {label}"), Axis::log(label, smallest, largest), y);
        let pairs = || self.sizes.iter().map(|n| *n as f64).zip(&self.times);
        let point = |(x, t): (f64, &Timing)| Point {
            x,
            y: t.median,
            label: String::new(),
            title: format!("{x}: {} s", figures(t.median, 3)),
        };
        let points = pairs().map(point).collect();
        let median = Series {
            name: "median".to_owned(),
            colour: 0,
            stroke: Stroke::Solid,
            shape: Shape::Circle,
            points,
        };
        if let Some(power) = &self.power {
            let line = |size: f64| (size, (power.logarithm + power.exponent * size.ln()).exp());
            let name = format!("fitted power, exponent {:.2}", power.exponent);
            let (start, end) =
                (self.sizes[self.sizes.len() / 2] as f64, self.sizes[self.sizes.len() - 1] as f64);
            chart.series.push(Series::line(&name, 9, [line(start), line(end)]).stroked(Stroke::Dashed));
        }
        for (x, t) in pairs() {
            chart.series.push(Series::line("", 0, [(x, t.low), (x, t.high)]));
        }
        chart.series.push(median);
        chart
    }
}

impl Power {
    /// Least squares of the logarithms of the larger half.
    fn fit(sizes: &[usize], times: &[Timing]) -> Option<Self> {
        let half = sizes.len() / 2;
        let points = sizes[half..]
            .iter()
            .zip(&times[half..])
            .map(|(n, t)| ((*n as f64).ln(), t.median.ln()))
            .collect::<Vec<_>>();
        let count = points.len() as f64;
        if count < 3.0 {
            return None;
        }
        let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / count;
        let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
        let (spread, together) = (mean(&|p| (p.0 - x).powi(2)), mean(&|p| (p.0 - x) * (p.1 - y)));
        let exponent = together / spread;
        let residual = mean(&|p| (p.1 - y - exponent * (p.0 - x)).powi(2));
        Some(Self {
            exponent,
            error: (residual / spread / (count - 2.0)).sqrt(),
            logarithm: y - exponent * x,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_is_found() {
        let sizes = [1, 2, 4, 8, 16, 32];
        let times = sizes.map(|n: usize| Timing::of(vec![3.0 * (n as f64).powf(2.5)]));
        let power = Power::fit(&sizes, &times).unwrap();
        assert!((power.exponent - 2.5).abs() < 1e-12 && power.error < 1e-6);
        assert!((power.logarithm.exp() - 3.0).abs() < 1e-12);
        assert!(Power::fit(&sizes[..2], &times[..2]).is_none());
    }
}
