use crate::SeriesError;
use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{One, Signed, ToPrimitive, Zero};
use restitution_real::convert::{big_integer, rug_integer};
use restitution_real::{Field, Rationals, kronecker};
use rug::Integer;

/// A power series in `t^(1/unit)` that knows where it ends.
///
/// ```text
/// s = sum_(k < order) c_k t^(k/unit) + O(t^(order/unit))
/// ```
///
/// The trajectories of spheres are series in half powers, `unit = 2`. The absolute truncation order is
/// part of the value: every operation gives as many terms as its operands prove and no more, and a
/// coefficient beyond it is unknown, never zero. The coefficients are exact fractions.
///
/// # Examples
///
/// ```
/// use restitution_series::{FractionalSeries, SeriesError};
///
/// let s = FractionalSeries::from_integers(2, &[1, -1, 0, 0]);
/// assert_eq!(s.to_string(), "1 - t^(1/2) + O(t^2)");
/// assert_eq!(s.recip()?.to_string(), "1 + t^(1/2) + t + t^(3/2) + O(t^2)");
///
/// let t = FractionalSeries::from_integers(2, &[0, 0, 1]);
/// assert!(matches!(t.recip(), Err(SeriesError::ZeroConstantTerm { .. })));
/// # Ok::<(), SeriesError>(())
/// ```
///
/// Every operation keeps track of what is known:
///
/// ```
/// use num_rational::BigRational;
/// use restitution_series::{FractionalSeries, SeriesError};
///
/// let s = FractionalSeries::from_integers(2, &[0, 0, 1, 2]); // t + 2 t^(3/2) + O(t^2)
/// assert_eq!((s.unit(), s.order(), s.valuation(), s.exponent(3).to_string()), (2, 4, 2, "3/2".into()));
/// assert_eq!(s.multiply(&s)?.to_string(), "t^2 + 4 t^(5/2) + O(t^3)");
/// assert_eq!(s.power(&BigRational::new(1.into(), 2.into()))?.to_string(), "t^(1/2) + t + O(t^(3/2))");
/// assert_eq!(s.derivative()?.to_string(), "1 + 3 t^(1/2) + O(t)");
/// assert_eq!(s.derivative()?.integral().subtract(&s)?.valuation(), 4); // nothing but O(t^2)
/// assert_eq!(s.scaled(1, 2).truncated(3).to_string(), "1/2 t + O(t^(3/2))");
///
/// assert!(matches!(s.coefficient(4), Err(SeriesError::BeyondTruncation { .. }))); // unknown, not zero
/// let root = FractionalSeries::from_integers(2, &[0, 1]);
/// assert!(matches!(root.derivative(), Err(SeriesError::NegativeExponent { .. })));
/// assert!(matches!(s.add(&FractionalSeries::from_integers(3, &[1])), Err(SeriesError::DifferentSteps { .. })));
/// # Ok::<(), SeriesError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FractionalSeries {
    unit: i64,
    coefficients: Vec<BigRational>,
}

impl FractionalSeries {
    /// Returns the series in `t^(1/unit)` with the given coefficients, truncated after them.
    ///
    /// A `unit` below 1 is read as 1.
    pub fn new(unit: i64, coefficients: Vec<BigRational>) -> Self {
        Self { unit: unit.max(1), coefficients }
    }

    /// Returns the series with the given integers as coefficients.
    pub fn from_integers(unit: i64, coefficients: &[i64]) -> Self {
        Self::new(unit, coefficients.iter().map(|&n| fraction(n, 1)).collect())
    }

    /// How many lattice steps make one power of `t`.
    pub fn unit(&self) -> i64 {
        self.unit
    }

    /// The index of the first unknown coefficient: the series ends with `O(t^(order/unit))`.
    pub fn order(&self) -> usize {
        self.coefficients.len()
    }

    /// The known coefficients, by index.
    pub fn coefficients(&self) -> &[BigRational] {
        &self.coefficients
    }

    /// Returns the coefficient of `t^(index/unit)`.
    ///
    /// # Errors
    ///
    /// [`SeriesError::BeyondTruncation`] if it is not known.
    pub fn coefficient(&self, index: usize) -> Result<&BigRational, SeriesError> {
        let beyond = || SeriesError::BeyondTruncation {
            exponent: self.exponent(index),
            order: self.exponent(self.order()),
        };
        self.coefficients.get(index).ok_or_else(beyond)
    }

    /// The exponent `index/unit`.
    pub fn exponent(&self, index: usize) -> Ratio<i64> {
        Ratio::new(as_i64(index), self.unit)
    }

    /// The index of the first coefficient that is not exactly zero; the order if there is none.
    pub fn valuation(&self) -> usize {
        self.coefficients.iter().position(|c| !c.is_zero()).unwrap_or(self.order())
    }

