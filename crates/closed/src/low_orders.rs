//! `C_1 ... C_4`, `a_1 ... a_4` and `h_k` as far as they go from two Beta values.

use crate::root::rational_power;
use crate::{ClosedError, beta};
use num_rational::{BigRational, Ratio};
use num_traits::{One, Zero};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::DelayedRecovery;

/// The largest order that Beta values alone give: `a_5` has a constant of its own.
pub const LARGEST_BETA_ORDER: usize = 4;

/// A family of coefficients with a closed form.
///
/// # Examples
///
/// ```
/// use restitution_closed::{ClosedError, Family};
/// use restitution_law::ForceLaw;
///
/// let spheres = ForceLaw::viscoelastic_spheres();
/// assert_eq!(Family::Scaled.largest_index(&spheres)?, 4);
/// assert_eq!(Family::DelayedRecovery.largest_index(&spheres)?, 9); // powers of sqrt(u)
///
/// let no_end: ForceLaw = "1,2".parse().unwrap();
/// assert!(matches!(Family::DelayedRecovery.largest_index(&no_end), Err(ClosedError::Series(_))));
/// # Ok::<(), ClosedError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// `C_k` of `eps = 1 + C_1 u + C_2 u^2 + ...` (A30).
    Restitution,
    /// `a_k` of `eps = 1 - a_1 v + a_2 v^2 - ...`, `v = -C_1 u` (A33)-(A36).
    Scaled,
    /// `h_k` of the contact that ends at zero force, by powers of `u^(1/d)` (MATH section 7).
    DelayedRecovery,
}

impl Family {
    /// The largest index whose coefficient is a rational expression in two Beta values.
    ///
    /// # Errors
    ///
    /// [`ClosedError::Series`] if the law has no zero-force end and that is what was asked for.
    pub fn largest_index(self, law: &ForceLaw) -> Result<usize, ClosedError> {
        match self {
            Self::Restitution | Self::Scaled => Ok(LARGEST_BETA_ORDER),
            Self::DelayedRecovery => {
                let step = DelayedRecovery::new(law)?.damping_exponent();
                let steps = usize::try_from(*step.denom()).unwrap_or(usize::MAX);
                Ok(steps.saturating_mul(LARGEST_BETA_ORDER + 1).saturating_sub(1))
            }
        }
    }
}

/// Returns the coefficients `0 ..= order` of a law from their closed forms, each enclosed so narrowly that
/// `digits` decimals are proved by [`Ball::to_digits`].
///
/// With `s = (gamma+1)/(a+1)`, `P = B(3/2, s)`:
///
/// ```text
/// a_2 = s,   a_3 = s (4s-1)/3 + (6s+1)/(4s (2s+1)^2) B(3/2, 3s)/P^3,   a_4 = (4s-1) (a_3 - s (5s-1)/6)
/// C_k = a_k C_1^k,   C_1 = -((a+1)/2)^(s-1) P
/// ```
///
/// (`docs/closed-forms.md`, sections 3 and 4; `h_k` section 5.) Error bound: the balls. Cost: two Beta values, one
/// root and a few products; a million digits of four coefficients take a few seconds on two cores.
///
/// # Errors
///
/// [`ClosedError::BeyondBeta`] if `order` exceeds [`Family::largest_index`], [`ClosedError::Series`] for `h` of a
/// law without zero-force end, [`ClosedError::Precision`] if the digits cannot be proved.
///
/// # Examples
///
/// ```
/// use restitution_closed::{ClosedError, Family, low_orders};
/// use restitution_law::ForceLaw;
///
/// let spheres = ForceLaw::viscoelastic_spheres();
/// let c = low_orders(Family::Restitution, &spheres, 4, 20)?;
/// assert_eq!(c[3].to_digits(20).as_deref(), Some("-0.52288256808841496390"));
///
/// assert!(matches!(low_orders(Family::Scaled, &spheres, 5, 20), Err(ClosedError::BeyondBeta { .. })));
/// # Ok::<(), ClosedError>(())
/// ```
pub fn low_orders(
    family: Family,
    law: &ForceLaw,
    order: usize,
    digits: usize,
) -> Result<Vec<Ball>, ClosedError> {
    let largest = family.largest_index(law)?;
    if order > largest {
        return Err(ClosedError::BeyondBeta { order, largest });
    }
    let wanted = u32::try_from(digits.saturating_mul(3322) / 1000).unwrap_or(u32::MAX / 4);
    let mut spare = 64;
    loop {
        let bits = wanted.saturating_add(spare);
        let values = at_precision(family, law, order, bits)?;
        if values.iter().all(|value| is_known_to(value, wanted)) {
            return Ok(values);
        }
        spare *= 2;
        if spare > wanted.saturating_add(1 << 16) {
            return Err(ClosedError::Precision { digits, bits });
        }
    }
}

