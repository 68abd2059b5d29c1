//! The turning point and the maximal compression as power series in `u` (A15)-(A27).

use crate::Field;
use crate::fractional_series::{small_fraction, unit_power};
use crate::{SeriesError, Units, ZeroTest};
use num_rational::BigRational;
use restitution_law::ForceLaw;

/// The trajectory around the undamped turning point `T`: a polynomial in `t - T` and `u`.
///
/// ```text
/// x(T + dt; u) = sum_m X_m(u) dt^m,    X_m = sum_n u^n x_n^(m)(T)/m!
/// ```
///
/// Because `dt = O(u)`, row `m` is kept to order `N - m` only. Rows 0 and 1 are sums of the series at
/// `T`; all others follow from the equation of motion.
pub(crate) struct TurningPoint<T: Field> {
    rows: Vec<Vec<T>>,
    order: usize,
}

impl<T: Field> TurningPoint<T> {
    /// Continues `x_n(T)` and `x_n'(T)`, `n = 0 .. N`, by the equation of motion in the given units.
    ///
    /// With `G = x^a`, `H = x^(gamma+1)` as series in `dt`, each by Miller's formula:
    ///
    /// ```text
    /// (m+2)(m+1) X_(m+2) = -damping/(gamma+1) u (m+1) H_(m+1) - elastic G_m
    /// ```
    ///
    /// # Errors
    ///
    /// [`SeriesError::NoPower`] if `x_0(T)` has no power `a` or `gamma + 1` in the field.
    pub fn new(
        law: &ForceLaw,
        units: &Units<T>,
        position: Vec<T>,
        velocity: Vec<T>,
    ) -> Result<Self, SeriesError> {
        let order = position.len() - 1;
        let lattice = law.lattice();
        let mut force = Power::new(lattice.elastic - lattice.unit, lattice.unit, &position)?;
        let mut friction = Power::new(lattice.damping, lattice.unit, &position)?;
        let shared = law.is_viscoelastic();
        let mut factors = vec![T::factor(&position, order + 1), T::factor(&velocity, order)];
        let mut rows = vec![position, velocity[..order].to_vec()];
        for m in 0..order.saturating_sub(1) {
            let len = order - m - 1;
            let (m_, unit) = (as_i64(m), lattice.unit);
            force.extend_to(m, &factors, len + 2);
            let drag = if shared { &mut force } else { &mut friction };
            drag.extend_to(m + 1, &factors, len + 1);
            let drag = drag.rows[m + 1].clone();
            let pull = &force.rows[m];
            let row = (0..len).map(|n| {
                let pull = units.elastic.times(&pull[n]);
                let drag = if n == 0 { T::zero() } else { units.damping.times(&drag[n - 1]) };
                let drag = drag.scaled(unit * (m_ + 1), lattice.damping);
                -(pull + drag).scaled(1, (m_ + 1) * (m_ + 2))
            });
            let row: Vec<T> = row.collect();
            factors.push(T::factor(&row, len));
            rows.push(row);
        }
        Ok(Self { rows, order })
    }

    /// The shift of the turning point, `dt = tau_1 u + tau_2 u^2 + ...` (A18), below `u^len`.
    ///
    /// Newton's iteration on `x'(T + dt; u) = 0` (A17): each step doubles the number of right terms.
    ///
    /// # Errors
    ///
    /// [`SeriesError::ZeroConstantTerm`] if `x_0''(T)` may be zero at this precision.
    pub fn shift(&self, len: usize) -> Result<Vec<T>, SeriesError> {
        let mut shift = vec![T::zero()];
        while shift.len() < len.min(self.order) {
            let known = shift.len();
            let next = (2 * known).min(len).min(self.order);
            shift.resize(next, T::zero());
            let velocity = self.derivative_at(&shift, 1, next);
            let acceleration = self.derivative_at(&shift, 2, next - known);
            let inverse = reciprocal(&acceleration)?;
            let correction = T::product(&velocity[known..], &inverse, next - known);
            for (c, s) in correction.into_iter().zip(&mut shift[known..]) {
                *s = -c;
            }
        }
        Ok(shift)
    }

    /// The maximal compression `Y(u) = sum y_k u^k` (A22)-(A27), to order `N`.
    ///
    /// The velocity vanishes there, so that the shift is needed to half the order only.
    ///
    /// # Errors
    ///
    /// As [`TurningPoint::shift`].
    pub fn compression(&self) -> Result<Vec<T>, SeriesError> {
        let shift = self.shift(self.order / 2 + 1)?;
        Ok(self.derivative_at(&shift, 0, self.order + 1))
    }

