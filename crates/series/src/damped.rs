//! The orders `x_1, x_2, ...` in the damping, one after the other.

use crate::undamped::Undamped;
use crate::{Field, Units};
use restitution_law::ForceLaw;

/// A power `F^p` of `F = sum_n w^n F_n`, order by order in `w`, by Miller's formula over series.
///
/// ```text
/// (F^p)_n = p F_0^(p-1) F_n + K_n,
/// K_n = 1/(n F_0) sum_(k=1..n-1) (p k - (n-k)) F_k (F^p)_(n-k)
/// ```
struct Power<T: Field> {
    /// `p` is `steps/unit`.
    steps: i64,
    unit: i64,
    /// `p F_0^(p-1)`.
    slope: T::Factor,
    orders: Vec<T::Factor>,
    latest: Vec<T>,
}

impl<T: Field> Power<T> {
    fn new(steps: i64, unit: i64, zeroth: Vec<T>, reciprocal: &T::Factor) -> Self {
        let len = zeroth.len();
        let factor = T::factor(&zeroth, len);
        let slope = T::sum_of_products(&[(1, &factor, reciprocal)], len);
        let slope = T::factor(&T::scale_each(&slope, &|_| (steps, unit)), len);
        Self { steps, unit, slope, orders: vec![factor], latest: zeroth }
    }

    /// `K_n`, what the lower orders contribute to order `n >= 2`; zero for `n = 1`.
    fn lower_orders(&self, f: &[T::Factor], reciprocal: &T::Factor, len: usize) -> Vec<T> {
        let n = f.len();
        if n < 2 {
            return vec![T::zero(); len];
        }
        let term = |k: usize| {
            let (k_, rest) = (as_i64(k), as_i64(n - k));
            (self.steps * k_ - self.unit * rest, &f[k], &self.orders[n - k])
        };
        let sum = T::sum_of_products(&(1..n).map(term).collect::<Vec<_>>(), len);
        let sum = T::factor(&T::scale_each(&sum, &|_| (1, self.unit * as_i64(n))), len);
        T::sum_of_products(&[(1, &sum, reciprocal)], len)
    }

    /// Adds order `n`, `p F_0^(p-1) F_n + K_n`.
    fn push(&mut self, f_n: &T::Factor, lower: Vec<T>) {
        let len = lower.len();
        let change = T::sum_of_products(&[(1, &self.slope, f_n)], len);
        self.latest = change.into_iter().zip(lower).map(|(x, y)| x + y).collect();
        self.orders.push(T::factor(&self.latest, len));
    }
}

/// Returns `F_0 .. F_N`: order `n` solves the linearised equation with right side
///
/// ```text
/// -(e/(gamma+1)) damping (F^(gamma+1))_(n-1) - elastic s K_n,    K_n of F^a
/// ```
pub(crate) fn damped_orders<T: Field>(
    law: &ForceLaw,
    undamped: Undamped<T>,
    damping_order: usize,
    units: &Units<T>,
    watch: &mut dyn FnMut(usize),
) -> Vec<Vec<T>> {
    let lattice = law.lattice();
    let Undamped { f, force, reciprocal, linearised } = undamped;
    let len = f.len();
    let reciprocal = T::factor(&reciprocal, len);
    let friction_power = friction_at_order_zero(law, &f, &reciprocal);
    let mut friction =
        friction_power.map(|zeroth| Power::new(lattice.damping, lattice.unit, zeroth, &reciprocal));
    let mut force = Power::new(lattice.elastic - lattice.unit, lattice.unit, force, &reciprocal);
    let mut factors = vec![T::factor(&f, len)];
    let mut orders = vec![f];
    for n in 1..=damping_order {
        let lower = force.lower_orders(&factors, &reciprocal, len);
        let lower_friction = friction.as_ref().map(|power| power.lower_orders(&factors, &reciprocal, len));
        let e = |j: usize| (lattice.elastic * as_i64(j) + lattice.damping * as_i64(n), lattice.damping);
        let drag = T::scale_each(&friction.as_ref().unwrap_or(&force).latest, &e);
        let shifted = std::iter::once(T::zero()).chain(lower.iter().cloned());
        let total = |(drag, pull): (T, T)| -(units.damping.times(&drag) + units.elastic.times(&pull));
        let right: Vec<T> = drag.into_iter().zip(shifted).map(total).collect();
        let f_n = linearised.solve(&right, 0, n);
        if n < damping_order {
            let factor = T::factor(&f_n, len);
            force.push(&factor, lower);
            if let (Some(friction), Some(lower)) = (friction.as_mut(), lower_friction) {
                friction.push(&factor, lower);
            }
            factors.push(factor);
        }
        orders.push(f_n);
        watch(n);
    }
    orders
}

/// `F_0^(gamma+1)`, or `None` where it is the elastic force itself (`gamma + 1 = a`, eq. 13).
///
/// With `theta = s d/ds`, `H = F^p` solves `theta H = p (theta F)/F H`.
fn friction_at_order_zero<T: Field>(law: &ForceLaw, f: &[T], reciprocal: &T::Factor) -> Option<Vec<T>> {
    if law.is_viscoelastic() {
        return None;
    }
    let lattice = law.lattice();
    let len = f.len();
    // theta log F = (theta F)/F.
    let slope = T::factor(&T::scale_each(f, &|j| (as_i64(j), 1)), len);
    let logarithmic = T::sum_of_products(&[(1, &slope, reciprocal)], len);
    let rate = T::scale_each(&logarithmic, &|_| (lattice.damping, lattice.unit));
    Some(exponential(&rate))
}

/// The series `H` with `H_0 = 1` and `theta H = rate H` (`rate_0 = 0`).
///
/// Newton's iteration with `1/H` carried along: `H <- H (1 + theta^(-1)((rate H - theta H)/H))`.
fn exponential<T: Field>(rate: &[T]) -> Vec<T> {
    let len = rate.len();
    // With the precision of the rate, which its zero constant term need not have.
    let one = rate.iter().find(|c| !c.is_zero()).map_or_else(T::one, |c| c.ratio(1, 1));
    let (mut h, mut inverse) = (vec![one.clone()], vec![one]);
    while h.len() < len {
        let known = h.len();
        let next = (2 * known).min(len);
        let new = next - known;
        // The defect rate H - theta H vanishes below `known`; there theta H has no further terms.
        let defect = T::product(rate, &h, next);
        let quotient = T::product(&defect[known..], &inverse, new);
        let quotient = T::scale_each(&quotient, &|i| (1, as_i64(known + i)));
        h.extend(T::product(&h, &quotient, new));
        let overlap = T::product(&h, &inverse, next);
        let correction = T::product(&overlap[known..], &inverse, new);
        inverse.extend(correction.into_iter().map(|c| -c));
    }
    h
}

fn as_i64(index: usize) -> i64 {
    i64::try_from(index).unwrap_or(i64::MAX)
}
