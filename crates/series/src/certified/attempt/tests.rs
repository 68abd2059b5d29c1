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

/// Everything around the turning point, with a unit of time that is so many times the usual one.
struct Around {
    shop: Workshop,
    scale: Scale,
    turning: TurningScale,
    near: Neighbourhood,
    shift: Fixed,
    start: Start,
}

impl Around {
    fn new(text: &str, order: usize, bits: u32, lambda: f64, longer: f64) -> Self {
        let law: ForceLaw = text.parse().unwrap();
        let request = Request { law: &law, damping: order, last: order };
        let plan = Plan { bits, lambda, step: 0.0, margin: 24 };
        let (scale, shop, motion) = motion(&request, plan, &mut |_| ()).unwrap();
        let outcome = motion_proof::bound(&shop, &scale, &motion, log_singular_ratio(&law));
        let Ok(Outcome::Bounded(errors)) = outcome else { panic!("{outcome:?}") };
        let shop = Workshop::new(bits, HEAD, (0, 1));
        let start = Start::new(&law, &scale, &motion, errors, bits);
        let turning = start.turning(longer * start.first_step());
        let (position, velocity) = (&start.position, &start.velocity);
        let near = Neighbourhood::new(&shop, &scale, &turning, position, velocity, bits + ROW_HEAD).unwrap();
        let shift = near.shift(&shop, order / 2 + 1);
        Self { shop, scale, turning, near, shift, start }
    }

    fn bound(&self, position: f64, velocity: f64, shift: &Fixed) -> Option<f64> {
        let errors = (Magnitude::exact(position), Magnitude::exact(velocity));
        let bound = turning_proof::bound(&self.shop, &self.scale, &self.turning, &self.near, errors, shift);
        bound.map(Magnitude::to_f64)
    }

    fn step(&self) -> f64 {
        self.turning.step.0 as f64 / self.turning.step.1 as f64
    }

    fn compression(&self, shift: &Fixed) -> Fixed {
        self.near.derivative_at(&self.shop, shift, 0, self.near.rows.len())
    }

    fn shifted(&self, k: usize, by: f64) -> Fixed {
        let mut shift = self.shift.clone();
        shift.set(k, &(shift.integer(k) + Integer::from_f64(by).unwrap()));
        shift
    }
}

/// The largest number up to which something holds, to a thousandth.
fn largest(holds: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0f64, 200.0f64);
    while high - low > 1e-3 {
        let middle = (low + high) / 2.0;
        if holds(middle.exp2()) { low = middle } else { high = middle }
    }
    low
}

/// What is not known of the positions and of the velocities at `T` is in the bound of the compression.
#[test]
fn errors_at_the_undamped_turning_point_reach_the_compression() {
    let around = Around::new("3/2,1/2", 4, 160, 0.9, 1.5);
    let large = 2f64.powi(60);
    let bound = |position, velocity| around.bound(position, velocity, &around.shift).unwrap();
    assert!(bound(0.0, 0.0) < 2f64.powi(40));
    // A position off by so much at T is as far off later, at least to first order.
    assert!(bound(large, 0.0) >= large);
    assert!(bound(0.0, large) >= large * around.step());
}

/// Errors put into the initial values, one after the other: the compression found is within the bound of the true one.
#[test]
fn errors_put_into_the_initial_values_are_in_the_bound() {
    for (text, order) in [("3/2,1/2", 5), ("7/3,5/6", 4), ("1/2,-1/2", 4)] {
        let around = Around::new(text, order, 160, 0.5, 1.1);
        let exact = around.compression(&around.shift);
        let error = 2f64.powi(60);
        for k in 1..=order {
            for velocity in [false, true] {
                let mut position = around.start.position.clone();
                let mut speed = around.start.velocity.clone();
                let changed = if velocity { &mut speed[k] } else { &mut position[k] };
                *changed += Integer::from_f64(error).unwrap();
                let (shop, limit) = (&around.shop, 160 + ROW_HEAD);
                let near = Neighbourhood::new(shop, &around.scale, &around.turning, &position, &speed, limit)
                    .unwrap();
                let shift = near.shift(shop, order / 2 + 1);
                let off = near.derivative_at(shop, &shift, 0, order + 1);
                let off: f64 = (0..=order).map(|i| (off.integer(i) - exact.integer(i)).to_f64().abs()).sum();
                let errors = if velocity { (0.0, error) } else { (error, 0.0) };
                let bound = around.bound(errors.0, errors.1, &around.shift).unwrap();
                assert!(off <= bound, "{text}: order {k} moves y by {off:e}, bound {bound:e}");
                assert!(off > 0.0 || velocity && 2 * k >= order, "{text}: order {k}");
            }
        }
    }
}

