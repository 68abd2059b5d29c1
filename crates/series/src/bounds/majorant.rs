//! The inequalities whose solution bounds every coefficient beyond the head.

use super::decay::Decay;
use super::head::{Head, Term};
use num_traits::One;
use restitution_law::ForceLaw;
use restitution_real::{Ball, Magnitude};

/// Rounds of the search for a solution; a good pair of weights needs about 20.
const ROUNDS: usize = 200;

/// Norms of the tails of `L`, `A`, `B`, `F` in the weighted norm.
///
/// ```text
/// ||f|| = sum |f_(n,j)| T^e r^j v^n
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Tails {
    logarithmic: Magnitude,
    elastic: Magnitude,
    damping: Magnitude,
    trajectory: Magnitude,
}

impl Tails {
    fn within(&self, other: &Self) -> bool {
        self.logarithmic <= other.logarithmic
            && self.elastic <= other.elastic
            && self.damping <= other.damping
            && self.trajectory <= other.trajectory
    }

    fn scaled(self, factor: Magnitude) -> Self {
        Self {
            logarithmic: self.logarithmic * factor,
            elastic: self.elastic * factor,
            damping: self.damping * factor,
            trajectory: self.trajectory * factor,
        }
    }
}

/// The head with what does not depend on the weights.
pub(super) struct Majorant<'h> {
    head: &'h Head,
    elastic_scale: Magnitude,
    damping_scale: Magnitude,
    /// `|a - 1|`, `|gamma|`, `1/(gamma + 1)`.
    elastic_power: Magnitude,
    damping_power: Magnitude,
    damping_step_inverse: Magnitude,
    /// `1/E`, `1/(E + 1)` for the largest exponent `E` of the head.
    inverse: Magnitude,
    next_inverse: Magnitude,
}

impl<'h> Majorant<'h> {
    pub fn new(law: &ForceLaw, head: &'h Head) -> Self {
        let bits = 64;
        let (limit, unit) = (head.limit, head.lattice.unit);
        let one = num_rational::BigRational::one();
        let of = |x: &_| Magnitude::of(&Ball::from_rational(x, bits));
        Self {
            head,
            elastic_scale: Magnitude::of(&head.elastic_scale),
            damping_scale: Magnitude::of(&head.damping_scale),
            elastic_power: of(&(law.a() - one)),
            damping_power: of(law.gamma()),
            damping_step_inverse: of(&law.damping_step().recip()),
            inverse: Magnitude::of(&Ball::from_ratio(unit, limit, bits)),
            next_inverse: Magnitude::of(&Ball::from_ratio(unit, limit + unit, bits)),
        }
    }

    /// Returns the decay that the weights `r` and `v` prove, if they do; `v = 0` bounds `n = 0` alone.
    ///
    /// Cost: one pass over the head.
    pub fn decay(&self, ratio: f64, damping: f64) -> Option<Decay> {
        let weighted = Weighted::new(self, ratio, damping);
        let (elastic_drive, damping_drive) = weighted.drives(&weighted.tails()?);
        let damping_drive = damping_drive * self.damping_step_inverse;
        Some(Decay::new(ratio, damping, elastic_drive, damping_drive))
    }
}

/// Norms of the head and of the products of head terms that leave it, at one pair of weights.
struct Weighted<'m, 'h> {
    majorant: &'m Majorant<'h>,
    /// `||s||`, `||w||`.
    s: Magnitude,
    w: Magnitude,
    /// Norms of the heads of `L`, `A`, `B`, `F`.
    head: Tails,
    /// Norms of what leaves the head: `L^2 + s A + w B (1 + L)`, `L A`, `L B`, and `F A`, `F B` after
    /// the step of `s` and `w`.
    logarithmic: Magnitude,
    with_elastic: Magnitude,
    with_damping: Magnitude,
    elastic_drive: Magnitude,
    damping_drive: Magnitude,
}

impl<'m, 'h> Weighted<'m, 'h> {
    fn new(majorant: &'m Majorant<'h>, ratio: f64, damping: f64) -> Self {
        let head = majorant.head;
        let (s, w) = (
            majorant.elastic_scale * Magnitude::exact(ratio),
            majorant.damping_scale * Magnitude::exact(damping),
        );
        let [l, a, b, f] = weigh(&head.terms, ratio, damping);
        let norm = |series: &[Magnitude]| series.iter().copied().sum::<Magnitude>();
        let leaves = |x: &[Magnitude], y: &[Magnitude], step: i64| head.product_beyond(x, y, step);
        let (elastic, damping) = (head.lattice.elastic, head.lattice.damping);
        Self {
            majorant,
            s,
            w,
            head: Tails { logarithmic: norm(&l), elastic: norm(&a), damping: norm(&b), trajectory: norm(&f) },
            logarithmic: leaves(&l, &l, 0)
                + s * head.beyond(&a, elastic)
                + w * (head.beyond(&b, damping) + leaves(&b, &l, damping)),
            with_elastic: leaves(&l, &a, 0),
            with_damping: leaves(&l, &b, 0),
            elastic_drive: leaves(&f, &a, elastic),
            damping_drive: leaves(&f, &b, damping),
        }
    }

