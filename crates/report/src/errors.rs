//! Error against damping, and the two ends of contact compared.

use crate::ReportError;
use crate::certified_values::CertifiedValues;
use crate::chart::{Axis, Chart, Series, Stroke};
use crate::contestants::{Contestant, Family};
use crate::formulas::SLOPE;
use crate::page::{Data, Figure, Section};
use crate::speed::{end_name, error_cell};
use restitution_direct::{End, saturation_radius};
use restitution_law::ForceLaw;
use restitution_table::{Cell, Table};

/// Where the page's extracts of long tables show a row: the nearest points of the grid.
const EXTRACT: [f64; 7] = [0.1, 0.5, 1.0, 1.5, 2.0, 5.0, 7.5];

/// The part of the report on error against damping.
pub fn section(
    contestants: &[Contestant],
    reference: &CertifiedValues,
    errors: &[Vec<f64>],
) -> Result<Section, ReportError> {
    let radius = saturation_radius(&ForceLaw::viscoelastic_spheres(), 20).map_err(ReportError::failure)?;
    let digits = |count| radius.to_digits(count).unwrap_or_default();
    let velocity = (SLOPE * radius.to_f64()).powi(5);
    let rule = (radius.to_f64(), format!("R = {}", digits(7)));
    let group = |id: &str, wanted: &dyn Fn(&Contestant) -> bool| {
        let mut chart = chart(id, contestants, reference, errors, wanted);
        if !id.ends_with("zero-force") {
            chart.rules.push(rule.clone());
        }
        chart
    };
    let families = |families: &'static [Family]| move |c: &Contestant| families.contains(&c.family);
    let approximants =
        |end| move |c: &Contestant| matches!(c.family, Family::Pade | Family::TwoPoint) && c.end == end;
    let data = Data::long(
        "error-by-u.csv",
        table(contestants, reference, errors, |_| true),
        table(contestants, reference, errors, |u| EXTRACT.contains(&u)),
    );
    let series = group("error-series", &families(&[Family::Series]));
    let printed = [Family::Formula35, Family::Approximate, Family::MuellerPoeschel];
    let formulas = group("error-formulas", &|c| printed.contains(&c.family));
    let pade = group("error-pade", &approximants(End::ZeroCompression));
    let pade_force = group("error-pade-zero-force", &approximants(End::ZeroForce));
    let evaluator = group("error-evaluator", &families(&[Family::Evaluator, Family::Tier]));
    let integration = group("error-integration", &families(&[Family::Integration]));
    Ok(Section::new(
        "Error against damping",
        &format!(
            "Relative errors against the certified integrator. The series in u converges for |u| < R = {}, in velocities for g < {velocity:.2} g*; beyond R further orders make it worse.",
            digits(12)
        ),
        vec![
            Figure::new(
                series,
                "The truncated series. Left of R each order gains digits, right of it each order loses them.",
            )
            .with(data),
            Figure::new(
                formulas,
                "The formulas of the literature. Formula (35) carries the constants of Table I, which come from wrong a₃ and a₄ and a₅ = 0; its counterparts have the exact ones. With every coefficient exact the [1/4] formula falls below zero, and its relative error exceeds 1 from there on. Müller and Pöschel's formulas are judged by contacts that end at zero force.",
            ),
            Figure::new(
                pade,
                "Padé approximants in u from exact coefficients, and two-point approximants, which also meet ε u⁵ → R⁵ at infinity (the last number says with how many conditions). Contact ends at zero compression.",
            ),
            Figure::new(
                pade_force,
                "Padé approximants in √u from exact coefficients, for contacts that end at zero force.",
            ),
            Figure::new(
                evaluator,
                "The f64 evaluator and its tiers. Each point is the largest of eight neighbouring values of the grid, so that the curves can be told apart; dashed: contact ends at zero force.",
            ),
            Figure::new(
                integration,
                "An ODE library (differential-equations, methods of Dormand and Prince of order 5 and 8) integrating the equation of motion in plain time to several tolerances. Each point is the largest of eight neighbouring values of the grid.",
            ),
            ends(reference),
        ],
    ))
}