/// An error put into the shift of the turning point is found, and bounded to first and second order.
#[test]
fn errors_of_the_shift_are_found() {
    for text in ["3/2,1/2", "7/3,5/6"] {
        let around = Around::new(text, 5, 160, 0.5, 1.1);
        let exact = around.compression(&around.shift);
        let least = around.bound(0.0, 0.0, &around.shift).unwrap();
        for k in 1..around.shift.len() {
            for error in [2f64.powi(50), 2f64.powi(80), 2f64.powi(110)] {
                let shift = around.shifted(k, error);
                let found = around.compression(&shift);
                let off: f64 = (0..=5).map(|i| (found.integer(i) - exact.integer(i)).to_f64().abs()).sum();
                let bound = around.bound(0.0, 0.0, &shift).unwrap();
                assert!(off <= bound + least, "{text}: {off:e}, bound {bound:e}");
                // The shift itself is off by so much: what is proved of it must say so.
                let velocity = around.near.derivative_at(&around.shop, &shift, 1, shift.len());
                assert!(velocity.norm(0, 1.0).to_f64() > 0.1 * error * around.step().powi(2));
                assert!(bound > error * 1e-3, "{text}: {bound:e} for {error:e}");
            }
        }
    }
}

/// How large errors may be before nothing is proved: as `log2` of units, to the last place a thousandth.
#[test]
fn errors_too_large_for_the_turning_point_are_refused() {
    for (text, expected) in [("3/2,1/2", "134.95 137.36 156.11"), ("7/3,5/6", "135.23 138.74 157.13")] {
        let around = Around::new(text, 4, 160, 0.5, 1.1);
        let position = largest(|error| around.bound(error, 0.0, &around.shift).is_some());
        let velocity = largest(|error| around.bound(0.0, error, &around.shift).is_some());
        let shift = largest(|error| around.bound(0.0, 0.0, &around.shifted(1, error)).is_some());
        assert_eq!(format!("{position:.2} {velocity:.2} {shift:.2}"), expected, "{text}");
    }
    // A unit of time so short that the shift is longer than 1.
    let size = |around: &Around| around.shift.norm(160, 1.0).to_f64();
    for (longer, proved) in [(0.66, false), (0.72, true)] {
        let around = Around::new("3/2,1/2", 4, 160, 0.9, longer);
        assert_eq!(around.bound(0.0, 0.0, &around.shift).is_some(), proved, "{}", size(&around));
    }
}

/// Where errors grow so much that what is of second order exceeds what is given, nothing is proved, however small the error
/// itself is: a unit of time 16 times the usual one.
#[test]
fn errors_of_second_order_have_to_stay_below_those_of_first() {
    let far = Around::new("3/2,1/2", 4, 192, 0.5, 16.0);
    let position = largest(|error| far.bound(error, 0.0, &far.shift).is_some());
    let proved = far.bound((position - 1.0).exp2(), 0.0, &far.shift).unwrap() * 2f64.powi(-192);
    assert_eq!(format!("{position:.2}"), "115.77");
    assert!(proved < 1e-9, "an error of {proved:e} is small");
}

/// Integers that weigh the rows must be words: a unit of the damping so small that they would not be is refused.
#[test]
fn weights_that_are_no_words_are_refused() {
    let law: ForceLaw = "499999/500000,-1/500000".parse().unwrap();
    assert!(law.is_viscoelastic());
    let request = Request { law: &law, damping: 3, last: 3 };
    let of = |lambda: f64| motion(&request, Plan { bits: 128, lambda, step: 0.0, margin: 8 }, &mut |_| ());
    assert!(of(1e-12).is_none() && of(1e-3).is_some());
}

/// Exponents next to 1 and to 0 are the doubles next to the exact ones, not differences of doubles.
#[test]
fn small_powers_are_as_exact_as_large_ones() {
    for text in ["400001/400000,1/400000", "7/3,5/6", "3/2,-1/3"] {
        let law: ForceLaw = text.parse().unwrap();
        let expected = [law.a() - BigRational::one(), law.gamma().clone()].map(|x| x.to_f64().unwrap());
        assert_eq!(Scale::new(&law, 1.0, 128).lower_powers(), expected, "{text}");
    }
}

#[test]
fn the_longest_product_is_as_precise_as_is_said() {
    assert_eq!(LARGEST_ORDER + 1, turning_proof::MOST_PLACES);
    let rounded = 0.5 + 2f64.powi(-20);
    assert!(motion_proof::SETTLED >= rounded && motion_proof::SETTLED < 0.52);
    let dropped = turning_proof::MOST_PLACES as f64 * 2.0 * 2f64.powi(-16);
    assert!(turning_proof::PRODUCT >= motion_proof::SETTLED + dropped && turning_proof::PRODUCT < 0.77);
}

