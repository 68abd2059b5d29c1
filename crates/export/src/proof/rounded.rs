//! What the roundings of a form add up to, a priori.

use restitution::forms::Number;
use std::ops::Mul;

/// What the bounds themselves may be rounded by.
const SLACK: f64 = 1.0 + 1e-14;

/// A number that is computed: its exact value lies between `low` and `high`, and what is computed is off by at most `error`.
///
/// An operation passes the errors of its operands on and adds half a unit in the last place of the largest result; fused or not,
/// a multiplication with an addition counts both roundings.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rounded {
    pub(super) low: f64,
    pub(super) high: f64,
    error: f64,
    /// The part of the last operation in it.
    last: f64,
}

impl Rounded {
    pub(super) fn new(low: f64, high: f64, error: f64) -> Self {
        Self { low, high, error, last: 0.0 }
    }

    fn largest(&self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// An operation with this exact range, to which the operands pass on this error.
    fn after(low: f64, high: f64, error: f64) -> Self {
        let (low, high, error) = (low.next_down(), high.next_up(), error * SLACK);
        let last = half_unit(low.abs().max(high.abs()) + error);
        Self { low, high, error: (error + last) * SLACK, last }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        Self::after(self.low + other.low, self.high + other.high, self.error + other.error)
    }

    /// A bound of the error relative to an exact result within `missed` of this one.
    pub(super) fn relative(&self, missed: f64) -> f64 {
        let least = (self.low.abs().min(self.high.abs()) - missed).next_down();
        let known = self.low * self.high > 0.0 && least > 0.0;
        if known { (self.error + missed) * SLACK / least } else { f64::INFINITY }
    }

    /// A bound of the error in units of the last place of the exact result, if that lies within `missed` of this one.
    ///
    /// The last rounding is half a unit of the result. Just below a power of two, where units are smaller than those of what
    /// is rounded, the result is that power as long as everything else is below one unit; else the rounding counts one.
    pub(super) fn units(&self, missed: f64) -> f64 {
        let least = (self.low.abs().min(self.high.abs()) - missed).next_down();
        let most = (self.largest() + missed).next_up();
        let unit = 2.0 * half_unit(least);
        let before = (self.error - self.last * (1.0 - 1e-12) + missed) * SLACK / unit;
        let straddles = half_unit(most) > half_unit(least);
        if self.low * self.high <= 0.0 || least <= 0.0 {
            f64::INFINITY
        } else if straddles && before >= 1.0 {
            before + 1.0
        } else {
            before + 0.5
        }
    }
}

/// Half a unit in the last place of a number of this size.
pub(super) fn half_unit(x: f64) -> f64 {
    let power = f64::from_bits(x.abs().to_bits() & 0x7ff0_0000_0000_0000);
    power * f64::EPSILON / 2.0
}

impl Mul for Rounded {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let products = [self.low, self.high].map(|a| [other.low, other.high].map(|b| a * b)).concat();
        let low = products.iter().copied().fold(f64::INFINITY, f64::min);
        let high = products.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let error = self.largest() * other.error + other.largest() * self.error + self.error * other.error;
        Self::after(low, high, error)
    }
}

impl Number for Rounded {
    fn of(&self, constant: f64) -> Self {
        Self::new(constant, constant, 0.0)
    }

    fn multiply_add(self, b: Self, c: Self) -> Self {
        (self * b).plus(c)
    }