    /// Returns a solution of the inequalities (4) of theorem 1, if one is found.
    ///
    /// The candidate grows until the right sides, rounded up, lie within it.
    fn tails(&self) -> Option<Tails> {
        let wider = Magnitude::exact(1.0 + 1.0 / 64.0);
        let mut tails = Tails::default();
        for _ in 0..ROUNDS {
            let image = self.image(&tails);
            if !image.trajectory.is_finite() || !image.logarithmic.is_finite() {
                return None;
            }
            if image.within(&tails) {
                return Some(tails);
            }
            tails = image.scaled(wider);
        }
        None
    }

    /// The right sides of the inequalities (4) of theorem 1.
    fn image(&self, tails: &Tails) -> Tails {
        let Majorant { elastic_power, damping_power, damping_step_inverse, inverse, next_inverse, .. } =
            *self.majorant;
        let Tails { logarithmic: l, elastic: a, damping: b, .. } = *tails;
        let heads = &self.head;
        let product = |head_x, x, head_y, y| head_x * y + head_y * x + x * y;
        let logarithmic = self.logarithmic
            + product(heads.logarithmic, l, heads.logarithmic, l)
            + self.s * a
            + self.w * (b + product(heads.damping, b, heads.logarithmic, l));
        let (elastic_drive, damping_drive) = self.drives(tails);
        Tails {
            logarithmic: logarithmic * next_inverse,
            elastic: elastic_power
                * inverse
                * (self.with_elastic + product(heads.logarithmic, l, heads.elastic, a)),
            damping: damping_power
                * inverse
                * (self.with_damping + product(heads.logarithmic, l, heads.damping, b)),
            trajectory: next_inverse * (elastic_drive * inverse + damping_drive * damping_step_inverse),
        }
    }

    /// Norms of the tails of `s F A` and `w F B`, the forces.
    fn drives(&self, tails: &Tails) -> (Magnitude, Magnitude) {
        let heads = &self.head;
        let force = |beyond, head, tail| {
            beyond + heads.trajectory * tail + head * tails.trajectory + tails.trajectory * tail
        };
        (
            self.s * force(self.elastic_drive, heads.elastic, tails.elastic),
            self.w * force(self.damping_drive, heads.damping, tails.damping),
        )
    }
}

/// The terms of `L`, `A`, `B`, `F` in the weighted norm.
fn weigh(terms: &[Term], ratio: f64, damping: f64) -> [Vec<Magnitude>; 4] {
    let largest = |index: fn(&Term) -> usize| terms.iter().map(index).max().unwrap_or(0) + 1;
    let radial = Magnitude::exact(ratio).powers(largest(|t| t.elastic_index));
    let orders = Magnitude::exact(damping).powers(largest(|t| t.damping_order));
    let weight = |t: &Term| radial[t.elastic_index] * orders[t.damping_order];
    let weighted = |size: fn(&Term) -> Magnitude| terms.iter().map(|t| weight(t) * size(t)).collect();
    [
        weighted(|t| t.logarithmic),
        weighted(|t| t.elastic),
        weighted(|t| t.damping),
        weighted(|t| t.trajectory),
    ]
}

impl Head {
    /// The norm of the terms of `x` that a further step takes beyond the head.
    fn beyond(&self, x: &[Magnitude], step: i64) -> Magnitude {
        self.terms.iter().zip(x).filter(|(t, _)| t.grade + step > self.limit).map(|(_, x)| *x).sum()
    }

    /// A bound of the norm of the terms of `x y` that with a further step lie beyond the head.
    ///
    /// ```text
    /// sum_(g(i) + g(k) + step > limit) x_i y_k
    /// ```
    fn product_beyond(&self, x: &[Magnitude], y: &[Magnitude], step: i64) -> Magnitude {
        let mut total = Magnitude::ZERO;
        let mut suffix = Magnitude::ZERO;
        let mut next = y.len();
        for (term, x) in self.terms.iter().zip(x) {
            while next > 0 && term.grade + self.terms[next - 1].grade + step > self.limit {
                next -= 1;
                suffix = suffix + y[next];
            }
            total = total + *x * suffix;
        }
        total
    }
}

#[cfg(test)]
mod tests {
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
    fn inequalities(
        law: &ForceLaw,
        head: &Head,
        weights: (f64, f64),
        tails: [f64; 4],
    ) -> ([f64; 4], [f64; 2]) {
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
        let elastic_tail = (power - 1.0).abs()
            * (beyond(&l, &a, 0) + norm(&l) * tail_a + norm(&a) * tail_l + tail_l * tail_a);
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
}
