//! The trajectories modulo eight primes at once, in the units of the paper.

use super::residues::Residues;
use crate::kernels::{Lanes, size_for};
use restitution_law::Lattice;

/// The equation of motion modulo eight primes.
pub(super) struct Motion<'r> {
    pub field: &'r Residues,
    pub lattice: Lattice,
    /// Whether the damping force is a multiple of the elastic one, `gamma + 1 = a`.
    pub shared: bool,
    pub terms: usize,
}

/// The undamped trajectory `x_0 = t F(s)` with what the damped orders need of it.
struct Undamped {
    /// `F`.
    f: Vec<Lanes>,
    /// `F^a`.
    force: Vec<Lanes>,
    /// `1/F`.
    reciprocal: Vec<Lanes>,
}

/// The two solutions `V = x_0'` and `P = x_0 + (a-1)/2 t x_0'` of the linearised equation (see `certified::undamped`).
struct Linearised {
    velocity: Vec<Lanes>,
    rescaling: Vec<Lanes>,
}

/// A power `F^p`, `p = steps/unit`, order by order: `(F^p)_n = p F_0^(p-1) F_n + K_n`, `K_n` by Miller's formula.
struct Power {
    steps: i64,
    /// The transform of `p F_0^(p-1)`.
    slope: Vec<Lanes>,
    transforms: Vec<Vec<Lanes>>,
    latest: Vec<Lanes>,
}

