use crate::SeriesError;
use crate::fractional_series::small_fraction;
use num_rational::{BigRational, Ratio};
use num_traits::Signed;
use restitution_law::ForceLaw;
use restitution_real::convert::{big_rational, rug_rational};
use rug::{Integer, Rational};

/// The contact that ends at zero force: the factor `Psi` between the two ends of contact.
///
/// Dry bodies don't attract: on the way out the contact ends where `x'' = 0` (\[SP2008\]), before the
/// compression is gone. Followed backwards from the exit, the last piece of the trajectory is the one of
/// an impact with velocity `eps` and damping `-v`, `v = u eps^p`, and depends on one variable only:
///
/// ```text
/// eps_d(u) = eps(u) Psi(y),    y = (u eps^p)^r,    r = (a+1)/(a-gamma)
/// ```
///
/// (MATH section 7; for spheres `r = 5/2`, `p = 1/5`, `y = u^(5/2) eps^(1/2)`.)
#[derive(Clone, Debug)]
pub struct DelayedRecovery {
    law: ForceLaw,
    /// `a - gamma > 0`.
    lag: BigRational,
}

impl DelayedRecovery {
    /// Returns the zero-force end of contact for a law.
    ///
    /// # Errors
    ///
    /// [`SeriesError::NoZeroForceEnd`] unless `a > gamma`: else damping outweighs elasticity at no small
    /// compression.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_law::ForceLaw;
    /// use restitution_series::{DelayedRecovery, SeriesError};
    ///
    /// let end = DelayedRecovery::new(&ForceLaw::viscoelastic_spheres())?;
    /// let psi: Vec<String> = end.psi(3).iter().map(ToString::to_string).collect();
    /// assert_eq!(psi, ["1", "4/15", "13/150", "4897/160875"]);
    /// assert_eq!(end.damping_exponent().to_string(), "5/2");
    ///
    /// let law = "1,2".parse().expect("a force law");
    /// assert!(matches!(DelayedRecovery::new(&law), Err(SeriesError::NoZeroForceEnd { .. })));
    /// # Ok::<(), SeriesError>(())
    /// ```
    pub fn new(law: &ForceLaw) -> Result<Self, SeriesError> {
        let lag = law.a() - law.gamma();
        if !lag.is_positive() {
            return Err(SeriesError::NoZeroForceEnd { law: law.to_string() });
        }
        Ok(Self { law: law.clone(), lag })
    }

    /// The exponent `r = (a+1)/(a-gamma)` of the damping in `y`.
    pub fn damping_exponent(&self) -> Ratio<i64> {
        let r = self.law.elastic_step() / &self.lag;
        let (n, d) = small_fraction(&r).unwrap_or((1, 1));
        Ratio::new(n, d)
    }

    /// Returns `Psi(y) = 1 + psi_1 y + ...` to order `y^order`, exactly.
    ///
    /// In the phase plane the last piece, followed backwards, is a function of compression alone. With
    /// `q = x^(gamma+1)`, `m = (a-gamma)/(gamma+1)`, and `q` scaled so that zero force is where `q^m = V`,
    ///
    /// ```text
    /// V dV/dq = c (V - q^m),   V(0) = 1,   c = y/(gamma+1),     V = sum_k (c q)^k P_k(q^m)
    /// ```
    ///
    /// with polynomials `P_k` of degree `k`. At zero force `q^m = V = Psi`, so that with `xi = c Psi^(1/m)`
    ///
    /// ```text
    /// Psi = sum_k xi^k P_k(Psi),     [c^k] Psi = [xi^k] Psi^(1 + k/m)/(1 + k/m)
    /// ```
    ///
    /// the second by Lagrange's inversion of `c = xi Psi^(-1/m)`. Cost: about `order^4/48` products of
    /// integers and `order^3/2` of fractions; order 60 takes half a second.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_series::DelayedRecovery;
    ///
    /// let end = DelayedRecovery::new(&"1,0".parse().expect("a force law"))?;
    /// let psi: Vec<String> = end.psi(3).iter().map(ToString::to_string).collect();
    /// assert_eq!(psi, ["1", "1/2", "5/24", "19/240"]);
    /// # Ok::<(), restitution_series::SeriesError>(())
    /// ```
    pub fn psi(&self, order: usize) -> Vec<BigRational> {
        let measure = self.law.damping_step();
        let m = rug_rational(&(&self.lag / &measure));
        let polynomials = phase_plane(&m, order);
        let end = end_of_contact(&polynomials, order);
        let per_order = rug_rational(&measure).recip();
        let mut scale = Rational::from(1);
        let coefficient = |k: usize| {
            let exponent = Rational::from(k) / &m + 1u32;
            let coefficient = power(&end[..=k], &exponent) / exponent * &scale;
            scale *= &per_order;
            big_rational(&coefficient)
        };
        (0..=order).map(coefficient).collect()
    }
}

