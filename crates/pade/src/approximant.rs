use crate::null_vector::null_vector;
use crate::{AtInfinity, PadeError, PadeType, RationalFunction, polynomial};
use restitution_real::{Field, OrderedField, ZeroTest};
use std::fmt;

/// How far a series and its approximant agree: the first power of `x` in `A - P/Q`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Contact {
    /// `A - P/Q = c x^n + ...` with `c != 0`.
    Exactly(usize),
    /// `A - P/Q = O(x^n)`; whether the coefficient of `x^n` vanishes too is not known, because the
    /// series ends there or the precision does not tell.
    AtLeast(usize),
}

impl Contact {
    /// The proved order `n` of `A - P/Q = O(x^n)`.
    pub fn order(self) -> usize {
        let (Self::Exactly(n) | Self::AtLeast(n)) = self;
        n
    }
}

impl fmt::Display for Contact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exactly(n) => write!(f, "exactly O(x^{n})"),
            Self::AtLeast(n) => write!(f, "at least O(x^{n})"),
        }
    }
}

/// A Padé approximant in lowest terms, with what it is an approximant of.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_pade::{PadeError, PadeType, approximant};
/// use restitution_real::Rationals;
///
/// let series = [1, -1, 1, -1, 1].map(|n| BigRational::from_integer(n.into())); // 1/(1 + x)
/// let found = approximant(&Rationals, &series, PadeType::new(2, 2))?;
/// assert_eq!((found.asked().to_string(), found.exact_type().to_string()), ("[2/2]".into(), "[0/1]".into()));
/// assert_eq!((found.num(), found.den()), (&series[..1], &[series[0].clone(), series[0].clone()][..]));
/// assert_eq!((found.contact().order(), found.met_at_infinity(), found.deficiency()), (5, 0, 0));
/// assert_eq!(found.function().value(&series[0])?.to_string(), "1/2");
/// assert_eq!(found.reciprocal()?.num(), found.den()); // 1 + x, of the reciprocal series
///
/// let longer = approximant(&Rationals, &series, PadeType::new(3, 3));
/// assert!(matches!(longer, Err(PadeError::NotEnoughCoefficients { needed: 7, known: 5, .. })));
/// # Ok::<(), PadeError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Approximant<F: Field> {
    asked: PadeType,
    function: RationalFunction<F>,
    contact: Contact,
    met_at_infinity: usize,
    /// The coefficients of the series that `P/Q` shares.
    shared: Vec<F::Number>,
}

impl<F: OrderedField> Approximant<F> {
    /// The type that was asked for.
    pub fn asked(&self) -> PadeType {
        self.asked
    }

    /// The exact type `[mu/nu]`: the degrees in lowest terms. In a degenerate block of the table
    /// they are lower than what was asked for; the zero function counts as `[0/0]`.
    pub fn exact_type(&self) -> PadeType {
        self.function.degrees()
    }

    /// The order of contact with the series at 0.
    pub fn contact(&self) -> Contact {
        self.contact
    }

    /// How many of the conditions at infinity are met: all, unless the approximant is degenerate.
    pub fn met_at_infinity(&self) -> usize {
        self.met_at_infinity
    }

    /// The power `lambda` by which `x^lambda (P, Q)` solves the linear conditions as asked,
    /// `A Q - P = O(x^(L+M+1))`, when `P/Q` itself does not; 0 outside degenerate blocks.
    pub fn deficiency(&self) -> usize {
        self.asked.conditions().saturating_sub(self.contact.order() + self.met_at_infinity)
    }

    /// The quotient `P/Q`.
    pub fn function(&self) -> &RationalFunction<F> {
        &self.function
    }

    /// The coefficients of the numerator, constant term first.
    pub fn num(&self) -> &[F::Number] {
        self.function.num()
    }

    /// The coefficients of the denominator, constant term (which is 1) first.
    pub fn den(&self) -> &[F::Number] {
        self.function.den()
    }

