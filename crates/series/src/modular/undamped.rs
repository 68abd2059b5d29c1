//! The undamped trajectory `x_0` modulo a prime, by Newton's iteration on series.

use super::linearised::Linearised;
use super::modulus::Modulus;
use restitution_law::ForceLaw;

/// Coefficients found one by one before the iteration starts to double them.
const FIRST_TERMS: usize = 16;

/// The undamped trajectory `x_0 = t F(s)`, `s = t^(a+1)`, with what the damped orders need of it.
pub(super) struct Undamped {
    /// `F`, the coefficients `q_(0,j)`.
    pub f: Vec<u64>,
    /// `F^a`, the elastic force.
    pub force: Vec<u64>,
    /// `1/F`.
    pub reciprocal: Vec<u64>,
    /// The linearised equation of motion around `x_0`.
    pub linearised: Linearised,
}

impl Undamped {
    /// Solves `e (e+1) q_j = -(F^a)_(j-1)`, `e = (a+1) j`, for `terms` coefficients.
    pub fn solve(modulus: &Modulus, law: &ForceLaw, terms: usize) -> Self {
        let (mut f, mut force) = first_terms(modulus, law, terms.min(FIRST_TERMS));
        let mut inverse = extend_reciprocal(modulus, vec![modulus.prime.one], &f, &force, f.len());
        while f.len() < terms {
            double(modulus, law, &mut f, &mut force, &mut inverse, terms);
        }
        // 1/F = F^a / (F F^a).
        let inverse = extend_reciprocal(modulus, inverse, &f, &force, terms);
        let reciprocal = modulus.product(&force, &inverse, terms);
        let linearised = Linearised::new(modulus, law, &f);
        Self { f, force, reciprocal, linearised }
    }
}

/// The recurrence term by term, with Miller's formula for the power:
/// `j (F^a)_j = sum_(i=1..j) (a i - (j-i)) q_i (F^a)_(j-i)`.
fn first_terms(modulus: &Modulus, law: &ForceLaw, terms: usize) -> (Vec<u64>, Vec<u64>) {
    let (lattice, prime) = (law.lattice(), &modulus.prime);
    let (mut f, mut force) = (vec![prime.one], vec![prime.one]);
    for j in 1..terms {
        let e = lattice.elastic * as_i64(j);
        let pull = modulus.scaled(force[j - 1], lattice.unit, e);
        f.push(modulus.negated(modulus.scaled(pull, lattice.unit, e + lattice.unit)));
        let term = |i: usize| {
            let weight = (lattice.elastic - lattice.unit) * as_i64(i) - lattice.unit * as_i64(j - i);
            prime.mul(prime.mul(f[i], force[j - i]), prime.form(weight))
        };
        let sum = (1..=j).fold(0, |sum, i| prime.add(sum, term(i)));
        force.push(modulus.scaled(sum, 1, lattice.unit * as_i64(j)));
    }
    (f, force)
}

/// Newton's iteration `z <- z (2 - z F F^a)` for the reciprocal of a series that begins with 1.
fn extend_reciprocal(modulus: &Modulus, mut z: Vec<u64>, f: &[u64], force: &[u64], terms: usize) -> Vec<u64> {
    if z.len() >= terms {
        return z;
    }
    let series = modulus.product(f, force, terms);
    while z.len() < terms {
        let known = z.len();
        let next = (2 * known).min(terms);
        let defect = modulus.product(&series, &z, next);
        let correction = modulus.product(&defect[known..], &z, next - known);
        z.extend(correction.into_iter().map(|c| modulus.negated(c)));
    }
    z
}

/// One Newton step: from `n` right coefficients of `F` and `F^a` to `2 n`.
///
/// 1. The power of the polynomial `F` at hand: `F^a = G + E` with `G` known to order `n` and
///    `E = G theta^(-1)(D/(F G))`, `D = a (theta F) G - F theta G`, `theta = s d/ds`.
/// 2. The residual of the equation of motion is `s (G + E)` from order `n` on.
/// 3. The linearised equation gives the correction of `F`; that of `F^a` is `a F^(a-1)` times it.
fn double(
    modulus: &Modulus,
    law: &ForceLaw,
    f: &mut Vec<u64>,
    force: &mut Vec<u64>,
    inverse: &mut Vec<u64>,
    terms: usize,
) {
    let lattice = law.lattice();
    let a = lattice.elastic - lattice.unit;
    let known = f.len();
    let next = (2 * known).min(terms);
    let new = next - known;

    let slope_of_f = modulus.scale_each(f, |i| (a * as_i64(i), lattice.unit));
    let slope_of_force = modulus.scale_each(force, |i| (as_i64(i), 1));
    let [slope_of_f, slope_of_force, f_factor, force_factor] =
        [&slope_of_f, &slope_of_force, &*f, &*force].map(|series| modulus.transform(series, next));
    let defect =
        modulus.sum_of_products(&[(1, &slope_of_f, &force_factor), (-1, &f_factor, &slope_of_force)], next);
    *inverse = extend_reciprocal(modulus, std::mem::take(inverse), f, force, known);
    let quotient = modulus.product(&defect[known..], inverse, new);
    let quotient = modulus.scale_each(&quotient, |i| (1, as_i64(known + i)));
    let missing = modulus.product(force, &quotient, new);

    let pulls = force[known - 1..].iter().chain(&missing).take(new);
    let residual: Vec<u64> = pulls.map(|&g| modulus.negated(g)).collect();
    let correction = Linearised::new(modulus, law, f).solve(modulus, &residual, known, 0);

    let reciprocal = modulus.product(force, inverse, new);
    let stiffness = modulus.product(force, &reciprocal, new);
    let change = modulus.scale_each(&modulus.product(&stiffness, &correction, new), |_| (a, lattice.unit));
    f.extend(correction);
    force.extend(modulus.sum(&missing, &change));
}

fn as_i64(index: usize) -> i64 {
    i64::try_from(index).unwrap_or(i64::MAX)
}