fn chart(
    id: &str,
    contestants: &[Contestant],
    reference: &CertifiedValues,
    errors: &[Vec<f64>],
    wanted: &dyn Fn(&Contestant) -> bool,
) -> Chart {
    let members = contestants.iter().zip(errors).filter(|(c, _)| wanted(c)).collect::<Vec<_>>();
    let all = members.iter().flat_map(|(_, errors)| errors.iter().map(|e| e.clamp(1e-18, 90.0)));
    let y = Axis::decades("relative error", all);
    let x = Axis::linear("damping u (no unit)", 0.0, 7.5);
    let names = members.iter().map(|(c, _)| c.name.as_str()).collect::<Vec<_>>().join(", ");
    let mut chart = Chart::new(id, &format!("Relative error against u: {names}"), x, y);
    for (i, (contestant, errors)) in members.into_iter().enumerate() {
        let jumps = matches!(contestant.family, Family::Evaluator | Family::Tier | Family::Integration);
        let points = envelope(&reference.u, errors, if jumps { 8 } else { 1 });
        let stroke = if contestant.end == End::ZeroForce { Stroke::Dashed } else { Stroke::Solid };
        chart.series.push(Series::line(&contestant.name, i % 9, points).stroked(stroke));
    }
    chart
}

/// The largest error of each `count` neighbours, at the middle one.
fn envelope(u: &[f64], errors: &[f64], count: usize) -> Vec<(f64, f64)> {
    let largest = |errors: &[f64]| errors.iter().copied().fold(0.0, f64::max);
    u.chunks(count).zip(errors.chunks(count)).map(|(u, errors)| (u[u.len() / 2], largest(errors))).collect()
}

fn table(
    contestants: &[Contestant],
    reference: &CertifiedValues,
    errors: &[Vec<f64>],
    wanted: impl Fn(f64) -> bool,
) -> Table {
    let mut table = Table::new(&["method", "end", "u", "relative_error"]);
    for (contestant, errors) in contestants.iter().zip(errors) {
        for (u, error) in reference.u.iter().zip(errors).filter(|(u, _)| wanted(**u)) {
            table.push(vec![
                contestant.name.as_str().into(),
                end_name(contestant.end).into(),
                (*u).into(),
                error_cell(*error),
            ]);
        }
    }
    table
}

fn ends(reference: &CertifiedValues) -> Figure {
    let value = |end: End| reference.values(end).iter().map(restitution_real::Ball::to_f64);
    let start = || std::iter::once((0.0, 1.0));
    let line = |name: &str, colour, end| {
        Series::line(name, colour, start().chain(reference.u.iter().copied().zip(value(end))))
    };
    let mut chart = Chart::new(
        "ends-of-contact",
        "Coefficient of restitution against u for both ends of contact",
        Axis::linear("damping u (no unit)", 0.0, 7.5),
        Axis::linear("coefficient of restitution ε (no unit)", 0.0, 1.0),
    );
    chart.series.push(line("contact ends at zero force", 1, End::ZeroForce));
    chart
        .series
        .push(line("contact ends at zero compression", 0, End::ZeroCompression).stroked(Stroke::Dashed));
    let gain = |at: f64| {
        let index = reference.u.iter().position(|u| *u == at)?;
        let [inner, outer] =
            [End::ZeroCompression, End::ZeroForce].map(|end| reference.values(end)[index].to_f64());
        Some(format!("{:.0} % at u = {at}", 100.0 * (outer / inner - 1.0)))
    };
    let gains = [0.5, 1.0, 2.0].into_iter().filter_map(gain).collect::<Vec<_>>().join(", ");
    let caption = format!(
        "The two ends of contact. The paper ends it at zero compression, after a spell of attraction that dry bodies do not have; ending it where the force vanishes gives a larger ε, by {gains}. Both curves are certified."
    );
    let columns = ["u", "epsilon_zero_compression", "epsilon_zero_force"];
    let rows = |wanted: &dyn Fn(f64) -> bool| {
        let mut table = Table::new(&columns);
        let pairs = reference.values(End::ZeroCompression).iter().zip(reference.values(End::ZeroForce));
        for (u, (inner, outer)) in reference.u.iter().zip(pairs).filter(|(u, _)| wanted(**u)) {
            let digits = |ball: &restitution_real::Ball| Cell::digits(ball.to_digits(20).unwrap_or_default());
            table.push(vec![(*u).into(), digits(inner), digits(outer)]);
        }
        table
    };
    Figure::new(chart, &caption).with(Data::long(
        "ends-of-contact.csv",
        rows(&|_| true),
        rows(&|u| EXTRACT.contains(&u)),
    ))
}
