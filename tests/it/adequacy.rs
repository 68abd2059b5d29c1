//! Whether a law fits: false alarms at any number of rows, and laws that do not fit.

use crate::support::{cases, generator};
use proptest::prelude::RngExt;
use restitution::{End, Restitution};
use restitution_fit::{Departure, FALSE_ALARMS, Law, Loss, Measurement, adequacy, compare, fit};

const ENDS: [End; 2] = [End::ZeroCompression, End::ZeroForce];

type Curve = Box<dyn Fn(f64) -> f64>;

/// A standard normal variable: twelve uniform ones (Irwin and Hall), cut at six standard deviations.
fn normal(rng: &mut impl RngExt) -> f64 {
    (0..12).map(|_| rng.random::<f64>()).sum::<f64>() - 6.0
}

fn rows(pairs: impl IntoIterator<Item = (f64, f64)>) -> Vec<Measurement> {
    pairs.into_iter().map(|(g, epsilon)| Measurement::new(g, epsilon).unwrap()).collect()
}

/// `n` velocities of equal ratio, each measured `times` times.
fn velocities(from: f64, to: f64, n: usize, times: usize) -> Vec<f64> {
    let velocity = |k: usize| from * (to / from).powf((k / times) as f64 / (n - 1) as f64);
    (0..n * times).map(velocity).collect()
}

fn is_doubtful(rows: &[Measurement], end: End) -> bool {
    fit(rows, end, Loss::Squares).is_ok_and(|result| adequacy(rows, &result).unwrap().is_doubtful())
}

#[test]
fn sound_tables_are_called_unsound_as_often_as_stated() {
    let tables = cases(1000);
    let designs = [
        (3, 1, 0.01, 0.01, 10.0),
        (4, 1, 0.01, 0.01, 10.0),
        (5, 1, 0.03, 0.001, 1.0),
        (8, 1, 0.02, 0.1, 1.0),
        (12, 1, 0.03, 1e-4, 10.0),
        (30, 1, 0.02, 0.3, 3.0),
        (5, 2, 0.02, 0.01, 10.0),
        (4, 5, 0.03, 0.1, 3.0),
        (100, 1, 0.05, 1e-3, 10.0),
    ];
    for (case, (n, times, noise, from, to)) in designs.into_iter().enumerate() {
        let mut generator = generator(60 + case as u64, 1);
        let end = ENDS[case % 2];
        let curve = Restitution::from_g_star(1.0, end);
        let mut alarms = 0;
        for _ in 0..tables {
            let g = velocities(from, to, n, times);
            let table = rows(g.iter().map(|&g| (g, curve.epsilon(g) + noise * normal(generator.rng()))));
            alarms += usize::from(is_doubtful(&table, end));
        }
        let share = alarms as f64 / tables as f64;
        println!("{n} velocities, {times} times each, noise {noise}: {:.1} % false alarms", 100.0 * share);
        // the tests together give at most the stated share: four standard deviations above it
        assert!(share < FALSE_ALARMS + 4.0 * (FALSE_ALARMS / tables as f64).sqrt(), "n = {n}: {share}");
        // three rows are only asked whether they rise, and these fall
        assert!(share > 0.004 || n * times == 3, "a test that never speaks is none: n = {n}");
    }
}

#[test]
fn standard_deviations_that_are_too_small_are_noticed() {
    let curve = Restitution::from_g_star(1.0, End::ZeroForce);
    let mut generator = generator(80, 1);
    let mut noticed = [0, 0];
    for _ in 0..cases(300) {
        let table = velocities(0.01, 10.0, 12, 1)
            .into_iter()
            .map(|g| (g, curve.epsilon(g) + 0.03 * normal(generator.rng())));
        let table = rows(table);
        for (sigma, count) in [0.03, 0.01].into_iter().zip(&mut noticed) {
            let table = table.iter().map(|row| row.with_sigma(sigma).unwrap()).collect::<Vec<_>>();
            *count += usize::from(is_doubtful(&table, End::ZeroForce));
        }
    }
    let share = |count: usize| count as f64 / cases(300) as f64;
    assert!(share(noticed[0]) < 0.1 && share(noticed[1]) > 0.99, "{noticed:?}");
}

/// Ten rows in which epsilon rises with g.
const RISING: [(f64, f64); 10] = [
    (0.1, 0.205),
    (0.2, 0.33),
    (0.3, 0.41),
    (0.5, 0.5),
    (0.8, 0.59),
    (1.2, 0.66),
    (2.0, 0.74),
    (3.0, 0.79),
    (5.0, 0.84),
    (8.0, 0.875),
];

#[test]
fn laws_that_do_not_fit_are_noticed() {
    let ice = (0..28).map(|k| 0.01 * 500_f64.powf(f64::from(k) / 27.0)).map(|g| (g, 0.32 * g.powf(-0.234)));
    let plastic = [0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0].map(|g: f64| (g, 0.45 * g.powf(-0.25)));
    let cushion = [(0.5, 0.51), (1.0, 0.6), (1.5, 0.66), (2.0, 0.71), (2.5, 0.74), (3.0, 0.76)];
    let constant = [0.1, 0.3, 1.0, 3.0, 10.0].map(|g| (g, 0.8));
    let unsound = [rows(ice), rows(plastic), rows(cushion), rows(RISING), rows(constant)];
    for (table, rises) in unsound.iter().zip([false, false, true, true, false]) {
        for end in ENDS {
            let verdict = adequacy(table, &fit(table, end, Loss::Squares).unwrap()).unwrap();
            assert!(verdict.is_doubtful(), "{table:?}: {verdict:?}");
            assert_eq!(verdict.rises(), rises, "{verdict:?}");
        }
    }
}

