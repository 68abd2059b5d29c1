use crate::certified::{Expansion, Goal, LARGEST_ORDER, Unproved, expand};
use crate::{DelayedRecovery, SeriesError};
use num_rational::{BigRational, Ratio};
use num_traits::{One, Zero};
use restitution_law::ForceLaw;
use restitution_real::{Ball, RealError};

/// A family of expansion coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// `C_k` of `eps = 1 + C_1 u + C_2 u^2 + ...` (A30).
    Restitution,
    /// `a_k = C_k/C_1^k` of `eps = 1 - a_1 s + a_2 s^2 - ...`, `s = -C_1 u = (g/g*)^(1/5)` (A33)-(A36).
    ScaledRestitution,
    /// `y_k` of the maximal compression `x_max = y_0 + y_1 u + ...` (A23).
    Compression,
    /// `h_k` of the contact that ends at zero force, `eps_d = 1 + h_2 u + ... + h_5 u^(5/2) + ...`, by powers of
    /// `u^(1/d)`, `d` the denominator of [`DelayedRecovery::damping_exponent`]: half powers for spheres.
    DelayedRecovery,
}

/// Working precision above which no further attempt is made.
const MAX_BITS: usize = 4_000_000;

/// Returns the coefficients of order `0 ..= order`, each enclosed so narrowly that `digits` decimals are proved.
///
/// The working precision is raised until [`Ball::to_digits`] shows the digits asked for.
///
/// # Errors
///
/// [`SeriesError::Real`] if that takes more than the largest working precision, and what the expansion
/// of the law says where there is none.
///
/// # Examples
///
/// ```
/// use restitution_law::ForceLaw;
/// use restitution_series::{Quantity, coefficients};
///
/// let spheres = ForceLaw::viscoelastic_spheres();
/// let c = coefficients(Quantity::Restitution, &spheres, 3, 12)?;
/// assert_eq!(c[3].to_digits(12).as_deref(), Some("-0.522882568088"));
/// # Ok::<(), restitution_series::SeriesError>(())
/// ```
pub fn coefficients(
    quantity: Quantity,
    law: &ForceLaw,
    order: usize,
    digits: usize,
) -> Result<Vec<Ball>, SeriesError> {
    coefficients_watched(quantity, law, order, digits, &mut |_| ())
}

/// As [`coefficients`], telling `watch` each order in the damping as it is done.
///
/// # Errors
///
/// As [`coefficients`].
///
/// # Examples
///
/// ```
/// use restitution_law::ForceLaw;
/// use restitution_series::{Quantity, SeriesError, coefficients_watched};
///
/// let mut seen = 0;
/// let spheres = ForceLaw::viscoelastic_spheres();
/// let c = coefficients_watched(Quantity::Restitution, &spheres, 2, 10, &mut |order| seen = order)?;
/// assert_eq!((c[1].to_digits(10).as_deref(), seen > 0), (Some("-1.153448858"), true));
///
/// let no_end = coefficients_watched(Quantity::DelayedRecovery, &"1,2".parse().unwrap(), 2, 10, &mut |_| ());
/// assert!(matches!(no_end, Err(SeriesError::NoZeroForceEnd { .. })));
/// # Ok::<(), SeriesError>(())
/// ```
pub fn coefficients_watched(
    quantity: Quantity,
    law: &ForceLaw,
    order: usize,
    digits: usize,
    watch: &mut dyn FnMut(usize),
) -> Result<Vec<Ball>, SeriesError> {
    let wanted = bits_of(digits) + 8;
    let delay = (quantity == Quantity::DelayedRecovery).then(|| Delay::new(law, order)).transpose()?;
    let whole = delay.as_ref().map_or(order, Delay::whole_order);
    if whole > LARGEST_ORDER {
        return Err(SeriesError::OrderTooLarge { order, largest: LARGEST_ORDER });
    }
    let limit = (16 * wanted + 64 * whole + 4096).min(MAX_BITS);
    let select = |expansion: &Expansion| match &delay {
        Some(delay) => delay.coefficients(&expansion.restitution[..=whole]),
        None => expansion.select(quantity)[..=order].to_vec(),
    };
    let missing = |expansion: &Expansion| {
        let missing = |value: &Ball| {
            if value.to_digits(digits).is_some() { 0 } else { shortfall(value, wanted).max(1) }
        };
        select(expansion).iter().map(missing).max().unwrap_or(0)
    };
    let goal = Goal {
        law,
        last: whole,
        damping: damping_order_for(quantity, whole),
        wanted,
        limit,
        missing: &missing,
    };
    let expansion = match expand(&goal, watch) {
        Ok(expansion) => expansion,
        Err(Unproved::Exhausted) => {
            return Err(RealError::PrecisionExhausted { digits, reached_bits: limit as u32 }.into());
        }
        Err(Unproved::Norms) => return Err(SeriesError::Unproved { law: law.to_string() }),
    };
    Ok(select(&expansion))
}

