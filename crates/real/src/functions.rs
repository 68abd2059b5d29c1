//! Elementary functions and the gamma function of balls.

use crate::Ball;
use crate::ball::{RADIUS_BITS, rounding_error};
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};
use rug::Float;
use rug::float::{Constant, Round};
use rug::ops::{AddAssignRound, DivAssignRound, MulAssignRound};

impl Ball {
    /// Returns pi.
    pub fn pi(prec: u32) -> Self {
        Self::rounded(prec, Constant::Pi)
    }

    /// Returns the square root; the whole line unless the ball is positive or exactly 0.
    ///
    /// `|sqrt(X) - sqrt(x)| <= r/sqrt(x)` for `X >= 0`.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_real::Ball;
    ///
    /// let two = Ball::from_integer(2, 100);
    /// assert_eq!(two.sqrt().to_digits(20).as_deref(), Some("1.4142135623730950488"));
    /// assert!(!(-two).sqrt().is_finite());
    /// ```
    #[must_use]
    pub fn sqrt(&self) -> Self {
        if self.is_exact() && self.mid.is_zero() {
            return self.clone();
        }
        if !self.is_positive() {
            return Self::whole_line(self.prec());
        }
        let (mid, direction) = Float::with_val_round(self.prec(), self.mid.sqrt_ref(), Round::Nearest);
        let mut rad = self.rad.clone();
        let root_down = Float::with_val_round(RADIUS_BITS, self.mid.sqrt_ref(), Round::Down).0;
        rad.div_assign_round(&root_down, Round::Up);
        rad.add_assign_round(&rounding_error(&mid, direction), Round::Up);
        Self::new(mid, &rad)
    }

    /// Returns `e^x`.
    ///
    /// `|e^X - e^x| <= e^x (e^r - 1)`.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_real::Ball;
    ///
    /// let pi = Ball::pi(100);
    /// assert_eq!(pi.exp().ln().to_digits(20), pi.to_digits(20));
    /// assert!(!Ball::whole_line(100).exp().is_finite());
    /// ```
    #[must_use]
    pub fn exp(&self) -> Self {
        let (mid, direction) = Float::with_val_round(self.prec(), self.mid.exp_ref(), Round::Nearest);
        let mut rad = Float::with_val_round(RADIUS_BITS, self.rad.exp_m1_ref(), Round::Up).0;
        if !rad.is_zero() {
            rad.mul_assign_round(
                &Float::with_val_round(RADIUS_BITS, self.mid.exp_ref(), Round::Up).0,
                Round::Up,
            );
        }
        rad.add_assign_round(&rounding_error(&mid, direction), Round::Up);
        Self::new(mid, &rad)
    }

    /// Returns the natural logarithm; the whole line unless the ball is positive.
    ///
    /// `|ln X - ln x| <= ln(1 + r/(x - r))`.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_real::Ball;
    ///
    /// let two = Ball::from_integer(2, 100);
    /// assert_eq!(two.ln().to_digits(10).as_deref(), Some("0.6931471806"));
    /// assert!(!Ball::from_integer(0, 100).ln().is_finite());
    /// ```
    #[must_use]
    pub fn ln(&self) -> Self {
        if !self.is_positive() {
            return Self::whole_line(self.prec());
        }
        let (mid, direction) = Float::with_val_round(self.prec(), self.mid.ln_ref(), Round::Nearest);
        let mut rad = self.rad.clone();
        rad.div_assign_round(&self.abs_down(), Round::Up);
        let mut rad = Float::with_val_round(RADIUS_BITS, rad.ln_1p_ref(), Round::Up).0;
        rad.add_assign_round(&rounding_error(&mid, direction), Round::Up);
        Self::new(mid, &rad)
    }