    /// `x^(d)(T + dt; u)` below `u^len`, by Horner's scheme in `dt`.
    fn derivative_at(&self, shift: &[T], derivative: usize, len: usize) -> Vec<T> {
        let factor = T::factor(shift, len);
        let mut sum: Vec<T> = Vec::new();
        for (m, row) in self.rows.iter().enumerate().skip(derivative).rev() {
            // Row m meets dt^(m - derivative): only so many of its terms count.
            let Some(needed) = (len + derivative).checked_sub(m).filter(|&n| n > 0) else { continue };
            let mut next = if sum.is_empty() {
                vec![T::zero(); needed]
            } else {
                T::sum_of_products(&[(1, &T::factor(&sum, needed), &factor)], needed)
            };
            let falling: i64 = (0..derivative).map(|i| as_i64(m - i)).product();
            for (s, c) in next.iter_mut().zip(row) {
                *s = c.scaled(falling, 1) + &*s;
            }
            sum = next;
        }
        sum
    }
}

/// A power `x^p` as a series in `dt` over series in `u`, row by row, by Miller's formula:
///
/// ```text
/// m X_0 P_m = sum_(i=1..m) (p i - (m-i)) X_i P_(m-i)
/// ```
struct Power<T: Field> {
    steps: i64,
    unit: i64,
    reciprocal: T::Factor,
    rows: Vec<Vec<T>>,
    factors: Vec<T::Factor>,
}

impl<T: Field> Power<T> {
    fn new(steps: i64, unit: i64, position: &[T]) -> Result<Self, SeriesError> {
        let exponent = BigRational::new(steps.into(), unit.into());
        let zeroth = power(position, &exponent)?;
        let len = position.len();
        let reciprocal = T::factor(&reciprocal(position)?, len);
        let factors = vec![T::factor(&zeroth, len)];
        Ok(Self { steps, unit, reciprocal, rows: vec![zeroth], factors })
    }

    /// Adds the rows up to `m`, row `i` with `len + m - i` terms.
    fn extend_to(&mut self, m: usize, x: &[T::Factor], len: usize) {
        for row in self.rows.len()..=m {
            let len = len + m - row;
            let term = |i: usize| {
                let weight = self.steps * as_i64(i) - self.unit * as_i64(row - i);
                (weight, &x[i], &self.factors[row - i])
            };
            let sum = T::sum_of_products(&(1..=row).map(term).collect::<Vec<_>>(), len);
            let sum = T::scale_each(&sum, &|_| (1, self.unit * as_i64(row)));
            let next = T::sum_of_products(&[(1, &T::factor(&sum, len), &self.reciprocal)], len);
            self.factors.push(T::factor(&next, len));
            self.rows.push(next);
        }
    }
}

/// `s^p` for a series in `u` with a nonzero constant term.
pub(crate) fn power<T: Field>(series: &[T], exponent: &BigRational) -> Result<Vec<T>, SeriesError> {
    let lead = leading(series, "power")?;
    let no_power =
        || SeriesError::NoPower { coefficient: format!("{lead:?}"), exponent: exponent.to_string() };
    let small = small_fraction(exponent).ok_or_else(no_power)?;
    let factor = lead.power(exponent).ok_or_else(no_power)?;
    let monic: Vec<T> = series.iter().map(|c| c.clone() / lead).collect();
    Ok(unit_power(&monic, small).into_iter().map(|c| c * &factor).collect())
}

/// `1/s` for a series in `u` with a nonzero constant term.
pub(crate) fn reciprocal<T: Field>(series: &[T]) -> Result<Vec<T>, SeriesError> {
    let lead = leading(series, "reciprocal")?;
    let mut r = vec![T::one() / lead];
    while r.len() < series.len() {
        let known = r.len();
        let next = (2 * known).min(series.len());
        let defect = T::product(series, &r, next);
        r.extend(T::product(&defect[known..], &r, next - known).into_iter().map(|c| -c));
    }
    Ok(r)
}

fn leading<'a, T: Field>(series: &'a [T], operation: &'static str) -> Result<&'a T, SeriesError> {
    let certain = |c: &&T| c.zero_test() == ZeroTest::NonZero;
    series.first().filter(certain).ok_or(SeriesError::ZeroConstantTerm { operation })
}

fn as_i64(index: usize) -> i64 {
    i64::try_from(index).unwrap_or(i64::MAX)
}
