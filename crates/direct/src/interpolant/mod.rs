//! The coefficient of restitution on an interval: a polynomial in the damping with a proved remainder.

mod arc;
mod defect;
mod ends;
mod jets;
mod motion;

use crate::collision::Collision;
use crate::coordinate::Coordinate;
use crate::equation::Equation;
use crate::error::DirectError;
use crate::fixed::{BOUND_BITS, from_fixed, upper_bound};
use arc::Flow;
use ends::{Exit, Found};
use jets::Range;
use motion::Motion;
use num_rational::BigRational;
use num_traits::Signed;
use restitution_real::Ball;
use restitution_real::convert::rug_integer;
use rug::{Float, Integer};

/// In what the interpolant is a polynomial.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Variable {
    /// The damping `u`.
    #[default]
    Damping,
    /// Its square root, in which `epsilon` at zero force is smoother near `u = 0`.
    Root,
}

/// The largest degree of an interpolant.
const LARGEST_DEGREE: usize = 100;
/// The least and the largest working precision.
const PRECISIONS: std::ops::RangeInclusive<u32> = 40..=20_000;
/// Bits by which the fixed point is finer than the working precision: products with small integers lose them.
const GUARD_BITS: u32 = 32;

/// `epsilon(u)` for every `u` of an interval: a polynomial of exact coefficients and a proved remainder.
///
/// ```text
/// |epsilon(u) - Sum_j c_j t^j| <= remainder,    t = (variable - center)/half_width in [-1, 1]
/// ```
///
/// Made by [`Collision::interpolant`].
#[derive(Clone, Debug)]
pub struct Interpolant {
    variable: Variable,
    center: Float,
    half_width: Float,
    coefficients: Vec<Ball>,
    remainder: Ball,
}

impl Interpolant {
    /// In what it is a polynomial.
    pub fn variable(&self) -> Variable {
        self.variable
    }

    /// The middle of the interval of the variable, exactly.
    pub fn center(&self) -> &Float {
        &self.center
    }

    /// Half the width of the interval of the variable, exactly; the interval holds the one asked for.
    pub fn half_width(&self) -> &Float {
        &self.half_width
    }

    /// The coefficients of the powers of `t`, exact numbers.
    pub fn coefficients(&self) -> &[Ball] {
        &self.coefficients
    }

    /// What `epsilon` differs from the polynomial by at most, anywhere on the interval.
    pub fn remainder(&self) -> &Ball {
        &self.remainder
    }

    /// Encloses `epsilon` for every damping in a ball; `None` if it reaches beyond the interval.
    pub fn enclose(&self, u: &Ball) -> Option<Ball> {
        let variable = match self.variable {
            Variable::Damping => u.clone(),
            Variable::Root if u.mid().is_zero() && u.is_exact() => u.clone(),
            Variable::Root => u.sqrt(),
        };
        let t = variable - Ball::exact(self.center.clone());
        let inside = (Ball::exact(self.half_width.clone()) - t.abs()).lower() >= 0;
        let t = if self.half_width.is_zero() { t } else { t / Ball::exact(self.half_width.clone()) };
        let sum = self
            .coefficients
            .iter()
            .rev()
            .fold(None, |sum: Option<Ball>, c| Some(sum.map_or_else(|| c.clone(), |sum| sum * &t + c)));
        inside.then_some(())?;
        Some(sum?.widened(&self.remainder.upper()))
    }
}

