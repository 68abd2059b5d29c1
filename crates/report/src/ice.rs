//! Figure 1 of the paper: ice.

use crate::ReportError;
use crate::chart::{Axis, Chart, Series, Stroke};
use crate::formulas::printed_35;
use crate::page::{Data, Figure, Section};
use crate::speed::figures;
use restitution::{End, Restitution};
use restitution_fit::{Fit, Loss, Measurement, adequacy, fit};
use restitution_table::Table;

/// The paper's characteristic velocity of ice, in cm/s (\[RPBS1999\], Fig. 1).
const PRINTED_G_STAR: f64 = 0.32;
/// Velocities of the figure, and of the fit, in cm/s.
const SHOWN: (f64, f64) = (1e-3, 10.0);
const FITTED: (f64, f64) = (0.01, 5.0);
const FITTED_ROWS: usize = 28;

/// A coefficient of restitution as a function of the velocity in cm/s.
type Curve = Box<dyn Fn(f64) -> f64>;

/// The law fitted to measurements of ice, `g` in cm/s (\[BHL1984\], as \[RPBS1999\] quotes it).
fn bridges(g: f64) -> f64 {
    0.32 * g.powf(-0.234)
}

/// The part of the report on ice.
///
/// # Errors
///
/// What the fit says.
pub fn section() -> Result<Section, ReportError> {
    let (fitted, doubtful) = refit()?;
    let g_star = fitted.characteristic_velocity;
    let (low, high) = fitted.interval;
    let curves: [(String, usize, Stroke, Curve); 4] = [
        ("Bridges' law 0.32 g^−0.234".to_owned(), 9, Stroke::Solid, Box::new(bridges)),
        (
            "formula (35), g* = 0.32 cm/s".to_owned(),
            1,
            Stroke::Dashed,
            Box::new(|g| printed_35((g / PRINTED_G_STAR).powf(0.2))),
        ),
        ("exact ε, g* = 0.32 cm/s".to_owned(), 0, Stroke::Solid, exact(PRINTED_G_STAR)),
        (format!("exact ε, g* = {} cm/s", figures(g_star, 3)), 2, Stroke::Solid, exact(g_star)),
    ];
    let grid = ratio_grid(SHOWN, 161);
    let x = Axis::log("impact velocity g (cm/s)", SHOWN.0, SHOWN.1);
    let mut chart = Chart::new(
        "ice",
        "Coefficient of restitution of ice against impact velocity",
        x,
        Axis::linear("coefficient of restitution ε (no unit)", 0.0, 1.7),
    );
    let mut table =
        Table::new(&["velocity_cm_s", "bridges", "formula_35", "exact_g_star_0.32", "exact_g_star_refitted"]);
    for (name, colour, stroke, f) in &curves {
        chart.series.push(Series::line(name, *colour, grid.iter().map(|g| (*g, f(*g)))).stroked(*stroke));
    }
    for g in ratio_grid(SHOWN, 41) {
        let values = curves.iter().map(|curve| restitution_table::Cell::digits(figures((curve.3)(g), 5)));
        table.push(std::iter::once(restitution_table::Cell::digits(figures(g, 4))).chain(values).collect());
    }
    let run = if doubtful {
        " By the tests of docs/materials.md the law is not the curve of a viscoelastic collision, and the interval understates how uncertain g* is."
    } else {
        ""
    };
    let caption = format!(
        "Ice, as in Fig. 1 of the paper. Refitted g* = {} cm/s (95 % confidence: {} to {} cm/s; largest residual {:.3}) by least squares to Bridges' law at {FITTED_ROWS} velocities from {} to {} cm/s.{run} Bridges' law exceeds 1 below {} cm/s.",
        figures(g_star, 3),
        figures(low, 3),
        figures(high, 3),
        fitted.largest_residual.abs(),
        FITTED.0,
        FITTED.1,
        figures(0.32_f64.powf(1.0 / 0.234), 2)
    );
    let text = "The paper fits g* = 0.32 cm/s with formula (35) and its Table I. With the same g* the exact ε is lower at every velocity of the figure, and a fit of the exact ε gives another g*.";
    Ok(Section::new(
        "Ice: Fig. 1 of the paper",
        text,
        vec![Figure::new(chart, &caption).with(Data::new("ice.csv", table))],
    ))
}

fn exact(g_star: f64) -> Curve {
    let ice = Restitution::from_g_star(g_star, End::ZeroCompression);
    Box::new(move |g| ice.epsilon(g))
}

/// The fit, and whether the law does not follow the data.
fn refit() -> Result<(Fit, bool), ReportError> {
    let rows = ratio_grid(FITTED, FITTED_ROWS).into_iter().map(|g| Measurement::new(g, bridges(g)));
    let rows = rows.collect::<Result<Vec<_>, _>>().map_err(ReportError::failure)?;
    let fitted = fit(&rows, End::ZeroCompression, Loss::Squares).map_err(ReportError::failure)?;
    let verdict = adequacy(&rows, &fitted).map_err(ReportError::failure)?;
    Ok((fitted, verdict.is_doubtful()))
}

fn ratio_grid((low, high): (f64, f64), count: usize) -> Vec<f64> {
    (0..count).map(|i| low * (high / low).powf(i as f64 / (count - 1) as f64)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fit_is_nearer_than_the_paper_s() {
        let squares = |g_star| {
            let f = exact(g_star);
            ratio_grid(FITTED, FITTED_ROWS).into_iter().map(|g| (f(g) - bridges(g)).powi(2)).sum::<f64>()
        };
        let best = refit().unwrap().0.characteristic_velocity;
        assert!(squares(best) < squares(PRINTED_G_STAR));
        assert!(squares(best) < squares(best * 1.05) && squares(best) < squares(best / 1.05));
    }

    #[test]
    fn the_exact_curve_is_lower_than_the_printed_one() {
        let exact = exact(PRINTED_G_STAR);
        for g in ratio_grid(SHOWN, 30) {
            assert!(exact(g) < printed_35((g / PRINTED_G_STAR).powf(0.2)), "{g}");
        }
    }
}
