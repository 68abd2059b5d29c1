use super::decay::{Decay, TurningPointSum};
use super::error::BoundError;
use super::head::{Head, as_i64};
use super::search;
use num_traits::One;
use restitution_law::{ForceLaw, Lattice};
use restitution_real::{Ball, Magnitude};
use rug::Float;
use rug::float::Round;
use rug::ops::AddAssignRound;

/// Far more bits than any sum can have, and within the exponents of MPFR.
const MAX_BITS: u32 = 1 << 30;

/// Proved bounds of the coefficients of the trajectories `x_0, ..., x_N` of one force law.
///
/// ```text
/// x_n(t) = t sum_j q_(n,j) t^e,   e = (a+1) j + (gamma+1) n
/// |q_(n,j)| T^e <= min over the rates of (G/(e(e+1)) + H/(e+1)) r^(-j) v^(-n)
/// ```
///
/// Theorem 1 of `docs/error-bounds.md`: statement, domain of validity and proof. Every bound holds
/// for all `n <= damping_order` and all `j >= 0`; below [`TailBound::checked_terms`] enclosed
/// coefficients are used. All values are scaled by the undamped turning time `T`: the coefficient is
/// `q T^e`, the sums are `x_n(T)/T^(1+(gamma+1)n)` and `x_n'(T)/T^((gamma+1)n)`.
///
/// # Examples
///
/// ```
/// use restitution_law::ForceLaw;
/// use restitution_series::{BoundError, TailBound, TurningPointSum};
///
/// let bound = TailBound::find(&ForceLaw::viscoelastic_spheres(), 4)?;
/// let terms = bound.terms_for(100);
/// assert!(terms < 80 && bound.ratio() > 5.0 && bound.checked_terms() < terms);
/// assert!(bound.tail_at_turning_point(TurningPointSum::Velocity, 4, terms) < 2f64.powi(-100));
///
/// // Beyond the order that was asked for nothing is known.
/// assert!(bound.coefficient_up(5, 0).is_infinite());
///
/// // The series of this law reach the turning point so barely that no bound can be found.
/// let hard = "100000,1".parse().expect("a force law");
/// assert!(matches!(TailBound::find(&hard, 1), Err(BoundError::TurningPointNotReached { .. })));
/// # Ok::<(), BoundError>(())
/// ```
#[derive(Clone, Debug)]
pub struct TailBound {
    lattice: Lattice,
    damping_order: usize,
    checked_terms: usize,
    /// Bounds of the enclosed `|q_(n,j)| T^e`, by damping order and elastic index.
    head: Vec<Vec<Magnitude>>,
    rates: Vec<Decay>,
}

impl TailBound {
    /// Finds bounds for the orders `0..=damping_order` of a law.
    ///
    /// Cost: that of the trajectories to `J = 40` terms at 184 bits, or more terms for laws with large
    /// `a`, and a few hundred passes over them: 31 ms for spheres and `N = 12`, 0.17 s for `N = 100`.
    ///
    /// # Errors
    ///
    /// [`BoundError::TurningPointNotReached`] if no rate `r > 1` could be proved: the nearest
    /// singularity lies at `t = min(2 T, T/cos(pi/(a+1)))`, which tends to `T` as `a` grows.
    pub fn find(law: &ForceLaw, damping_order: usize) -> Result<Self, BoundError> {
        let (head, rates) = search::rates(&search::CLOSE, law, damping_order)?;
        Ok(Self::new(damping_order, &head, rates))
    }

    /// As [`TailBound::find`], from fewer terms and weights: proved as well, larger by some bits in a hundred.
    pub(crate) fn find_rough(law: &ForceLaw, damping_order: usize) -> Result<Self, BoundError> {
        let (head, rates) = search::rates(&search::ROUGH, law, damping_order)?;
        Ok(Self::new(damping_order, &head, rates))
    }

    fn new(damping_order: usize, head: &Head, rates: Vec<Decay>) -> Self {
        let mut rows: Vec<Vec<Magnitude>> = Vec::new();
        for term in &head.terms {
            rows.resize(rows.len().max(term.damping_order + 1), Vec::new());
            rows[term.damping_order].push(term.trajectory);
        }
        let checked_terms = rows.first().map_or(0, Vec::len);
        Self { lattice: head.lattice, damping_order, checked_terms, head: rows, rates }
    }

