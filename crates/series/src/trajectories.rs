use crate::{FractionalSeries, SeriesError};
use num_rational::{BigRational, Ratio};
use num_traits::Zero;
use restitution_law::ForceLaw;

/// The trajectories `x_n(t)` of the damped collision as power series (A13), (A14).
///
/// ```text
/// x(t) = sum_n u^n x_n(t),    x_n(t) = t^(1 + (gamma+1) n) sum_j q_(n,j) t^((a+1) j)
/// ```
///
/// They solve `x'' + u x^gamma x' + x^a = 0`, `x(0) = 0`, `x'(0) = 1` order by order in `u`:
/// (\[RPBS1999\] (A1)-(A14); for spheres `x_n = t^(1+3n/2) sum_j q_(n,j) t^(5j/2)`.)
///
/// All coefficients are exact fractions.
///
/// # Examples
///
/// ```
/// use restitution_law::ForceLaw;
/// use restitution_series::{SeriesError, Trajectories};
///
/// let law = ForceLaw::viscoelastic_spheres();
/// let trajectories = Trajectories::exact_watched(&law, 1, 3, &|_| ()); // as `exact`, telling the share that is done
/// assert_eq!(trajectories.order_n(0)?.to_string(), "t - 4/35 t^(7/2) + 1/175 t^6 + O(t^(17/2))");
/// assert_eq!(trajectories.order_n(1)?.to_string(), "-4/15 t^(5/2) + 3/70 t^5 - 713/238875 t^(15/2) + O(t^10)");
/// assert_eq!(trajectories.coefficients(1)?[2].to_string(), "-713/238875"); // q_(1,2), of t to the power
/// assert_eq!(trajectories.exponent(1, 2).to_string(), "15/2");
/// assert_eq!((trajectories.law(), trajectories.damping_order(), trajectories.terms()), (&law, 1, 3));
/// assert!(matches!(trajectories.order_n(2), Err(SeriesError::BeyondDampingOrder { .. })));
/// # Ok::<(), SeriesError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Trajectories {
    law: ForceLaw,
    terms: usize,
    orders: Vec<Vec<BigRational>>,
}

impl Trajectories {
    /// Puts together trajectories whose coefficients were found elsewhere.
    pub(crate) fn from_orders(law: &ForceLaw, terms: usize, orders: Vec<Vec<BigRational>>) -> Self {
        Self { law: law.clone(), terms, orders }
    }

    /// The force law.
    pub fn law(&self) -> &ForceLaw {
        &self.law
    }

    /// The highest order in the damping.
    pub fn damping_order(&self) -> usize {
        self.orders.len() - 1
    }

    /// How many coefficients of each order are known.
    pub fn terms(&self) -> usize {
        self.terms
    }

    /// The coefficients `q_(n,j)`, `j = 0 .. terms - 1`.
    ///
    /// # Errors
    ///
    /// [`SeriesError::BeyondDampingOrder`] if order `n` was not computed.
    pub fn coefficients(&self, n: usize) -> Result<&[BigRational], SeriesError> {
        let beyond = SeriesError::BeyondDampingOrder { asked: n, known: self.damping_order() };
        self.orders.get(n).map(Vec::as_slice).ok_or(beyond)
    }

    /// The exponent `1 + (gamma+1) n + (a+1) j` of `t` that belongs to `q_(n,j)`.
    pub fn exponent(&self, n: usize, j: usize) -> Ratio<i64> {
        let lattice = self.law.lattice();
        Ratio::new(lattice.unit + index(&self.law, n, j), lattice.unit)
    }

    /// Returns `x_n(t)` as a series in fractional powers of `t`.
    ///
    /// # Errors
    ///
    /// [`SeriesError::BeyondDampingOrder`] if order `n` was not computed.
    pub fn order_n(&self, n: usize) -> Result<FractionalSeries, SeriesError> {
        let lattice = self.law.lattice();
        let position =
            |j: usize| usize::try_from(lattice.unit + index(&self.law, n, j)).unwrap_or(usize::MAX);
        let mut coefficients = vec![BigRational::zero(); position(self.terms)];
        for (j, q) in self.coefficients(n)?.iter().enumerate() {
            coefficients[position(j)] = q.clone();
        }
        Ok(FractionalSeries::new(lattice.unit, coefficients))
    }
}

/// The lattice index `e unit = elastic j + damping n` of `q_(n,j)`.
pub(crate) fn index(law: &ForceLaw, n: usize, j: usize) -> i64 {
    let lattice = law.lattice();
    let count = |i: usize| i64::try_from(i).unwrap_or(i64::MAX);
    lattice.elastic * count(j) + lattice.damping * count(n)
}