    /// Returns the series cut off at a lower order.
    #[must_use]
    pub fn truncated(&self, order: usize) -> Self {
        Self::new(self.unit, self.coefficients[..order.min(self.order())].to_vec())
    }

    /// Returns the sum, known to the lower of the two orders.
    ///
    /// # Errors
    ///
    /// [`SeriesError::DifferentSteps`] unless both have the same unit.
    pub fn add(&self, other: &Self) -> Result<Self, SeriesError> {
        self.same_unit(other)?;
        let sum = self.coefficients.iter().zip(&other.coefficients).map(|(x, y)| x.clone() + y);
        Ok(Self::new(self.unit, sum.collect()))
    }

    /// Returns the difference, known to the lower of the two orders.
    ///
    /// # Errors
    ///
    /// As [`FractionalSeries::add`].
    pub fn subtract(&self, other: &Self) -> Result<Self, SeriesError> {
        self.add(&other.map(|c| -c.clone()))
    }

    /// Returns the product, known to `min(order_a + valuation_b, order_b + valuation_a)`.
    ///
    /// # Errors
    ///
    /// As [`FractionalSeries::add`].
    pub fn multiply(&self, other: &Self) -> Result<Self, SeriesError> {
        self.same_unit(other)?;
        let (low_a, low_b) = (self.valuation(), other.valuation());
        let known = (self.order() - low_a).min(other.order() - low_b);
        let product = product(&self.coefficients[low_a..], &other.coefficients[low_b..], known);
        Ok(Self::shifted(self.unit, product, low_a + low_b))
    }

    /// Returns every coefficient times the fraction `numerator/denominator` (`denominator != 0`).
    #[must_use]
    pub fn scaled(&self, numerator: i64, denominator: i64) -> Self {
        self.map(|c| c * fraction(numerator, denominator))
    }

    /// Returns the derivative by `t`: `sum_k (k/unit) c_k t^(k/unit - 1)`.
    ///
    /// # Errors
    ///
    /// [`SeriesError::NegativeExponent`] if there is a term with an exponent strictly between 0 and 1.
    pub fn derivative(&self) -> Result<Self, SeriesError> {
        let unit = as_usize(self.unit);
        let derived = self.weighted(|k| fraction(as_i64(k), self.unit));
        if let Some(k) = derived.iter().take(unit).position(|c| !c.is_zero()) {
            return Err(SeriesError::NegativeExponent { exponent: self.exponent(k) - 1 });
        }
        Ok(Self::new(self.unit, derived.into_iter().skip(unit).collect()))
    }

    /// Returns the integral from 0: `sum_k c_k/(k/unit + 1) t^(k/unit + 1)`.
    #[must_use]
    pub fn integral(&self) -> Self {
        let integrated = self.weighted(|k| fraction(self.unit, as_i64(k) + self.unit));
        Self::shifted(self.unit, integrated, as_usize(self.unit))
    }

    /// Returns the reciprocal `1/s`, known to the order of `s`, by Newton's iteration `r <- r (2 - s r)`.
    ///
    /// # Errors
    ///
    /// [`SeriesError::ZeroConstantTerm`] if the constant term is zero.
    pub fn recip(&self) -> Result<Self, SeriesError> {
        let first = self.coefficients.first().filter(|c| !c.is_zero());
        let first = first.ok_or(SeriesError::ZeroConstantTerm { operation: "reciprocal" })?;
        let mut r = vec![first.recip()];
        while r.len() < self.order() {
            let known = r.len();
            let next = (2 * known).min(self.order());
            let defect = product(&self.coefficients, &r, next);
            r.extend(product(&defect[known..], &r, next - known).into_iter().map(|c| -c));
        }
        Ok(Self::new(self.unit, r))
    }