/// A polynomial with rational coefficients over one denominator.
struct Polynomial {
    numerators: Vec<Integer>,
    denominator: Integer,
}

impl Polynomial {
    fn new(coefficients: &[Rational]) -> Self {
        let denominator = coefficients.iter().fold(Integer::from(1), |common, c| common.lcm(c.denom()));
        let numerator = |c: &Rational| Integer::from(denominator.div_exact_ref(c.denom())) * c.numer();
        Self { numerators: coefficients.iter().map(numerator).collect(), denominator }
    }

    fn coefficient(&self, j: usize) -> Rational {
        self.numerators.get(j).map_or_else(Rational::new, |n| Rational::from((n, &self.denominator)))
    }

    /// The numerators of the product over the product of the denominators.
    fn product(&self, other: &Self) -> Vec<Integer> {
        let mut product = vec![Integer::new(); self.numerators.len() + other.numerators.len() - 1];
        for (i, x) in self.numerators.iter().enumerate() {
            for (total, y) in product[i..].iter_mut().zip(&other.numerators) {
                *total += x * y;
            }
        }
        product
    }
}

/// `P_0 .. P_order` of `V = sum_k (c q)^k P_k(q^m)`, from `d(V^2)/dq = 2 c (V - q^m)` and the square root.
fn phase_plane(m: &Rational, order: usize) -> Vec<Polynomial> {
    let mut polynomials = vec![Polynomial::new(&[Rational::from(1)])];
    for k in 1..=order {
        // 2 P_k = (V^2)_k - sum of P_l P_(k-l) over 0 < l < k, of which those with l < k/2 come twice.
        let mut sum: Vec<Rational> = (0..=k)
            .map(|j| {
                let pull = u32::from(k == 1 && j == 1);
                let speed = polynomials[k - 1].coefficient(j) - pull;
                speed * 2u32 / (Rational::from(j) * m + k as u64)
            })
            .collect();
        for l in 1..=k / 2 {
            let (one, other) = (&polynomials[l], &polynomials[k - l]);
            let denominator = Integer::from(&one.denominator * &other.denominator);
            let times = if 2 * l == k { 1u32 } else { 2 };
            for (total, numerator) in sum.iter_mut().zip(one.product(other)) {
                *total -= Rational::from((numerator * times, &denominator));
            }
        }
        sum.iter_mut().for_each(|c| *c /= 2u32);
        polynomials.push(Polynomial::new(&sum));
    }
    polynomials
}

/// `Psi` as a series in `xi`, from `Psi = sum_k xi^k P_k(Psi)`.
fn end_of_contact(polynomials: &[Polynomial], order: usize) -> Vec<Rational> {
    // powers[j][d] = [xi^d] Psi^j, for j + d <= order.
    let mut powers: Vec<Vec<Rational>> = vec![vec![Rational::from(1)]; order + 1];
    let mut end = vec![Rational::from(1)];
    for k in 1..=order {
        let next = (1..=k).map(|l| {
            let polynomial = &polynomials[l];
            let terms = (0..=l).map(|j| Rational::from(&powers[j][k - l] * &polynomial.numerators[j]));
            terms.fold(Rational::new(), |sum, term| sum + term) / &polynomial.denominator
        });
        let next = next.fold(Rational::new(), |sum, term| sum + term);
        end.push(next);
        powers[0].push(Rational::new());
        for j in 1..=order - k {
            let terms = (0..=k).map(|d| Rational::from(&powers[j - 1][d] * &end[k - d]));
            let coefficient = terms.fold(Rational::new(), |sum, term| sum + term);
            powers[j].push(coefficient);
        }
    }
    end
}

/// The last coefficient of `series^exponent`, for a series that begins with 1 (Miller's formula).
fn power(series: &[Rational], exponent: &Rational) -> Rational {
    let mut power = vec![Rational::from(1)];
    for k in 1..series.len() {
        let term = |i: usize| {
            let weight = Rational::from(exponent * i as u64) - (k - i) as u64;
            weight * &series[i] * &power[k - i]
        };
        let sum = (1..=k).fold(Rational::new(), |sum, i| sum + term(i));
        power.push(sum / k as u64);
    }
    power.pop().unwrap_or_default()
}