/// Returns about how many bytes [`coefficients`] needs at its peak: not less than measured for spheres, nor twice as much.
///
/// # Examples
///
/// ```
/// use restitution_law::ForceLaw;
/// use restitution_series::memory_estimate;
///
/// let spheres = ForceLaw::viscoelastic_spheres();
/// assert!(memory_estimate(&spheres, 1000, 30) < 4e9);
/// ```
pub fn memory_estimate(law: &ForceLaw, order: usize, digits: usize) -> f64 {
    crate::certified::memory_estimate(law, order, digits)
}

/// The damping order to which trajectories are needed: `C_N` of even order follows from the lower ones,
/// `y_N` does not.
fn damping_order_for(quantity: Quantity, order: usize) -> usize {
    if quantity != Quantity::Compression && order >= 2 && order.is_multiple_of(2) { order - 1 } else { order }
}

impl Expansion {
    fn select(&self, quantity: Quantity) -> Vec<Ball> {
        match quantity {
            Quantity::Compression => self.compression.clone(),
            Quantity::Restitution | Quantity::DelayedRecovery => self.restitution.clone(),
            Quantity::ScaledRestitution => scaled(&self.restitution),
        }
    }
}

/// The expansion of the zero-force end, `eps_d = sum_k psi_k u^(r k) eps^(1 + p r k)`.
struct Delay {
    /// `r`, the exponent of the damping in `y`.
    exponent: Ratio<i64>,
    /// `p`, the velocity exponent.
    velocity: BigRational,
    psi: Vec<BigRational>,
    /// The largest index, in powers of `u^(1/denominator of r)`.
    order: usize,
}

impl Delay {
    fn new(law: &ForceLaw, order: usize) -> Result<Self, SeriesError> {
        let end = DelayedRecovery::new(law)?;
        let exponent = end.damping_exponent();
        let terms = order / usize::try_from(*exponent.numer()).unwrap_or(usize::MAX);
        Ok(Self { exponent, velocity: law.velocity_exponent(), psi: end.psi(terms), order })
    }

    /// The order in whole powers of `u` that the restitution is needed to; at least 1.
    fn whole_order(&self) -> usize {
        (self.order / self.steps_per_power()).max(1)
    }

    fn steps_per_power(&self) -> usize {
        usize::try_from(*self.exponent.denom()).unwrap_or(1)
    }

    /// `h_0 .. h_order`.
    fn coefficients(&self, restitution: &[Ball]) -> Vec<Ball> {
        let mut h = vec![Ball::zero(); self.order + 1];
        let stride = usize::try_from(*self.exponent.numer()).unwrap_or(usize::MAX);
        let exponent = BigRational::new((*self.exponent.numer()).into(), (*self.exponent.denom()).into());
        for (k, psi) in self.psi.iter().enumerate() {
            let power = BigRational::one() + &self.velocity * &exponent * BigRational::from_integer(k.into());
            let places = h.iter_mut().skip(stride * k).step_by(self.steps_per_power());
            for (place, c) in places.zip(unit_power(restitution, &power)) {
                *place += &c * Ball::from_rational(psi, c.prec().max(restitution[1].prec()));
            }
        }
        h
    }
}

/// `s^p` for a series that begins with 1, by Miller's formula, of which the sums are taken as
///
/// ```text
/// g_k = (p+1)/k sum_(i=1..k) i s_i g_(k-i) - sum_(i=1..k) s_i g_(k-i)
/// ```
fn unit_power(series: &[Ball], exponent: &BigRational) -> Vec<Ball> {
    let factor = exponent + BigRational::one();
    let mut power = vec![Ball::one()];
    for k in 1..series.len() {
        let (mut weighted, mut plain) = (Ball::zero(), Ball::zero());
        for i in 1..=k {
            let term = &series[i] * &power[k - i];
            weighted += &term * Ball::from_integer(i as i64, 64);
            plain += term;
        }
        let factor = &factor / BigRational::from_integer(k.into());
        let prec = weighted.prec();
        power.push(weighted * Ball::from_rational(&factor, prec) - plain);
    }
    power
}

/// `a_k = C_k/C_1^k`.
fn scaled(restitution: &[Ball]) -> Vec<Ball> {
    let first = restitution.get(1).cloned().unwrap_or_else(Ball::one);
    let mut power = Ball::one();
    let divide = |(k, c): (usize, &Ball)| match k {
        0 => c.clone(),
        1 => Ball::one(),
        _ => {
            if k == 2 {
                power = first.clone();
            }
            power *= &first;
            c / &power
        }
    };
    restitution.iter().enumerate().map(divide).collect()
}

/// Bits that hold `digits` decimals: `log2(10) < 3.322`.
pub(crate) fn bits_of(digits: usize) -> usize {
    digits.saturating_mul(3322) / 1000 + 1
}

/// Bits by which the enclosure is too wide.
fn shortfall(value: &Ball, wanted: usize) -> usize {
    let wanted = i64::try_from(wanted).unwrap_or(i64::MAX);
    let known = value.relative_bits().unwrap_or(wanted).max(-wanted);
    usize::try_from(wanted - known).unwrap_or(0)
}