    /// Returns `x^q` for a rational exponent: by multiplication if `q` is an integer, by roots if it
    /// is a half, else as `exp(q ln x)`, which needs `x > 0`.
    ///
    /// # Examples
    ///
    /// ```
    /// use num_rational::BigRational;
    /// use restitution_real::Ball;
    ///
    /// let exponent = |n: i64, d: i64| BigRational::new(n.into(), d.into());
    /// let x = Ball::from_integer(32, 100);
    /// assert_eq!(x.pow(&exponent(2, 5)).to_digits(5).as_deref(), Some("4.0000"));
    /// assert!(x.fifth_root().contains(&Ball::from_integer(2, 100)) && x.powi(-1).is_exact());
    /// assert!((-x).pow(&exponent(2, 1)).is_positive() && !Ball::from_integer(-32, 100).fifth_root().is_finite());
    /// ```
    #[must_use]
    pub fn pow(&self, exponent: &BigRational) -> Self {
        if exponent.is_integer()
            && let Some(n) = exponent.to_integer().to_i64()
        {
            return self.powi(n);
        }
        let doubled = exponent + exponent;
        if doubled.is_integer()
            && let Some(n) = doubled.to_integer().to_i64()
        {
            return self.sqrt().powi(n);
        }
        if self.is_exact() && self.mid == 1 {
            return self.clone();
        }
        // A few bits more carry the logarithm's size, so that the result keeps the precision.
        let guarded = self.with_prec(self.prec().saturating_add(16));
        (guarded.ln() * Self::from_rational(exponent, guarded.prec())).exp().with_prec(self.prec())
    }

    /// Returns the gamma function of a positive ball; the whole line elsewhere.
    ///
    /// Gamma is convex on the positive axis, so `|Gamma'| = |Gamma psi|` is largest at an end.
    ///
    /// # Examples
    ///
    /// ```
    /// use num_rational::BigRational;
    /// use restitution_real::Ball;
    ///
    /// assert!(Ball::from_integer(5, 100).gamma().contains(&Ball::from_integer(24, 100)));
    /// assert!(!Ball::from_integer(0, 100).gamma().is_finite());
    ///
    /// let half = BigRational::new(1.into(), 2.into());
    /// assert_eq!(Ball::beta(&half, &half, 100).to_digits(20), Ball::pi(100).to_digits(20));
    /// ```
    #[must_use]
    pub fn gamma(&self) -> Self {
        if !self.is_positive() {
            return Self::whole_line(self.prec());
        }
        let (mid, direction) = Float::with_val_round(self.prec(), self.mid.gamma_ref(), Round::Nearest);
        let mut rad = rounding_error(&mid, direction);
        if !self.rad.is_zero() {
            let lower = self.lower();
            if lower.is_zero() {
                return Self::whole_line(self.prec());
            }
            let slope = slope_of_gamma_up(&lower).max(&slope_of_gamma_up(&self.upper()));
            let mut spread = self.rad.clone();
            spread.mul_assign_round(&slope, Round::Up);
            rad.add_assign_round(&spread, Round::Up);
        }
        Self::new(mid, &rad)
    }

    /// Returns the beta function `B(p, q) = Gamma(p) Gamma(q)/Gamma(p + q)` of positive rationals.
    pub fn beta(p: &BigRational, q: &BigRational, prec: u32) -> Self {
        let gamma = |x: &BigRational| Self::from_rational(x, prec).gamma();
        gamma(p) * gamma(q) / gamma(&(p + q))
    }

    /// Returns `x` to the power 1/5 of a positive ball.
    #[must_use]
    pub fn fifth_root(&self) -> Self {
        self.pow(&BigRational::new(One::one(), 5.into()))
    }
}

/// An upper bound of `|Gamma'(x)| = |Gamma(x) psi(x)|` at one point.
fn slope_of_gamma_up(x: &Float) -> Float {
    let mut slope = Float::with_val_round(RADIUS_BITS, x.digamma_ref(), Round::AwayZero).0.abs();
    slope.mul_assign_round(&Float::with_val_round(RADIUS_BITS, x.gamma_ref(), Round::Up).0, Round::Up);
    slope
}