#[test]
fn the_order_of_rows_does_not_matter() {
    let curve = Restitution::from_g_star(1.0, End::ZeroForce);
    let mut generator = generator(81, 1);
    let mut table = rows(
        velocities(0.01, 10.0, 6, 3)
            .into_iter()
            .map(|g| (g, curve.epsilon(g) + 0.02 * normal(generator.rng()))),
    );
    let p =
        |table: &[Measurement]| adequacy(table, &fit(table, End::ZeroForce, Loss::Squares).unwrap()).unwrap();
    let (before, tests) = (p(&table).p().unwrap(), p(&table).tests.len());
    table.reverse();
    table.swap(3, 9);
    assert!((p(&table).p().unwrap() / before - 1.0).abs() < 1e-6);
    assert_eq!(tests, 3);
}

#[test]
fn repetitions_judge_a_kink() {
    // one velocity off by five standard errors of its mean: smooth terms see little of it, repetitions all
    let curve = Restitution::from_g_star(1.0, End::ZeroCompression);
    let mut generator = generator(82, 1);
    let off = |g: f64| if (0.1..0.2).contains(&g) { 0.06 } else { 0.0 };
    let table = rows(
        velocities(0.001, 10.0, 12, 4)
            .into_iter()
            .map(|g| (g, curve.epsilon(g) + off(g) + 0.01 * normal(generator.rng()))),
    );
    let verdict = adequacy(&table, &fit(&table, End::ZeroCompression, Loss::Squares).unwrap()).unwrap();
    let lack = verdict.tests.iter().find(|test| test.departure == Departure::LackOfFit).unwrap();
    assert!(lack.p < 1e-6 && lack.degrees == (11, 36), "{verdict:?}");
}

#[test]
fn a_curve_through_every_row_is_not_tested() {
    let curve = Restitution::from_g_star(0.3, End::ZeroCompression);
    let table = rows(velocities(0.01, 10.0, 9, 1).into_iter().map(|g| (g, curve.epsilon(g))));
    let verdict = adequacy(&table, &fit(&table, End::ZeroCompression, Loss::Squares).unwrap()).unwrap();
    assert!(verdict.tests.is_empty() && !verdict.is_doubtful() && verdict.p().is_none());
    let two = rows([(0.1, 0.5), (0.2, 0.45)]);
    assert_eq!(adequacy(&two, &fit(&two, End::ZeroForce, Loss::Squares).unwrap()).unwrap().p(), None);
}

#[test]
fn the_right_law_comes_first() {
    let g = velocities(0.01, 10.0, 12, 1);
    let mut generator = generator(83, 1);
    let cases: [(Law, Curve); 5] = [
        (
            Law::Viscoelastic(End::ZeroCompression),
            Box::new(|g| Restitution::from_g_star(0.5, End::ZeroCompression).epsilon(g)),
        ),
        (
            Law::Viscoelastic(End::ZeroForce),
            Box::new(|g| Restitution::from_g_star(0.01, End::ZeroForce).epsilon(g)),
        ),
        (Law::Constant, Box::new(|_| 0.8)),
        (Law::Plastic, Box::new(|g| 0.3 * g.powf(-0.25))),
        (Law::Power, Box::new(|g| 0.4 * g.powf(-0.12))),
    ];
    for (law, epsilon) in &cases {
        let table = rows(g.iter().map(|&g| (g, epsilon(g) + 0.002 * normal(generator.rng()))));
        let fits = compare(&table, &Law::USUAL).unwrap();
        assert_eq!(fits.len(), 5);
        assert_eq!(fits[0].law, *law, "{fits:?}");
        assert!(fits.windows(2).all(|pair| pair[0].criterion <= pair[1].criterion));
        assert!((fits[0].epsilon(1.0) - epsilon(1.0)).abs() < 0.005, "{:?}", fits[0]);
    }
    // without noise the law with fewer parameters wins
    let exact = compare(&rows(g.iter().map(|&g| (g, 0.3 * g.powf(-0.25)))), &Law::USUAL).unwrap();
    assert_eq!((exact[0].law, exact[1].law), (Law::Plastic, Law::Power));
    // what rises has no viscoelastic law near the top
    let rising = compare(&rows(RISING), &Law::USUAL).unwrap();
    assert_eq!(rising[0].law, Law::Power);
    assert!(rising[0].exponent.unwrap() < -0.2);
}

#[test]
fn the_criterion_is_that_of_akaike_for_few_rows() {
    let table = rows([(1.0, 0.5), (2.0, 0.52), (3.0, 0.47), (4.0, 0.51), (5.0, 0.5)]);
    let fits = compare(&table, &[Law::Constant, Law::Power]).unwrap();
    let constant = fits.iter().find(|fit| fit.law == Law::Constant).unwrap();
    let sum = [0.5, 0.52, 0.47, 0.51, 0.5_f64].iter().map(|e| (e - 0.5).powi(2)).sum::<f64>();
    let expected = 5.0 * (sum / 5.0).ln() + 4.0 + 12.0 / 2.0; // n = 5, k = 2
    assert!((constant.criterion.unwrap() - expected).abs() < 1e-9);
    let power = fits.iter().find(|fit| fit.law == Law::Power).unwrap();
    let expected = 10.0 * power.residual.ln() + 6.0 + 24.0; // k = 3
    assert!((power.criterion.unwrap() - expected).abs() < 1e-9);
    assert!(compare(&table[..4], &[Law::Power]).unwrap()[0].criterion.is_none());
}
