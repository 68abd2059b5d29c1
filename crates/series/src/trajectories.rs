use crate::damped::damped_orders;
use crate::undamped::Undamped;
use crate::{Field, FractionalSeries, SeriesError};
use num_rational::Ratio;
use restitution_law::ForceLaw;

/// The factors that a choice of units puts before the two forces: `x'' + damping u x^gamma x' + elastic x^a = 0`.
///
/// Both are 1 in the units of the paper. With the elastic half-duration `T` as the unit of time and
/// length they are `T^(a+1)` and `T^(gamma+1)`, and every series is summed at 1.
#[derive(Clone, Debug)]
pub struct Units<T> {
    /// The factor of the elastic force.
    pub elastic: T,
    /// The factor of the damping force.
    pub damping: T,
}

impl<T: Field> Units<T> {
    /// The units of the paper: both factors are the exact 1, which has no precision of its own.
    ///
    /// For exact fields; enclosing ones give both factors at their working precision.
    pub fn natural() -> Self {
        Self { elastic: T::one(), damping: T::one() }
    }
}

/// The trajectories `x_n(t)` of the damped collision as power series (A13), (A14).
///
/// ```text
/// x(t) = sum_n u^n x_n(t),    x_n(t) = t^(1 + (gamma+1) n) sum_j q_(n,j) t^((a+1) j)
/// ```
///
/// They solve `x'' + u x^gamma x' + x^a = 0`, `x(0) = 0`, `x'(0) = 1` order by order in `u`:
/// (\[RPBS1999\] (A1)-(A14); for spheres `x_n = t^(1+3n/2) sum_j q_(n,j) t^(5j/2)`.)
///
/// Exact over the rationals, enclosing over balls. Cost: a few series products for each order, and
/// one more for every lower order.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_law::ForceLaw;
/// use restitution_series::{SeriesError, Trajectories, Units};
///
/// let law = ForceLaw::viscoelastic_spheres();
/// let trajectories = Trajectories::<BigRational>::derive(&law, 1, 3, &Units::natural());
/// assert_eq!(trajectories.order_n(0)?.to_string(), "t - 4/35 t^(7/2) + 1/175 t^6 + O(t^(17/2))");
/// assert_eq!(trajectories.order_n(1)?.to_string(), "-4/15 t^(5/2) + 3/70 t^5 - 713/238875 t^(15/2) + O(t^10)");
/// assert!(matches!(trajectories.order_n(2), Err(SeriesError::BeyondDampingOrder { .. })));
/// # Ok::<(), SeriesError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Trajectories<T> {
    law: ForceLaw,
    terms: usize,
    orders: Vec<Vec<T>>,
}

impl<T: Field> Trajectories<T> {
    /// Derives `x_0 .. x_N` for `N = damping_order` with the first `terms` coefficients each.
    pub fn derive(law: &ForceLaw, damping_order: usize, terms: usize, units: &Units<T>) -> Self {
        Self::derive_watched(law, damping_order, terms, units, &mut |_| ())
    }

    /// As [`Trajectories::derive`], telling `watch` each order as it is done.
    pub fn derive_watched(
        law: &ForceLaw,
        damping_order: usize,
        terms: usize,
        units: &Units<T>,
        watch: &mut dyn FnMut(usize),
    ) -> Self {
        let undamped = Undamped::solve(law, terms, units);
        watch(0);
        let orders = damped_orders(law, undamped, damping_order, units, watch);
        Self { law: law.clone(), terms, orders }
    }

    /// Puts together trajectories whose coefficients were found elsewhere.
    pub(crate) fn from_orders(law: &ForceLaw, terms: usize, orders: Vec<Vec<T>>) -> Self {
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
    pub fn coefficients(&self, n: usize) -> Result<&[T], SeriesError> {
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
    pub fn order_n(&self, n: usize) -> Result<FractionalSeries<T>, SeriesError> {
        let lattice = self.law.lattice();
        let position =
            |j: usize| usize::try_from(lattice.unit + index(&self.law, n, j)).unwrap_or(usize::MAX);
        let mut coefficients = vec![T::zero(); position(self.terms)];
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
