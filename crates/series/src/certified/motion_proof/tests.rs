use super::super::units::log_singular_ratio;
use super::*;
use num_rational::BigRational;
use restitution_law::ForceLaw;
use restitution_real::Ball;

/// What the proof is about: trajectories of so many terms, found at so many bits.
struct Found {
    law: ForceLaw,
    shop: Workshop,
    scale: Scale,
    motion: Motion,
    slope: f64,
}

impl Found {
    fn new(text: &str, orders: usize, bits: u32, size: usize) -> Self {
        let law: ForceLaw = text.parse().unwrap();
        let slope = log_singular_ratio(&law);
        let scale = Scale::new(&law, 0.5, bits);
        let shop = Workshop::new(bits, 48, (2, 1));
        let motion = Motion::derive(&shop, &scale, orders, size, bits + 12, &mut |_| ()).unwrap();
        Self { law, shop, scale, motion, slope }
    }

    fn bound(&self) -> Result<Outcome, Unbounded> {
        bound(&self.shop, &self.scale, &self.motion, self.slope)
    }

    /// The bounds of positions and velocities in units.
    fn errors(&self) -> (f64, f64) {
        match self.bound() {
            Ok(Outcome::Bounded(errors)) => (errors.position.to_f64(), errors.velocity.to_f64()),
            other => panic!("{}: {other:?}", self.law),
        }
    }

    /// `e + 1` at a place.
    fn exponent(&self, n: usize, j: usize) -> f64 {
        self.scale.index(n, j) as f64 / self.scale.lattice.unit as f64
    }

    /// By how much `x_0(T)` and `x_0'(T)` are off: they are `((a+1)/2)^(1/(a+1))` and 0.
    fn off_at_turning_point(&self) -> (f64, f64) {
        let bits = self.shop.bits();
        let step = self.law.elastic_step();
        let half = BigRational::new(1.into(), 2.into());
        let top = Ball::from_rational(&(&step * half), bits + 64).pow(&step.recip()) / &self.scale.time;
        let (mut position, mut velocity) = (Integer::new(), Integer::new());
        for j in 0..self.motion.f[0].len() {
            let q = self.motion.f[0].integer(j);
            velocity += Integer::from(&q * (self.scale.index(0, j) + self.scale.lattice.unit));
            position += q;
        }
        let position = Ball::from_big_integer(&position, bits + 64) - top.shifted(bits as i32);
        (position.abs().to_f64(), velocity.to_f64().abs() / self.scale.lattice.unit as f64)
    }
}

fn add(series: &mut Fixed, j: usize, error: &Integer) {
    series.set(j, &(series.integer(j) + error));
}

fn integer(x: f64) -> Integer {
    Integer::from_f64(x).unwrap()
}

const LAWS: [&str; 4] = ["3/2,1/2", "7/3,5/6", "1,0", "1/2,-1/2"];

/// Errors put into the trajectories, one after the other.
#[test]
fn errors_put_into_trajectories_are_in_the_bound() {
    for text in LAWS {
        let mut found = Found::new(text, 2, 160, 128);
        let (position, velocity) = found.errors();
        let (off, fast) = found.off_at_turning_point();
        assert!(off <= position && fast <= velocity, "{text}");
        let error = 2f64.powi(60);
        for (n, j) in [(0, 1), (0, 5), (1, 0), (1, 1), (1, 9), (2, 0), (2, 3)] {
            add(&mut found.motion.f[n], j, &integer(error));
            let (at, speed) = found.errors();
            // What is off is the error that was put in, but for what was off before.
            assert!(at >= error - position, "{text}: {at:e} at {n} {j}");
            let exact = error * (found.exponent(n, j) + 1.0);
            assert!(speed >= exact - velocity, "{text}: {speed:e} at {n} {j}");
            add(&mut found.motion.f[n], j, &integer(-error));
        }
    }
}

/// An error put into the undamped force, with the trajectory that this force gives: the equation of motion holds, and
/// only the defect of the power tells. How far off it is then follows from the closed form of `x_0(T)`.
#[test]
fn errors_put_into_the_force_are_in_the_bound() {
    for text in LAWS {
        for j in [0, 1, 4, 12] {
            let mut found = Found::new(text, 0, 160, 128);
            let error = integer(2f64.powi(70));
            // e (e+1) F_(j+1) = -H_j
            let (m, unit) = (found.scale.index(0, j + 1), found.scale.lattice.unit);
            let change = Integer::from(&error * (unit * unit)) / (m * (m + unit));
            add(&mut found.motion.force[0], j, &error);
            add(&mut found.motion.f[0], j + 1, &-change);
            let (off, fast) = found.off_at_turning_point();
            assert!(off > 2f64.powi(50), "{text}: {off:e}");
            let (position, velocity) = found.errors();
            assert!(
                off <= position && fast <= velocity,
                "{text} {j}: {off:e} {position:e} {fast:e} {velocity:e}"
            );
        }
    }
}

