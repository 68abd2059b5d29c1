//! Random and corner operands, points inside them, and what a result must satisfy.

use restitution_real::Ball;
use rug::float::Round;
use rug::{Float, Rational};

/// Bits of a radius.
pub const RADIUS_BITS: u32 = 32;

/// A small source of random numbers (xorshift), the same in every run.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    pub fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    pub fn below(&mut self, n: usize) -> usize {
        ((u128::from(self.next()) * n as u128) >> 64) as usize
    }

    pub fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len())]
    }

    pub fn between(&mut self, low: i64, high: i64) -> i64 {
        low + self.below((high - low + 1) as usize) as i64
    }

    /// A number of `prec` bits, mostly random, sometimes a power of two or all ones, times `2^exponent`.
    pub fn float(&mut self, prec: u32, exponent: i32) -> Float {
        let mut x = Float::with_val(prec, 0);
        match self.below(8) {
            0 => x += 1,
            1 => x = Float::with_val_round(prec, 1.0 - 2.0_f64.powi(-53), Round::Down).0,
            2 => x += Float::with_val(prec, self.between(1, 9)) / 8,
            _ => (0..=prec / 64).for_each(|_| x = (x.clone() + self.next()) >> 64),
        }
        if x.is_zero() {
            x += 1;
        }
        x <<= exponent;
        if self.below(2) == 0 { -x } else { x }
    }

    /// A ball: low and high precision, zero, exact, narrow, wide, wider than its midpoint.
    pub fn ball(&mut self) -> Ball {
        let prec = self.pick(&[2, 3, 5, 16, 31, 32, 33, 53, 64, 100, 200]);
        let exponent = self.pick(&[0, 0, 1, -1, 2, -3, 7, -20, 60, -64, 300, -500]);
        let mid = if self.below(12) == 0 { Float::new(prec) } else { self.float(prec, exponent) };
        let relative = match self.below(6) {
            0 => return Ball::exact(mid),
            1 => self.between(-40, 3) as i32,
            2 => -1 - self.between(0, 3) as i32,
            _ => -(self.between(1, i64::from(prec) + 8) as i32),
        };
        let rad = self.float(RADIUS_BITS, exponent.saturating_add(relative)).abs();
        Ball::new(mid, &rad)
    }

    /// A ball whose points are all positive.
    pub fn positive(&mut self) -> Ball {
        loop {
            let ball = self.ball();
            if ball.is_positive() {
                return ball;
            }
            if ball.is_negative() {
                return -ball;
            }
        }
    }

    /// Both ends, the middle and some points between, exactly.
    pub fn points(&mut self, ball: &Ball) -> Vec<Rational> {
        let (mid, rad) = (exact(ball.mid()), exact(ball.rad()));
        let mut shares = vec![Rational::from(-1), Rational::new(), Rational::from(1)];
        shares.extend((0..2).map(|_| Rational::from((self.between(-997, 997), 997))));
        shares.into_iter().map(|share| &mid + share * &rad).collect()
    }
}

/// How many cases: `n` times `RESTITUTION_TEST_MULTIPLIER`.
pub fn cases(n: usize) -> usize {
    let multiplier = std::env::var("RESTITUTION_TEST_MULTIPLIER").unwrap_or_else(|_| "1".to_owned());
    n * multiplier.parse::<usize>().expect("RESTITUTION_TEST_MULTIPLIER is a whole number")
}

/// A finite number as a fraction.
pub fn exact(x: &Float) -> Rational {
    x.to_rational().unwrap_or_else(|| panic!("{x} is not finite"))
}

/// `|value - midpoint| <= radius`, by fractions alone.
pub fn inside(ball: &Ball, value: &Rational) -> bool {
    ball.rad().is_infinite() || (value - exact(ball.mid())).abs() <= exact(ball.rad())
}

/// As [`inside`] for a value that is rounded to nearest: half a unit of its last place is open.
pub fn nearly_inside(ball: &Ball, value: &Float) -> bool {
    let half_unit = if value.is_zero() { Float::new(64) } else { value.clone().abs() >> value.prec() };
    let distance = (exact(value) - exact(ball.mid())).abs();
    ball.rad().is_infinite() || distance <= exact(ball.rad()) + exact(&half_unit)
}

/// Half a unit in the last place of the midpoint, the largest error of rounding to nearest.
pub fn half_unit(ball: &Ball) -> Rational {
    let Some(exponent) = ball.mid().get_exp() else { return Rational::new() };
    exact(&(Float::with_val(64, 1) << (exponent - ball.prec() as i32 - 1)))
}

/// Whether the radius is at most `rule`, up to the few roundings a radius of 32 bits has.
pub fn not_wider(ball: &Ball, rule: &Rational) -> bool {
    let slack = Rational::from(1) + (Rational::from(1) >> 28);
    exact(ball.rad()) <= Rational::from(rule * &slack)
}