    fn negated(self) -> Self {
        Self { low: -self.high, high: -self.low, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Rational;

    fn exactly(x: f64) -> Rational {
        Rational::from_f64(x).unwrap()
    }

    /// A unit in the last place of a number that is not zero.
    fn unit(x: &Rational) -> Rational {
        let x = rug::Float::with_val_round(53, x, rug::float::Round::Zero).0;
        exactly(2.0 * half_unit(x.to_f64()))
    }

    struct Source(u64);

    impl Source {
        /// From -1 to 1.
        fn next(&mut self) -> f64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            self.0.cast_signed() as f64 / 2f64.powi(63)
        }

        /// A range with an error, an exact value in it and a computed one; often at the ends, and next to powers of two.
        fn operand(&mut self) -> (Rounded, f64, f64) {
            let middle = match (self.next() * 4.0) as i32 {
                0 => self.next() * 8.0,
                1 => 1.0 + self.next() * 1e-15,
                2 => -2.0 + self.next() * 1e-14,
                _ => self.next() * 1e-3,
            };
            let width =
                if self.next() > 0.0 { 0.0 } else { self.next().abs() * 10f64.powf(self.next() * 8.0 - 8.0) };
            let (low, high) = (middle - width, middle + width);
            let error =
                if self.next() > 0.5 { 0.0 } else { self.next().abs() * 10f64.powf(self.next() - 15.0) };
            let exact = [low, high, middle][(self.next().abs() * 3.0) as usize % 3];
            let mut computed =
                exact + error * [1.0, -1.0, self.next()][(self.next().abs() * 3.0) as usize % 3];
            if (exactly(computed) - exactly(exact)).abs() > exactly(error) {
                computed = exact;
            }
            (Rounded::new(low, high, error), exact, computed)
        }
    }

    /// The exact result is in the range and the computed one within the error of it, which is no larger than what is stated.
    fn holds(found: Rounded, exact: &Rational, computed: f64, stated: f64, random: &mut Source) {
        assert!(exactly(found.low) <= *exact && *exact <= exactly(found.high), "{found:?} {exact}");
        let error = (exactly(computed) - exact).abs();
        assert!(error <= exactly(found.error), "{found:?}: {exact} {computed}");
        assert!(found.error <= stated * (1.0 + 1e-12), "{found:?}: {stated}");
        // What else is missed lies on either side.
        let missed = random.next().abs() * 10f64.powf(random.next() * 3.0 - 16.0);
        for sign in [-1.0, 0.0, 1.0] {
            let truth = exact + exactly(sign * missed);
            let relative = found.relative(missed);
            if relative.is_finite() {
                let error = (exactly(computed) - &truth).abs();
                assert!(error <= exactly(relative) * Rational::from(truth.abs_ref()), "{found:?} {missed:e}");
            }
            // An error in units counts the last rounding once, of the value that is nearest.
            let units = found.units(missed);
            if units.is_finite() {
                let error = (exactly(computed) - &truth).abs();
                assert!(error <= exactly(units) * unit(&truth), "{found:?} {missed:e} {units}");
            }
        }
    }

    #[test]
    fn what_is_computed_is_within_the_error() {
        let mut random = Source(1);
        for _ in 0..4000 {
            let [(a, x, f), (b, y, g), (c, z, h)] = std::array::from_fn(|_| random.operand());
            let (most, of_b, of_c) = (a.largest(), b.largest(), c.largest());
            let sum = a.error + b.error;
            let rounding = |size: f64, error: f64| half_unit(size.next_up() + error * SLACK);
            holds(
                a.plus(b),
                &(exactly(x) + exactly(y)),
                f + g,
                sum + rounding(most + of_b, sum),
                &mut random,
            );
            let passed = most * b.error + of_b * a.error + a.error * b.error;
            let product = exactly(x) * exactly(y);
            let of_product = passed + rounding(most * of_b, passed);
            holds(a * b, &product, f * g, of_product, &mut random);
            let exact = product + exactly(z);
            let passed = of_product + c.error;
            let both = passed + rounding((most * of_b).next_up() + of_c, passed);
            for computed in [f.mul_add(g, h), f * g + h] {
                holds(a.multiply_add(b, c), &exact, computed, both, &mut random);
            }
            let opposite = a.negated();
            assert_eq!((opposite.low, opposite.high, opposite.error), (-a.high, -a.low, a.error));
        }
    }

    #[test]
    fn bounds_are_those_of_their_formulas() {
        let [e, d] = [2f64.powi(-50), 2f64.powi(-51)];
        let (a, b) = (Rounded::new(1.5, 1.75, e), Rounded::new(-3.0, 2.0, d));
        let sum = a.plus(b);
        let of_sum = ((e + d) * SLACK + 2f64.powi(-52)) * SLACK;
        let expected = ((-1.5f64).next_down(), 3.75f64.next_up(), of_sum, 2f64.powi(-52));
        assert_eq!((sum.low, sum.high, sum.error, sum.last), expected);
        let product = a * b;
        let of_product = ((1.75 * d + 3.0 * e + e * d) * SLACK + 2f64.powi(-51)) * SLACK;
        let expected = ((-5.25f64).next_down(), 3.5f64.next_up(), of_product, 2f64.powi(-51));
        assert_eq!((product.low, product.high, product.error, product.last), expected);
        // An error that reaches the next power of two counts.
        let last = Rounded::new(1.0, 1.0, 0.0).plus(Rounded::new(0.5, 1.0 - f64::EPSILON / 2.0, 1e-9)).last;
        assert_eq!(last, 2f64.powi(-52));
        assert_eq!([0.75, 1.0, -1.5, 2.0].map(half_unit), [1.0, 2.0, 2.0, 4.0].map(|x| x * 2f64.powi(-54)));
        // Without an own rounding; with one of 2^-53, that of numbers from 1 to 2.
        let start = Rounded::new(-1.5, -1.25, e);
        let least = (1.25 - d).next_down();
        assert_eq!(start.relative(d), (e + d) * SLACK / least);
        assert_eq!(start.units(d), (e + d) * SLACK / 2f64.powi(-52) + 0.5);
        assert_eq!((b.relative(d), b.units(d)), (f64::INFINITY, f64::INFINITY));
        let zero = Rounded::new(0.0, 1.0, 0.0);
        assert_eq!((zero.relative(0.0), zero.units(0.0)), (f64::INFINITY, f64::INFINITY));
        assert_eq!((a.relative(1.5), a.units(1.5)), (f64::INFINITY, f64::INFINITY));
        let rounded = Rounded { last: 2f64.powi(-53), ..start };
        assert_eq!(rounded.units(0.0), (e - 2f64.powi(-53) * (1.0 - 1e-12)) * SLACK / 2f64.powi(-52) + 0.5);
        // Straddling 1: units below are 2^-53, and one that is missed makes the rounding count one.
        let about_one = Rounded { low: 0.9, high: 1.0, error: 0.0, last: 0.0 };
        let unit = 2f64.powi(-53);
        assert_eq!(about_one.units(unit), SLACK + 1.0);
        assert_eq!(about_one.units(unit * 0.9), unit * 0.9 * SLACK / unit + 0.5);
        let below = Rounded { low: 0.75, high: 0.875, error: 0.0, last: 0.0 };
        assert_eq!(below.units(unit), SLACK + 0.5);
    }
}
