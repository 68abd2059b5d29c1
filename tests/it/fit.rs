//! Fits of the characteristic velocity: exact data, noise, outliers, and data that say nothing.

use crate::support::{cases, generator};
use proptest::prelude::RngExt;
use restitution::{Contact, End, Restitution, ViscoelasticContact};
use restitution_fit::{Fit, FitError, Loss, Measurement, fit, stiffness};

const ENDS: [End; 2] = [End::ZeroCompression, End::ZeroForce];
const LOSSES: [Loss; 2] = [Loss::Squares, Loss::Huber];

/// Coefficients of the evaluator at velocities of equal ratio, with `noise` added to each.
fn table(
    g_star: f64,
    end: End,
    from: f64,
    to: f64,
    n: usize,
    mut noise: impl FnMut() -> f64,
) -> Vec<Measurement> {
    let curve = Restitution::from_g_star(g_star, end);
    let velocity = |k: usize| from * (to / from).powf(k as f64 / (n - 1) as f64);
    (0..n).map(|k| Measurement::new(velocity(k), curve.epsilon(velocity(k)) + noise()).unwrap()).collect()
}

/// A standard normal variable: twelve uniform ones (Irwin and Hall), cut at six standard deviations.
fn normal(rng: &mut impl RngExt) -> f64 {
    (0..12).map(|_| rng.random::<f64>()).sum::<f64>() - 6.0
}

#[test]
fn exact_tables_give_back_the_velocity() {
    for g_star in [1e-6, 3.2e-3, 1.0, 7e4] {
        for end in ENDS {
            for loss in LOSSES {
                let rows = table(g_star, end, g_star * 1e-6, g_star * 1e2, 20, || 0.0);
                let result = fit(&rows, end, loss).unwrap();
                assert!((result.characteristic_velocity / g_star - 1.0).abs() < 1e-12, "{result:?}");
                assert!(result.log_error < 1e-12 && result.largest_residual.abs() < 1e-14);
                assert_eq!(result.rows, 20);
            }
        }
    }
}

#[test]
fn two_rows_suffice() {
    let rows = table(1.0, End::ZeroForce, 0.1, 10.0, 2, || 0.0);
    assert!((fit(&rows, End::ZeroForce, Loss::Squares).unwrap().characteristic_velocity - 1.0).abs() < 1e-12);
}

#[test]
fn a_unit_is_only_a_factor() {
    let mut generator = generator(21, 1);
    let rows = table(1.0, End::ZeroCompression, 1e-3, 10.0, 30, || 0.02 * normal(generator.rng()));
    let other = rows.iter().map(|row| Measurement::new(100.0 * row.velocity(), row.epsilon()).unwrap());
    let other = other.collect::<Vec<_>>();
    for loss in LOSSES {
        let (one, two) = (
            fit(&rows, End::ZeroCompression, loss).unwrap(),
            fit(&other, End::ZeroCompression, loss).unwrap(),
        );
        assert!((two.characteristic_velocity / one.characteristic_velocity / 100.0 - 1.0).abs() < 1e-9);
        assert!((two.log_error / one.log_error - 1.0).abs() < 1e-6);
    }
}

#[test]
fn the_minimum_is_one() {
    // no parameter on a fine grid does better
    let mut generator = generator(22, 1);
    for _ in 0..cases(5) {
        let rows = table(1.0, End::ZeroCompression, 1e-5, 10.0, 15, || 0.05 * normal(generator.rng()));
        let best = fit(&rows, End::ZeroCompression, Loss::Squares).unwrap();
        let loss = |g_star: f64| {
            let curve = Restitution::from_g_star(g_star, End::ZeroCompression);
            rows.iter().map(|row| (row.epsilon() - curve.epsilon(row.velocity())).powi(2)).sum::<f64>()
        };
        let reached = loss(best.characteristic_velocity);
        for k in -2000..2000 {
            assert!(loss((f64::from(k) * 0.005).exp()) >= reached * (1.0 - 1e-12));
        }
    }
}

