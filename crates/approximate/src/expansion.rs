use crate::ApproximateError;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use restitution_direct::{Collision, DirectError, End, saturation_speed};
use restitution_law::ForceLaw;
use restitution_pade::{AtInfinity, RationalFunction, Sample};
use restitution_real::{Ball, Balls, Field};
use restitution_series::{DelayedRecovery, Quantity, coefficients};
use std::collections::HashMap;
use std::sync::Mutex;

/// The variable that an approximant is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Variable {
    /// s = -C_1 u = (g/g*)^(1/5), the paper's.
    S,
    /// u, the damping scaled by the impact velocity.
    U,
    /// The square root of u, in which the end at zero force expands.
    SqrtU,
}

impl Variable {
    /// The variable as it is written.
    pub fn name(self) -> &'static str {
        match self {
            Self::S => "s",
            Self::U => "u",
            Self::SqrtU => "sqrt(u)",
        }
    }
}

/// Proved digits of a certified value, enough to judge errors down to about 1e-25.
const SAMPLE_DIGITS: usize = 28;
/// Bits that hold such a value.
const SAMPLE_BITS: u32 = 128;

/// The restitution coefficient of one law with one end of contact, as a series in one variable.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_approximate::{ApproximateError, Expansion, Variable};
/// use restitution_direct::End;
/// use restitution_law::ForceLaw;
///
/// let spheres = ForceLaw::viscoelastic_spheres();
/// let in_u = Expansion::new(&spheres, End::ZeroCompression, None)?;
/// let series = in_u.coefficients(3, 80)?;
/// assert_eq!(series[1].to_digits(10).as_deref(), Some("-1.153448858"));
/// assert_eq!((in_u.variable().name(), in_u.end()), ("u", End::ZeroCompression));
///
/// // eps falls off like u^-5, and eps u^5 tends to R^5
/// assert_eq!((in_u.decay()?, in_u.saturation(5)?.to_digits(5).as_deref()), (5, Some("5.1584")));
/// assert!(in_u.at_infinity(2, 80).is_ok() && in_u.reciprocal(&series, 80)?.is_none()); // that needs eleven
/// let at_zero = in_u.sample(&BigRational::from_integer(0.into()))?; // certified
/// assert_eq!(at_zero.value.to_digits(3).as_deref(), Some("1.00"));
/// let at_force = Expansion::new(&spheres, End::ZeroForce, None)?;
/// assert!(at_force.decay().is_err_and(|error| error.is_request_at_fault())); // like u^(-5/3)
///
/// let no_series = Expansion::new(&spheres, End::ZeroForce, Some(Variable::U));
/// assert!(matches!(no_series, Err(ApproximateError::NoPowerSeries { .. })));
/// # Ok::<(), ApproximateError>(())
/// ```
#[derive(Debug)]
pub struct Expansion {
    law: ForceLaw,
    variable: Variable,
    collision: Collision,
    samples: Mutex<HashMap<BigRational, Sample>>,
}

impl Expansion {
    /// Returns the expansion; without a variable in the one that belongs to the end of contact.
    ///
    /// # Errors
    ///
    /// [`ApproximateError::NoPowerSeries`] in `s` or `u` at zero force, [`ApproximateError::Law`] for a law without that end.
    pub fn new(law: &ForceLaw, end: End, variable: Option<Variable>) -> Result<Self, ApproximateError> {
        let variable = match (end, variable) {
            (End::ZeroCompression, variable) => variable.unwrap_or(Variable::U),
            (End::ZeroForce, None | Some(Variable::SqrtU)) => Variable::SqrtU,
            (End::ZeroForce, Some(variable)) => {
                return Err(ApproximateError::NoPowerSeries { variable: variable.name() });
            }
        };
        let collision = Collision::new(law, end).map_err(ApproximateError::Law)?;
        Ok(Self { law: law.clone(), variable, collision, samples: Mutex::default() })
    }

    /// The variable.
    pub fn variable(&self) -> Variable {
        self.variable
    }

    /// The end of contact.
    pub fn end(&self) -> End {
        self.collision.end()
    }