/// Whether the relative width is below `2^-(bits + 32)`, so that only a tie can keep a decimal from being proved.
fn is_known_to(value: &Ball, bits: u32) -> bool {
    value.relative_bits().is_none_or(|known| known >= i64::from(bits) + 32)
}

fn at_precision(family: Family, law: &ForceLaw, order: usize, bits: u32) -> Result<Vec<Ball>, ClosedError> {
    Ok(match family {
        Family::Scaled => LowOrders::new(law, order, bits).scaled(order),
        Family::Restitution => LowOrders::new(law, order, bits).restitution(order),
        Family::DelayedRecovery => delayed(law, order, bits)?,
    })
}

/// The two Beta values of a law, and its scale.
struct LowOrders {
    s: Ratio<i64>,
    bits: u32,
    /// `B(3/2, s)`
    first: Ball,
    /// `B(3/2, 3s)`, from order 3 on.
    third: Ball,
    /// `-((a+1)/2)^(s-1)`
    scale: Ball,
}

impl LowOrders {
    fn new(law: &ForceLaw, order: usize, bits: u32) -> Self {
        let lattice = law.lattice();
        let s = Ratio::new(lattice.damping, lattice.elastic);
        let third = || if order >= 3 { beta(s * 3, bits) } else { Ball::zero() };
        let half_step = law.elastic_step() / BigRational::from_integer(2.into());
        let scale = || -rational_power(&half_step, s - 1, bits);
        let (first, (third, scale)) = rayon::join(|| beta(s, bits), || (third(), scale()));
        Self { s, bits, first, third, scale }
    }

    fn rational(&self, value: Ratio<i128>) -> Ball {
        let value = BigRational::new((*value.numer()).into(), (*value.denom()).into());
        Ball::from_rational(&value, self.bits)
    }

    fn wide(&self) -> Ratio<i128> {
        Ratio::new((*self.s.numer()).into(), (*self.s.denom()).into())
    }

    /// `a_3 = alpha + beta B(3/2, 3s)/P^3`: `alpha`, `beta`.
    fn third_order(&self) -> [Ball; 2] {
        let s = self.wide();
        let one = Ratio::one();
        [s * (s * 4 - one) / 3, (s * 6 + one) / (s * 4 * (s * 2 + one) * (s * 2 + one))]
            .map(|value| self.rational(value))
    }

    /// `a_4 = alpha a_3 + beta`: `alpha`, `beta`, both 0 for `s = 1/4`.
    fn fourth_order(&self) -> Option<[Ball; 2]> {
        let s = self.wide();
        let one = Ratio::one();
        let slope = s * 4 - one;
        if slope.is_zero() {
            return None;
        }
        Some([slope, -slope * s * (s * 5 - one) / 6].map(|value| self.rational(value)))
    }

