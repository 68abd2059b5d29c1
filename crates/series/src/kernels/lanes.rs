//! Eight numbers side by side, and functions compiled for every width of vectors.

use std::ops::{Add, Neg, Sub};

/// Numbers side by side: one vector of 512 bits, or two of 256, or four of 128.
pub(crate) const LANES: usize = 8;

/// Eight numbers that every operation treats alike.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub(crate) struct Lanes(pub [f64; LANES]);

/// At the head of a loop: keeps the compiler from taking several turns of it together, so that lanes make up vectors.
#[inline(always)]
pub(crate) fn turn() {
    std::hint::black_box(());
}

/// The number in every lane: a plain loop, since a closure may not be inlined into vectorised code.
macro_rules! each {
    (|$lane:ident| $value:expr) => {{
        let mut lanes = $crate::kernels::Lanes::ZERO;
        for $lane in 0..$crate::kernels::LANES {
            lanes.0[$lane] = $value;
        }
        lanes
    }};
}
pub(crate) use each;

impl Lanes {
    pub const ZERO: Self = Self([0.0; LANES]);
    pub const ONE: Self = Self([1.0; LANES]);

    #[inline(always)]
    pub fn splat(value: f64) -> Self {
        Self([value; LANES])
    }

    /// Integers below `2^52` as numbers: their bits are the mantissa of a number from `2^52` on.
    #[inline(always)]
    pub fn of(integers: &[u64; LANES]) -> Self {
        each!(|l| f64::from_bits(integers[l] | TWO_52.to_bits()) - TWO_52)
    }

    /// The integers from 0 to `2^52` that the numbers are.
    #[inline(always)]
    pub fn integers(self) -> [u64; LANES] {
        let mut integers = [0; LANES];
        for (integer, x) in integers.iter_mut().zip(self.0) {
            *integer = (x + TWO_52).to_bits() & (TWO_52_BITS - 1);
        }
        integers
    }
}

const TWO_52_BITS: u64 = 1 << 52;
const TWO_52: f64 = TWO_52_BITS as f64;

impl Add for Lanes {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        each!(|l| self.0[l] + other.0[l])
    }
}

impl Sub for Lanes {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        each!(|l| self.0[l] - other.0[l])
    }
}

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        each!(|l| -self.0[l])
    }
}

/// The widest vectors that the processor has.
pub(crate) fn arch() -> pulp::Arch {
    #[cfg(test)]
    if tests::WITHOUT_VECTORS.load(std::sync::atomic::Ordering::Relaxed) {
        return pulp::Arch::Scalar;
    }
    pulp::Arch::new()
}

/// Defines a function that is compiled for every width of vectors; the processor at hand chooses.
///
/// References in its arguments live for `'a`. All that it calls must be inlined, lest it be compiled for none.
macro_rules! vectorised {
    ($(#[$doc:meta])* $vis:vis fn $name:ident($($argument:ident: $type:ty),+ $(,)?) $body:block) => {
        $(#[$doc])*
        $vis fn $name<'a>($($argument: $type),+) {
            struct Job<'a> { $($argument: $type),+ }
            impl<'a> pulp::NullaryFnOnce for Job<'a> {
                type Output = ();
                #[inline(always)]
                fn call(self) {
                    let Job { $($argument),+ } = self;
                    $body
                }
            }
            $crate::kernels::arch().dispatch(Job { $($argument),+ });
        }
    };
}
pub(crate) use vectorised;

#[cfg(test)]
pub(super) mod tests {
    use crate::Trajectories;
    use crate::{Quantity, coefficients};
    use restitution_law::ForceLaw;
    use std::sync::atomic::{AtomicBool, Ordering};

    /// Whether all functions run as on a processor without vectors and fused multiplication. All results are exact, so
    /// that tests running meanwhile notice nothing.
    pub(in crate::kernels) static WITHOUT_VECTORS: AtomicBool = AtomicBool::new(false);

    /// The bits of exact and of certified results on a processor without fused multiplication.
    #[test]
    fn results_do_not_depend_on_vectors() {
        let results = || {
            let [spheres, other]: [ForceLaw; 2] = ["3/2,1/2", "5/3,1/4"].map(|law| law.parse().unwrap());
            let digits = coefficients(Quantity::Restitution, &spheres, 5, 40).unwrap();
            let balls: Vec<_> = digits.iter().map(|c| (c.mid().clone(), c.rad().clone())).collect();
            let exact = [Trajectories::exact(&spheres, 2, 40), Trajectories::exact(&other, 1, 30)];
            (balls, exact.map(|x| format!("{x:?}")))
        };
        let with = results();
        WITHOUT_VECTORS.store(true, Ordering::Relaxed);
        let without = results();
        WITHOUT_VECTORS.store(false, Ordering::Relaxed);
        assert_eq!(with, without);
    }
}
