//! The approximate theory of section III of \[RPBS1999\], for any power law.

use num_rational::BigRational;
use num_traits::One;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use rug::Float;

/// The approximate theory of section III: the velocity falls with compression as in the elastic
/// collision, scaled to the true turning point (20), (24).
///
/// ```text
/// eps + s eps^q = 1,     q = (gamma+1)/(a+1),     s = 2 d delta = -C_1 u = (g/g*)^p      (27)
/// ```
///
/// For spheres `q = 3/5`. The first two coefficients of its expansion are exact for every power law,
/// `a_1 = 1` and `a_2 = q`; the others are not (`docs/approximate-theory.md`).
///
/// # Examples
///
/// ```
/// use restitution_law::ForceLaw;
/// use restitution_real::Ball;
/// use restitution_series::ApproximateTheory;
///
/// let theory = ApproximateTheory::new(&ForceLaw::viscoelastic_spheres());
/// let a: Vec<String> = theory.coefficients(4).iter().map(ToString::to_string).collect();
/// assert_eq!(a, ["1", "1", "3/5", "6/25", "7/125"]);
///
/// let one = Ball::from_integer(1, 100);
/// assert_eq!(theory.restitution(&one).to_digits(12).as_deref(), Some("0.412320197142"));
///
/// assert_eq!((theory.exponent().to_string(), theory.coefficient(2).to_string()), ("3/5".into(), "3/5".into()));
/// assert_eq!(theory.continued_fraction(&one, 60).to_digits(12).as_deref(), Some("0.412320197142"));
///
/// // The theory knows no collision that gains energy.
/// assert!(!theory.restitution(&-one).is_finite());
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ApproximateTheory {
    exponent: BigRational,
}

impl ApproximateTheory {
    /// Returns the theory of a force law.
    pub fn new(law: &ForceLaw) -> Self {
        Self { exponent: law.damping_step() / law.elastic_step() }
    }

    /// The exponent `q = (gamma + 1)/(a + 1)` of (27).
    pub fn exponent(&self) -> &BigRational {
        &self.exponent
    }

    /// Returns the coefficient `a_k` of `eps = 1 - a_1 s + a_2 s^2 - ...` (32), exactly.
    ///
    /// Lagrange's inversion of `1 - eps = s (1 - (1 - eps))^q`:
    ///
    /// ```text
    /// a_0 = 1,    a_k = (1/k) binomial(q k, k - 1)
    /// ```
    ///
    /// Exact. Cost: `k` rational multiplications.
    pub fn coefficient(&self, k: usize) -> BigRational {
        let integer = |n: usize| BigRational::from_integer(n.into());
        let top = &self.exponent * integer(k);
        let factor = |i: usize| (&top - integer(i)) / integer(i + 2);
        (0..k.saturating_sub(1)).map(factor).product()
    }

    /// Returns `a_0 ..= a_order`, exactly.
    pub fn coefficients(&self, order: usize) -> Vec<BigRational> {
        (0..=order).map(|k| self.coefficient(k)).collect()
    }

    /// Returns the solution of (27) for `s >= 0`, enclosed; the whole line if `s` may be negative.
    ///
    /// `f(eps) = eps + s eps^q - 1` increases, so that a change of its sign encloses the one root.
    /// Newton's iteration only proposes where.
    pub fn restitution(&self, s: &Ball) -> Ball {
        let prec = s.prec();
        if !s.is_finite() || s.lower() < 0 {
            return Ball::whole_line(prec);
        }
        let (high, low) = (self.root(&Ball::exact(s.lower())), self.root(&Ball::exact(s.upper())));
        low.union(&high).with_prec(prec)
    }

    /// Returns the continued fraction (28) broken off after `depth` levels.
    ///
    /// ```text
    /// 1/eps_0 = 1,    1/eps_(m+1) = 1 + s (1/eps_m)^(1-q)
    /// ```
    ///
    /// For `0 < q <= 1` it falls towards the solution of (27), at least like `(1-q)^m` in the end.
    pub fn continued_fraction(&self, s: &Ball, depth: usize) -> Ball {
        let one = Ball::one();
        let power = BigRational::one() - &self.exponent;
        let level = |inverse: Ball| &one + s * inverse.pow(&power);
        let inverse = (0..depth).fold(Ball::from_integer(1, s.prec()), |inverse, _| level(inverse));
        one / inverse
    }

    /// The root at one exact `s >= 0`.
    fn root(&self, s: &Ball) -> Ball {
        let prec = s.prec() + 32;
        let s = s.with_prec(prec);
        let guess = self.newton(&s);
        let ulp = Float::with_val(32, guess.mid()) >> i32::try_from(prec - 24).unwrap_or(i32::MAX);
        let shifted = |steps: i64| &guess + Ball::exact(ulp.clone()) * Ball::from_integer(steps, prec);
        // A wider bracket is tried until the signs prove it; [0, 1] always holds the root.
        for steps in (0..40).map(|k| 1i64 << k) {
            let (low, high) = (shifted(-steps), shifted(steps));
            if low.is_positive()
                && self.defect(&s, &low).is_negative()
                && self.defect(&s, &high).is_positive()
            {
                return Ball::between(&low.lower(), &high.upper(), prec);
            }
        }
        Ball::between(&Float::new(prec), &Float::with_val(prec, 1), prec)
    }

    /// `f(eps) = eps + s eps^q - 1`.
    fn defect(&self, s: &Ball, eps: &Ball) -> Ball {
        eps + s * eps.pow(&self.exponent) - Ball::one()
    }

    /// A point near the root, of which nothing is proved.
    ///
    /// In `x = ln eps` the equation `ln(e^x + s e^(q x)) = 0` is convex with a slope between
    /// `q` and 1, so that Newton's iteration converges from everywhere.
    fn newton(&self, s: &Ball) -> Ball {
        let prec = s.prec();
        let exponent = Ball::from_rational(&self.exponent, prec);
        let mut x = Ball::from_integer(0, prec);
        for _ in 0..100 {
            let eps = x.exp();
            let damped = s * (&exponent * &x).exp();
            let sum = &eps + &damped;
            let step = Ball::exact((sum.ln() * &sum / (eps + &exponent * damped)).mid().clone());
            x = Ball::exact((x - &step).mid().clone());
            if step.abs_up() < Float::with_val(32, 1) >> i32::try_from(prec / 2 + 8).unwrap_or(i32::MAX) {
                break;
            }
        }
        Ball::exact(x.exp().mid().clone())
    }
}
