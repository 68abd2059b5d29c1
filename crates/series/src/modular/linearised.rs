use super::modulus::{Modulus, Transformed};
use restitution_law::{ForceLaw, Lattice};

/// The equation of motion linearised around the undamped trajectory `x_0 = t F(s)`.
///
/// ```text
/// d'' + a x_0^(a-1) d = r
/// ```
///
/// has the solutions `V = x_0'` (shift of time) and `P = x_0 + (a-1)/2 t x_0'` (change of scale)
/// without right side; their Wronskian is `V P' - V' P = (a+1)/2`, so that
///
/// ```text
/// d = 2/(a+1) (P int V r dt - V int P r dt)
/// ```
///
/// No series is divided. Cost: four products.
pub(super) struct Linearised {
    lattice: Lattice,
    velocity: Transformed,
    rescaling: Transformed,
}

impl Linearised {
    /// Prepares the two solutions from the coefficients of `F`.
    pub fn new(modulus: &Modulus, law: &ForceLaw, f: &[u64]) -> Self {
        let lattice = law.lattice();
        let steps = |j: usize| lattice.elastic * i64::try_from(j).unwrap_or(i64::MAX);
        let velocity = modulus.scale_each(f, |j| (steps(j) + lattice.unit, lattice.unit));
        let part = modulus.scale_each(&velocity, |_| (lattice.elastic - 2 * lattice.unit, 2 * lattice.unit));
        let rescaling = modulus.sum(&part, f);
        let transform = |series: &[u64]| modulus.transform(series, f.len());
        Self { lattice, velocity: transform(&velocity), rescaling: transform(&rescaling) }
    }

    /// Returns the coefficients of `d` for the coefficients of `r`, both from index `first` on, in
    /// damping order `n`:
    ///
    /// ```text
    /// d = sum_j d_j t^(e+1),  r = sum_j r_j t^(e-1),  e = (a+1) j + (gamma+1) n > 0
    /// ```
    pub fn solve(&self, modulus: &Modulus, right: &[u64], first: usize, n: usize) -> Vec<u64> {
        let Lattice { elastic, damping, unit } = self.lattice;
        let len = right.len();
        let count = |i: usize| i64::try_from(i).unwrap_or(i64::MAX);
        let e = |j: usize| elastic * count(first + j) + damping * count(n);
        let right = modulus.transform(right, len);
        let integral = |solution: &Transformed, shift: i64| {
            let product = modulus.sum_of_products(&[(1, solution, &right)], len);
            modulus.transform(&modulus.scale_each(&product, |j| (unit, e(j) + shift)), len)
        };
        let (work, moment) = (integral(&self.velocity, 0), integral(&self.rescaling, unit));
        let sum = modulus.sum_of_products(&[(1, &self.rescaling, &work), (-1, &self.velocity, &moment)], len);
        modulus.scale_each(&sum, |_| (2 * unit, elastic))
    }
}