#[test]
fn the_standard_error_is_the_error() {
    // over many tables, the deviation in units of its standard error has variance 1
    for loss in LOSSES {
        let mut generator = generator(23, 1);
        let tables = cases(200);
        let (mut square, mut inside) = (0.0, 0);
        for _ in 0..tables {
            let rows = table(1.0, End::ZeroCompression, 1e-4, 30.0, 40, || 0.02 * normal(generator.rng()));
            let result = fit(&rows, End::ZeroCompression, loss).unwrap();
            let z = result.characteristic_velocity.ln() / result.log_error;
            square += z * z;
            inside += usize::from(z.abs() < 1.0);
        }
        let (variance, share) = (square / tables as f64, inside as f64 / tables as f64);
        println!("{loss:?}: variance {variance:.3}, within one standard error {share:.3}");
        // four standard deviations of the two statistics over 200 tables are 0.4 and 0.13
        assert!((variance - 1.0).abs() < 0.4 && (share - 0.683).abs() < 0.13);
    }
}

#[test]
fn outliers_pull_huber_less() {
    let mut generator = generator(24, 1);
    let mut rows = table(1.0, End::ZeroForce, 1e-3, 10.0, 30, || 0.01 * normal(generator.rng()));
    for k in [3, 11, 25] {
        rows[k] = Measurement::new(rows[k].velocity(), 1.6).unwrap();
    }
    let off = |loss| fit(&rows, End::ZeroForce, loss).unwrap().characteristic_velocity.ln().abs();
    assert!(off(Loss::Huber) < 0.1 && off(Loss::Squares) > 5.0 * off(Loss::Huber));
    let result = fit(&rows, End::ZeroForce, Loss::Huber).unwrap();
    assert!((3..15).contains(&result.outliers), "{result:?}");
    assert!([3, 11, 25].contains(&result.largest_residual_row));
}

#[test]
fn coefficients_above_one_are_noise() {
    let mut generator = generator(25, 1);
    let rows = table(1e6, End::ZeroCompression, 1e-3, 1e4, 200, || 0.05 * normal(generator.rng()));
    assert!(rows.iter().filter(|row| row.epsilon() > 1.0).count() > 10);
    let result = fit(&rows, End::ZeroCompression, Loss::Squares).unwrap();
    assert!((result.characteristic_velocity / 1e6).ln().abs() < 4.0 * result.log_error);
}

#[test]
fn data_that_say_nothing_are_refused() {
    let rows = |pairs: &[(f64, f64)]| {
        pairs.iter().map(|&(g, epsilon)| Measurement::new(g, epsilon).unwrap()).collect::<Vec<_>>()
    };
    let refused = |pairs: &[(f64, f64)]| fit(&rows(pairs), End::ZeroForce, Loss::Squares).unwrap_err();
    assert_eq!(refused(&[]), FitError::TooFewRows { rows: 0 });
    assert_eq!(refused(&[(1.0, 0.5)]), FitError::TooFewRows { rows: 1 });
    assert_eq!(refused(&[(1.0, 0.5), (1.0, 0.6)]), FitError::OneVelocity { velocity: 1.0 });
    assert_eq!(refused(&[(1.0, 1.0), (2.0, 1.1)]), FitError::NoDamping { rows: 2 });
    let scattered = [(0.1, 0.99), (1.0, 1.3), (2.0, 0.7), (3.0, 1.4), (4.0, 0.65)];
    assert!(matches!(refused(&scattered), FitError::Uninformative { .. }));
    for (g, epsilon) in [(0.0, 0.5), (-1.0, 0.5), (f64::NAN, 0.5), (f64::INFINITY, 0.5)] {
        assert!(matches!(Measurement::new(g, epsilon), Err(FitError::Velocity { .. })));
    }
    // where epsilon no longer depends on g*, an error of NaN per cent would be no answer
    let absurd = [(1e-300, 1.0 - 1e-16), (1e300, 1e-300), (1e250, 1e-299)];
    assert!(matches!(
        refused(&absurd),
        FitError::Insensitive | FitError::OutOfRange | FitError::Uninformative { .. }
    ));
    for message in [refused(&absurd).to_string(), FitError::Insensitive.to_string()] {
        assert!(!message.contains("NaN") && !message.contains("inf"), "{message}");
    }
    let half = Measurement::new(2.0, 0.5).unwrap().with_sigma(0.1).unwrap();
    let mixed = [Measurement::new(1.0, 0.6).unwrap(), half];
    assert_eq!(fit(&mixed, End::ZeroForce, Loss::Squares), Err(FitError::MixedSigma));
    for epsilon in [0.0, -0.1, 2.1, f64::NAN, f64::INFINITY] {
        assert!(matches!(Measurement::new(1.0, epsilon), Err(FitError::Epsilon { .. })));
    }
}

