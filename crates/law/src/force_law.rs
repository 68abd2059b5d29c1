use crate::LawError;
use crate::exact::{Exact, NumberError};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};
use std::fmt;
use std::str::FromStr;

/// The exponents of the scaled equation of motion `x'' + u x^gamma x' + x^a = 0`.
///
/// Section II of \[RPBS1999\] with `alpha = a` and `beta = 1`; colliding viscoelastic spheres are
/// `a = 3/2`, `gamma = 1/2` (eq. 5). Exact: the exponents are rational numbers.
///
/// # Examples
///
/// ```
/// use restitution_law::{ForceLaw, LawError};
///
/// let spheres = ForceLaw::viscoelastic_spheres();
/// assert_eq!(spheres, "3/2,1/2".parse()?);
/// assert_eq!(spheres.velocity_exponent().to_string(), "1/5"); // u ~ g^(1/5)
/// assert_eq!(spheres, ForceLaw::new(spheres.a().clone(), spheres.gamma().clone())?);
/// assert_eq!((spheres.elastic_step().to_string(), spheres.damping_step().to_string()), ("5/2".into(), "3/2".into()));
/// let lattice = spheres.lattice(); // the same in halves
/// assert_eq!((lattice.elastic, lattice.damping, lattice.unit), (5, 3, 2));
/// assert!(spheres.is_viscoelastic());
///
/// assert!(matches!("3/2,-1".parse::<ForceLaw>(), Err(LawError::DampingExponent { .. })));
/// # Ok::<(), LawError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct ForceLaw {
    a: BigRational,
    gamma: BigRational,
    lattice: Lattice,
}

/// The exponents of a law as whole multiples of one unit, so that `t^(e)` has an integer index.
///
/// ```text
/// a + 1 = elastic/unit,   gamma + 1 = damping/unit,   e = (elastic j + damping n)/unit
/// ```
///
/// For spheres `elastic = 5`, `damping = 3`, `unit = 2`: the half powers of the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Lattice {
    /// `a + 1` in units: the step of the elastic monomial `s`.
    pub elastic: i64,
    /// `gamma + 1` in units: the step of the damping monomial `w`.
    pub damping: i64,
    /// How many lattice steps make one power of `t`.
    pub unit: i64,
}

impl Lattice {
    /// Largest unit and largest step: all products of an index and a step then fit 64 bits.
    const LIMIT: i64 = 1_000_000;

    fn of(a: &BigRational, gamma: &BigRational) -> Option<Self> {
        let unit = a.denom().lcm(gamma.denom()).to_i64()?;
        let steps = |exponent: &BigRational| {
            ((exponent + BigRational::one()) * BigRational::from_integer(unit.into())).to_integer().to_i64()
        };
        let (elastic, damping) = (steps(a)?, steps(gamma)?);
        (unit.max(elastic).max(damping) <= Self::LIMIT).then_some(Self { elastic, damping, unit })
    }
}

impl ForceLaw {
    /// Returns the law with elastic exponent `a` and damping exponent `gamma`.
    ///
    /// # Errors
    ///
    /// [`LawError::ElasticExponent`] unless `a > 0`, [`LawError::DampingExponent`] unless `gamma > -1`,
    /// [`LawError::TooFine`] if a common denominator of the exponents, or an exponent in units of it,
    /// exceeds 10^6.
    pub fn new(a: BigRational, gamma: BigRational) -> Result<Self, LawError> {
        if !a.is_positive() {
            return Err(LawError::ElasticExponent { a });
        }
        if gamma <= -BigRational::one() {
            return Err(LawError::DampingExponent { gamma });
        }
        match Lattice::of(&a, &gamma) {
            Some(lattice) => Ok(Self { a, gamma, lattice }),
            None => Err(LawError::TooFine { law: format!("{a},{gamma}") }),
        }
    }

    /// Returns the law of viscoelastic spheres, `a = 3/2`, `gamma = 1/2` (eq. 5).
    pub fn viscoelastic_spheres() -> Self {
        let half = |n: i64| BigRational::new(n.into(), 2.into());
        Self { a: half(3), gamma: half(1), lattice: Lattice { elastic: 5, damping: 3, unit: 2 } }
    }

    /// The elastic exponent `a`.
    pub fn a(&self) -> &BigRational {
        &self.a
    }

    /// The damping exponent `gamma`.
    pub fn gamma(&self) -> &BigRational {
        &self.gamma
    }

    /// The exponents as whole multiples of one unit.
    pub fn lattice(&self) -> Lattice {
        self.lattice
    }

    /// The exponent `a + 1` of the elastic monomial `s = t^(a+1)`.
    pub fn elastic_step(&self) -> BigRational {
        &self.a + BigRational::one()
    }

    /// The exponent `gamma + 1` of the damping monomial `w = u t^(gamma+1)`.
    pub fn damping_step(&self) -> BigRational {
        &self.gamma + BigRational::one()
    }

    /// The exponent `p = (2 gamma - a + 1)/(a + 1)` with which `u ~ g^p` grows with impact velocity.
    ///
    /// Eq. (11) with `beta = 1`; 1/5 for spheres, 0 where the restitution coefficient is constant
    /// (eq. 12).
    pub fn velocity_exponent(&self) -> BigRational {
        let two = BigRational::from_integer(2.into());
        (two * &self.gamma - &self.a + BigRational::one()) / self.elastic_step()
    }

    /// Whether the damping force is the time derivative of the elastic one, `gamma = a - 1` (eq. 13).
    pub fn is_viscoelastic(&self) -> bool {
        self.damping_step() == self.a
    }
}

impl fmt::Display for ForceLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{}", self.a, self.gamma)
    }
}

impl FromStr for ForceLaw {
    type Err = LawError;

    fn from_str(text: &str) -> Result<Self, LawError> {
        let read = |exponent: &str| match exponent.parse::<Exact>() {
            Ok(exponent) => Ok(exponent.value().clone()),
            Err(error @ NumberError::TooLong) => Err(error.into()),
            Err(_) => Err(LawError::NotALaw { text: text.to_owned() }),
        };
        let not_a_law = || LawError::NotALaw { text: text.to_owned() };
        let (a, gamma) = text.split_once(',').ok_or_else(not_a_law)?;
        Self::new(read(a)?, read(gamma)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_read_exactly() {
        let law: ForceLaw = "1.001, -0.25".parse().unwrap();
        assert_eq!(law.to_string(), "1001/1000,-1/4");
        let law: ForceLaw = "1e-1,0".parse().unwrap();
        assert_eq!(law.to_string(), "1/10,0");
    }

    #[test]
    fn nonsense_is_refused() {
        for text in [
            "",
            "3/2",
            "3/0,1",
            "1.5.5,1",
            "x,1",
            "1e9,1",
            "1e999999999,1",
            "-1,0",
            "1,-1",
            "1/1000003,0",
            "2000000,0",
        ] {
            assert!(text.parse::<ForceLaw>().is_err(), "{text}");
        }
    }
}
