use crate::Field;
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
/// No series is divided: all of them decay as `x_0` itself does. Cost: four products.
pub(crate) struct Linearised<T: Field> {
    lattice: Lattice,
    velocity: T::Factor,
    rescaling: T::Factor,
}

impl<T: Field> Linearised<T> {
    /// Prepares the two solutions from the coefficients of `F`.
    pub fn new(law: &ForceLaw, f: &[T]) -> Self {
        let lattice = law.lattice();
        let steps = |j: usize| lattice.elastic * i64::try_from(j).unwrap_or(i64::MAX);
        let velocity = T::scale_each(f, &|j| (steps(j) + lattice.unit, lattice.unit));
        let part = T::scale_each(&velocity, &|_| (lattice.elastic - 2 * lattice.unit, 2 * lattice.unit));
        let rescaling: Vec<T> = part.into_iter().zip(f).map(|(v, q)| v + q).collect();
        Self { lattice, velocity: T::factor(&velocity, f.len()), rescaling: T::factor(&rescaling, f.len()) }
    }

    /// Returns the coefficients of `d` for the coefficients of `r`, both from index `first` on, in
    /// damping order `n`:
    ///
    /// ```text
    /// d = sum_j d_j t^(e+1),  r = sum_j r_j t^(e-1),  e = (a+1) j + (gamma+1) n > 0
    /// ```
    pub fn solve(&self, right: &[T], first: usize, n: usize) -> Vec<T> {
        let Lattice { elastic, damping, unit } = self.lattice;
        let len = right.len();
        let count = |i: usize| i64::try_from(i).unwrap_or(i64::MAX);
        let e = |j: usize| elastic * count(first + j) + damping * count(n);
        let right = T::factor(right, len);
        let work = T::sum_of_products(&[(1, &self.velocity, &right)], len);
        let work = T::factor(&T::scale_each(&work, &|j| (unit, e(j))), len);
        let moment = T::sum_of_products(&[(1, &self.rescaling, &right)], len);
        let moment = T::factor(&T::scale_each(&moment, &|j| (unit, e(j) + unit)), len);
        let sum = T::sum_of_products(&[(1, &self.rescaling, &work), (-1, &self.velocity, &moment)], len);
        T::scale_each(&sum, &|_| (2 * unit, elastic))
    }
}
