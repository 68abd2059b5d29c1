use super::*;

/// The expansion at some precision, with a smaller unit of the damping where the first proves nothing.
fn proved(law: &ForceLaw, order: usize, bits: u32, lambda: f64) -> (Expansion, f64) {
    let request = Request { law, damping: order, last: order };
    let mut plan = Plan { bits, lambda, step: 0.0, margin: 24 };
    loop {
        match attempt(&request, plan, &mut |_| ()) {
            Ok(expansion) => return (expansion, plan.lambda),
            Err(Failure::Terms(terms)) => plan.margin += terms + 16,
            Err(Failure::Norms | Failure::Bits(_)) => plan.lambda *= 0.7,
        }
        assert!(plan.lambda > 1e-3, "{law}: nothing was proved");
    }
}

/// Every radius holds the distance to a run with a hundred digits more; how many bits it gives away is shown.
#[test]
fn radii_hold_the_true_errors() {
    let cases = [
        ("3/2,1/2", 8, 128),
        ("3/2,1/2", 31, 200),
        ("3/2,1/2", 5, 700),
        ("2,1/3", 7, 160),
        ("5/4,-1/4", 9, 160),
        ("1,0", 6, 150),
        ("5/2,3/2", 6, 180),
        ("3/2,4999/10000", 4, 140),
        ("3,0", 8, 160),
    ];
    let mut most = 0.0f64;
    for (text, order, bits) in cases {
        let law: ForceLaw = text.parse().unwrap();
        let (first, lambda) = proved(&law, order, bits, 0.9);
        let (second, _) = proved(&law, order, bits + 332, lambda);
        for (name, first, second) in
            [("y", &first.compression, &second.compression), ("C", &first.restitution, &second.restitution)]
        {
            let mut given_away = Vec::new();
            for (k, (x, better)) in first.iter().zip(second).enumerate().skip(1) {
                if x.is_exact() {
                    continue;
                }
                let error = (Ball::exact(x.mid().clone()) - Ball::exact(better.mid().clone())).abs_up();
                let error = error + better.rad();
                assert!(x.rad() >= &error, "{text} {name}_{k}: {x:?} is off by {error}");
                given_away.push((x.rad() / error).to_f64().log2());
            }
            let largest = given_away.iter().copied().fold(0.0, f64::max);
            println!(
                "{text}, {bits} bits: {name}_1..{order} give away {:.0} to {largest:.0} bits",
                given_away.iter().copied().fold(f64::INFINITY, f64::min)
            );
            most = most.max(largest);
        }
    }
    assert!(most < 60.0, "{most} bits are given away");
}

/// A proof that forgets the errors of what it was given would prove less than nothing.
#[test]
fn errors_of_the_sums_reach_the_coefficients() {
    let law = ForceLaw::viscoelastic_spheres();
    let (coarse, lambda) = proved(&law, 6, 128, 0.9);
    let (fine, _) = proved(&law, 6, 160, lambda);
    for (coarse, fine) in coarse.restitution.iter().zip(&fine.restitution).skip(1) {
        let gained = (coarse.rad() / Float::with_val(64, fine.rad())).to_f64().log2();
        assert!((28.0..36.0).contains(&gained), "32 bits more gain {gained}");
    }
}

/// What is not known of the positions and of the velocities at `T` is in the bound of the compression.
#[test]
fn errors_at_the_undamped_turning_point_reach_the_compression() {
    let (law, bits) = (ForceLaw::viscoelastic_spheres(), 160);
    let scale = Scale::new(&law, 0.9, bits);
    let shop = Workshop::new(bits, HEAD, (2, 1));
    let size = size_for_bits(&law, bits, 24);
    let motion = Motion::derive(&shop, &scale, 4, size, bits + ROW_HEAD, &mut |_| ()).unwrap();
    let outcome = motion_proof::bound(&shop, &scale, &motion, log_singular_ratio(&law));
    let Ok(Outcome::Bounded(errors)) = outcome else { panic!("{outcome:?}") };
    let flat = Workshop::new(bits, HEAD, (0, 1));
    let start = Start::new(&law, &scale, &motion, errors, bits);
    let turning = start.turning(1.5 * start.first_step());
    let (position, velocity) = (&start.position, &start.velocity);
    let near = Neighbourhood::new(&flat, &scale, &turning, position, velocity, bits + ROW_HEAD).unwrap();
    let shift = near.shift(&flat, 3);
    let bound =
        |errors| turning_proof::bound(&flat, &scale, &turning, &near, errors, &shift).unwrap().to_f64();
    let (none, large) = (Magnitude::ZERO, Magnitude::exact(2f64.powi(60)));
    assert!(bound((none, none)) < 2f64.powi(40));
    // A position off by so much at T is as far off later, at least to first order.
    assert!(bound((large, none)) >= 2f64.powi(60));
    assert!(bound((none, large)) >= 2f64.powi(60) * turning.step.0 as f64 / turning.step.1 as f64);
}