#[test]
fn the_interval_holds_the_velocity_as_often_as_it_says() {
    // 1,000 tables each: few and many rows, little and much noise, equal and given standard deviations
    let tables = cases(1000);
    for (case, (n, noise, known)) in
        [(3, 0.01, false), (5, 0.02, false), (10, 0.05, false), (40, 0.02, false), (8, 0.03, true)]
            .into_iter()
            .enumerate()
    {
        let mut generator = generator(40 + case as u64, 1);
        let end = ENDS[case % 2];
        let (mut held, mut fitted) = (0, 0);
        for _ in 0..tables {
            let rows = table(1.0, end, 1e-3, 10.0, n, || noise * normal(generator.rng()));
            let rows = rows.into_iter().map(|row| if known { row.with_sigma(noise).unwrap() } else { row });
            let Ok(result) = fit(&rows.collect::<Vec<_>>(), end, Loss::Squares) else { continue };
            fitted += 1;
            held += usize::from(result.interval.0 <= 1.0 && 1.0 <= result.interval.1);
        }
        let share = held as f64 / fitted as f64;
        println!("n = {n}, noise {noise}, sigma given {known}: {held} of {fitted}, {:.1} %", 100.0 * share);
        // four standard deviations of a share of 0.95 in 1,000
        assert!(
            fitted > tables * 99 / 100 && (share - 0.95).abs() < 4.0 * (0.95 * 0.05 / fitted as f64).sqrt()
        );
    }
}

/// Rows of a contact in cm/s with their durations in s, and relative noise of both.
fn lasting(
    pair: &ViscoelasticContact,
    end: End,
    n: usize,
    mut noise: impl FnMut() -> (f64, f64),
) -> (Vec<Measurement>, Vec<f64>) {
    let row = |k: usize| {
        let g = 0.02 * 100.0_f64.powf(k as f64 / (n - 1) as f64);
        let (of_epsilon, of_duration) = noise();
        let epsilon = pair.epsilon(g, end).unwrap() + of_epsilon;
        let duration = pair.course(g, end).unwrap().unwrap().duration * f64::exp(of_duration);
        (Measurement::new(100.0 * g, epsilon).unwrap(), duration)
    };
    (0..n).map(row).unzip()
}

#[test]
fn durations_give_stiffness_and_damping() {
    let contact = Contact::new(0.01, 0.02, 3e8).unwrap();
    let pair = ViscoelasticContact::new(contact, 2e-5).unwrap();
    let rate = contact.force_prefactor() / contact.effective_mass();
    for end in ENDS {
        // few rows are integrated, many interpolated
        for n in [2, 5, 3000] {
            let (rows, durations) = lasting(&pair, end, n, || (0.0, 0.0));
            let fitted = fit(&rows, end, Loss::Squares).unwrap();
            let found = stiffness(&rows, &durations, 0.01, &fitted).unwrap();
            assert!((found.per_mass / rate - 1.0).abs() < 1e-7, "{end:?} {n}: {found:?}");
            assert!((found.dissipative_constant / 2e-5 - 1.0).abs() < 1e-7, "{end:?} {n}: {found:?}");
            assert!((found.rows, found.beyond) == (n, 0) && found.scatter < 1e-6);
        }
    }
    let (rows, mut durations) = lasting(&pair, End::ZeroForce, 4, || (0.0, 0.0));
    let fitted = fit(&rows, End::ZeroForce, Loss::Squares).unwrap();
    durations[2] = f64::NAN;
    assert!(matches!(stiffness(&rows, &durations, 0.01, &fitted), Err(FitError::Duration { .. })));
}