    /// The first `count` coefficients in the variable, to about `bits` bits.
    ///
    /// What is known exactly is exact: the constant term 1, zeros between powers, and in `s` the
    /// linear term.
    ///
    /// # Errors
    ///
    /// [`ApproximateError::Coefficients`], and at zero force [`ApproximateError::OtherRoot`].
    pub fn coefficients(&self, count: usize, bits: u32) -> Result<Vec<Ball>, ApproximateError> {
        let digits = (f64::from(bits) * std::f64::consts::LOG10_2).ceil() as usize;
        let mut series = match (self.end(), self.variable) {
            (End::ZeroForce, _) => self.half_powers(count, digits)?,
            (_, Variable::U) => self.known(Quantity::Restitution, count, digits)?,
            (_, Variable::S) => {
                let a = self.known(Quantity::ScaledRestitution, count, digits)?;
                a.into_iter().enumerate().map(|(k, a)| if k % 2 == 1 { -a } else { a }).collect()
            }
            (_, Variable::SqrtU) => {
                spread(self.known(Quantity::Restitution, count.div_ceil(2), digits)?, count)
            }
        };
        if let Some(constant) = series.first_mut() {
            *constant = Ball::one();
        }
        Ok(series)
    }

    fn known(&self, quantity: Quantity, count: usize, digits: usize) -> Result<Vec<Ball>, ApproximateError> {
        let order = count.saturating_sub(1).max(1);
        let mut values =
            coefficients(quantity, &self.law, order, digits).map_err(ApproximateError::Coefficients)?;
        values.truncate(count);
        Ok(values)
    }

    /// The reciprocal of the series, where time reversal makes one of its coefficients exactly zero.
    ///
    /// With `v = -u eps^p`, which is its own inverse, Lagrange's formula gives for `k = 1/p` whole
    ///
    /// ```text
    /// k [u^k] v^-k = -k [u^k] v^-k,    hence    [u^(2k)] 1/eps = 0
    /// ```
    ///
    /// so that (spheres) the approximants `[0/10]`, `[1/9]`, `[1/10]` in `u` are all `[0/9]`. No enclosure can
    /// show that. `None` where the series is shorter or `1/p` is not whole.
    ///
    /// # Errors
    ///
    /// [`ApproximateError::Pade`].
    pub fn reciprocal(&self, series: &[Ball], bits: u32) -> Result<Option<Vec<Ball>>, ApproximateError> {
        let power = self.law.velocity_exponent();
        let whole = power.is_positive() && power.numer().is_one() && self.end() == End::ZeroCompression;
        let steps = if self.variable == Variable::SqrtU { 4 } else { 2 };
        let index = power.denom().to_usize().and_then(|k| k.checked_mul(steps)).filter(|_| whole);
        let Some(index) = index.filter(|&index| index < series.len()) else { return Ok(None) };
        let field = Balls::new(bits);
        let one_over = RationalFunction::new(&field, vec![field.one()], series.to_vec())?;
        let mut reciprocal = one_over.series(series.len());
        reciprocal[index] = field.zero();
        Ok(Some(reciprocal))
    }

    /// The largest `u <= high`, to about three digits, at which the bodies separate.
    ///
    /// For laws with `p <= 0` there is a critical damping beyond which they do not.
    ///
    /// # Errors
    ///
    /// [`ApproximateError::Value`].
    pub fn reach(&self, high: &BigRational) -> Result<BigRational, ApproximateError> {
        const HALVINGS: usize = 10;
        const DIGITS: usize = 5;
        let has_value = |u: &BigRational| match self.collision.epsilon(u, DIGITS) {
            Ok(_) => Ok(true),
            Err(
                DirectError::Overdamped { .. } | DirectError::Vanishing { .. } | DirectError::Faint { .. },
            ) => Ok(false),
            Err(error) => Err(ApproximateError::Value(error)),
        };
        if self.law.velocity_exponent().is_positive() || has_value(high)? {
            return Ok(high.clone());
        }
        let (mut low, mut beyond) = (BigRational::zero(), high.clone());
        for _ in 0..HALVINGS {
            let middle = (&low + &beyond) / BigRational::from_integer(2.into());
            if has_value(&middle)? { low = middle } else { beyond = middle }
        }
        Ok(low)
    }

