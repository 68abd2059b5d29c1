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
mod tests;
