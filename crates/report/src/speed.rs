//! Speed against error of every contestant.

use crate::Watch;
use crate::certified_values::CertifiedValues;
use crate::chart::{Axis, Chart, Point, Series, Shape, Stroke};
use crate::contestants::{Contestant, Family};
use crate::effort::Effort;
use crate::page::{Data, Figure, Section};
use crate::timing::{Task, Timing, in_turn};
use restitution_direct::End;
use restitution_table::{Cell, Table};

/// The upper ends of the ranges of `u`, which start at 0.
pub const RANGES: [f64; 3] = [1.0, 2.0, 7.5];
pub const NANOSECOND: f64 = 1e-9;
/// The file of the times.
pub const FILE: &str = "speed-and-error.csv";

/// What was found about one contestant on one range.
pub struct Result {
    pub contestant: usize,
    pub range: f64,
    /// The largest relative error on the grid, and where.
    pub error: f64,
    pub worst_at: f64,
    /// Seconds for a value when arguments do not wait for one another, and when each waits for the last value.
    pub apart: Timing,
    pub chained: Timing,
    /// Whether no other one for the same end of contact is both faster and better.
    pub on_front: bool,
}

/// Measures the time of every contestant on every range, with the errors of [`errors`].
pub fn measure(
    contestants: &[Contestant],
    reference: &CertifiedValues,
    errors: &[Vec<f64>],
    effort: &Effort,
    watch: &Watch,
) -> Vec<Result> {
    let mut results = Vec::new();
    for range in RANGES {
        let apart = times(contestants, range, effort, watch, |contestant, u| {
            let mut out = vec![0.0; u.len()];
            Box::new(move || {
                contestant.kernel.values(std::hint::black_box(&u), std::hint::black_box(&mut out))
            })
        });
        let chained = times(contestants, range, effort, watch, |contestant, u| {
            Box::new(move || {
                std::hint::black_box(contestant.kernel.chain(std::hint::black_box(&u)));
            })
        });
        for contestant in 0..contestants.len() {
            let (error, worst_at) = largest(&reference.u, &errors[contestant], range);
            let (apart, chained) = (apart[contestant], chained[contestant]);
            results.push(Result { contestant, range, error, worst_at, apart, chained, on_front: false });
        }
    }
    mark_fronts(contestants, &mut results);
    results
}

/// The relative errors of every contestant at every `u` of the grid.
pub fn errors(contestants: &[Contestant], reference: &CertifiedValues) -> Vec<Vec<f64>> {
    let of = |contestant: &Contestant| {
        let mut values = vec![0.0; reference.u.len()];
        contestant.kernel.values(&reference.u, &mut values);
        reference.errors(&values, contestant.end)
    };
    contestants.iter().map(of).collect()
}

fn times<'a>(
    contestants: &'a [Contestant],
    range: f64,
    effort: &Effort,
    watch: &Watch,
    work: impl Fn(&'a Contestant, Vec<f64>) -> Box<dyn FnMut() + 'a>,
) -> Vec<Timing> {
    let task = |contestant: &'a Contestant| {
        let values =
            if contestant.family == Family::Integration { effort.values / 32 } else { effort.values };
        Task { values, work: work(contestant, scattered(range, values)) }
    };
    let mut tasks = contestants.iter().map(task).collect::<Vec<_>>();
    in_turn(&mut tasks, effort.rounds, effort.sample, watch)
}

/// Numbers in `(0, high)` that fill it evenly in no order a processor could foresee (Weyl's sequence).
fn scattered(high: f64, count: usize) -> Vec<f64> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    (1..=count).map(|i| high * (i as f64 * GOLDEN).fract()).collect()
}

fn largest(u: &[f64], errors: &[f64], range: f64) -> (f64, f64) {
    let within = u.iter().zip(errors).filter(|(u, _)| **u <= range);
    within.fold((0.0, 0.0), |(worst, at), (u, error)| if *error > worst { (*error, *u) } else { (worst, at) })
}

fn mark_fronts(contestants: &[Contestant], results: &mut [Result]) {
    let end = |result: &Result| contestants[result.contestant].end;
    let beaten = |a: &Result| {
        results.iter().any(|b| {
            let rivals = b.range == a.range && end(b) == end(a);
            let no_worse = b.error <= a.error && b.apart.median <= a.apart.median;
            rivals && no_worse && (b.error < a.error || b.apart.median < a.apart.median)
        })
    };
    let fronts = results.iter().map(|a| a.error.is_finite() && !beaten(a)).collect::<Vec<_>>();
    results.iter_mut().zip(fronts).for_each(|(result, front)| result.on_front = front);
}

