use crate::{Approximant, PadeError, RationalFunction, polynomial};
use restitution_real::{Field, OrderedField, ZeroTest};

/// One link `c x^alpha` of a continued fraction.
#[derive(Clone, Debug, PartialEq)]
pub struct Link<N> {
    /// The coefficient `c`, not zero.
    pub coefficient: N,
    /// The power `alpha >= 1`.
    pub power: usize,
}

/// A corresponding continued fraction (C-fraction),
///
/// ```text
/// c_0 + c_1 x^alpha_1
///       ---------------------------
///       1 + c_2 x^alpha_2
///           -----------------------
///           1 + c_3 x^alpha_3 / (1 + ...)
/// ```
///
/// Every power series has exactly one, and it ends if and only if the series is a rational function
/// \[LS1939\]; powers above 1 occur exactly where the Padé table has degenerate blocks on its staircase.
/// With all powers 1 it is the regular C-fraction, whose convergents are the approximants
/// `[0/0], [1/0], [1/1], [2/1], ...`.
///
/// # Examples
///
/// ```
/// use num_rational::BigRational;
/// use restitution_pade::{PadeError, PadeType, approximant};
/// use restitution_real::{Ball, Balls, Rationals};
///
/// let series = [(1, 1), (1, 1), (1, 2)].map(|(n, d): (i64, i64)| BigRational::new(n.into(), d.into())); // e^x
/// let found = approximant(&Rationals, &series, PadeType::new(1, 1))?;
/// let fraction = found.continued_fraction()?; // 1 + x/(1 - (1/2) x)
/// let links: Vec<_> = fraction.links.iter().map(|link| (link.coefficient.to_string(), link.power)).collect();
/// assert_eq!(links, [("1".to_owned(), 1), ("-1/2".to_owned(), 1)]);
/// assert_eq!(&fraction.to_rational()?, found.function());
///
/// let third = Ball::from_ratio(1, 3, 53);
/// let balls = [third.clone(), &third - &third, third]; // does x come next, or x^2?
/// let open = approximant(&Balls::new(53), &balls, PadeType::new(2, 0))?.continued_fraction();
/// assert!(matches!(open, Err(PadeError::Undecided { .. })));
/// # Ok::<(), PadeError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ContinuedFraction<F: Field> {
    field: F,
    /// The constant `c_0`.
    pub constant: F::Number,
    /// The links, outermost first.
    pub links: Vec<Link<F::Number>>,
}

impl<F: OrderedField> ContinuedFraction<F> {
    /// Returns the quotient of polynomials that the fraction equals, in lowest terms.
    ///
    /// ```text
    /// A_n = A_(n-1) + c_n x^alpha_n A_(n-2),    B_n likewise
    /// ```
    ///
    /// (Wallis and Euler.) `A_n B_(n-1) - A_(n-1) B_n` is a power of `x` and `B_n(0) = 1`, hence no
    /// common factor remains. Cost: about `n^2` multiplications for `n` links.
    ///
    /// # Errors
    ///
    /// [`PadeError::Undecided`] if a ball leaves a leading coefficient open.
    pub fn to_rational(&self) -> Result<RationalFunction<F>, PadeError> {
        let field = &self.field;
        let mut before = (vec![field.one()], Vec::new());
        let mut last = (vec![self.constant.clone()], vec![field.one()]);
        for link in &self.links {
            let next = (add_link(field, &last.0, link, &before.0), add_link(field, &last.1, link, &before.1));
            before = std::mem::replace(&mut last, next);
        }
        RationalFunction::new(field, last.0, last.1)
    }
}

/// `a + c x^alpha b`.
fn add_link<F: Field>(field: &F, a: &[F::Number], link: &Link<F::Number>, b: &[F::Number]) -> Vec<F::Number> {
    let mut out = a.to_vec();
    if !b.is_empty() {
        out.resize(a.len().max(b.len() + link.power), field.zero());
    }
    for (c, y) in out.iter_mut().skip(link.power).zip(b) {
        *c = field.add(c, &field.mul(&link.coefficient, y));
    }
    out
}

impl<F: OrderedField> Approximant<F> {
    /// Returns the continued fraction that equals the approximant.
    ///
    /// With `f_0 = Q`, `f_1 = (P - c_0 Q)/(c_1 x^alpha_1)`, `f_(n+1) = (f_(n-1) - f_n)/(c x^alpha)`
    /// (Viskovatov), all scaled to `f_n(0) = 1`. Exact for rationals, degenerate blocks included; for
    /// balls the zeros that the series has exactly stay exact.
    /// Cost: about `(mu + nu)^2` multiplications.
    ///
    /// # Errors
    ///
    /// [`PadeError::Undecided`] if a ball that decides a power contains zero.
    pub fn continued_fraction(&self) -> Result<ContinuedFraction<F>, PadeError> {
        let field = self.field();
        let constant = self.num().first().cloned().unwrap_or_else(|| field.zero());
        let (mut polynomial, mut series) = (self.minus(&constant), self.shared().to_vec());
        set_constant(&mut series, field.zero());
        set_constant(&mut polynomial, field.zero());
        let mut before = Pair { polynomial: self.den().to_vec(), series: vec![field.one()] };
        before.series.resize(series.len(), field.zero());
        let (mut last, mut links) = (Pair { polynomial, series }, Vec::new());
        while let Some(link) = last.take_link(field)? {
            links.push(link);
            let next = before.minus(field, &last);
            before = std::mem::replace(&mut last, next);
        }
        Ok(ContinuedFraction { field: field.clone(), constant, links })
    }
}

fn set_constant<N>(p: &mut [N], value: N) {
    if let Some(c) = p.first_mut() {
        *c = value;
    }
}

/// A polynomial `f_n` and the beginning of the series `f_n/Q`.
///
/// Both have the same lowest term; the series shows it sharply, the polynomial knows where to end.
struct Pair<N> {
    polynomial: Vec<N>,
    series: Vec<N>,
}

impl<N: Clone> Pair<N> {
    /// Splits off the lowest term `c x^alpha`, leaving a constant term 1; `None` at the end.
    fn take_link<F: Field<Number = N>>(&mut self, field: &F) -> Result<Option<Link<N>>, PadeError> {
        let what = "whether a link of the continued fraction is zero";
        for (blurred, sharp) in self.polynomial.iter_mut().zip(&self.series) {
            if field.zero_test(sharp) != ZeroTest::Zero {
                break;
            }
            *blurred = field.zero();
        }
        let sharp = polynomial::lowest(field, &self.series, what)?;
        let (power, coefficient) = match sharp {
            Some(power) => (power, self.series[power].clone()),
            None => match polynomial::lowest(field, &self.polynomial, what)? {
                Some(power) => (power, self.polynomial[power].clone()),
                None => return Ok(None),
            },
        };
        for part in [&mut self.polynomial, &mut self.series] {
            *part = part.iter().skip(power).map(|c| field.div(c, &coefficient)).collect();
            set_constant(part, field.one());
        }
        Ok(Some(Link { coefficient, power }))
    }

    /// `f_(n-1) - f_n`, whose constant terms cancel.
    fn minus<F: Field<Number = N>>(&self, field: &F, other: &Self) -> Self {
        let mut polynomial = polynomial::difference(field, &self.polynomial, &other.polynomial);
        let terms = self.series.iter().zip(&other.series);
        let mut series: Vec<_> = terms.map(|(a, b)| field.sub(a, b)).collect();
        set_constant(&mut polynomial, field.zero());
        set_constant(&mut series, field.zero());
        Self { polynomial, series }
    }
}

#[cfg(test)]
mod tests;
