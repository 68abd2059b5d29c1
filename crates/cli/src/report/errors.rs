//! Error against damping, and the two ends of contact compared.

use super::chart::{Axis, Chart, Series, Stroke};
use super::contestants::{Contestant, Family};
use super::page::{Data, Figure, Section};
use super::reference::Reference;
use super::speed::{end_name, error_cell};
use crate::{Cell, CliError, Table};
use restitution_direct::{End, saturation_radius};
use restitution_law::ForceLaw;

/// Where the page's extracts of long tables show a row: the nearest points of the grid.
const EXTRACT: [f64; 7] = [0.1, 0.5, 1.0, 1.5, 2.0, 5.0, 7.5];

/// The part of the report on error against damping.
pub fn section(
    contestants: &[Contestant],
    reference: &Reference,
    errors: &[Vec<f64>],
) -> Result<Section, CliError> {
    let radius = saturation_radius(&ForceLaw::viscoelastic_spheres(), 20).map_err(CliError::failure)?;
    let shown = radius.to_digits(12).unwrap_or_default();
    let rule = (radius.to_f64(), format!("R = {}", &shown[..shown.len().min(8)]));
    let group = |id: &str, families: &[Family]| {
        let mut chart = chart(id, contestants, reference, errors, families);
        chart.rules.push(rule.clone());
        chart
    };
    let data = Data::long(
        "error-by-u.csv",
        table(contestants, reference, errors, |_| true),
        table(contestants, reference, errors, |u| EXTRACT.contains(&u)),
    );
    let series = group("error-series", &[Family::Series]);
    let formulas =
        group("error-formulas", &[Family::Formula35, Family::Approximate, Family::MuellerPoeschel]);
    let pade = group("error-pade", &[Family::Pade, Family::TwoPoint]);
    let machine = group("error-machine", &[Family::Evaluator, Family::Tier, Family::Integration]);
    Ok(Section::new(
        "Error against damping",
        &format!(
            "Relative errors against the certified integrator. The series in u converges for |u| < R = {shown}, in velocities for g < 10.53 g*: it does not diverge at every high velocity, nor converge at all of them. Beyond R further orders make it worse."
        ),
        vec![
            Figure::new(
                series,
                "The truncated series. Left of R each order gains digits, right of it each order loses them.",
            )
            .with(data),
            Figure::new(
                formulas,
                "The formulas of the literature. Formula (35) carries the constants of Table I, which come from wrong a₃ and a₄ and a₅ = 0; its counterparts have the exact ones. With every coefficient exact the [1/4] formula falls below zero at s = 3.31, u = 2.87. Müller and Pöschel's formulas are judged by contacts that end at zero force.",
            ),
            Figure::new(
                pade,
                "Padé approximants in u from exact coefficients, and two-point approximants, which also meet ε u⁵ → R⁵ at infinity (the last number says with how many conditions).",
            ),
            Figure::new(
                machine,
                "The f64 evaluator, and an ODE library integrating the equation of motion to several tolerances. Values that agree with the certified one to the last bit have no place on a logarithmic axis; lines break there.",
            ),
            ends(reference),
        ],
    ))
}

fn chart(
    id: &str,
    contestants: &[Contestant],
    reference: &Reference,
    errors: &[Vec<f64>],
    families: &[Family],
) -> Chart {
    let members =
        contestants.iter().zip(errors).filter(|(c, _)| families.contains(&c.family)).collect::<Vec<_>>();
    let all = members.iter().flat_map(|(_, errors)| errors.iter().map(|e| e.clamp(1e-18, 90.0)));
    let y = Axis::decades("relative error", all);
    let x = Axis::linear("damping u (no unit)", 0.0, 7.5);
    let names = families
        .iter()
        .map(|f| f.name().split(',').next().unwrap_or_default())
        .collect::<Vec<_>>()
        .join(", ");
    let mut chart = Chart::new(id, &format!("Relative error against u: {names}"), x, y);
    for (i, (contestant, errors)) in members.into_iter().enumerate() {
        let points = reference.u.iter().copied().zip(errors.iter().copied());
        let stroke = if contestant.end == End::ZeroForce { Stroke::Dashed } else { Stroke::Solid };
        chart.series.push(Series::line(&contestant.name, i % 9, points).stroked(stroke));
    }
    chart
}

fn table(
    contestants: &[Contestant],
    reference: &Reference,
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

fn ends(reference: &Reference) -> Figure {
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
    let caption = "The two ends of contact. The paper ends it at zero compression, after a spell of attraction that dry bodies do not have; ending it where the force vanishes gives a larger ε, by a fifth at u = 1 and by much more beyond. Both curves are certified.";
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
    Figure::new(chart, caption).with(Data::long(
        "ends-of-contact.csv",
        rows(&|_| true),
        rows(&|u| EXTRACT.contains(&u)),
    ))
}
