//! The field operations: each states the error it adds.

use crate::Ball;
use crate::ball::{RADIUS_BITS, magnitude_up, rounding_error, smallest_error};
use num_traits::{One, Zero};
use rug::Float;
use rug::float::{Round, exp_max, exp_min};
use rug::ops::{AddAssignRound, DivAssignRound, MulAssignRound};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// `|(x + y) - (X + Y)| <= rx + ry + rounding`.
pub(crate) fn add(x: &Ball, y: &Ball, prec: u32) -> Ball {
    let (mid, direction) = Float::with_val_round(prec, &x.mid + &y.mid, Round::Nearest);
    let mut rad = rounding_error(&mid, direction);
    rad.add_assign_round(&x.rad, Round::Up);
    rad.add_assign_round(&y.rad, Round::Up);
    Ball::new(mid, &rad)
}

/// As [`add`], with the sign of `y` turned.
pub(crate) fn sub(x: &Ball, y: &Ball, prec: u32) -> Ball {
    let (mid, direction) = Float::with_val_round(prec, &x.mid - &y.mid, Round::Nearest);
    let mut rad = rounding_error(&mid, direction);
    rad.add_assign_round(&x.rad, Round::Up);
    rad.add_assign_round(&y.rad, Round::Up);
    Ball::new(mid, &rad)
}

/// `|x y - X Y| <= |x| ry + |y| rx + rx ry + rounding`.
pub(crate) fn mul(x: &Ball, y: &Ball, prec: u32) -> Ball {
    let (mid, direction) = Float::with_val_round(prec, &x.mid * &y.mid, Round::Nearest);
    let mut rad = rounding_error(&mid, direction);
    if !y.rad.is_zero() {
        let mut part = x.abs_up();
        part.mul_assign_round(&y.rad, Round::Up);
        rad.add_assign_round(&part, Round::Up);
    }
    if !x.rad.is_zero() {
        let mut part = magnitude_up(&y.mid);
        part.mul_assign_round(&x.rad, Round::Up);
        rad.add_assign_round(&part, Round::Up);
    }
    Ball::new(mid, &rad)
}

/// `|x/y - X/Y| <= (rx + |x/y| ry)/min|Y| + rounding`; the whole line if `y` contains 0.
pub(crate) fn div(x: &Ball, y: &Ball, prec: u32) -> Ball {
    if y.contains_zero() {
        return Ball::whole_line(prec);
    }
    let (mid, direction) = Float::with_val_round(prec, &x.mid / &y.mid, Round::Nearest);
    let rounding = rounding_error(&mid, direction);
    let mut rad = magnitude_up(&mid);
    rad.add_assign_round(&rounding, Round::Up);
    rad.mul_assign_round(&y.rad, Round::Up);
    rad.add_assign_round(&x.rad, Round::Up);
    rad.div_assign_round(&y.abs_down(), Round::Up);
    rad.add_assign_round(&rounding, Round::Up);
    Ball::new(mid, &rad)
}

macro_rules! field_operation {
    ($trait:ident, $method:ident, $assign_trait:ident, $assign_method:ident, $function:ident) => {
        impl $trait<&Ball> for &Ball {
            type Output = Ball;
            fn $method(self, other: &Ball) -> Ball {
                $function(self, other, self.prec().max(other.prec()))
            }
        }
        impl $trait<Ball> for Ball {
            type Output = Ball;
            fn $method(self, other: Ball) -> Ball {
                $function(&self, &other, self.prec().max(other.prec()))
            }
        }
        impl $trait<&Ball> for Ball {
            type Output = Ball;
            fn $method(self, other: &Ball) -> Ball {
                $function(&self, other, self.prec().max(other.prec()))
            }
        }
        impl $trait<Ball> for &Ball {
            type Output = Ball;
            fn $method(self, other: Ball) -> Ball {
                $function(self, &other, self.prec().max(other.prec()))
            }
        }
        impl $assign_trait<&Ball> for Ball {
            fn $assign_method(&mut self, other: &Ball) {
                *self = $function(self, other, self.prec().max(other.prec()));
            }
        }
        impl $assign_trait<Ball> for Ball {
            fn $assign_method(&mut self, other: Ball) {
                *self = $function(self, &other, self.prec().max(other.prec()));
            }
        }
    };
}

field_operation!(Add, add, AddAssign, add_assign, add);
field_operation!(Sub, sub, SubAssign, sub_assign, sub);
field_operation!(Mul, mul, MulAssign, mul_assign, mul);
field_operation!(Div, div, DivAssign, div_assign, div);

impl Neg for Ball {
    type Output = Ball;
    fn neg(mut self) -> Ball {
        self.mid = -self.mid;
        self
    }
}

impl Neg for &Ball {
    type Output = Ball;
    fn neg(self) -> Ball {
        -self.clone()
    }
}

impl Zero for Ball {
    fn zero() -> Self {
        Self::constant(0)
    }

    /// Whether the ball is exactly the point 0; see [`Ball::contains_zero`] for "may be zero".
    fn is_zero(&self) -> bool {
        self.mid.is_zero() && self.rad.is_zero()
    }
}

impl One for Ball {
    fn one() -> Self {
        Self::constant(1)
    }
}

impl Ball {
    /// Returns the ball times `2^power`, exactly (within the exponents of MPFR, about `2^30`).
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_real::Ball;
    ///
    /// let three = Ball::from_integer(-3, 53);
    /// assert_eq!(three.shifted(-1).abs().to_f64(), 1.5);
    /// assert_eq!(three.powi(2).shifted(1).to_f64(), 18.0);
    /// assert!(!Ball::from_integer(0, 53).powi(-1).is_finite());
    /// ```
    #[must_use]
    pub fn shifted(&self, power: i32) -> Self {
        let exponents = i64::from(exp_min())..=i64::from(exp_max());
        let fits =
            |x: &Float| x.get_exp().is_none_or(|e| exponents.contains(&(i64::from(e) + i64::from(power))));
        let inside = fits(&self.mid) && fits(&self.rad);
        let (mid, rad) = (self.mid.clone() << power, self.rad.clone() << power);
        if inside { Self { mid, rad } } else { Self::new(mid, &rad).widened(&smallest_error()) }
    }

    /// Returns the absolute value.
    #[must_use]
    pub fn abs(&self) -> Self {
        if self.contains_zero() {
            let upper = self.abs_up();
            let half = Float::with_val_round(RADIUS_BITS, &upper / 2u32, Round::Up).0;
            return Self::new(Float::with_val(self.prec().max(RADIUS_BITS), &half), &half);
        }
        if self.is_negative() { -self.clone() } else { self.clone() }
    }

    /// Returns `x^n`; the whole line where a negative power meets zero.
    #[must_use]
    pub fn powi(&self, n: i64) -> Self {
        let power = n.unsigned_abs();
        let mut result = Self::from_integer(1, self.prec());
        for bit in (0..u64::BITS - power.leading_zeros()).rev() {
            result = &result * &result;
            if power >> bit & 1 == 1 {
                result *= self;
            }
        }
        if n.is_negative() { Self::from_integer(1, self.prec()) / result } else { result }
    }
}
