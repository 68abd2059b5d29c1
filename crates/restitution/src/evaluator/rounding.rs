//! The operations whose rounding the bounds count.

/// Returns `a b + c`: rounded once where the target has the instruction and `std` is there, else twice.
#[inline(always)]
pub(crate) fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
    #[cfg(all(feature = "std", target_feature = "fma"))]
    {
        a.mul_add(b, c)
    }
    #[cfg(not(all(feature = "std", target_feature = "fma")))]
    {
        a * b + c
    }
}

/// What the forms are evaluated in: a number, several side by side, or what a proof follows instead of one.
pub trait Number: Clone + core::ops::Mul<Output = Self> {
    /// A constant of a form.
    fn of(&self, constant: f64) -> Self;
    /// `self b + c`: rounded once where the target has the instruction and `std` is there, else twice.
    #[must_use]
    fn multiply_add(self, b: Self, c: Self) -> Self;
    /// The number with the opposite sign.
    #[must_use]
    fn negated(self) -> Self;
}

/// A number that can be divided by another.
pub(crate) trait Divided: Number {
    /// `self/divisor`, rounded to nearest.
    fn over(self, divisor: Self) -> Self;
}

/// A number that has a square root.
pub(crate) trait Rooted: Number {
    /// The square root of a number of `[0, 1]`, rounded to nearest.
    fn square_root(self) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn of(&self, constant: f64) -> Self {
        constant
    }

    #[inline(always)]
    fn multiply_add(self, b: Self, c: Self) -> Self {
        multiply_add(self, b, c)
    }

    #[inline(always)]
    fn negated(self) -> Self {
        -self
    }
}

impl Divided for f64 {
    #[inline(always)]
    fn over(self, divisor: Self) -> Self {
        self / divisor
    }
}

impl Rooted for f64 {
    #[inline(always)]
    fn square_root(self) -> Self {
        square_root(self)
    }
}

/// Returns `(p, e)` with `a b = p + e` exactly, barring overflow and underflow.
///
/// Dekker's product (Muller et al., *Handbook of Floating-Point Arithmetic*, 2nd ed., alg. 4.10).
#[inline]
pub(crate) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    if cfg!(all(feature = "std", target_feature = "fma")) {
        return (product, multiply_add(a, b, -product));
    }
    let (a_high, a_low) = halves(a);
    let (b_high, b_low) = halves(b);
    (product, a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low))
}

/// Returns `a` as a sum of two numbers of at most 26 bits each (Veltkamp).
#[inline(always)]
fn halves(a: f64) -> (f64, f64) {
    let scaled = a * 134_217_729.0; // 2^27 + 1
    let high = scaled - (scaled - a);
    (high, a - high)
}

/// Returns the square root of a number of `[0, 1]`, rounded to nearest from 1e-290 on.
#[inline(always)]
pub(crate) fn square_root(x: f64) -> f64 {
    #[cfg(feature = "std")]
    {
        x.sqrt()
    }
    #[cfg(not(feature = "std"))]
    {
        newton_square_root(x)
    }
}

/// Newton's iteration from an estimate by halving the exponent, then the neighbour that is closest: the bits that hardware
/// gives. `core` has no square root.
#[cfg(any(test, not(feature = "std")))]
#[inline]
fn newton_square_root(x: f64) -> f64 {
    if x == 0.0 {
        return x;
    }
    let mut root = f64::from_bits((x.to_bits() >> 1) + 0x1ff7_a3be_a91d_9b1b);
    for _ in 0..4 {
        root = 0.5 * (root + x / root);
    }
    let (square, error) = two_product(root, root);
    let missing = (x - square) - error; // sqrt(x) = root + missing/(2 root), about
    if missing > root * (root.next_up() - root) {
        root.next_up()
    } else if missing <= root * (root.next_down() - root) {
        root.next_down()
    } else {
        root
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_product_is_split_exactly() {
        let x = 1.0 + f64::EPSILON;
        assert_eq!(two_product(x, x), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
        assert_eq!(two_product(3.0, 5.0), (15.0, 0.0));
    }

    #[test]
    fn the_square_root_of_core_has_the_bits_of_hardware() {
        for i in 0..20_000 {
            let x = (f64::from(i) * 0.618_033_988_749_894_9).fract() * 0.97_f64.powi(i % 4000);
            assert_eq!(newton_square_root(x), x.sqrt(), "{x:e}");
        }
        for root in [0.25_f64, 0.5, 0.75, 1.0 - f64::EPSILON / 2.0] {
            for x in [(root * root).next_down(), root * root, (root * root).next_up().min(1.0)] {
                assert_eq!(newton_square_root(x), x.sqrt(), "{x:e}");
            }
        }
    }
}
