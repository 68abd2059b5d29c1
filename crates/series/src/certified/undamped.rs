//! The undamped trajectory `x_0 = t F(s)` in fixed point, by Newton's iteration.

use super::units::Scale;
use crate::kernels::{Fixed, Workshop};
use rug::Integer;

/// Coefficients found one by one before the iteration starts to double them.
const FIRST_TERMS: usize = 16;

/// `F` with what the damped orders need of it.
pub(crate) struct Undamped {
    /// `F`.
    pub f: Fixed,
    /// `e F^a`.
    pub force: Fixed,
    /// `1/F`.
    pub reciprocal: Fixed,
}

/// The two solutions of the linearised equation `d'' + a e x_0^(a-1) d = r` without right side:
///
/// ```text
/// V = x_0' (shift of time),    P = x_0 + (a-1)/2 t x_0' (change of scale),    V P' - V' P = (a+1)/2
/// d = 2/(a+1) (P int V r dt - V int P r dt)
/// ```
///
/// No series is divided: all of them decay as `x_0` itself does.
pub(crate) struct Linearised {
    pub velocity: Fixed,
    pub rescaling: Fixed,
}

impl Linearised {
    pub fn new(scale: &Scale, f: &Fixed) -> Self {
        let lattice = scale.lattice;
        let velocity = f.scaled(|j| (scale.index(0, j) + lattice.unit, lattice.unit));
        let mut rescaling = velocity.scaled(|_| (lattice.elastic - 2 * lattice.unit, 2 * lattice.unit));
        rescaling.add(f);
        Self { velocity, rescaling }
    }

    /// The coefficients of `d` from `first` on for those of `r`, at damping order 0.
    fn solve(&self, shop: &Workshop, scale: &Scale, right: &Fixed, first: usize) -> Fixed {
        let lattice = scale.lattice;
        let len = right.len();
        let e = |j: usize| scale.index(0, first + j);
        let work = shop.product(&self.velocity, right, len).scaled(|j| (lattice.unit, e(j)));
        let moment =
            shop.product(&self.rescaling, right, len).scaled(|j| (lattice.unit, e(j) + lattice.unit));
        let sum = shop.products(&[(-1, &self.velocity, &moment), (1, &self.rescaling, &work)], 0..len);
        sum.scaled(|_| (2 * lattice.unit, lattice.elastic))
    }
}

impl Undamped {
    /// Solves `e_j (e_j+1) q_j = -(e F^a)_(j-1)` for `terms` coefficients.
    pub fn solve(shop: &Workshop, scale: &Scale, terms: usize) -> Self {
        let (mut f, mut force) = first_terms(shop, scale, terms.min(FIRST_TERMS));
        let one = Integer::from(1) << (2 * shop.bits());
        let lead = Fixed::from_integers(&[one / force.integer(0)], shop.width());
        let mut inverse = extend_reciprocal(shop, lead, &f, &force, f.len());
        let mut reciprocal = shop.product(&force, &inverse, f.len());
        while f.len() < terms {
            reciprocal = double(shop, scale, &mut f, &mut force, &mut inverse, terms);
        }
        let reciprocal = newton_reciprocal(shop, reciprocal, &f, terms);
        Self { f, force, reciprocal }
    }
}

/// The recurrence term by term, with Miller's formula for the power:
/// `j (F^a)_j = sum_(i=1..j) (a i - (j-i)) q_i (F^a)_(j-i)`.
fn first_terms(shop: &Workshop, scale: &Scale, terms: usize) -> (Fixed, Fixed) {
    let lattice = scale.lattice;
    let one = Integer::from(1) << shop.bits();
    let mut f = vec![one];
    let mut force = vec![super::units::fixed(&scale.elastic, shop.bits())];
    for j in 1..terms {
        let e = scale.index(0, j);
        let pull = -Integer::from(&force[j - 1] * lattice.unit) / e;
        f.push(pull * lattice.unit / (e + lattice.unit));
        let mut sum = Integer::new();
        for i in 1..=j {
            let weight = scale.powers()[0] * i as i64 - lattice.unit * (j - i) as i64;
            sum += Integer::from(&f[i] * &force[j - i]) * weight;
        }
        force.push((sum >> shop.bits()) / (lattice.unit * j as i64));
    }
    (Fixed::from_integers(&f, shop.width()), Fixed::from_integers(&force, shop.width()))
}

/// Continues the reciprocal of `F G`.
fn extend_reciprocal(shop: &Workshop, z: Fixed, f: &Fixed, g: &Fixed, terms: usize) -> Fixed {
    if z.len() >= terms {
        return z;
    }
    newton_reciprocal(shop, z, &shop.product(f, g, terms), terms)
}

/// Newton's iteration `z <- z (2 - z F)` for the reciprocal of a series.
fn newton_reciprocal(shop: &Workshop, mut z: Fixed, series: &Fixed, terms: usize) -> Fixed {
    while z.len() < terms {
        let known = z.len();
        let next = (2 * known).min(terms);
        let defect = shop.products(&[(1, series, &z)], known..next);
        z.extend(&shop.product(&defect, &z, next - known).negated());
    }
    z
}

/// One Newton step: from `n` right coefficients of `F` and `e F^a` to `2 n`.
///
/// 1. The power of the polynomial `F` at hand: `F^a = G + E` with `G` known to order `n` and
///    `E = G theta^(-1)(D/(F G))`, `D = a (theta F) G - F theta G`, `theta = s d/ds`.
/// 2. The residual of the equation of motion is `s (G + E)` from order `n` on.
/// 3. The linearised equation gives the correction of `F`; that of `F^a` is `a F^(a-1)` times it.
///
/// Returns the first terms of `1/F`.
fn double(
    shop: &Workshop,
    scale: &Scale,
    f: &mut Fixed,
    force: &mut Fixed,
    inverse: &mut Fixed,
    terms: usize,
) -> Fixed {
    let (unit, a) = (scale.lattice.unit, scale.powers()[0]);
    let known = f.len();
    let next = (2 * known).min(terms);
    let new = next - known;

    let slope_of_f = f.scaled(|i| (a * i as i64, unit));
    let slope_of_force = force.scaled(|i| (i as i64, 1));
    let defect = shop.products(&[(-1, f, &slope_of_force), (1, &slope_of_f, force)], known..next);
    *inverse = extend_reciprocal(shop, inverse.clone(), f, force, known);
    let quotient = shop.product(&defect, inverse, new).scaled(|i| (1, (known + i) as i64));
    let missing = shop.product(force, &quotient, new);

    let mut pulls = force.beyond(known - 1);
    pulls.extend(&missing);
    let residual = pulls.truncated(new).negated();
    let correction = Linearised::new(scale, f).solve(shop, scale, &residual, known);

    let reciprocal = shop.product(force, inverse, new);
    let stiffness = shop.product(force, &reciprocal, new);
    let mut change = shop.product(&stiffness, &correction, new).scaled(|_| (a, unit));
    change.add(&missing);
    f.extend(&correction);
    force.extend(&change);
    reciprocal
}
