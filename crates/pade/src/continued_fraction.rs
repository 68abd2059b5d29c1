use crate::{Approximant, PadeError, RationalFunction, RealField, polynomial};

/// One link `c x^alpha` of a continued fraction.
#[derive(Clone, Debug, PartialEq)]
pub struct Link<F> {
    /// The coefficient `c`, not zero.
    pub coefficient: F,
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
#[derive(Clone, Debug, PartialEq)]
pub struct ContinuedFraction<F> {
    /// The constant `c_0`.
    pub constant: F,
    /// The links, outermost first.
    pub links: Vec<Link<F>>,
}

impl<F: RealField> ContinuedFraction<F> {
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
        let mut before = (vec![F::one()], Vec::new());
        let mut last = (vec![self.constant.clone()], vec![F::one()]);
        for link in &self.links {
            let next = (add_link(&last.0, link, &before.0), add_link(&last.1, link, &before.1));
            before = std::mem::replace(&mut last, next);
        }
        RationalFunction::new(last.0, last.1)
    }
}

/// `a + c x^alpha b`.
fn add_link<F: RealField>(a: &[F], link: &Link<F>, b: &[F]) -> Vec<F> {
    let mut out = a.to_vec();
    if !b.is_empty() {
        out.resize(a.len().max(b.len() + link.power), F::zero());
    }
    for (c, y) in out.iter_mut().skip(link.power).zip(b) {
        *c = std::mem::replace(c, F::zero()) + link.coefficient.times(y);
    }
    out
}

impl<F: RealField> Approximant<F> {
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
        let constant = self.num().first().cloned().unwrap_or_else(F::zero);
        let mut series = self.shared().to_vec();
        if let Some(c) = series.first_mut() {
            *c = F::zero();
        }
        let (mut polynomial, mut links) = (self.minus(&constant), Vec::new());
        set_constant_zero(&mut polynomial);
        let mut before = Pair { polynomial: self.den().to_vec(), series: vec![F::one()] };
        before.series.resize(series.len(), F::zero());
        let mut last = Pair { polynomial, series };
        while let Some(link) = last.take_link()? {
            links.push(link);
            let next = before.minus(&last);
            before = std::mem::replace(&mut last, next);
        }
        Ok(ContinuedFraction { constant, links })
    }
}

fn set_constant_zero<F: RealField>(p: &mut [F]) {
    if let Some(c) = p.first_mut() {
        *c = F::zero();
    }
}

/// A polynomial `f_n` and the beginning of the series `f_n/Q`.
///
/// Both have the same lowest term; the series shows it sharply, the polynomial knows where to end.
struct Pair<F> {
    polynomial: Vec<F>,
    series: Vec<F>,
}

impl<F: RealField> Pair<F> {
    /// Splits off the lowest term `c x^alpha`, leaving a constant term 1; `None` at the end.
    fn take_link(&mut self) -> Result<Option<Link<F>>, PadeError> {
        let what = "whether a link of the continued fraction is zero";
        for (blurred, sharp) in self.polynomial.iter_mut().zip(&self.series) {
            if !sharp.is_zero() {
                break;
            }
            *blurred = F::zero();
        }
        let sharp = polynomial::lowest(&self.series, what)?;
        let (power, coefficient) = match sharp {
            Some(power) => (power, self.series[power].clone()),
            None => match polynomial::lowest(&self.polynomial, what)? {
                Some(power) => (power, self.polynomial[power].clone()),
                None => return Ok(None),
            },
        };
        for part in [&mut self.polynomial, &mut self.series] {
            *part = part.iter().skip(power).map(|c| c.clone() / &coefficient).collect();
            if let Some(c) = part.first_mut() {
                *c = F::one();
            }
        }
        Ok(Some(Link { coefficient, power }))
    }

    /// `f_(n-1) - f_n`, whose constant terms cancel.
    fn minus(&self, other: &Self) -> Self {
        let mut polynomial = polynomial::difference(&self.polynomial, &other.polynomial);
        let terms = self.series.iter().zip(&other.series);
        let mut series: Vec<F> = terms.map(|(a, b)| a.clone() - b).collect();
        set_constant_zero(&mut polynomial);
        set_constant_zero(&mut series);
        Self { polynomial, series }
    }
}