/// Bits for large powers: none up to 16, then more and more slowly; a part of them for the rows.
#[test]
fn powers_have_the_bits_for_them() {
    let of = |text: &str| {
        let law: ForceLaw = text.parse().unwrap();
        (bits_of_powers(&law), head(&law), row_head(&law))
    };
    for text in ["3/2,1/2", "1,0", "16,15", "1/2,14"] {
        assert_eq!(of(text), (0, 48, 12), "{text}");
    }
    let found: Vec<_> = ["20,19", "40,39", "100,0", "3/2,40", "1/2,60", "20,60", "1/2,5000"].map(of).to_vec();
    let expected = [
        (2, 50, 13),
        (10, 58, 17),
        (21, 69, 22),
        (41, 89, 32),
        (106, 154, 65),
        (27, 75, 25),
        (4096, 4144, 2060),
    ];
    assert_eq!(found, expected);
    for (text, slope) in [("3/2,1/2", 2.5), ("1/2,1/2", 1.5), ("3,0", 2.0)] {
        let (bits, places) = decay(&text.parse().unwrap());
        let share = bits as f64 / places as f64 / slope;
        assert!((0.75..0.851).contains(&share), "{text}: {share} of the slope");
    }
}

#[test]
fn norms_are_those_of_the_larger_power() {
    for (text, lambda, of_friction) in
        [("3/2,1/2", 0.5, false), ("3/2,3", 0.5, true), ("3/2,3", 0.05, true), ("3,1/10", 0.5, false)]
    {
        let law: ForceLaw = text.parse().unwrap();
        let request = Request { law: &law, damping: 3, last: 3 };
        let plan = Plan { bits: 128, lambda, step: 0.0, margin: 8 };
        let (_, shop, motion) = motion(&request, plan, &mut |_| ()).unwrap();
        let rows = if of_friction { &motion.friction } else { &motion.force };
        let expected: Vec<f64> =
            rows.iter().map(|row| row.norm(i64::from(shop.bits()), 1.0).to_f64()).collect();
        assert_eq!(norms_of_powers(&request, plan).unwrap(), expected, "{text}");
    }
}

#[test]
fn a_damping_too_large_for_its_unit_proves_nothing() {
    let law = ForceLaw::viscoelastic_spheres();
    let motion_of = |lambda: f64| {
        let request = Request { law: &law, damping: 4, last: 4 };
        motion(&request, Plan { bits: 128, lambda, step: 0.0, margin: 8 }, &mut |_| ()).is_some()
    };
    // Rows of order 4 grow like the fourth power; a damping beyond 2^10 is not even tried.
    let largest = largest(motion_of);
    assert_eq!(format!("{largest:.2}"), "3.67");
    let request = Request { law: &law, damping: 1, last: 1 };
    let first = |lambda: f64| {
        motion(&request, Plan { bits: 128, lambda, step: 0.0, margin: 8 }, &mut |_| ()).is_some()
    };
    assert_eq!(format!("{:.2}", self::largest(first)), "8.95");
}

/// A unit of time that is given is used, where it is long enough.
#[test]
fn a_step_that_is_given_is_used() {
    let law = ForceLaw::viscoelastic_spheres();
    let request = Request { law: &law, damping: 4, last: 4 };
    let with = |step: f64| attempt(&request, Plan { bits: 128, lambda: 0.9, step, margin: 24 }, &mut |_| ());
    let found = with(0.0).unwrap().step;
    let steps: Vec<String> = [0.3, 0.5].map(|step| format!("{:.6}", with(step).unwrap().step)).to_vec();
    assert_eq!(steps.join(" "), "0.231252 0.231854", "{found}");
    let far = with(1000.0);
    assert!(matches!(far, Err(Failure::Norms)), "{:?}", far.err());
    // Without anything that moves the turning point, any unit of time does.
    let mut around = Around::new("3/2,1/2", 4, 128, 0.9, 1.0);
    let first = around.start.first_step();
    assert!(first > 0.01 && first < 1.0);
    around.start.velocity[1] = Integer::new();
    assert_eq!(around.start.first_step(), 0.25);
    around.start.velocity[1] = Integer::from(1) << 128;
    around.start.elastic = Ball::from_integer(0, 64);
    assert_eq!(around.start.first_step(), 0.25);
}

/// What is proved of the compression, to the last bit, where every part of the bound counts: few bits, or large errors.
#[test]
fn figures_of_the_turning_point() {
    for (text, order, bits, expected) in [
        ("3/2,1/2", 4, 44, 44711.69313871437),
        ("3/2,1/2", 4, 48, 44711.693011423886),
        ("7/3,5/6", 3, 44, 2105.400402680487),
    ] {
        let few = Around::new(text, order, bits, if order == 4 { 0.9 } else { 0.6 }, 1.1);
        assert_eq!(few.bound(0.0, 0.0, &few.shift), Some(expected), "{text} {bits}");
    }
    for (text, position, velocity) in [
        ("3/2,1/2", 6.04314112590224e41, 1.3177861398968713e42),
        ("7/3,5/6", 2.7556321347807474e41, 3.954745918770939e41),
    ] {
        let around = Around::new(text, 4, 160, 0.5, 1.1);
        assert_eq!(around.bound(2f64.powi(134), 0.0, &around.shift), Some(position), "{text}");
        assert_eq!(around.bound(0.0, 2f64.powi(137), &around.shift), Some(velocity), "{text}");
    }
}
