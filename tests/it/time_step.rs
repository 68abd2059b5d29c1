//! The stated bound of the error of a time step, against the scheme that the codes run.

use restitution::{End, MaterialError, epsilon, time_step_error, time_step_for};

/// The codes' scheme: the dashpot sees the velocity of half a step before. Returns the exit speed of a contact that
/// begins `phase` of a step before its first force.
fn codes_scheme(u: f64, dt: f64, phase: f64, end: End) -> f64 {
    let (mut x, mut v) = (-phase * dt, 1.0_f64);
    loop {
        let force = if x > 0.0 { x.sqrt() * (x + u * v) } else { 0.0 };
        if v < 0.0 && (x <= 0.0 || (end == End::ZeroForce && force <= 0.0)) {
            return -v;
        }
        v -= dt * force;
        x += dt * v;
    }
}

#[test]
fn the_scheme_gives_the_figures_that_the_codes_gave() {
    // at dt = tau/50 and the worst phase 6e-5, 5e-4, 9e-4, 9e-4; at dt = 1e-4 tau in proportion to 3.7e-8 at 1e-6
    let worst = |u: f64, dt: f64| {
        let exact = epsilon(u, End::ZeroCompression);
        let errors =
            (0..50).map(|k| (codes_scheme(u, dt, f64::from(k) / 50.0, End::ZeroCompression) - exact).abs());
        errors.fold(0.0, f64::max)
    };
    for (u, seen) in [(0.1, 6e-5), (0.5, 5e-4), (1.0, 9e-4), (2.0, 9e-4)] {
        let found = worst(u, 0.02);
        assert!((found / seen - 1.0).abs() < 0.15, "u = {u}: {found}");
    }
    assert!((worst(1.0, 1e-4) / 3.7e-6 - 1.0).abs() < 0.1);
}

#[test]
fn the_bound_holds_wherever_the_contact_begins() {
    let mut tightest = 0.0_f64;
    for k in 0..34 {
        let u = if k == 0 { 0.0005 } else { 0.01 * 1.26_f64.powi(k - 1).min(2000.0) };
        for dt in [0.1, 0.085, 0.07, 0.05, 0.03, 0.01] {
            for end in [End::ZeroCompression, End::ZeroForce] {
                let bound = time_step_error(u, dt).unwrap();
                for phase in 0..40 {
                    let error = codes_scheme(u, dt, (f64::from(phase) + 0.5) / 40.0, end) - epsilon(u, end);
                    assert!(error.abs() <= bound, "u = {u}, dt = {dt}, {end:?}: {error}");
                    tightest = tightest.max(error.abs() / bound);
                }
            }
        }
    }
    println!("largest error over bound: {tightest:.3}");
    assert!(tightest > 0.7, "a bound far above the errors wastes steps");
}

#[test]
fn the_step_keeps_the_error() {
    for u in [0.0, 0.1, 1.0, 5.0, 20.0] {
        for error in [1e-2, 1e-4, 1e-8] {
            let step = time_step_for(u, error).unwrap();
            assert!(time_step_error(u, step).unwrap() <= error * (1.0 + 1e-15));
        }
    }
    for (u, step) in [(20.1, 0.01), (-0.1, 0.01), (f64::NAN, 0.01), (1.0, 0.11), (1.0, f64::INFINITY)] {
        assert!(matches!(
            time_step_error(u, step),
            Err(MaterialError::TimeStepRange { .. } | MaterialError::NotPositive { .. })
        ));
    }
    assert!(matches!(time_step_for(1.0, 0.0), Err(MaterialError::NotPositive { .. })));
}