    /// `h_k` of `eps = sum h_k u^(k/2)`.
    fn half_powers(&self, count: usize, digits: usize) -> Result<Vec<Ball>, ApproximateError> {
        let end = DelayedRecovery::new(&self.law).map_err(ApproximateError::NoDelayedRecovery)?;
        match *end.damping_exponent().denom() {
            2 => self.known(Quantity::DelayedRecovery, count, digits),
            1 => Ok(spread(self.known(Quantity::DelayedRecovery, count.div_ceil(2), digits)?, count)),
            steps => Err(ApproximateError::OtherRoot { law: Box::new(self.law.clone()), steps }),
        }
    }

    /// The first `conditions` terms of the expansion at infinity, `eps = (exit speed)/u^(1/p)` and nothing more.
    ///
    /// # Errors
    ///
    /// [`ApproximateError::Law`], [`ApproximateError::NoWholePower`], [`ApproximateError::NoWholePowerAtZeroForce`].
    pub fn at_infinity(&self, conditions: usize, bits: u32) -> Result<AtInfinity<Balls>, ApproximateError> {
        let digits = (f64::from(bits) * std::f64::consts::LOG10_2).ceil() as usize;
        let mut leading = self.saturation(digits)?;
        let decay = self.decay()?;
        if self.variable == Variable::S {
            leading *= self.scale(digits)?.powi(i64::try_from(decay).unwrap_or(i64::MAX));
        }
        let zeros = std::iter::repeat_with(Ball::zero);
        Ok(AtInfinity::new(decay, std::iter::once(leading).chain(zeros).take(conditions).collect()))
    }

    /// `lim eps u^(1/p)`.
    ///
    /// # Errors
    ///
    /// [`ApproximateError::Law`], [`ApproximateError::NoWholePowerAtZeroForce`].
    pub fn saturation(&self, digits: usize) -> Result<Ball, ApproximateError> {
        if self.end() == End::ZeroForce {
            return Err(ApproximateError::NoWholePowerAtZeroForce);
        }
        saturation_speed(&self.law, digits).map_err(ApproximateError::Law)
    }

    /// The exponent with which `eps` falls off in the variable: `1/p`, or twice that in `sqrt(u)`.
    ///
    /// # Errors
    ///
    /// [`ApproximateError::NoWholePower`], [`ApproximateError::NoWholePowerAtZeroForce`].
    pub fn decay(&self) -> Result<usize, ApproximateError> {
        if self.end() == End::ZeroForce {
            return Err(ApproximateError::NoWholePowerAtZeroForce);
        }
        let p = self.law.velocity_exponent();
        let steps = if self.variable == Variable::SqrtU { 2 } else { 1 };
        let decay = p.is_positive().then(|| BigRational::from_integer(steps.into()) / &p);
        let whole = decay.filter(|d| d.is_integer()).and_then(|d| d.to_usize());
        whole.ok_or_else(|| ApproximateError::NoWholePower {
            law: Box::new(self.law.clone()),
            exponent: Box::new(p),
            variable: self.variable.name(),
        })
    }

    /// `-C_1`.
    fn scale(&self, digits: usize) -> Result<Ball, ApproximateError> {
        let c = coefficients(Quantity::Restitution, &self.law, 1, digits)
            .map_err(ApproximateError::Coefficients)?;
        Ok(-c.into_iter().nth(1).unwrap_or_else(Ball::one))
    }

    /// The certified value at `u`; the argument is in the variable.
    ///
    /// # Errors
    ///
    /// [`ApproximateError::Value`].
    pub fn sample(&self, u: &BigRational) -> Result<Sample, ApproximateError> {
        let lock = || self.samples.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(sample) = lock().get(u) {
            return Ok(sample.clone());
        }
        let exact = Ball::from_rational(u, SAMPLE_BITS);
        let x = match self.variable {
            Variable::U => exact,
            Variable::S => exact * self.scale(SAMPLE_DIGITS + 10)?,
            Variable::SqrtU if u.is_zero() => Ball::zero(),
            Variable::SqrtU => exact.sqrt(),
        };
        let value = self.collision.epsilon(u, SAMPLE_DIGITS).map_err(ApproximateError::Value)?;
        let sample = Sample { x, value: value.with_prec(SAMPLE_BITS) };
        lock().insert(u.clone(), sample.clone());
        Ok(sample)
    }
}

/// A series in `u` as one in `sqrt(u)`, with exact zeros between.
fn spread(series: Vec<Ball>, count: usize) -> Vec<Ball> {
    series.into_iter().flat_map(|c| [c, Ball::zero()]).take(count).collect()
}
