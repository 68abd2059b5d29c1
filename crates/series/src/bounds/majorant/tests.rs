use super::*;

#[test]
fn products_are_cut_where_they_leave_the_head() {
    let head = Head::new(&ForceLaw::viscoelastic_spheres(), 0, 3);
    let ones = vec![Magnitude::ONE; head.terms.len()];
    // Grades 0, 5, 10, 15 and limit 17: the sums 20, 25, 30 are reached 3, 2, 1 times.
    assert!((head.product_beyond(&ones, &ones, 0).to_f64() - 6.0).abs() < 1e-12);
    assert!((head.beyond(&ones, 5).to_f64() - 1.0).abs() < 1e-12);
}

/// Norms of what a longer head has beyond a shorter one.
fn true_tails(longer: &Head, limit: i64, ratio: f64, damping: f64) -> Tails {
    let series = weigh(&longer.terms, ratio, damping);
    let beyond = |x: &[Magnitude]| {
        longer.terms.iter().zip(x).filter(|(t, _)| t.grade > limit).map(|(_, x)| *x).sum::<Magnitude>()
    };
    let [logarithmic, elastic, damping, trajectory] = series.map(|x| beyond(&x));
    Tails { logarithmic, elastic, damping, trajectory }
}

#[test]
fn tails_of_all_four_series_are_bounded_closely() {
    // The largest slack is that of F, whose coefficients fall faster than the norm of L can tell.
    for (law, ratio, damping, largest) in
        [("3/2,1/2", 4.0, 0.3, 6e4), ("2,1/3", 4.0, 0.5, 40.0), ("1/2,1/2", 2.0, 0.2, 900.0)]
    {
        let law: ForceLaw = law.parse().unwrap();
        let (head, longer) = (Head::new(&law, 3, 40), Head::new(&law, 3, 80));
        let majorant = Majorant::new(&law, &head);
        let bound = Weighted::new(&majorant, ratio, damping).tails().unwrap();
        let truth = true_tails(&longer, head.limit, ratio, damping);
        let slack = |x: Magnitude, y: Magnitude| x.to_f64() / y.to_f64();
        let slacks = [
            slack(bound.logarithmic, truth.logarithmic),
            slack(bound.elastic, truth.elastic),
            slack(bound.damping, truth.damping),
            slack(bound.trajectory, truth.trajectory),
        ];
        assert!(slacks.iter().all(|&x| x >= 1.0), "{law} {slacks:?}");
        assert!(slacks.iter().all(|&x| x < largest), "{law} {slacks:?}");
    }
}

/// The sizes of one series of a head by `(n, j)`, in the weighted norm, with the exponent of each.
fn sizes(head: &Head, ratio: f64, damping: f64, size: fn(&Term) -> Magnitude) -> Vec<(i64, f64)> {
    let power = |x: f64, k: usize| x.powi(i32::try_from(k).unwrap());
    let weight = |t: &Term| power(ratio, t.elastic_index) * power(damping, t.damping_order);
    head.terms.iter().map(|t| (t.grade, size(t).to_f64() * weight(t))).collect()
}

/// The right sides of (4a) to (4d) of `docs/error-bounds.md`, `G` and `H`, as they are written there, pair by pair
/// and in double precision.
fn inequalities(law: &ForceLaw, head: &Head, weights: (f64, f64), tails: [f64; 4]) -> ([f64; 4], [f64; 2]) {
    let (r, v) = weights;
    let (elastic, damping) = (head.lattice.elastic, head.lattice.damping);
    let [l, a, b, f] = [
        sizes(head, r, v, |t| t.logarithmic),
        sizes(head, r, v, |t| t.elastic),
        sizes(head, r, v, |t| t.damping),
        sizes(head, r, v, |t| t.trajectory),
    ];
    let norm = |x: &[(i64, f64)]| x.iter().map(|x| x.1).sum::<f64>();
    let beyond = |x: &[(i64, f64)], y: &[(i64, f64)], step: i64| {
        let pairs = x.iter().flat_map(|x| y.iter().map(move |y| (x.0 + y.0 + step, x.1 * y.1)));
        pairs.filter(|pair| pair.0 > head.limit).map(|pair| pair.1).sum::<f64>()
    };
    let one = [(0, 1.0)];
    let (s, w) = (head.elastic_scale.to_f64() * r, head.damping_scale.to_f64() * v);
    let [tail_l, tail_a, tail_b, tail_f] = tails;
    let end = head.limit as f64 / head.lattice.unit as f64;
    let number = |x: &num_rational::BigRational| Ball::from_rational(x, 64).to_f64();
    let (power, gamma) = (number(law.a()), number(law.gamma()));
    let logarithmic = beyond(&l, &l, 0)
        + s * beyond(&a, &one, elastic)
        + w * (beyond(&b, &one, damping) + beyond(&b, &l, damping))
        + 2.0 * norm(&l) * tail_l
        + tail_l * tail_l
        + s * tail_a
        + w * (tail_b + norm(&b) * tail_l + norm(&l) * tail_b + tail_b * tail_l);
    let elastic_tail =
        (power - 1.0).abs() * (beyond(&l, &a, 0) + norm(&l) * tail_a + norm(&a) * tail_l + tail_l * tail_a);
    let damping_tail =
        gamma.abs() * (beyond(&l, &b, 0) + norm(&l) * tail_b + norm(&b) * tail_l + tail_l * tail_b);
    let g = s * (beyond(&f, &a, elastic) + norm(&f) * tail_a + norm(&a) * tail_f + tail_f * tail_a);
    let h = w / (gamma + 1.0)
        * (beyond(&f, &b, damping) + norm(&f) * tail_b + norm(&b) * tail_f + tail_f * tail_b);
    let trajectory = g / (end * (end + 1.0)) + h / (end + 1.0);
    ([logarithmic / (end + 1.0), elastic_tail / end, damping_tail / end, trajectory], [g, h])
}