    /// Returns the approximant `Q/P` of the reciprocal series, of type `[M/L]`.
    ///
    /// `[L/M]` of `A` is the reciprocal of `[M/L]` of `1/A` (Hadamard), for every entry of the table where
    /// `A(0)` is not zero; so an exact zero among the coefficients of `1/A` decides what the balls of
    /// `A` leave open.
    ///
    /// # Errors
    ///
    /// [`PadeError::PoleAtZero`] if the series vanishes at 0, [`PadeError::Undecided`] if a ball leaves that open.
    pub fn reciprocal(&self) -> Result<Self, PadeError> {
        let function = RationalFunction::new(self.field(), self.den().to_vec(), self.num().to_vec())?;
        let asked = PadeType::new(self.asked.denominator, self.asked.numerator);
        let shared = RationalFunction::new(self.field(), vec![self.field().one()], self.shared.clone())?
            .series(self.shared.len());
        Ok(Self { asked, function, shared, ..self.clone() })
    }

    /// The field of the coefficients.
    pub fn field(&self) -> &F {
        self.function.field()
    }

    /// The coefficients of the series up to the order of contact, which `P/Q` has too.
    pub(crate) fn shared(&self) -> &[F::Number] {
        &self.shared
    }

    /// The polynomial `P - c Q`, below the order of contact as `(A - c) Q`.
    ///
    /// The series keeps zeros exact that a difference of balls would blur.
    pub(crate) fn minus(&self, c: &F::Number) -> Vec<F::Number> {
        let field = self.field();
        let mut series = self.shared.clone();
        if let Some(constant) = series.first_mut() {
            *constant = field.sub(constant, c);
        }
        let scaled: Vec<_> = self.den().iter().map(|q| field.mul(q, c)).collect();
        let mut out = polynomial::difference(field, self.num(), &scaled);
        let known = polynomial::product_trunc(field, &series, self.den(), series.len().min(out.len()));
        for (coefficient, sharp) in out.iter_mut().zip(known) {
            *coefficient = sharp;
        }
        out
    }

    /// The polynomial `P' Q - P Q'`, below the order of contact as `A' Q^2`.
    pub(crate) fn slope(&self) -> Vec<F::Number> {
        let (field, num, den) = (self.field(), self.num(), self.den());
        let rise = polynomial::product(field, &polynomial::derivative(field, num), den);
        let fall = polynomial::product(field, num, &polynomial::derivative(field, den));
        let mut out = polynomial::difference(field, &rise, &fall);
        if num.len() == den.len() {
            out.truncate((num.len() + den.len()).saturating_sub(3));
        }
        let slopes = polynomial::derivative(field, &self.shared);
        let square = polynomial::product(field, den, den);
        let known = polynomial::product_trunc(field, &slopes, &square, slopes.len().min(out.len()));
        for (coefficient, sharp) in out.iter_mut().zip(known) {
            *coefficient = sharp;
        }
        out
    }
}

/// Returns the `[L/M]` Padé approximant of the series `A` with the given coefficients.
///
/// ```text
/// A Q - P = O(x^(L+M+1)),   deg P <= L,   deg Q <= M
/// ```
///
/// The answer is the one quotient `P/Q` that these conditions leave, in lowest terms with `Q(0) = 1`,
/// for every entry of the table: where several pairs solve them (a degenerate block), the pair with
/// the denominator of least degree is found and its common power of `x` is taken out \[GGT2013, sec. 2\].
/// It then carries its exact type and its order of contact, which says whether `P/Q` itself or only
/// `x^lambda (P, Q)` meets the conditions ([`Approximant::deficiency`]). The zero series gives `0/1`.
///
/// Exact for rationals; enclosures for balls.
/// Cost: `M^3/3 + L M` multiplications.
///
/// # Errors
///
/// [`PadeError::NotEnoughCoefficients`] with fewer than `L + M + 1` coefficients;
/// [`PadeError::Undecided`] if a ball that decides the type contains zero.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_pade::{Contact, PadeError, PadeType, approximant};
/// use restitution_real::Rationals;
///
/// let ints = |p: &[i64]| p.iter().map(|&c| BigRational::from_integer(c.into())).collect::<Vec<_>>();
///
/// // 1 + x^2 + O(x^4): [1/1] degenerates to [0/0], because no [1/1] quotient matches x^2.
/// let even = approximant(&Rationals, &ints(&[1, 0, 1, 0]), PadeType::new(1, 1))?;
/// assert_eq!(even.exact_type(), PadeType::new(0, 0));
/// assert_eq!(even.contact(), Contact::Exactly(2));
/// assert_eq!(even.deficiency(), 1);
///
/// let short = approximant(&Rationals, &ints(&[1, 1]), PadeType::new(1, 1));
/// assert!(matches!(short, Err(PadeError::NotEnoughCoefficients { needed: 3, known: 2, .. })));
/// # Ok::<(), PadeError>(())
/// ```
pub fn approximant<F: OrderedField>(
    field: &F,
    series: &[F::Number],
    asked: PadeType,
) -> Result<Approximant<F>, PadeError> {
    solve(field, series, asked, &AtInfinity::nothing())
}