impl Collision {
    /// Encloses `epsilon(u)` for every `u` of `[from, to]` by a polynomial with a proved remainder.
    ///
    /// The whole motion is integrated as a polynomial in time and in the deviation of the damping from
    /// the middle of the interval; the defect of these polynomials, an exact finite sum, bounds the error
    /// of the motion for every damping at once (docs/direct-integration.md, section 10). The remainder
    /// falls by the ratio of the half width to the distance of the next singularity, `u = -R` at zero
    /// compression, with each degree. Cost: some tenths of a second at 128 bits and
    /// degree 15.
    ///
    /// # Errors
    ///
    /// [`DirectError::Interval`] unless `0 <= from <= to`, the degree is at most 100 and `prec` from 40
    /// to 20000 bits; [`DirectError::NoInterpolant`] for laws whose motion has a branch point at zero
    /// compression; [`DirectError::Overdamped`] if bodies with the damping `to` are proved never to leave; [`DirectError::StepVanished`] or [`DirectError::Stiff`] if the interval is too wide, or reaches a damping for which
    /// contact does not end, or down to 0 with the end at zero force.
    ///
    /// # Examples
    ///
    /// ```
    /// use num_rational::BigRational;
    /// use restitution_direct::{Collision, DirectError, End, Variable};
    /// use restitution_law::ForceLaw;
    /// use restitution_real::Ball;
    ///
    /// let spheres = Collision::new(&ForceLaw::viscoelastic_spheres(), End::ZeroCompression)?;
    /// let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
    /// let piece = spheres.interpolant(&ratio(9, 10), &ratio(11, 10), Variable::Damping, 12, 100)?;
    /// assert!(piece.remainder().upper() < 1e-14);
    /// assert_eq!((piece.variable(), piece.center().to_f64(), piece.coefficients().len()), (Variable::Damping, 1.0, 13));
    /// assert!(*piece.half_width() > 0.09);
    /// let at_one = piece.enclose(&Ball::from_integer(1, 100)).unwrap();
    /// assert_eq!(at_one.to_digits(13).as_deref(), Some("0.3311648104666"));
    /// assert!(piece.enclose(&Ball::from_integer(2, 100)).is_none());
    ///
    /// let upside_down = spheres.interpolant(&ratio(2, 1), &ratio(1, 1), Variable::Damping, 12, 100);
    /// assert!(matches!(upside_down, Err(DirectError::Interval { .. })));
    /// # Ok::<(), DirectError>(())
    /// ```
    pub fn interpolant(
        &self,
        from: &BigRational,
        to: &BigRational,
        variable: Variable,
        degree: usize,
        prec: u32,
    ) -> Result<Interpolant, DirectError> {
        if from.is_negative() || from > to || degree > LARGEST_DEGREE || !PRECISIONS.contains(&prec) {
            let interval = format!("[{from}, {to}] at degree {degree} and {prec} bits");
            return Err(DirectError::Interval { interval });
        }
        let fastest = Equation::new(self.law(), &Ball::from_rational(to, prec), prec);
        if to.is_positive() && self.is_without_rebound(&fastest) {
            return Err(fastest.overdamped());
        }
        let damping = Dampings::of(from, to, variable, (prec + GUARD_BITS).next_multiple_of(2));
        let motion = self.motion(&damping, degree + 1, prec)?;
        let exit = self.exit(&motion)?;
        let bits = exit.velocity.bits;
        let exact = |c: &Integer| {
            Ball::exact(Float::with_val(c.significant_bits().max(1), c)).shifted(-(bits as i32))
        };
        Ok(Interpolant {
            variable,
            center: damping.center,
            half_width: damping.half_width,
            coefficients: exit.velocity.row(0).iter().map(|c| -exact(c)).collect(),
            remainder: exit.error,
        })
    }

    /// The motions of the interval.
    fn motion(&self, damping: &Dampings, width: usize, prec: u32) -> Result<Motion, DirectError> {
        let coordinate = Coordinate::of(self.law());
        let order = (prec / 9 * 4 + 10) as usize;
        let flow = Flow::new(&coordinate, damping.jet.clone(), damping.bits, order, width);
        let flow = flow.ok_or_else(|| DirectError::NoInterpolant { law: Box::new(self.law().clone()) })?;
        let u = damping.range.clone();
        Ok(Motion { flow, coordinate, u, elastic_step: self.law().elastic_step(), prec, end: self.end() })
    }

    /// Follows the motions from impact to the end of contact.
    fn exit(&self, motion: &Motion) -> Result<Exit, DirectError> {
        let mut stepper = motion.stepper();
        let mut state = motion.rebound(&mut stepper)?;
        loop {
            let (reached, found) = stepper.step(f64::INFINITY, |length| {
                let (leg, slope) = motion.step(&state, length)?;
                let found = motion.end_of_contact(&leg)?;
                Some(((leg.reached, found), slope))
            })?;
            match found {
                Found::Here(exit) => return Ok(exit),
                Found::Beyond => state = reached,
            }
        }
    }
}

/// The dampings of an interval as a polynomial in `delta`, `-1 <= delta <= 1`.
struct Dampings {
    jet: Vec<Integer>,
    bits: u32,
    range: Range,
    center: Float,
    half_width: Float,
}

impl Dampings {
    /// The smallest interval in the fixed point that holds the one given; `bits` is even.
    fn of(from: &BigRational, to: &BigRational, variable: Variable, bits: u32) -> Self {
        let units = if variable == Variable::Root { bits / 2 } else { bits };
        let (mut low, mut high) = (floor(from, bits), ceil(to, bits));
        if variable == Variable::Root {
            low = low.sqrt();
            let root = Integer::from(high.sqrt_ref());
            high = if root.clone().square() == high { root } else { root + 1 };
        }
        if Integer::from(&high - &low).is_odd() {
            high += 1;
        }
        let center = Integer::from(&low + &high) >> 1;
        let half_width = Integer::from(&high - &low) >> 1;
        let exact = |x: &Integer| {
            let scaled = Ball::exact(Float::with_val(x.significant_bits().max(1), x));
            scaled.shifted(-(units as i32)).mid().clone()
        };
        let (middle, width) = (exact(&center), exact(&half_width));
        let jet = match variable {
            Variable::Damping => vec![center, half_width],
            Variable::Root => {
                let mixed = Integer::from(&center * &half_width) << 1;
                vec![center.square(), mixed, half_width.square()]
            }
        };
        let square = |x: Integer| if variable == Variable::Root { x.square() } else { x };
        let bound = |x: Integer| from_fixed(&x, bits, bits.max(BOUND_BITS));
        let range = Range {
            low: crate::fixed::lower_bound(&bound(square(low))),
            high: upper_bound(&bound(square(high))),
        };
        Self { jet, bits, range, center: middle, half_width: width }
    }
}