    /// `a_0 .. a_order`.
    fn scaled(&self, order: usize) -> Vec<Ball> {
        let mut a = vec![Ball::one(), Ball::one(), self.rational(self.wide())];
        if order >= 3 {
            let [alpha, beta] = self.third_order();
            let cube = &self.first * &self.first * &self.first;
            let third = alpha + beta * &self.third / cube;
            let fourth = match self.fourth_order() {
                Some([alpha, beta]) if order >= 4 => alpha * &third + beta,
                _ => Ball::zero(),
            };
            a.extend([third, fourth]);
        }
        a.truncate(order + 1);
        a
    }

    /// `C_0 .. C_order`; no division, because `C_1^3` takes away the `P^3` of `a_3`.
    fn restitution(&self, order: usize) -> Vec<Ball> {
        let first = &self.first * &self.scale;
        let square = &first * &first;
        let mut c = vec![Ball::one(), first, self.rational(self.wide()) * &square];
        if order >= 3 {
            let [alpha, beta] = self.third_order();
            let scale_cubed = &self.scale * &self.scale * &self.scale;
            let third = alpha * (&square * &c[1]) + beta * (&self.third * scale_cubed);
            let fourth = match self.fourth_order() {
                Some([alpha, beta]) if order >= 4 => alpha * (&third * &c[1]) + beta * (&square * &square),
                _ => Ball::zero(),
            };
            c.extend([third, fourth]);
        }
        c.truncate(order + 1);
        c
    }
}

/// `h_0 .. h_order` by `eps_d = sum_k psi_k u^(r k) eps^(1 + p r k)`, `r = (a+1)/(a-gamma)`.
fn delayed(law: &ForceLaw, order: usize, bits: u32) -> Result<Vec<Ball>, ClosedError> {
    let end = DelayedRecovery::new(law)?;
    let step = end.damping_exponent();
    let (stride, steps) = (usize::try_from(*step.numer()), usize::try_from(*step.denom()));
    let (stride, steps) = (stride.unwrap_or(usize::MAX), steps.unwrap_or(1));
    let whole = order / steps;
    let c = LowOrders::new(law, whole, bits).restitution(whole);
    let exponent = BigRational::new((*step.numer()).into(), (*step.denom()).into());
    let mut h = vec![Ball::zero(); order + 1];
    for (k, psi) in end.psi(order / stride).iter().enumerate() {
        let index = BigRational::from_integer(k.into());
        let power = BigRational::one() + law.velocity_exponent() * &exponent * index;
        let places = h.iter_mut().skip(stride * k).step_by(steps);
        for (place, coefficient) in places.zip(power_of(&c, &power, bits)) {
            *place += coefficient * Ball::from_rational(psi, bits);
        }
    }
    Ok(h)
}

/// `(1 + c_1 x + ...)^power` by J.C.P. Miller: `n f_n = sum_(i>0) (power i - (n - i)) c_i f_(n-i)`.
fn power_of(c: &[Ball], power: &BigRational, bits: u32) -> Vec<Ball> {
    let mut f = vec![Ball::one()];
    for n in 1..c.len() {
        let mut sum = Ball::zero();
        for i in 1..=n {
            let whole = |n: usize| BigRational::from_integer(n.into());
            let weight = (power * whole(i) - whole(n - i)) / whole(n);
            if !weight.is_zero() {
                sum += Ball::from_rational(&weight, bits) * &c[i] * &f[n - i];
            }
        }
        f.push(sum);
    }
    f
}

/// Bytes that [`low_orders`] and the decimals of its values take at the peak, for so many digits.
///
/// Above what was measured: 49 MB for 10^6 digits of four coefficients, 11 MB for 10^5.
///
/// # Examples
///
/// ```
/// use restitution_closed::memory_estimate;
///
/// assert!(memory_estimate(1_000_000) > 4.9e7); // 49 MB were measured
/// assert!(memory_estimate(20) < 3e7);
/// ```
pub fn memory_estimate(digits: usize) -> f64 {
    400.0 * digits as f64 + 2e7
}