/// Solves for `P/Q` with the last conditions exchanged for those at infinity.
pub(crate) fn solve<F: OrderedField>(
    field: &F,
    series: &[F::Number],
    asked: PadeType,
    infinity: &AtInfinity<F>,
) -> Result<Approximant<F>, PadeError> {
    let conditions = infinity.conditions();
    let needed = asked.conditions().saturating_sub(conditions);
    if series.len() < needed {
        return Err(PadeError::NotEnoughCoefficients { asked, needed, known: series.len() });
    }
    let PadeType { numerator, denominator } = asked;
    let mut rows: Vec<Vec<F::Number>> =
        (numerator + 1..needed).map(|n| contact_row(field, series, n, denominator)).collect();
    rows.extend((0..conditions).map(|i| infinity.row(field, series, asked, i)));
    let den = null_vector(field, rows, denominator + 1)?;
    let lost = denominator + 1 - den.len();
    let shift =
        polynomial::lowest(field, &den, "whether the constant term of the denominator is zero")?.unwrap_or(0);
    let constant = den[shift].clone();
    let mut den: Vec<_> = den.iter().skip(shift).map(|c| field.div(c, &constant)).collect();
    den[0] = field.one();
    let num = polynomial::product_trunc(field, series, &den, (numerator + 1).saturating_sub(shift));
    let function = RationalFunction::new(field, num, den)?;
    let contact = contact(series, &function, needed.saturating_sub(shift));
    let shared = series[..contact.order()].to_vec();
    let met_at_infinity = conditions.saturating_sub(lost);
    Ok(Approximant { asked, function, contact, met_at_infinity, shared })
}

/// The coefficient of `x^n` in `A Q`, as a row of the unknowns `q_0, ..., q_M`.
fn contact_row<F: Field>(field: &F, series: &[F::Number], n: usize, denominator: usize) -> Vec<F::Number> {
    (0..=denominator).map(|j| n.checked_sub(j).map_or_else(|| field.zero(), |k| series[k].clone())).collect()
}

/// The order of contact, from the first coefficient of `A Q - P` that is not zero.
///
/// Below `proved` the coefficients vanish by construction.
fn contact<F: OrderedField>(series: &[F::Number], function: &RationalFunction<F>, proved: usize) -> Contact {
    let field = function.field();
    for n in proved..series.len() {
        let terms = function.den().iter().zip(series[..=n].iter().rev());
        let product = terms.fold(field.zero(), |sum, (q, a)| field.add(&sum, &field.mul(q, a)));
        let residual = function.num().get(n).map_or_else(|| product.clone(), |p| field.sub(&product, p));
        match field.zero_test(&residual) {
            ZeroTest::Zero => {}
            ZeroTest::NonZero => return Contact::Exactly(n),
            ZeroTest::Undecided => return Contact::AtLeast(n),
        }
    }
    Contact::AtLeast(series.len())
}

#[cfg(test)]
mod tests;