    /// The largest damping order that is bounded.
    pub fn damping_order(&self) -> usize {
        self.damping_order
    }

    /// From this elastic index on the bounds are those of the theorem, at every damping order.
    pub fn checked_terms(&self) -> usize {
        self.checked_terms
    }

    /// The largest `r` that was proved: `|q_(n,j)| T^e` falls at least like `r^(-j)`.
    pub fn ratio(&self) -> f64 {
        self.rates.iter().filter(|rate| rate.covers(self.damping_order)).map(Decay::ratio).fold(0.0, f64::max)
    }

    /// Returns an upper bound of `|q_(n,j)| T^e`; infinite for `n` beyond the damping order.
    pub fn coefficient_up(&self, n: usize, j: usize) -> Float {
        if let Some(size) = self.head.get(n).and_then(|row| row.get(j)) {
            return size.to_float();
        }
        match self.best_rate(n, j) {
            Some(rate) => rate.coefficient_up(n, j, &self.exponent(n, j)),
            None => unbounded(),
        }
    }

    /// Returns an upper bound of what is left out of a sum at the turning point after `terms` terms.
    ///
    /// ```text
    /// sum_(j >= terms) |q_(n,j)| T^e       or       sum_(j >= terms) (e+1) |q_(n,j)| T^e
    /// ```
    ///
    /// Infinite for `n` beyond the damping order.
    pub fn tail_at_turning_point(&self, sum: TurningPointSum, n: usize, terms: usize) -> Float {
        let known = self.head.get(n).map_or(0, Vec::len);
        let first = terms.max(known);
        let Some(rate) = self.best_rate(n, first) else {
            return unbounded();
        };
        let mut tail = rate.tail_up(sum, n, first, &self.exponent(n, first));
        for j in terms..known {
            let weight = match sum {
                TurningPointSum::Position => Magnitude::ONE,
                TurningPointSum::Velocity => Magnitude::of(&(self.exponent(n, j) + Ball::one())),
            };
            tail.add_assign_round(&(weight * self.head[n][j]).to_float(), Round::Up);
        }
        tail
    }

    /// Returns how many terms make every tail of orders `0..=damping_order` less than `2^-bits`, for at
    /// most 2^30 bits.
    pub fn terms_for(&self, bits: u32) -> usize {
        (0..=self.damping_order).fold(0, |terms, n| self.terms_from(n, bits, terms))
    }

    /// The least number of terms that suffices, but at least `least`: by doubling, then bisection.
    fn terms_from(&self, n: usize, bits: u32, least: usize) -> usize {
        let suffices = |terms: usize| self.velocity_is_below(n, terms, bits);
        if suffices(least) {
            return least;
        }
        let mut step = 1;
        while !suffices(least + step) {
            step *= 2;
        }
        let (mut low, mut high) = (least + step / 2, least + step);
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if suffices(middle) { high = middle } else { low = middle }
        }
        high
    }

    /// Whether the velocity's tail, which exceeds the position's, is below `2^-bits`.
    fn velocity_is_below(&self, n: usize, terms: usize, bits: u32) -> bool {
        let tail = self.tail_at_turning_point(TurningPointSum::Velocity, n, terms);
        tail < Float::with_val(32, 1) >> i32::try_from(bits.min(MAX_BITS)).unwrap_or(i32::MAX)
    }

    /// The rate that gives about the smallest bound at an index beyond the head.
    fn best_rate(&self, n: usize, j: usize) -> Option<&Decay> {
        if n > self.damping_order {
            return None;
        }
        let exponent = self.exponent(n, j).to_f64();
        let covering = self.rates.iter().filter(|rate| rate.covers(n));
        covering.min_by(|x, y| x.rough_log(n, j, exponent).total_cmp(&y.rough_log(n, j, exponent)))
    }

    fn exponent(&self, n: usize, j: usize) -> Ball {
        let steps =
            |step: i64, count: usize| Ball::from_integer(step, 64) * Ball::from_integer(as_i64(count), 64);
        let grade = steps(self.lattice.damping, n) + steps(self.lattice.elastic, j);
        grade / Ball::from_integer(self.lattice.unit, 64)
    }
}

fn unbounded() -> Float {
    Float::with_val(32, rug::float::Special::Infinity)
}

#[cfg(test)]
mod tests;
