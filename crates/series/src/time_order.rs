use crate::{FractionalSeries, SeriesError, Trajectories};
use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{One, ToPrimitive};
use rayon::prelude::*;
use restitution_law::ForceLaw;
use restitution_real::convert::fraction;

/// A largest power of time, `t^P`, and what of the trajectories lies within.
///
/// `x_n` begins with `t^(1 + (gamma+1) n)` and has every `(a+1)`-th power from there on.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_law::ForceLaw;
/// use restitution_series::{SeriesError, TimeOrder};
///
/// let power = BigRational::from_integer(7.into());
/// let up_to = TimeOrder::new(&ForceLaw::viscoelastic_spheres(), &power);
/// assert_eq!((up_to.terms(), up_to.damping_order(9)), (3, 4)); // t, t^(7/2), t^6; x_4 begins with t^7
/// let trajectories = up_to.trajectories(1, &|_| ());
/// assert_eq!(up_to.fractions(&trajectories, 1)?, ["-4/15", "3/70"]); // of t^(5/2), t^5
/// assert_eq!(up_to.series(&trajectories, 1)?.to_string(), "-4/15 t^(5/2) + 3/70 t^5 + O(t^(15/2))");
///
/// assert_eq!(up_to.coefficients(&trajectories, 1)?.len(), 2);
/// assert!(up_to.memory_estimate(9) + up_to.series_memory_estimate() < 1e5); // bytes
///
/// assert!(matches!(up_to.series(&trajectories, 2), Err(SeriesError::BeyondDampingOrder { .. })));
/// # Ok::<(), SeriesError>(())
/// ```
#[derive(Clone, Debug)]
pub struct TimeOrder {
    law: ForceLaw,
    power: BigRational,
}

impl TimeOrder {
    /// Returns what lies up to `t^power`.
    pub fn new(law: &ForceLaw, power: &BigRational) -> Self {
        Self { law: law.clone(), power: power.clone() }
    }

    /// How many coefficients of `x_0` lie within, at least 1; the other orders have fewer.
    pub fn terms(&self) -> usize {
        let last = (&self.power - BigRational::one()) / self.law.elastic_step();
        last.floor().to_integer().to_usize().map_or(1, |last| last.saturating_add(1))
    }

    /// The largest order up to `most` that has a power of time within.
    pub fn damping_order(&self, most: usize) -> usize {
        let last = (&self.power - BigRational::one()) / self.law.damping_step();
        last.floor().to_integer().to_usize().unwrap_or(0).min(most)
    }

    /// Derives the trajectories up to this power and the order `most`, as [`Trajectories::exact_watched`].
    ///
    /// Orders without a power within are left out.
    pub fn trajectories(&self, most: usize, watch: &(dyn Fn(Ratio<usize>) + Sync)) -> Trajectories {
        Trajectories::exact_watched(&self.law, self.damping_order(most), self.terms(), watch)
    }

    /// The coefficients of `x_n` that lie within.
    ///
    /// # Errors
    ///
    /// [`SeriesError::BeyondDampingOrder`] if order `n` was not computed.
    pub fn coefficients<'a>(
        &self,
        trajectories: &'a Trajectories,
        n: usize,
    ) -> Result<&'a [BigRational], SeriesError> {
        Ok(&trajectories.coefficients(n)?[..self.within(trajectories, n)])
    }

    /// The coefficients of `x_n` that lie within, as fractions; the processors share the work.
    ///
    /// # Errors
    ///
    /// [`SeriesError::BeyondDampingOrder`] if order `n` was not computed.
    pub fn fractions(&self, trajectories: &Trajectories, n: usize) -> Result<Vec<String>, SeriesError> {
        Ok(self.coefficients(trajectories, n)?.par_iter().map(fraction).collect())
    }

    /// `x_n` up to this power, with the first power that lies beyond.
    ///
    /// # Errors
    ///
    /// [`SeriesError::BeyondDampingOrder`] if order `n` was not computed.
    pub fn series(&self, trajectories: &Trajectories, n: usize) -> Result<FractionalSeries, SeriesError> {
        let series = trajectories.order_n(n)?;
        let end = trajectories.exponent(n, self.within(trajectories, n)) * series.unit();
        Ok(series.truncated(end.to_usize().unwrap_or(usize::MAX)))
    }

    /// How many coefficients of `x_n` lie within: `1 + (gamma+1) n + (a+1) j` is at most the power.
    fn within(&self, trajectories: &Trajectories, n: usize) -> usize {
        let first = BigRational::one() + self.law.damping_step() * BigRational::from_integer(n.into());
        let last = (&self.power - first) / self.law.elastic_step();
        let count = (last.floor().to_integer() + BigInt::one()).max(BigInt::ZERO);
        count.to_usize().unwrap_or(usize::MAX).min(trajectories.terms())
    }

    /// Bytes that the trajectories up to the order `most` and their fractions as text take at the peak.
    ///
    /// Numerator and denominator of coefficient `j` have about `20 j` bits each, and are held as residues, as integers and as
    /// text. About twice what was measured for (order, power) = (3, 2000), (0, 5000): 51, 95 MB.
    pub fn memory_estimate(&self, most: usize) -> f64 {
        let (orders, terms) = (self.damping_order(most) as f64 + 2.0, self.terms() as f64);
        orders * terms * (30.0 * terms + 300.0)
    }

    /// Bytes that [`series`](Self::series) takes besides, which also holds the powers whose coefficient is zero.
    pub fn series_memory_estimate(&self) -> f64 {
        self.terms() as f64 * self.law.lattice().elastic as f64 * 64.0
    }
}