/// The largest number up to which something holds, to a thousandth, as `log2`.
fn largest(mut holds: impl FnMut(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0f64, 250.0f64);
    while high - low > 1e-3 {
        let middle = (low + high) / 2.0;
        if holds(middle.exp2()) { low = middle } else { high = middle }
    }
    low
}

/// How large errors may be before what is of second order counts, and how many bits are asked for then.
#[test]
fn errors_too_large_for_the_first_order_are_refused() {
    for (text, expected) in [
        ("3/2,1/2", "146.83 1 3 Err(Coarse)"),
        ("7/3,5/6", "142.60 1 3 51"),
        ("3/2,2", "140.26 1 3 35"),
        ("1,0", "152.62 1 4 Err(Coarse)"),
        ("1/2,-1/2", "144.80 1 3 Err(Coarse)"),
    ] {
        let mut found = Found::new(text, 2, 160, 128);
        let mut with = |error: f64| {
            add(&mut found.motion.f[1], 2, &integer(error));
            let bound = found.bound();
            add(&mut found.motion.f[1], 2, &integer(-error));
            bound
        };
        let most = largest(|error| matches!(with(error), Ok(Outcome::Bounded(_))));
        let asked = |outcome: &Result<Outcome, Unbounded>| match outcome {
            Err(Unbounded::Bits(bits)) => format!("{bits}"),
            other => format!("{other:?}"),
        };
        let beyond = [0.01, 3.0, 20.5].map(|more| asked(&with((most + more).exp2())));
        assert_eq!(format!("{most:.2} {}", beyond.join(" ")), expected, "{text}");
    }
}

/// Rows that end too early prove nothing, and say how many terms are missing.
#[test]
fn sums_cut_off_too_early_are_told() {
    let outcome = |text: &str, bits: u32, size: usize| match Found::new(text, 2, bits, size).bound() {
        Ok(Outcome::Bounded(_)) => "bounded".to_owned(),
        Ok(Outcome::Cut(terms)) => format!("cut {terms}"),
        Err(error) => format!("{error:?}"),
    };
    for (text, expected) in [
        ("3/2,1/2", "Bits(80), cut 57, cut 38, cut 21, bounded, bounded, bounded"),
        ("7/3,5/6", "Bits(80), cut 60, cut 45, cut 28, cut 12, bounded, bounded"),
        ("1,0", "Bits(80), Bits(80), cut 54, cut 36, cut 18, bounded, bounded"),
        ("1/2,-1/2", "Bits(80), Bits(80), cut 83, cut 65, cut 47, cut 12, bounded"),
    ] {
        let all = [8, 16, 32, 48, 64, 96, 128].map(|size| outcome(text, 160, size));
        assert_eq!(all.join(", "), expected, "{text}");
    }
    // Four times as many terms, and more, are no matter of terms.
    let all = [172, 174, 176, 178].map(|bits| outcome("3/2,1/2", bits, 16));
    assert_eq!(all.join(", "), "cut 62, cut 63, Bits(88), Bits(89)");
}

/// A force whose last coefficient is wrong leaves a residual where the rows end.
#[test]
fn what_is_left_where_rows_end_asks_for_more_terms() {
    for (text, bits, size, expected) in [
        ("3/2,1/2", 160, 128, "15.21 Cut(3) Cut(12)"),
        ("7/3,5/6", 160, 128, "12.28 Cut(3) Cut(12)"),
        ("3/2,1/2", 152, 64, "13.46 Cut(3) Cut(12)"),
        ("7/3,5/6", 128, 64, "8.25 Cut(3) Cut(10)"),
    ] {
        let mut found = Found::new(text, 2, bits, size);
        let mut with = |error: f64| {
            add(&mut found.motion.force[2], size - 1, &integer(error));
            let bound = found.bound();
            add(&mut found.motion.force[2], size - 1, &integer(-error));
            bound
        };
        let most = largest(|error| matches!(with(error), Ok(Outcome::Bounded(_))));
        let [next, far] = [0.01, 20.0].map(|more| with((most + more).exp2()).unwrap());
        assert_eq!(format!("{most:.2} {next:?} {far:?}"), expected, "{text}");
    }
}

#[test]
fn terms_make_up_for_a_cut() {
    for (cut, slope, terms) in [(64.0, 2.5, 3), (1024.0, 0.5, 23), (2.0, 4.0, 1), (2f64.powi(100), 1.0, 112)]
    {
        assert_eq!(terms_for(cut, slope), terms);
    }
}

/// What is folded over counts if it is more than 64 times all else, by how much it is more than that or than rounding.
#[test]
fn cuts_are_measured() {
    for (found, folded, rounding, cut) in [
        (10.0, 640.0, 1.0, 0.0),
        (10.0, 641.0, 1.0, 641.0),
        (10.0, 1000.0, 1e6, 100.0),
        (0.5, 100.0, 4.0, 100.0),
        (1e9, 1e3, 1.0, 0.0),
    ] {
        let [found, folded] = [found, folded].map(Magnitude::exact);
        assert_eq!(Defects { power: 1.0, found, folded, rounding }.cut(), cut);
    }
}

