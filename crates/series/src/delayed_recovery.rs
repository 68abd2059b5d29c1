use crate::fractional_series::{small_fraction, unit_power};
use crate::{Field, SeriesError, Trajectories};
use num_rational::{BigRational, Ratio};
use num_traits::{One, Signed};
use restitution_law::ForceLaw;

/// The contact that ends at zero force: the factor `Psi` between the two ends of contact.
///
/// Dry bodies don't attract: on the way out the contact ends where `x'' = 0` (\[SP2008\]), before the
/// compression is gone. Followed backwards from the exit, the last piece of the trajectory is the one of
/// an impact with velocity `eps` and damping `-v`, `v = u eps^p`, and depends on one variable only:
///
/// ```text
/// eps_d(u) = eps(u) Psi(y),    y = (u eps^p)^r,    r = (a+1)/(a-gamma)
/// ```
///
/// (MATH section 7; for spheres `r = 5/2`, `p = 1/5`, `y = u^(5/2) eps^(1/2)`.)
#[derive(Clone, Debug)]
pub struct DelayedRecovery {
    law: ForceLaw,
    /// `a - gamma > 0`.
    lag: BigRational,
}

impl DelayedRecovery {
    /// Returns the zero-force end of contact for a law.
    ///
    /// # Errors
    ///
    /// [`SeriesError::NoZeroForceEnd`] unless `a > gamma`: else damping outweighs elasticity at no small
    /// compression.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_law::ForceLaw;
    /// use restitution_series::{DelayedRecovery, SeriesError};
    ///
    /// let end = DelayedRecovery::new(&ForceLaw::viscoelastic_spheres())?;
    /// let psi: Vec<String> = end.psi(3).iter().map(ToString::to_string).collect();
    /// assert_eq!(psi, ["1", "4/15", "13/150", "4897/160875"]);
    ///
    /// let law = "1,2".parse().expect("a force law");
    /// assert!(matches!(DelayedRecovery::new(&law), Err(SeriesError::NoZeroForceEnd { .. })));
    /// # Ok::<(), SeriesError>(())
    /// ```
    pub fn new(law: &ForceLaw) -> Result<Self, SeriesError> {
        let lag = law.a() - law.gamma();
        if !lag.is_positive() {
            return Err(SeriesError::NoZeroForceEnd { law: law.to_string() });
        }
        Ok(Self { law: law.clone(), lag })
    }

    /// The exponent `r = (a+1)/(a-gamma)` of the damping in `y`.
    pub fn damping_exponent(&self) -> Ratio<i64> {
        let r = self.law.elastic_step() / &self.lag;
        let (n, d) = small_fraction(&r).unwrap_or((1, 1));
        Ratio::new(n, d)
    }

    /// Returns `Psi(y) = 1 + psi_1 y + ...` to order `y^order`, exactly.
    ///
    /// Cost: about `order^5/60` rational operations.
    pub fn psi(&self, order: usize) -> Vec<BigRational> {
        let trajectories = Trajectories::exact(&self.law, order, order + 1);
        self.psi_from(&trajectories, &BigRational::one())
    }

    /// As [`DelayedRecovery::psi`], in the field of `one`, from exact trajectories.
    ///
    /// With `t = v^(1/(a-gamma)) theta`, both monomials of the trajectory are `y` times a power of `theta`:
    /// `s = y theta^(a+1)`, `w = -y theta^(gamma+1)`. Zero force, `x^(a-gamma) = v x'`, reads
    ///
    /// ```text
    /// theta = V^(1/(a-gamma))/F,    F = x/t,  V = x'
    /// ```
    ///
    /// and each pass through it gives one more right term, because `theta` enters `F` and `V` with a
    /// factor `y`. Then `Psi = V`.
    pub(crate) fn psi_from<T: Field>(&self, trajectories: &Trajectories<BigRational>, one: &T) -> Vec<T> {
        let order = trajectories.damping_order();
        let root = small_fraction(&self.lag.recip()).unwrap_or((1, 1));
        let mut theta = vec![one.clone()];
        for known in 1..=order {
            let [shape, velocity] = self.shape_and_velocity(trajectories, &theta, known + 1);
            let inverse = unit_power(&shape, (-1, 1));
            theta = T::product(&unit_power(&velocity, root), &inverse, known + 1);
        }
        let [_, velocity] = self.shape_and_velocity(trajectories, &theta, order + 1);
        velocity
    }

    /// `F` and `V` below `y^len`: `sum q_(n,j) (-1)^n y^(n+j) theta^e`, for `V` with the factor `e + 1`.
    fn shape_and_velocity<T: Field>(
        &self,
        trajectories: &Trajectories<BigRational>,
        theta: &[T],
        len: usize,
    ) -> [Vec<T>; 2] {
        let one = &theta[0];
        let zeros = || std::iter::repeat_with(T::zero);
        let theta: Vec<T> = theta.iter().cloned().chain(zeros()).take(len).collect();
        let mut sums = [zeros().take(len).collect::<Vec<T>>(), zeros().take(len).collect()];
        for n in 0..len {
            let Ok(coefficients) = trajectories.coefficients(n) else { break };
            for (j, q) in coefficients.iter().enumerate().take(len - n) {
                let exponent = trajectories.exponent(n, j);
                let e = exponent - 1;
                let power = unit_power(&theta[..len - n - j], (*e.numer(), *e.denom()));
                let q = one.rational(&if n % 2 == 1 { -q } else { q.clone() });
                let slope = q.scaled(*exponent.numer(), *exponent.denom());
                for (sum, weight) in sums.iter_mut().zip([q, slope]) {
                    for (total, term) in sum[n + j..].iter_mut().zip(&power) {
                        *total = weight.times(term) + &*total;
                    }
                }
            }
        }
        sums
    }
}
