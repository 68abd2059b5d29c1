//! The trajectories by the recurrence of their coefficients, in plain fractions.

use num_rational::BigRational;
use num_traits::{One, Zero};
use restitution_law::ForceLaw;

/// A series in `s` and `w`, by order in `w` and then in `s`.
type Rows = Vec<Vec<BigRational>>;

/// Returns the coefficients `q_(n,j)`, `n = 0 ..= damping_order`, `j < terms`, with `x = t F(s, w)`:
///
/// ```text
/// (e+1) e q_(n,j) = -e/(gamma+1) (F^(gamma+1))_(n-1,j) - (F^a)_(n,j-1),    e = (a+1) j + (gamma+1) n
/// ```
///
/// (`docs/error-bounds.md`, section 1.) Cost: about `N^2 J^2` products of fractions.
pub(crate) fn coefficients(law: &ForceLaw, damping_order: usize, terms: usize) -> Rows {
    let lattice = law.lattice();
    let fraction = |numerator: i64, denominator: i64| BigRational::new(numerator.into(), denominator.into());
    let grade = |n: usize, j: usize| lattice.elastic * j as i64 + lattice.damping * n as i64;
    let mut f = Rows::new();
    let mut force = Power::new(lattice.elastic - lattice.unit, lattice.unit);
    let mut friction = (!law.is_viscoelastic()).then(|| Power::new(lattice.damping, lattice.unit));
    for n in 0..=damping_order {
        f.push(Vec::with_capacity(terms));
        force.rows.push(Vec::with_capacity(terms));
        friction.iter_mut().for_each(|power| power.rows.push(Vec::with_capacity(terms)));
        for j in 0..terms {
            let e = grade(n, j);
            let mut sum = BigRational::zero();
            if n > 0 {
                let drag = &friction.as_ref().unwrap_or(&force).rows[n - 1][j];
                sum += drag * fraction(e, lattice.damping);
            }
            if j > 0 {
                sum += &force.rows[n][j - 1];
            }
            let q = match e {
                0 => BigRational::one(),
                _ => -sum * fraction(lattice.unit, e) * fraction(lattice.unit, e + lattice.unit),
            };
            f[n].push(q);
            force.push(&f, &grade);
            friction.iter_mut().for_each(|power| power.push(&f, &grade));
        }
    }
    f
}

/// A power `F^p`, `p = steps/unit`, by Miller's formula: `e (F^p)_e = sum (p e_1 - (e - e_1)) q_(e_1) (F^p)_(e - e_1)`.
struct Power {
    steps: i64,
    unit: i64,
    rows: Rows,
}

impl Power {
    fn new(steps: i64, unit: i64) -> Self {
        Self { steps, unit, rows: Rows::new() }
    }

    /// Adds the next coefficient of the last row.
    fn push(&mut self, f: &Rows, grade: &dyn Fn(usize, usize) -> i64) {
        let n = self.rows.len() - 1;
        let j = self.rows[n].len();
        if (n, j) == (0, 0) {
            self.rows[0].push(BigRational::one());
            return;
        }
        let mut sum = BigRational::zero();
        for (m, row) in f.iter().enumerate() {
            for (i, q) in row.iter().enumerate().take(j + 1).skip(usize::from(m == 0)) {
                let weight = self.steps * grade(m, i) - self.unit * grade(n - m, j - i);
                if let Some(power) = self.rows[n - m].get(j - i).filter(|_| weight != 0) {
                    sum += q * power * BigRational::from_integer(weight.into());
                }
            }
        }
        let denominator = BigRational::from_integer((self.unit * grade(n, j)).into());
        self.rows[n].push(sum / denominator);
    }
}