fn floor(x: &BigRational, bits: u32) -> Integer {
    (rug_integer(x.numer()) << bits).div_rem_floor(rug_integer(x.denom())).0
}

fn ceil(x: &BigRational, bits: u32) -> Integer {
    (rug_integer(x.numer()) << bits).div_rem_ceil(rug_integer(x.denom())).0
}

#[cfg(test)]
mod tests {
    use super::jets::Jets;
    use super::*;

    #[test]
    fn the_interval_is_held() {
        let third = BigRational::new(1.into(), 3.into());
        for variable in [Variable::Damping, Variable::Root] {
            let damping = Dampings::of(&third, &third, variable, 64);
            let [low, high] = [-1, 1].map(|s| {
                Float::with_val(200, &damping.center + &damping.half_width * Float::with_val(200, s))
            });
            let [low, high] =
                if variable == Variable::Root { [low.square(), high.square()] } else { [low, high] };
            assert!(Float::with_val(200, &low * 3u32) <= 1);
            assert!(Float::with_val(200, &high * 3u32) >= 1);
            assert!(damping.jet.len() <= 3 && Jets::constant(&damping.jet, 64).range().high.is_positive());
        }
    }

    #[test]
    fn what_is_asked_for_is_an_interval_of_dampings() {
        use restitution::End;
        let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
        let spheres = Collision::new(&"3/2,1/2".parse().unwrap(), End::ZeroForce).unwrap();
        let ask = |from: BigRational, to: BigRational, degree: usize, prec: u32| {
            spheres.interpolant(&from, &to, Variable::Root, degree, prec)
        };
        let piece = ask(ratio(9, 10), ratio(1, 1), 4, 60).unwrap();
        assert_eq!((piece.variable(), piece.coefficients().len()), (Variable::Root, 5));
        let at = |n: i64, d: i64| piece.enclose(&Ball::from_ratio(n, d, 80));
        assert!(at(19, 20).is_some() && at(9, 10).is_none_or(|e| e.is_finite()));
        let exactly = Ball::from_f64(0.953125, 80);
        let (found, known) = (piece.enclose(&exactly).unwrap(), spheres.enclose(&exactly, 80).unwrap());
        assert!((found - known).contains_zero());
        assert!(at(88, 100).is_none() && at(102, 100).is_none() && at(0, 1).is_none());
        for wrong in [
            ask(ratio(-1, 10), ratio(1, 1), 4, 60),
            ask(ratio(1, 1), ratio(9, 10), 4, 60),
            ask(ratio(9, 10), ratio(1, 1), 101, 60),
            ask(ratio(9, 10), ratio(1, 1), 4, 39),
        ] {
            assert!(matches!(wrong, Err(DirectError::Interval { .. })));
        }
        assert!(ask(ratio(1, 1), ratio(1, 1), 0, 60).is_ok());
        // A coordinate with a fraction as its power, q = 2/3; an elastic term of the lowest power, a < gamma.
        for law in ["2,1/2", "1,2"] {
            let other = Collision::new(&law.parse().unwrap(), End::ZeroCompression).unwrap();
            let piece = other.interpolant(&ratio(9, 10), &ratio(1, 1), Variable::Damping, 4, 60).unwrap();
            let (found, known) = (piece.enclose(&exactly).unwrap(), other.enclose(&exactly, 80).unwrap());
            assert!((found - known).contains_zero(), "{law}");
            assert!(piece.remainder().upper() < 1e-4, "{law}: {:?}", piece.remainder());
        }
        // A degree of 100 is not refused as such.
        let none = Collision::new(&"997/1009,5/7".parse().unwrap(), End::ZeroCompression).unwrap();
        let refusal = none.interpolant(&ratio(1, 1), &ratio(1, 1), Variable::Damping, 100, 60);
        assert!(matches!(refusal, Err(DirectError::NoInterpolant { .. })));
        // Beyond critical damping nothing leaves.
        let dashpot = Collision::new(&"1,0".parse().unwrap(), End::ZeroCompression).unwrap();
        let ask = |to: BigRational| dashpot.interpolant(&ratio(1, 1), &to, Variable::Damping, 4, 60);
        assert!(matches!(ask(ratio(201, 100)), Err(DirectError::Overdamped { .. })));
        let yielding = Collision::new(&"1,0".parse().unwrap(), End::ZeroForce).unwrap();
        assert!(yielding.interpolant(&ratio(2, 1), &ratio(201, 100), Variable::Damping, 4, 60).is_ok());
        assert!(dashpot.interpolant(&ratio(0, 1), &ratio(0, 1), Variable::Damping, 4, 60).is_ok());
        assert!(ask(ratio(101, 100)).is_ok());
    }
}
