//! The orders `x_1, x_2, ...` in the damping modulo a prime, one after the other.

use super::modulus::{Modulus, Transformed};
use super::undamped::Undamped;
use restitution_law::ForceLaw;

/// A power `F^p` of `F = sum_n w^n F_n`, order by order in `w`, by Miller's formula over series.
///
/// ```text
/// (F^p)_n = p F_0^(p-1) F_n + K_n,
/// K_n = 1/(n F_0) sum_(k=1..n-1) (p k - (n-k)) F_k (F^p)_(n-k)
/// ```
struct Power {
    /// `p` is `steps/unit`.
    steps: i64,
    unit: i64,
    /// `p F_0^(p-1)`.
    slope: Transformed,
    orders: Vec<Transformed>,
    latest: Vec<u64>,
}

impl Power {
    fn new(modulus: &Modulus, steps: i64, unit: i64, zeroth: Vec<u64>, reciprocal: &Transformed) -> Self {
        let len = zeroth.len();
        let factor = modulus.transform(&zeroth, len);
        let slope = modulus.sum_of_products(&[(1, &factor, reciprocal)], len);
        let slope = modulus.transform(&modulus.scale_each(&slope, |_| (steps, unit)), len);
        Self { steps, unit, slope, orders: vec![factor], latest: zeroth }
    }

    /// `K_n`, what the lower orders contribute to order `n >= 2`; zero for `n = 1`.
    fn lower_orders(
        &self,
        modulus: &Modulus,
        f: &[Transformed],
        reciprocal: &Transformed,
        len: usize,
    ) -> Vec<u64> {
        let n = f.len();
        if n < 2 {
            return vec![0; len];
        }
        let term = |k: usize| {
            let (k_, rest) = (as_i64(k), as_i64(n - k));
            (self.steps * k_ - self.unit * rest, &f[k], &self.orders[n - k])
        };
        let sum = modulus.sum_of_products(&(1..n).map(term).collect::<Vec<_>>(), len);
        let sum = modulus.transform(&modulus.scale_each(&sum, |_| (1, self.unit * as_i64(n))), len);
        modulus.sum_of_products(&[(1, &sum, reciprocal)], len)
    }

    /// Adds order `n`, `p F_0^(p-1) F_n + K_n`.
    fn push(&mut self, modulus: &Modulus, f_n: &Transformed, lower: &[u64]) {
        let len = lower.len();
        self.latest = modulus.sum(&modulus.sum_of_products(&[(1, &self.slope, f_n)], len), lower);
        self.orders.push(modulus.transform(&self.latest, len));
    }
}

/// Returns `F_0 .. F_N`: order `n` solves the linearised equation with right side
///
/// ```text
/// -(e/(gamma+1)) (F^(gamma+1))_(n-1) - s K_n,    K_n of F^a
/// ```
pub(super) fn damped_orders(
    modulus: &Modulus,
    law: &ForceLaw,
    undamped: Undamped,
    damping_order: usize,
) -> Vec<Vec<u64>> {
    let lattice = law.lattice();
    let Undamped { f, force, reciprocal, linearised } = undamped;
    let len = f.len();
    let reciprocal = modulus.transform(&reciprocal, len);
    let power = |steps: i64, zeroth: Vec<u64>| Power::new(modulus, steps, lattice.unit, zeroth, &reciprocal);
    let mut friction =
        friction_at_order_zero(modulus, law, &f, &reciprocal).map(|zeroth| power(lattice.damping, zeroth));
    let mut force = power(lattice.elastic - lattice.unit, force);
    let mut factors = vec![modulus.transform(&f, len)];
    let mut orders = vec![f];
    for n in 1..=damping_order {
        let lower = force.lower_orders(modulus, &factors, &reciprocal, len);
        let lower_friction =
            friction.as_ref().map(|power| power.lower_orders(modulus, &factors, &reciprocal, len));
        let e = |j: usize| (lattice.elastic * as_i64(j) + lattice.damping * as_i64(n), lattice.damping);
        let mut right = modulus.scale_each(&friction.as_ref().unwrap_or(&force).latest, e);
        for (sum, pull) in right[1..].iter_mut().zip(&lower) {
            *sum = modulus.prime.add(*sum, *pull);
        }
        right.iter_mut().for_each(|x| *x = modulus.negated(*x));
        let f_n = linearised.solve(modulus, &right, 0, n);
        if n < damping_order {
            let factor = modulus.transform(&f_n, len);
            force.push(modulus, &factor, &lower);
            if let (Some(friction), Some(lower)) = (friction.as_mut(), lower_friction) {
                friction.push(modulus, &factor, &lower);
            }
            factors.push(factor);
        }
        orders.push(f_n);
    }
    orders
}

/// `F_0^(gamma+1)`, or `None` where it is the elastic force itself (`gamma + 1 = a`, eq. 13).
///
/// With `theta = s d/ds`, `H = F^p` solves `theta H = p (theta F)/F H`.
fn friction_at_order_zero(
    modulus: &Modulus,
    law: &ForceLaw,
    f: &[u64],
    reciprocal: &Transformed,
) -> Option<Vec<u64>> {
    if law.is_viscoelastic() {
        return None;
    }
    let lattice = law.lattice();
    let len = f.len();
    let slope = modulus.transform(&modulus.scale_each(f, |j| (as_i64(j), 1)), len);
    let logarithmic = modulus.sum_of_products(&[(1, &slope, reciprocal)], len);
    let rate = modulus.scale_each(&logarithmic, |_| (lattice.damping, lattice.unit));
    Some(exponential(modulus, &rate))
}

/// The series `H` with `H_0 = 1` and `theta H = rate H` (`rate_0 = 0`).
///
/// Newton's iteration with `1/H` carried along: `H <- H (1 + theta^(-1)((rate H - theta H)/H))`.
fn exponential(modulus: &Modulus, rate: &[u64]) -> Vec<u64> {
    let len = rate.len();
    let one = modulus.prime.one;
    let (mut h, mut inverse) = (vec![one], vec![one]);
    while h.len() < len {
        let known = h.len();
        let next = (2 * known).min(len);
        let new = next - known;
        // The defect rate H - theta H vanishes below `known`; there theta H has no further terms.
        let defect = modulus.product(rate, &h, next);
        let quotient = modulus.product(&defect[known..], &inverse, new);
        let quotient = modulus.scale_each(&quotient, |i| (1, as_i64(known + i)));
        h.extend(modulus.product(&h, &quotient, new));
        let overlap = modulus.product(&h, &inverse, next);
        let correction = modulus.product(&overlap[known..], &inverse, new);
        inverse.extend(correction.into_iter().map(|c| modulus.negated(c)));
    }
    h
}

fn as_i64(index: usize) -> i64 {
    i64::try_from(index).unwrap_or(i64::MAX)
}