/// The part of the report on speed against error.
pub fn section(contestants: &[Contestant], results: &[Result], grid: usize) -> Section {
    let mut figures = Vec::new();
    for (i, range) in RANGES.into_iter().enumerate() {
        let on_range = results.iter().filter(|r| r.range == range).collect::<Vec<_>>();
        let chart = chart(
            &format!("speed-{}", i + 1),
            contestants,
            &on_range,
            |r| r.apart,
            "nanoseconds per value, arguments in a slice",
        );
        figures.push(Figure::new(chart, &format!("Speed against error for 0 < u ≤ {range}: median time of one value, and largest relative error against certified values. Lower left is better. The solid line is the Pareto front for contacts that end at zero compression, the dotted one for those that end at zero force; each method is judged by its own end of contact. A method that errs by more than a factor of ten is in the table alone.")));
    }
    let on_range = results.iter().filter(|r| r.range == RANGES[2]).collect::<Vec<_>>();
    let chart = chart(
        "latency",
        contestants,
        &on_range,
        |r| r.chained,
        "nanoseconds per value, each argument waiting for the last value",
    );
    figures.push(Figure::new(chart, &format!("The same for 0 < u ≤ {} when every argument depends on the value before it, as in a simulation that goes from collision to collision.", RANGES[2])));
    figures[0].data.push(Data::new(FILE, table(contestants, results)));
    Section::new(
        "Speed against error",
        &format!(
            "Each method gives ε(u) in f64. The error is the largest relative error seen on a grid of {grid} values of u that are exact in f64, against the certified integrator, which proves 21 digits of each; between grid points nothing is claimed. Times are medians of one run in which the methods take turns; the table has the quartiles."
        ),
        figures,
    )
}

fn chart(
    id: &str,
    contestants: &[Contestant],
    results: &[&Result],
    time: impl Fn(&Result) -> Timing,
    label: &str,
) -> Chart {
    let nanoseconds = |r: &Result| time(r).median / NANOSECOND;
    let x = Axis::decades(label, results.iter().map(|r| nanoseconds(r)));
    let y = Axis::decades("largest relative error", results.iter().map(|r| r.error.clamp(1e-17, 9.0)));
    let mut chart = Chart::new(id, &format!("Speed against error, {label}"), x, y);
    for (end, stroke) in [(End::ZeroCompression, Stroke::Solid), (End::ZeroForce, Stroke::Dotted)] {
        let mut front = results
            .iter()
            .filter(|r| contestants[r.contestant].end == end)
            .map(|r| (nanoseconds(r), r.error))
            .filter(|p| p.1.is_finite())
            .collect::<Vec<_>>();
        front.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let mut best = f64::INFINITY;
        front.retain(|p| {
            let better = p.1 < best;
            best = best.min(p.1);
            better
        });
        let name =
            if end == End::ZeroForce { "Pareto front, zero force" } else { "Pareto front, zero compression" };
        chart.series.push(Series::line(name, 9, front).stroked(stroke));
    }
    for family in Family::ALL {
        let members = results.iter().filter(|r| contestants[r.contestant].family == family);
        let point = |r: &&Result| {
            let contestant = &contestants[r.contestant];
            let title = format!("{}: {:.3} ns, error {:.1e}", contestant.name, nanoseconds(r), r.error);
            Point { x: nanoseconds(r), y: r.error, label: contestant.mark.clone(), title }
        };
        let points = members.map(point).collect::<Vec<_>>();
        if !points.is_empty() {
            let shape = if points.is_empty() { Shape::None } else { family.shape() };
            chart.series.push(Series {
                name: family.name().to_owned(),
                colour: family.colour(),
                stroke: Stroke::None,
                shape,
                points,
            });
        }
    }
    chart
}

fn table(contestants: &[Contestant], results: &[Result]) -> Table {
    let mut table = Table::new(&[
        "u_to",
        "method",
        "end",
        "largest_relative_error",
        "at_u",
        "ns",
        "ns_quartile_1",
        "ns_quartile_3",
        "chained_ns",
        "chained_ns_quartile_1",
        "chained_ns_quartile_3",
        "on_pareto_front",
    ]);
    for r in results {
        let contestant = &contestants[r.contestant];
        let (apart, chained) = (r.apart.in_units_of(NANOSECOND), r.chained.in_units_of(NANOSECOND));
        let times = [apart.median, apart.low, apart.high, chained.median, chained.low, chained.high];
        let mut row = vec![
            r.range.into(),
            contestant.name.as_str().into(),
            end_name(contestant.end).into(),
            error_cell(r.error),
            r.worst_at.into(),
        ];
        row.extend(times.map(|t| Cell::digits(figures(t, 3))));
        row.push(if r.on_front { "yes" } else { "no" }.into());
        table.push(row);
    }
    table
}

pub fn end_name(end: End) -> &'static str {
    if end == End::ZeroForce { "zero force" } else { "zero compression" }
}

/// An error to two figures.
pub fn error_cell(error: f64) -> Cell {
    match error {
        0.0 => Cell::digits("0"),
        error if error.is_finite() => Cell::digits(format!("{error:.1e}")),
        _ => "no value".into(),
    }
}

/// A number with so many figures, never in powers of ten.
pub fn figures(value: f64, count: i32) -> String {
    if !value.is_finite() || value == 0.0 {
        return value.to_string();
    }
    let decimals = (count - 1 - value.abs().log10().floor() as i32).max(0) as usize;
    format!("{value:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_counted() {
        assert_eq!(figures(0.012_345, 3), "0.0123");
        assert_eq!(figures(51_234.6, 3), "51235");
        assert_eq!([figures(0.0, 3), figures(f64::NAN, 3)], ["0", "NaN"]);
        assert_eq!(error_cell(f64::INFINITY), "no value".into());
    }

    #[test]
    fn arguments_fill_the_range() {
        let u = scattered(2.0, 100);
        assert!(u.iter().all(|u| (0.0..2.0).contains(u)));
        assert!((0..10).all(|i| u.iter().any(|u| (u / 0.2) as usize == i)));
    }
}