impl Motion<'_> {
    /// The lattice index `e unit` of `t^e` in order `n`, with `t^1` taken out.
    fn index(&self, n: usize, j: usize) -> i64 {
        self.lattice.elastic * j as i64 + self.lattice.damping * n as i64
    }

    /// `a unit`.
    fn a(&self) -> i64 {
        self.lattice.elastic - self.lattice.unit
    }

    /// `F_0 .. F_N`: order `n` solves the linearised equation with right side
    /// `-(e_n/(gamma+1)) (F^(gamma+1))_(n-1) - s K_n`, `K_n` of `F^a`.
    pub fn orders(&self, damping_order: usize) -> Vec<Vec<Lanes>> {
        let (field, terms) = (self.field, self.terms);
        let Undamped { f, force, reciprocal } = self.undamped();
        if damping_order == 0 {
            return vec![f];
        }
        let size = size_for(2 * terms);
        let transform = |series: &[Lanes]| field.transform(series, size);
        let reciprocal = transform(&reciprocal);
        let linearised = self.linearised(&f);
        let linearised = [transform(&linearised.velocity), transform(&linearised.rescaling)];
        let mut friction = (!self.shared).then(|| {
            let zeroth = self.friction_at_order_zero(&f, &reciprocal);
            self.power(self.lattice.damping, zeroth, &reciprocal)
        });
        let mut force = self.power(self.a(), force, &reciprocal);
        let mut transforms = vec![transform(&f)];
        let mut found = vec![f];
        for n in 1..=damping_order {
            let lower = self.lower(&force, &transforms, &reciprocal);
            let lower_friction = friction.as_ref().map(|power| self.lower(power, &transforms, &reciprocal));
            let drag = field.weighted(&friction.as_ref().unwrap_or(&force).latest, |j| -self.index(n, j));
            let mut right = field.over(drag, self.lattice.damping);
            if let Some(lower) = &lower {
                let mut pull = vec![Lanes::ZERO];
                pull.extend(lower.iter().map(|&pull| -pull));
                right = field.add(right, &pull);
            }
            let f_n = self.solve(&linearised, &right, 0, n);
            if n < damping_order {
                let transformed = transform(&f_n);
                self.push(&mut force, &transformed, lower);
                if let Some(friction) = &mut friction {
                    self.push(friction, &transformed, lower_friction.flatten());
                }
                transforms.push(transformed);
            }
            found.push(f_n);
        }
        found
    }

    fn power(&self, steps: i64, zeroth: Vec<Lanes>, reciprocal: &[Lanes]) -> Power {
        let (field, size) = (self.field, reciprocal.len());
        let transform = field.transform(&zeroth, size);
        let slope = field.sum(&[(steps, &transform, reciprocal)], self.terms, self.lattice.unit);
        let slope = field.transform(&slope, size);
        Power { steps, slope, transforms: vec![transform], latest: zeroth }
    }

    /// `K_n`, what the lower orders contribute to order `n`; nothing for `n = 1`.
    fn lower(&self, power: &Power, f: &[Vec<Lanes>], reciprocal: &[Lanes]) -> Option<Vec<Lanes>> {
        let (n, unit) = (f.len(), self.lattice.unit);
        let weight = |k: usize| power.steps * k as i64 - unit * (n - k) as i64;
        let terms: Vec<_> =
            (1..n).map(|k| (weight(k), f[k].as_slice(), power.transforms[n - k].as_slice())).collect();
        if terms.is_empty() {
            return None;
        }
        let sum = self.field.sum(&terms, self.terms, unit * n as i64);
        let sum = self.field.transform(&sum, reciprocal.len());
        Some(self.field.sum(&[(1, &sum, reciprocal)], self.terms, 1))
    }

    /// Adds an order to a power.
    fn push(&self, power: &mut Power, f_n: &[Lanes], lower: Option<Vec<Lanes>>) {
        let mut latest = self.field.sum(&[(1, &power.slope, f_n)], self.terms, 1);
        if let Some(lower) = lower {
            latest = self.field.add(latest, &lower);
        }
        power.transforms.push(self.field.transform(&latest, f_n.len()));
        power.latest = latest;
    }

    fn linearised(&self, f: &[Lanes]) -> Linearised {
        let Lattice { elastic, unit, .. } = self.lattice;
        let field = self.field;
        let velocity = field.weighted(f, |j| self.index(0, j) + unit);
        // F + (a-1)/2 V.
        let rescaling =
            field.weighted(f, |j| 2 * unit * unit + (elastic - 2 * unit) * (self.index(0, j) + unit));
        Linearised { velocity: field.over(velocity, unit), rescaling: field.over(rescaling, 2 * unit * unit) }
    }

    /// `d = 2/(a+1) (P int V r dt - V int P r dt)` for the coefficients of `r` from `first` on in order `n`.
    fn solve(
        &self,
        [velocity, rescaling]: &[Vec<Lanes>; 2],
        right: &[Lanes],
        first: usize,
        n: usize,
    ) -> Vec<Lanes> {
        let Lattice { elastic, unit, .. } = self.lattice;
        let (field, len, size) = (self.field, right.len(), velocity.len());
        let right = field.transform(right, size);
        let e = |j: usize| self.index(n, first + j);
        let over = field.reciprocals((0..len).map(e).chain((0..len).map(|j| e(j) + unit)));
        let part = |solution: &[Lanes], over: &[Lanes]| {
            let part = field.sum(&[(unit, solution, &right)], len, 1);
            field.transform(&field.scaled(part, over), size)
        };
        let (work, moment) = (part(velocity, &over[..len]), part(rescaling, &over[len..]));
        field.sum(&[(2 * unit, rescaling, &work), (-2 * unit, velocity, &moment)], len, elastic)
    }

    /// `F_0^(gamma+1)`: with `theta = s d/ds`, `H = F^p` solves `theta H = p (theta F)/F H`.
    ///
    /// Newton's iteration with `1/H` carried along: `H <- H (1 + theta^(-1)((rate H - theta H)/H))`.
    fn friction_at_order_zero(&self, f: &[Lanes], reciprocal: &[Lanes]) -> Vec<Lanes> {
        let (field, len) = (self.field, f.len());
        let slope = field.transform(&field.weighted(f, |j| j as i64), reciprocal.len());
        let rate = field.sum(&[(self.lattice.damping, &slope, reciprocal)], len, self.lattice.unit);
        let (mut h, mut inverse) = (vec![Lanes::ONE], vec![Lanes::ONE]);
        while h.len() < len {
            let known = h.len();
            let next = (2 * known).min(len);
            let new = next - known;
            let defect = field.products(&[(1, &rate, &h)], known..next);
            let quotient = field.product(&defect, &inverse, new);
            let quotient = field.scaled(quotient, &field.reciprocals((known..next).map(|i| i as i64)));
            h.extend(field.product(&h, &quotient, new));
            let overlap = field.products(&[(-1, &h, &inverse)], known..next);
            inverse.extend(field.product(&overlap, &inverse, new));
        }
        h
    }

    /// Solves `e (e+1) q_j = -(F^a)_(j-1)`, `e = (a+1) j`, by Newton's iteration from one term on.
    fn undamped(&self) -> Undamped {
        let terms = self.terms;
        let (mut f, mut force, mut inverse) = (vec![Lanes::ONE], vec![Lanes::ONE], vec![Lanes::ONE]);
        let mut reciprocal = vec![Lanes::ONE];
        while f.len() < terms {
            reciprocal = self.double(&mut f, &mut force, &mut inverse);
        }
        let reciprocal = self.field.reciprocal(reciprocal, &f, terms);
        Undamped { f, force, reciprocal }
    }

    /// One Newton step: from `n` right coefficients of `F` and `F^a` to `2 n` (see `certified::undamped::double`).
    ///
    /// Returns the first terms of `1/F`.
    fn double(&self, f: &mut Vec<Lanes>, force: &mut Vec<Lanes>, inverse: &mut Vec<Lanes>) -> Vec<Lanes> {
        let (field, unit, a) = (self.field, self.lattice.unit, self.a());
        let known = f.len();
        let next = (2 * known).min(self.terms);
        let new = next - known;
        let slope_of_f = field.weighted(f, |i| a * i as i64);
        let slope_of_force = field.weighted(force, |i| unit * i as i64);
        let defect = field.products(&[(-1, f, &slope_of_force), (1, &slope_of_f, force)], known..next);
        if inverse.len() < known {
            let product = field.product(f, force, known);
            *inverse = field.reciprocal(std::mem::take(inverse), &product, known);
        }
        let over = field.reciprocals((known..next).map(|i| unit * i as i64));
        let quotient = field.scaled(field.product(&defect, inverse, new), &over);
        let missing = field.product(force, &quotient, new);

        let mut pulls = force[known - 1..].to_vec();
        pulls.extend_from_slice(&missing);
        let residual: Vec<Lanes> = pulls[..new].iter().map(|&pull| -pull).collect();
        let linearised = self.linearised(f);
        let size = size_for(2 * new);
        let transform = |series: &[Lanes]| field.transform(&series[..series.len().min(new)], size);
        let linearised = [transform(&linearised.velocity), transform(&linearised.rescaling)];
        let correction = self.solve(&linearised, &residual, known, 0);

        let reciprocal = field.product(force, inverse, new);
        let stiffness = field.product(force, &reciprocal, new);
        let change = field.products(&[(a, &stiffness, &correction)], 0..new);
        f.extend(correction);
        force.extend(field.add(missing, &field.over(change, unit)));
        reciprocal
    }
}
