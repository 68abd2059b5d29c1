//! Numerical stability: digits that computations lose.

use crate::ReportError;
use crate::chart::{Axis, Chart, Series, Shape, Stroke};
use crate::digits_lost::digits_lost;
use crate::effort::Effort;
use crate::page::{Data, Figure, Section};
use crate::speed::{error_cell, figures};
use crate::{f64_pade, hard_cases};
use restitution_law::ForceLaw;
use restitution_pade::{PadeError, PadeType, approximant};
use restitution_real::{Ball, Balls};
use restitution_series::{Quantity, coefficients};
use restitution_table::{Cell, Table};

/// The laws whose coefficients are followed.
const LAWS: [(&str, &str); 3] = [
    ("3/2,1/2", "spheres, a = 3/2, γ = 1/2"),
    ("2,1", "a = 2, γ = 1"),
    ("1,0", "spring and dashpot, a = 1, γ = 0"),
];
/// Bits of the balls that Padé approximants are made of.
const BITS: u32 = 400;
const LARGEST_PADE: usize = 12;

/// Measures and returns the part of the report on numerical stability.
///
/// # Errors
///
/// What the coefficients and approximants say.
pub fn section(effort: &Effort) -> Result<Section, ReportError> {
    let text = "A digit is lost when a result is known to one digit less than the numbers that went into it. Certified numbers carry a radius, so their loss is read off; for f64 it is the distance to the certified result.";
    Ok(Section::new(
        "Numerical stability",
        text,
        vec![by_order(effort)?, pade(effort)?, hard_cases::figure(effort)],
    ))
}

fn by_order(effort: &Effort) -> Result<Figure, ReportError> {
    let mut table = Table::new(&["law_a_gamma", "k", "working_bits", "digits_lost"]);
    let mut lines = Vec::new();
    for (i, (law, name)) in LAWS.into_iter().enumerate() {
        let exponents: ForceLaw = law.parse()?;
        let values = coefficients(Quantity::Restitution, &exponents, effort.order, 20)?;
        let lost = values
            .iter()
            .enumerate()
            .skip(1)
            .map(|(k, ball)| (k as f64, digits_lost(ball)))
            .collect::<Vec<_>>();
        for (ball, (k, lost)) in values.iter().skip(1).zip(&lost) {
            table.push(vec![
                law.into(),
                (*k as usize).into(),
                (ball.prec() as usize).into(),
                Cell::digits(format!("{lost:.1}")),
            ]);
        }
        lines.push(Series::line(name, i, lost));
    }
    let highest = lines.iter().flat_map(|line| &line.points).map(|p| p.y).fold(1.0, f64::max);
    let x = Axis::linear("order k of the coefficient C_k", 0.0, effort.order as f64);
    let mut chart = Chart::new(
        "digits-lost",
        "Digits lost against order",
        x,
        Axis::linear("decimal digits lost", 0.0, 1.1 * highest),
    );
    let slope = lines[0].points.last().map(|p| p.y / p.x).unwrap_or_default();
    chart.series = lines;
    let caption = format!(
        "Digits between the working precision and the radius of C_k, by order; what is cut off and bounded counts as lost too. For spheres {slope:.1} digits an order at the last one shown. The command starts with that many more and shows only what is proved."
    );
    Ok(Figure::new(chart, &caption).with(Data::new("digits-lost.csv", table)))
}

fn pade(effort: &Effort) -> Result<Figure, ReportError> {
    let largest = LARGEST_PADE.min(effort.order / 2);
    let series = coefficients(Quantity::Restitution, &ForceLaw::viscoelastic_spheres(), 2 * largest, 120)?;
    let balls = series.iter().map(|c| Ball::exact(c.mid().clone()).with_prec(BITS)).collect::<Vec<_>>();
    let floats = series.iter().map(Ball::to_f64).collect::<Vec<_>>();
    let mut table = Table::new(&[
        "type",
        "f64_coefficient_digits_lost",
        "f64_error_at_u_1",
        "f64_error_at_u_5",
        "ball_digits_lost",
    ]);
    let (mut in_f64, mut in_balls) = (Vec::new(), Vec::new());
    for n in 1..=largest {
        let asked = PadeType::new(n, n);
        let certified = approximant(&Balls::new(BITS), &balls, asked)?;
        let exact = certified.num().iter().chain(certified.den());
        let ball_loss = exact.clone().map(digits_lost).fold(0.0, f64::max);
        let found = f64_pade::approximant(&floats, n, n);
        let coefficients = found.0.iter().chain(&found.1);
        let worst =
            exact.zip(coefficients).map(|(exact, c)| (c / exact.to_f64() - 1.0).abs()).fold(0.0, f64::max);
        let float_loss = (worst / f64::EPSILON).log10().max(0.0);
        let error = |u: i64| -> Result<Cell, PadeError> {
            let exact = certified.function().value(&Ball::from_integer(u, BITS))?.to_f64();
            Ok(error_cell((f64_pade::value(&found, u as f64) / exact - 1.0).abs()))
        };
        table.push(vec![
            Cell::digits(asked),
            Cell::digits(figures(float_loss, 3)),
            error(1)?,
            error(5)?,
            Cell::digits(figures(ball_loss, 3)),
        ]);
        in_f64.push((n as f64, float_loss));
        in_balls.push((n as f64, ball_loss));
    }
    let highest = in_f64.iter().chain(&in_balls).map(|p| p.1).fold(16.5, f64::max);
    let x = Axis::linear("degree n of the approximant [n/n]", 0.0, largest as f64);
    let mut chart = Chart::new(
        "pade-stability",
        "Digits lost by Padé approximants",
        x,
        Axis::linear("decimal digits lost", 0.0, 1.1 * highest),
    );
    let sixteen = Series::line("all that an f64 has", 9, [(0.0, 15.95), (largest as f64, 15.95)])
        .stroked(Stroke::Dotted);
    chart.series = vec![
        Series::line("f64, distance to exact", 1, in_f64).marked(Shape::Square),
        Series::line("balls, radius", 0, in_balls).marked(Shape::Circle),
        sixteen,
    ];
    let caption = "Padé approximants [n/n] of ε(u) computed in f64 from correctly rounded coefficients, against the same computed with balls. The linear systems are ill-conditioned: rounding the coefficients of the series is enough to lose the digits, whichever way the system is solved. The values of the approximant suffer less (columns of the table), because errors of numerator and denominator cancel near 0.";
    Ok(Figure::new(chart, caption).with(Data::new("pade-stability.csv", table)))
}