#[test]
fn the_intervals_of_stiffness_and_damping_hold_them() {
    let contact = Contact::new(0.01, 0.02, 3e8).unwrap();
    let pair = ViscoelasticContact::new(contact, 2e-5).unwrap();
    let rate = contact.force_prefactor() / contact.effective_mass();
    let tables = cases(250);
    let inside = |value: f64, (low, high): (f64, f64)| usize::from(low <= value && value <= high);
    for (case, (n, of_epsilon, of_duration)) in [(6, 0.01, 0.03), (20, 0.03, 0.005)].into_iter().enumerate() {
        let mut generator = generator(71 + case as u64, 1);
        let end = ENDS[case];
        let (mut stiff, mut damped) = (0, 0);
        for _ in 0..tables {
            let mut noise = || (of_epsilon * normal(generator.rng()), of_duration * normal(generator.rng()));
            let (rows, durations) = lasting(&pair, end, n, &mut noise);
            let fitted = fit(&rows, end, Loss::Squares).unwrap();
            let found = stiffness(&rows, &durations, 0.01, &fitted).unwrap();
            stiff += inside(rate, found.per_mass_interval);
            damped += inside(2e-5, found.dissipative_interval);
        }
        println!("n = {n}: rho/m_eff {stiff}, A {damped} of {tables}");
        // four standard deviations of a share of 0.95, and a little for the quantile of two variances
        for held in [stiff, damped] {
            let share = held as f64 / tables as f64;
            assert!((share - 0.95).abs() < 4.0 * (0.95 * 0.05 / tables as f64).sqrt() + 0.01, "{share}");
        }
    }
}

#[test]
fn given_standard_deviations_weigh() {
    // a row that is known ten times better pulls a hundred times harder
    let curve = Restitution::from_g_star(1.0, End::ZeroForce);
    let row = |g: f64, off: f64, sigma: f64| {
        Measurement::new(g, curve.epsilon(g) + off).unwrap().with_sigma(sigma).unwrap()
    };
    let rows = [row(0.1, 0.0, 0.001), row(0.3, 0.0, 0.001), row(1.0, 0.05, 0.1), row(3.0, 0.05, 0.1)];
    let weighted = fit(&rows, End::ZeroForce, Loss::Squares).unwrap();
    assert!(weighted.characteristic_velocity.ln().abs() < 0.01, "{weighted:?}");
    let plain = rows.map(|row| Measurement::new(row.velocity(), row.epsilon()).unwrap());
    assert!(fit(&plain, End::ZeroForce, Loss::Squares).unwrap().characteristic_velocity.ln().abs() > 0.1);
    // the standard error is that of the given deviations, not of the residuals
    let doubled = rows.map(|row| row.with_sigma(2.0 * row.sigma().unwrap()).unwrap());
    let doubled = fit(&doubled, End::ZeroForce, Loss::Squares).unwrap();
    assert!((doubled.log_error / weighted.log_error - 2.0).abs() < 1e-6);
}

#[test]
fn many_rows_are_fitted_like_few() {
    let mut generator = generator(27, 1);
    let rows = table(1.0, End::ZeroForce, 1e-4, 10.0, 20_000, || 0.05 * normal(generator.rng()));
    for loss in LOSSES {
        let many = fit(&rows, End::ZeroForce, loss).unwrap();
        assert!(many.characteristic_velocity.ln().abs() < 4.0 * many.log_error, "{many:?}");
        let loss_of = |g_star: f64| {
            let curve = Restitution::from_g_star(g_star, End::ZeroForce);
            rows.iter().map(|row| (row.epsilon() - curve.epsilon(row.velocity())).powi(2)).sum::<f64>()
        };
        if loss == Loss::Squares {
            let best = many.characteristic_velocity;
            assert!([0.999, 1.001].iter().all(|factor| loss_of(best * factor) >= loss_of(best)));
        }
    }
}

#[test]
fn extreme_tables_do_not_panic() {
    let velocities = [f64::MIN_POSITIVE, 1e-300, 1e-8, 1.0, 1e300, f64::MAX];
    let coefficients = [1e-300, 1e-16, 0.3, 1.0 - 1e-16, 1.0, 2.0];
    let mut fitted = 0;
    for (i, &g) in velocities.iter().enumerate() {
        for &h in &velocities[i + 1..] {
            for a in coefficients {
                for b in coefficients {
                    let rows = [Measurement::new(g, a).unwrap(), Measurement::new(h, b).unwrap()];
                    for loss in LOSSES {
                        if let Ok(result) = fit(&rows, End::ZeroCompression, loss) {
                            let Fit { characteristic_velocity, log_error, .. } = result;
                            assert!(characteristic_velocity.is_normal() && log_error.is_finite());
                            fitted += 1;
                        }
                    }
                }
            }
        }
    }
    assert!(fitted > 0);
}
