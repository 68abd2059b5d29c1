//! The undamped trajectory `x_0`, by Newton's iteration on series.

use crate::linearised::Linearised;
use crate::{Field, Units};
use restitution_law::ForceLaw;

/// Coefficients found one by one before the iteration starts to double them.
const FIRST_TERMS: usize = 16;

/// The undamped trajectory `x_0 = t F(s)`, `s = t^(a+1)`, with what the damped orders need of it.
pub(crate) struct Undamped<T: Field> {
    /// `F`, the coefficients `q_(0,j)`.
    pub f: Vec<T>,
    /// `F^a`, the elastic force.
    pub force: Vec<T>,
    /// `1/F`.
    pub reciprocal: Vec<T>,
    /// The linearised equation of motion around `x_0`.
    pub linearised: Linearised<T>,
}

impl<T: Field> Undamped<T> {
    /// Solves `e (e+1) q_j = -elastic (F^a)_(j-1)`, `e = (a+1) j`, for `terms` coefficients.
    pub fn solve(law: &ForceLaw, terms: usize, units: &Units<T>) -> Self {
        let (mut f, mut force) = first_terms(law, terms.min(FIRST_TERMS), units);
        let mut inverse = first_reciprocal(&f, &force);
        while f.len() < terms {
            double(law, units, &mut f, &mut force, &mut inverse, terms);
        }
        // 1/F = F^a / (F F^a).
        let inverse = extend_reciprocal(inverse, &f, &force, terms);
        let reciprocal = T::product(&force, &inverse, terms);
        let linearised = Linearised::new(law, &f);
        Self { f, force, reciprocal, linearised }
    }
}

/// The recurrence term by term, with Miller's formula for the power:
/// `j (F^a)_j = sum_(i=1..j) (a i - (j-i)) q_i (F^a)_(j-i)`.
fn first_terms<T: Field>(law: &ForceLaw, terms: usize, units: &Units<T>) -> (Vec<T>, Vec<T>) {
    let lattice = law.lattice();
    let one = units.elastic.ratio(1, 1);
    let (mut f, mut force) = (vec![one.clone()], vec![one]);
    for j in 1..as_i64(terms) {
        let e = lattice.elastic * j;
        let pull = units.elastic.times(&force[force.len() - 1]);
        f.push(-pull.scaled(lattice.unit, e).scaled(lattice.unit, e + lattice.unit));
        let mut sum = T::zero();
        for (i, q) in (1..).zip(&f[1..]) {
            let weight = (lattice.elastic - lattice.unit) * i - lattice.unit * (j - i);
            sum = sum + q.times(&force[f.len() - 1 - as_usize(i)]).scaled(weight, lattice.unit * j);
        }
        force.push(sum);
    }
    (f, force)
}

/// `1/(F F^a)` to as many terms as are given, term by term.
fn first_reciprocal<T: Field>(f: &[T], force: &[T]) -> Vec<T> {
    extend_reciprocal(vec![f[0].clone()], f, force, f.len())
}

/// Newton's iteration `z <- z (2 - z F F^a)` for the reciprocal of a series that begins with 1.
fn extend_reciprocal<T: Field>(mut z: Vec<T>, f: &[T], force: &[T], terms: usize) -> Vec<T> {
    if z.len() >= terms {
        return z;
    }
    let series = T::product(f, force, terms);
    while z.len() < terms {
        let known = z.len();
        let next = (2 * known).min(terms);
        let defect = T::product(&series, &z, next);
        let correction = T::product(&defect[known..], &z, next - known);
        z.extend(correction.into_iter().map(|c| -c));
    }
    z
}

/// One Newton step: from `n` right coefficients of `F` and `F^a` to `2 n`.
///
/// 1. The power of the polynomial `F` at hand: `F^a = G + E` with `G` known to order `n` and
///    `E = G theta^(-1)(D/(F G))`, `D = a (theta F) G - F theta G`, `theta = s d/ds`.
/// 2. The residual of the equation of motion is `elastic s (G + E)` from order `n` on.
/// 3. The linearised equation gives the correction of `F`; that of `F^a` is `a F^(a-1)` times it.
fn double<T: Field>(
    law: &ForceLaw,
    units: &Units<T>,
    f: &mut Vec<T>,
    force: &mut Vec<T>,
    inverse: &mut Vec<T>,
    terms: usize,
) {
    let lattice = law.lattice();
    let a = lattice.elastic - lattice.unit;
    let known = f.len();
    let next = (2 * known).min(terms);
    let new = next - known;

    let slope_of_f = T::factor(&T::scale_each(f, &|i| (a * as_i64(i), lattice.unit)), next);
    let slope_of_force = T::factor(&T::scale_each(force, &|i| (as_i64(i), 1)), next);
    let (f_factor, force_factor) = (T::factor(f, next), T::factor(force, next));
    let defect =
        T::sum_of_products(&[(1, &slope_of_f, &force_factor), (-1, &f_factor, &slope_of_force)], next);
    *inverse = extend_reciprocal(std::mem::take(inverse), f, force, new.max(known.min(terms)));
    let quotient = T::product(&defect[known..], inverse, new);
    let quotient = T::scale_each(&quotient, &|i| (1, as_i64(known + i)));
    let missing = T::product(force, &quotient, new);

    let pulls = force[known - 1..].iter().chain(&missing).take(new);
    let residual: Vec<T> = pulls.map(|g| -units.elastic.times(g)).collect();
    let linearised = Linearised::new(law, f);
    let correction = linearised.solve(&residual, known, 0);

    let reciprocal = T::product(force, inverse, new);
    let stiffness = T::product(force, &reciprocal, new);
    let change = T::scale_each(&T::product(&stiffness, &correction, new), &|_| (a, lattice.unit));
    f.extend(correction);
    force.extend(missing.into_iter().zip(change).map(|(x, y)| x + y));
}

fn as_i64(index: usize) -> i64 {
    i64::try_from(index).unwrap_or(i64::MAX)
}

fn as_usize(index: i64) -> usize {
    usize::try_from(index).unwrap_or(0)
}