    /// Returns the power `s^p` for a rational exponent.
    ///
    /// With `s = c t^v (1 + f)`, `s^p = c^p t^(v p) (1 + f)^p`, and the last factor by Miller's formula
    /// (Knuth, *TAOCP* vol. 2, sec. 4.7):
    ///
    /// ```text
    /// k g_k = sum_(i=1..k) (p i - (k-i)) f_i g_(k-i)
    /// ```
    ///
    /// Known to as many terms beyond the first as `s`. Cost: `N^2/2` multiplications for `N` terms.
    ///
    /// # Errors
    ///
    /// [`SeriesError::ZeroConstantTerm`] if all known coefficients are zero,
    /// [`SeriesError::NoPower`] if `c^p` is not rational, [`SeriesError::OffLattice`] if `v p` is no
    /// multiple of the step, [`SeriesError::NegativeExponent`] if it is negative.
    pub fn power(&self, exponent: &BigRational) -> Result<Self, SeriesError> {
        if exponent.is_one() {
            return Ok(self.clone());
        }
        let low = self.valuation();
        let lead = self.coefficients.get(low).filter(|c| !c.is_zero());
        let lead = lead.ok_or(SeriesError::ZeroConstantTerm { operation: "power" })?;
        let no_power =
            || SeriesError::NoPower { coefficient: lead.to_string(), exponent: exponent.to_string() };
        let small = small_fraction(exponent).ok_or_else(no_power)?;
        let factor = Rationals.power(lead, exponent).ok_or_else(no_power)?;
        let shift = BigRational::from_integer(low.into()) * exponent;
        if shift.is_negative() {
            return Err(SeriesError::NegativeExponent {
                exponent: Ratio::new(shift.to_integer().to_i64().unwrap_or(i64::MIN), self.unit),
            });
        }
        if !shift.is_integer() {
            return Err(SeriesError::OffLattice { unit: self.unit });
        }
        let shift =
            usize::try_from(shift.to_integer()).map_err(|_| SeriesError::OffLattice { unit: self.unit })?;
        let f: Vec<BigRational> = self.coefficients[low..].iter().map(|c| c / lead).collect();
        let power = unit_power(&f, small).into_iter().map(|c| c * &factor).collect();
        Ok(Self::shifted(self.unit, power, shift))
    }

    fn same_unit(&self, other: &Self) -> Result<(), SeriesError> {
        let differ = SeriesError::DifferentSteps { left: self.unit, right: other.unit };
        (self.unit == other.unit).then_some(()).ok_or(differ)
    }

    fn map(&self, function: impl Fn(&BigRational) -> BigRational) -> Self {
        Self::new(self.unit, self.coefficients.iter().map(function).collect())
    }

    fn weighted(&self, weight: impl Fn(usize) -> BigRational) -> Vec<BigRational> {
        self.coefficients.iter().enumerate().map(|(k, c)| c * weight(k)).collect()
    }

    fn shifted(unit: i64, coefficients: Vec<BigRational>, shift: usize) -> Self {
        let mut all = vec![BigRational::zero(); shift];
        all.extend(coefficients);
        Self::new(unit, all)
    }
}

/// Returns `f^(numerator/denominator)` for a series that begins with 1, to its own length, by Miller's
/// formula `k g_k = sum_(i=1..k) (p i - (k-i)) f_i g_(k-i)`.
fn unit_power(f: &[BigRational], (numerator, denominator): (i64, i64)) -> Vec<BigRational> {
    let mut g: Vec<BigRational> = Vec::with_capacity(f.len());
    for k in 0..f.len() {
        let term = |i: usize| {
            let weight = numerator * as_i64(i) - denominator * as_i64(k - i);
            &f[i] * &g[k - i] * BigInt::from(weight)
        };
        let sum = (1..=k).map(term).fold(BigRational::zero(), |sum, term| sum + term);
        g.push(if k == 0 { BigRational::one() } else { sum / BigInt::from(denominator * as_i64(k)) });
    }
    g
}

/// The first `len` coefficients of a product, over common denominators.
fn product(a: &[BigRational], b: &[BigRational], len: usize) -> Vec<BigRational> {
    let ((a, of_a), (b, of_b)) = (over_common_denominator(a, len), over_common_denominator(b, len));
    let denominator = of_a * of_b;
    let reduce = |numerator: Integer| {
        let common = Integer::from(numerator.gcd_ref(&denominator));
        let denominator = Integer::from(denominator.div_exact_ref(&common));
        BigRational::new_raw(big_integer(&numerator.div_exact(&common)), big_integer(&denominator))
    };
    kronecker::product(&a, &b, len).into_iter().map(reduce).collect()
}

/// The numerators of the first `len` coefficients over their least common denominator.
fn over_common_denominator(series: &[BigRational], len: usize) -> (Vec<Integer>, Integer) {
    let series = &series[..series.len().min(len)];
    let denominators = series.iter().map(|c| rug_integer(c.denom()));
    let denominator = denominators.fold(Integer::from(1), |common, d| common.lcm(&d));
    let numerator = |c: &BigRational| {
        rug_integer(c.numer()) * Integer::from(denominator.div_exact_ref(&rug_integer(c.denom())))
    };
    (series.iter().map(numerator).collect(), denominator)
}

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

/// A rational exponent as a pair of small integers; `None` if it is not one.
pub(crate) fn small_fraction(exponent: &BigRational) -> Option<(i64, i64)> {
    let limit = 1i64 << 40;
    let (n, d) = (exponent.numer().to_i64()?, exponent.denom().to_i64()?);
    (n.abs() < limit && d < limit).then_some((n, d))
}

fn as_i64(index: usize) -> i64 {
    i64::try_from(index).unwrap_or(i64::MAX)
}

fn as_usize(unit: i64) -> usize {
    usize::try_from(unit).unwrap_or(1)
}