/// `||F^p|| (1 + ||F^(-p-1)|| (found + folded))` and the part of what was folded over.
#[test]
fn errors_of_forces_are_those_of_the_document() {
    let found = Found::new("7/3,5/6", 2, 160, 128);
    let grading = Grading { row: 11.0 / 6.0, column: 10.0 / 3.0 };
    in_detail(|detail| {
        let sketch = Sketch::new(&found.motion.f, &[], 160, grading, detail)?;
        let powers = Powers::new(sketch, grading)?;
        let lower = powers.power(4.0 / 3.0)?.norm();
        let (known, folded) = (Magnitude::exact(100.0), Magnitude::exact(7.0));
        let defects = Defects { power: 7.0 / 3.0, found: known, folded, rounding: 1.0 };
        let (error, part) = defects.force_error(&powers, lower)?;
        let inverse = powers.power(-10.0 / 3.0)?.norm().to_f64();
        let force = lower.to_f64() * powers.base().to_f64();
        let close = |x: Magnitude, y: f64| (0.0..1e-12).contains(&(x.to_f64() / y - 1.0));
        assert!(close(error, force * (1.0 + inverse * 107.0)), "{error:?}");
        assert!(close(part, force * inverse * 7.0), "{part:?}");
        Ok(())
    })
    .unwrap();
}

/// Defects against the sums of products written out in whole numbers.
#[test]
fn defects_are_those_of_the_rows() {
    for text in ["3/2,1/2", "7/3,5/6"] {
        let found = Found::new(text, 2, 96, 64);
        let Found { shop, scale, motion, slope, .. } = &found;
        let [steps, _] = scale.powers();
        let unit = scale.lattice.unit;
        let force = Force { steps, rows: &motion.force, defects: &motion.force_defects };
        let defects = defects(shop, scale, motion, &force, *slope);
        let power = steps as f64 / unit as f64;
        let size = motion.f[0].len() as f64;
        let norms: f64 = motion.force.iter().map(|row| row.norm(96, 1.0).to_f64()).sum();
        let rounding = power.max(1.0) * norms * size * 3.0;
        assert!((defects.rounding / rounding - 1.0).abs() < 1e-12, "{text}");
        // a H_n theta F - F theta H, over n, by its exact products (theta is s d/ds at order 0), without what is beyond J.
        let mut sum = 0.0;
        for n in 0..=2usize {
            for j in 0..motion.f[0].len() {
                let mut term = Integer::new();
                for k in 0..=n {
                    for i in 0..=j {
                        let weight = match n {
                            0 => steps * i as i64 - unit * (j - i) as i64,
                            _ => steps * k as i64 - unit * (n - k) as i64,
                        };
                        term += motion.f[k].integer(i) * motion.force[n - k].integer(j - i) * weight;
                    }
                }
                let scaled = Ball::from_big_integer(&term, 256).shifted(-96).abs().to_f64();
                sum += scaled / unit as f64 / n.max(1) as f64;
            }
        }
        // Rounding of every coefficient counts besides, in the divided rows that of the division too.
        let counted = (0.51 * size * 3.0 + size * 2.0) / unit as f64;
        let bound = defects.found.to_f64();
        let folded = defects.folded.to_f64();
        assert!(bound + folded >= sum && bound >= counted, "{text}: {bound} {sum} {folded}");
        assert!(bound <= sum + folded + 2.0 * counted, "{text}: {bound} {sum} {folded} {counted}");
    }
}

/// Where a law's larger step spans many bins, these are made wider until there are few enough.
#[test]
fn bins_are_widened_where_there_would_be_too_many() {
    let grading = Grading { row: 1.0, column: 101.0 };
    let rows = [Fixed::from_integers(&[Integer::from(1) << 90, Integer::from(1) << 89], 2)];
    let sketch = in_detail(|detail| Sketch::new(&rows, &[], 90, grading, detail)).unwrap();
    let growth = |e: f64, d: f64| {
        let found = growth(grading, (&sketch, Magnitude::exact(e)), (&sketch, Magnitude::exact(d)));
        found.map_or("nothing".to_owned(), |found| format!("{:?}", found.to_f64()))
    };
    for (e, d, expected) in [
        (1.0, 1.0, "2.673995676240439"),
        (1e6, 1.0, "175166024011.87018"),
        (5e6, 0.0, "5.836635400147034e22"),
        (5e7, 0.0, "1.1466538478390552e70"),
        (1e8, 0.0, "1.452801092232059e98"),
        (1e9, 0.0, "nothing"),
        (1e7, 1.0, "nothing"),
    ] {
        assert_eq!(growth(e, d), expected, "{e} {d}");
    }
}