/// The formula in double precision is off by some ulp; the scales in the bound are rounded up to the 32 bits of a radius.
fn closely_above(what: &str, bound: f64, formula: f64) {
    let range = formula * (1.0 - 1e-12)..=formula * (1.0 + 1e-8);
    assert!(range.contains(&bound), "{what}: {bound} is not {formula}");
}

#[test]
fn the_inequalities_are_those_of_the_theorem() {
    for law in ["3/2,1/2", "2,1/3", "1/2,-1/4", "5/3,7/4"] {
        let law: ForceLaw = law.parse().unwrap();
        let head = Head::new(&law, 3, 9);
        let majorant = Majorant::new(&law, &head);
        for (weights, tails) in [
            ((2.5, 0.375), [0.0; 4]),
            ((2.5, 0.375), [0.5, 0.25, 0.125, 0.75]),
            ((1.25, 0.75), [3.0, 0.0, 0.0, 0.0]),
            ((1.25, 0.75), [0.0, 0.0, 5.0, 7.0]),
            ((3.0, 0.0), [0.125, 2.0, 0.0, 0.5]),
        ] {
            let weighted = Weighted::new(&majorant, weights.0, weights.1);
            let [logarithmic, elastic, damping, trajectory] = tails.map(Magnitude::exact);
            let candidate = Tails { logarithmic, elastic, damping, trajectory };
            let image = weighted.image(&candidate);
            let (g, h) = weighted.drives(&candidate);
            let (right, [true_g, true_h]) = inequalities(&law, &head, weights, tails);
            closely_above("l", image.logarithmic.to_f64(), right[0]);
            closely_above("A", image.elastic.to_f64(), right[1]);
            closely_above("B", image.damping.to_f64(), right[2]);
            closely_above("F", image.trajectory.to_f64(), right[3]);
            closely_above("G", g.to_f64(), true_g);
            closely_above("H", (h * majorant.damping_step_inverse).to_f64(), true_h);
        }
    }
}

/// The candidate that `tails` accepts solves the inequalities as they are written, with room for their rounding here.
#[test]
fn accepted_candidates_solve_the_inequalities() {
    let law = ForceLaw::viscoelastic_spheres();
    let head = Head::new(&law, 2, 40);
    let majorant = Majorant::new(&law, &head);
    for weights in [(4.0, 0.3), (2.0, 0.5), (4.5, 0.0)] {
        let tails = Weighted::new(&majorant, weights.0, weights.1).tails().unwrap();
        let candidate =
            [tails.logarithmic, tails.elastic, tails.damping, tails.trajectory].map(Magnitude::to_f64);
        let (right, [g, h]) = inequalities(&law, &head, weights, candidate);
        for (candidate, right) in candidate.iter().zip(right) {
            assert!(right <= candidate * (1.0 + 1e-12), "{right} {candidate}");
        }
        // What is handed on is that candidate's G and H.
        let decay = majorant.decay(weights.0, weights.1).unwrap();
        let exponent = Ball::from_integer(1, 64);
        closely_above("G/e + H", decay.coefficient_up(0, 0, &exponent).to_f64() * 2.0, g + h);
    }
}

#[test]
fn every_part_of_a_candidate_counts() {
    let one = |k: usize| {
        let part = |i| if i == k { Magnitude::exact(2.0) } else { Magnitude::ONE };
        Tails { logarithmic: part(0), elastic: part(1), damping: part(2), trajectory: part(3) }
    };
    let ones = one(4);
    assert!(ones.within(&ones));
    for k in 0..4 {
        assert!(ones.within(&one(k)));
        assert!(!one(k).within(&ones), "part {k}");
    }
}

#[test]
fn weights_beyond_the_singularity_prove_nothing() {
    let law = ForceLaw::viscoelastic_spheres();
    let head = Head::new(&law, 2, 40);
    let majorant = Majorant::new(&law, &head);
    assert!(majorant.decay(4.0, 1.0).is_some());
    assert!(majorant.decay(5.7, 0.0).is_none());
}
