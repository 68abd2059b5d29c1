//! How many digits f64 loses on the way from coefficients to approximants.

use crate::support::in_snapshots;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use restitution_law::ForceLaw;
use restitution_pade::{Approximant, PadeType, approximant};
use restitution_real::{Ball, Balls, Rationals};
use restitution_series::{Quantity, coefficients};

/// `P` and `Q` in f64.
type Quotient = (Vec<f64>, Vec<f64>);

/// The approximant as it is usually computed: Gauss's elimination with partial pivoting, all in f64.
fn in_f64(c: &[f64], asked: PadeType) -> Quotient {
    let (l, m) = (asked.numerator, asked.denominator);
    let at = |n: usize, j: usize| n.checked_sub(j).map_or(0.0, |k| c[k]);
    let mut rows: Vec<Vec<f64>> =
        (l + 1..=l + m).map(|n| (1..=m).map(|j| at(n, j)).chain([-at(n, 0)]).collect()).collect();
    for column in 0..m {
        let best = (column..m).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()));
        rows.swap(column, best.unwrap());
        let (done, below) = rows.split_at_mut(column + 1);
        for row in below {
            let factor = row[column] / done[column][column];
            row.iter_mut().zip(&done[column]).for_each(|(x, y)| *x -= factor * y);
        }
    }
    let mut q = vec![0.0; m + 1];
    for r in (0..m).rev() {
        let known: f64 = (r + 1..m).map(|j| rows[r][j] * q[j + 1]).sum();
        q[r + 1] = (rows[r][m] - known) / rows[r][r];
    }
    q[0] = 1.0;
    let p = (0..=l).map(|n| (0..=n.min(m)).map(|j| at(n, j) * q[j]).sum()).collect();
    (p, q)
}

fn nearest(entry: &Approximant<Rationals>) -> Quotient {
    let convert = |p: &[BigRational]| p.iter().map(|c| c.to_f64().unwrap()).collect();
    (convert(entry.num()), convert(entry.den()))
}

fn value((p, q): &Quotient, x: f64) -> f64 {
    let horner = |p: &[f64]| p.iter().rev().fold(0.0, |value, c| value * x + c);
    horner(p) / horner(q)
}

/// Digits lost: the worst relative error in units of 2^-53, as a power of ten.
fn lost(worst: f64) -> f64 {
    (worst / 2.0_f64.powi(-53)).max(1.0).log10()
}

fn lost_in_constants(entry: &Approximant<Balls>, (p, q): &Quotient) -> f64 {
    let exact = entry.num().iter().chain(entry.den());
    let errors = exact.zip(p.iter().chain(q)).map(|(exact, f)| {
        let exact = exact.with_prec(200);
        ((Ball::from_f64(*f, 200) / &exact) - Ball::from_integer(1, 200)).abs().to_f64()
    });
    lost(errors.fold(0.0, f64::max))
}

/// The approximants, all from the same certified coefficients, in a row for each type.
#[test]
fn digits_lost_in_f64() {
    let series = coefficients(Quantity::Restitution, &ForceLaw::viscoelastic_spheres(), 25, 60).unwrap();
    let rounded: Vec<f64> = series.iter().map(Ball::to_f64).collect();
    let exactly_rounded: Vec<_> = rounded.iter().map(|c| BigRational::from_float(*c).unwrap()).collect();
    let mut lines = vec![
        "type     constants: inputs rounded  all in f64    value at u = 1: inputs rounded  all in f64    at u = 2: inputs rounded  all in f64"
            .to_owned(),
    ];
    for (l, m) in
        [(1, 4), (1, 6), (2, 7), (3, 8), (4, 9), (5, 10), (6, 11), (7, 12), (8, 13), (9, 14), (10, 15)]
    {
        let asked = PadeType::new(l, m);
        let certified = approximant(&Balls::new(256), &series, asked).unwrap();
        let from_rounded = nearest(&approximant(&Rationals, &exactly_rounded, asked).unwrap());
        let float = in_f64(&rounded, asked);
        let off = |quotient: &Quotient, u: i64| {
            let exact = certified.function().value(&Ball::from_integer(u, 200)).unwrap().to_f64();
            lost((value(quotient, u as f64) / exact - 1.0).abs())
        };
        lines.push(format!(
            "{:<8} {:>24.0}  {:>10.0}    {:>30.0}  {:>10.0}    {:>24.0}  {:>10.0}",
            asked.to_string(),
            lost_in_constants(&certified, &from_rounded),
            lost_in_constants(&certified, &float),
            off(&from_rounded, 1),
            off(&float, 1),
            off(&from_rounded, 2),
            off(&float, 2)
        ));
        // Exact arithmetic on rounded coefficients is no better than f64 by more than two digits:
        // the loss is in the problem, not in the elimination.
        let gap = lost_in_constants(&certified, &float) - lost_in_constants(&certified, &from_rounded);
        assert!(gap.abs() < 3.0, "{asked}: {gap}");
    }
    in_snapshots("pade", || insta::assert_snapshot!("digits_lost_in_f64", lines.join("\n")));
}
