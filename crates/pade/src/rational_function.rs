use crate::{PadeError, PadeType, polynomial};
use restitution_real::{Field, OrderedField, ZeroTest};

/// A quotient of polynomials `P(x)/Q(x)` with `Q(0) = 1`.
///
/// Leading coefficients are not zero, so the degrees are exact; the zero function is `0/1` and has
/// an empty numerator.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_pade::{PadeError, RationalFunction};
/// use restitution_real::Rationals;
///
/// let ints = |p: &[i64]| p.iter().map(|&c| BigRational::from_integer(c.into())).collect::<Vec<_>>();
/// let f = RationalFunction::new(&Rationals, ints(&[2]), ints(&[2, -2]))?; // 1/(1 - x)
/// assert_eq!(f.series(4), ints(&[1, 1, 1, 1]));
/// assert_eq!(f.degrees().to_string(), "[0/1]");
/// assert_eq!((f.num(), f.den(), f.field()), (&ints(&[1])[..], &ints(&[1, -1])[..], &Rationals));
/// assert_eq!(f.value(&ints(&[3])[0])?.to_string(), "-1/2");
/// assert!(matches!(f.value(&ints(&[1])[0]), Err(PadeError::Undecided { .. }))); // a pole
/// assert!(RationalFunction::new(&Rationals, ints(&[0]), ints(&[1]))?.is_zero());
///
/// assert_eq!(RationalFunction::new(&Rationals, ints(&[1]), ints(&[0, 1])), Err(PadeError::PoleAtZero));
/// # Ok::<(), PadeError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RationalFunction<F: Field> {
    field: F,
    num: Vec<F::Number>,
    den: Vec<F::Number>,
}

impl<F: OrderedField> RationalFunction<F> {
    /// Returns `num/den`, scaled to `den(0) = 1`. Common factors are left in place.
    ///
    /// # Errors
    ///
    /// [`PadeError::PoleAtZero`] if `den(0) = 0`, [`PadeError::Undecided`] if a ball leaves that or
    /// the vanishing of a leading coefficient open.
    pub fn new(field: &F, mut num: Vec<F::Number>, mut den: Vec<F::Number>) -> Result<Self, PadeError> {
        let constant = den.first().cloned().unwrap_or_else(|| field.zero());
        match field.zero_test(&constant) {
            ZeroTest::Zero => return Err(PadeError::PoleAtZero),
            ZeroTest::Undecided => {
                return Err(PadeError::Undecided {
                    what: "whether the constant term of the denominator is zero",
                });
            }
            ZeroTest::NonZero => {}
        }
        if field.zero_test(&field.sub(&constant, &field.one())) != ZeroTest::Zero {
            for c in num.iter_mut().chain(den.iter_mut().skip(1)) {
                *c = field.div(c, &constant);
            }
            den[0] = field.one();
        }
        polynomial::trim(field, &mut num, "whether the leading coefficient of the numerator is zero")?;
        polynomial::trim(field, &mut den, "whether the leading coefficient of the denominator is zero")?;
        Ok(Self { field: field.clone(), num, den })
    }

    /// The field of the coefficients.
    pub fn field(&self) -> &F {
        &self.field
    }

    /// The coefficients of the numerator, constant term first; empty for the zero function.
    pub fn num(&self) -> &[F::Number] {
        &self.num
    }

    /// The coefficients of the denominator, constant term (which is 1) first.
    pub fn den(&self) -> &[F::Number] {
        &self.den
    }

    /// Whether this is the zero function.
    pub fn is_zero(&self) -> bool {
        self.num.is_empty()
    }

    /// The exact degrees; the zero function counts as `[0/0]`.
    pub fn degrees(&self) -> PadeType {
        PadeType::new(self.num.len().saturating_sub(1), self.den.len() - 1)
    }

    /// The value `P(x)/Q(x)`.
    ///
    /// # Errors
    ///
    /// [`PadeError::Undecided`] if `Q(x)` is or may be zero.
    pub fn value(&self, x: &F::Number) -> Result<F::Number, PadeError> {
        let field = &self.field;
        let den = polynomial::evaluate(field, &self.den, x);
        match field.zero_test(&den) {
            ZeroTest::NonZero => Ok(field.div(&polynomial::evaluate(field, &self.num, x), &den)),
            _ => Err(PadeError::Undecided { what: "whether the denominator is zero at the point" }),
        }
    }

    /// The first `len` coefficients of the power series at 0, from `Q A = P`.
    pub fn series(&self, len: usize) -> Vec<F::Number> {
        let field = &self.field;
        let mut out = Vec::with_capacity(len);
        for n in 0..len {
            let known = self.den.iter().skip(1).zip(out.iter().rev());
            let start = self.num.get(n).cloned().unwrap_or_else(|| field.zero());
            out.push(known.fold(start, |rest, (q, a)| field.sub(&rest, &field.mul(q, a))));
        }
        out
    }
}

#[cfg(test)]
mod tests;
