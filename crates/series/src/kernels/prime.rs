//! Arithmetic modulo eight primes at once, in the floating-point unit.
//!
//! Residues are integers in `f64`, and every result is exact: the product of two of them is the sum of its rounded
//! value and of what a fused multiplication gives as the rest (Dekker 1971); the quotient by `p` need not be right,
//! since a wrong one leaves a residue that is larger but as good. (Shoup's and Harvey's way, as in FLINT's `fft_small`.)

use super::lanes::{LANES, Lanes, each, vectorised};
use std::sync::{Mutex, OnceLock, PoisonError};

/// Every prime has roots of unity of the orders that divide `3 * 2^24`.
pub(super) const ORDER: u64 = 3 << 24;
/// Primes are below `2^50`, by at most a fourteenth.
const LARGEST: u64 = ((1 << 50) - 1) / ORDER;
const LEAST: u64 = LARGEST / 14 * 13;
/// Bits of the product of eight primes, at least: `8 (50 + log2(13/14))` is above 399.1.
const BITS: u32 = 399;
/// Bases that are tried for a root of unity: each serves one prime in three.
const BASES: [f64; 24] = [
    2., 3., 5., 7., 11., 13., 17., 19., 23., 29., 31., 37., 41., 43., 47., 53., 59., 61., 67., 71., 73., 79.,
    83., 89.,
];

/// Eight odd primes `p < 2^50` with `p = 1 mod 3 2^24`.
///
/// A residue is any integer below `2^53` in absolute value. *Reduced* is one of at most `p/2 + 2`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Primes {
    pub p: Lanes,
    /// `1/p`, rounded.
    inverse: Lanes,
    /// A root of unity of order [`ORDER`].
    root: Lanes,
}

impl Primes {
    fn new(p: [u64; LANES], root: Lanes) -> Self {
        let p = Lanes(p.map(|p| p as f64));
        Self { p, inverse: Lanes(p.0.map(|p| 1.0 / p)), root }
    }

    /// `x y` modulo `p`: for `|x y| <= B p^2`, `B <= 8`, of absolute value at most `(1/2 + 3B/8) p`.
    ///
    /// 1. `h` is `x y (1 + e)` with `|e| <= 2^-53`, and `l = x y - h` is exact: an integer of at most 53 bits.
    /// 2. Three roundings on the way to `q`: `|q - x y/p| <= 1/2 + 3 2^-53 (1 + 2^-50) |x y|/p`. Since
    ///    `|x y|/p <= B p` and `p < 2^50 (1 - 2^-49)`, this is at most `1/2 + 3B/8`; and `q` is an integer below `2^53`.
    /// 3. `h - q p = (x y - q p) - l` is an integer of at most `(1/2 + 3B/8) p + 2^49 < 2^53`, hence exact when
    ///    fused, and so is the sum with `l`.
    #[inline(always)]
    pub fn mul(&self, x: Lanes, y: Lanes) -> Lanes {
        each!(|i| {
            let (x, y) = (x.0[i], y.0[i]);
            let h = x * y;
            let l = x.mul_add(y, -h);
            let q = (h * self.inverse.0[i]).round_ties_even();
            q.mul_add(-self.p.0[i], h) + l
        })
    }

    /// `x` modulo `p` for `|x| <= 2^53`, reduced.
    ///
    /// The rounded `x/p` is off by less than `8 2^-52`, which is worth at most two units of `x`; `x - q p` is small,
    /// hence exact when fused.
    #[inline(always)]
    pub fn reduce(&self, x: Lanes) -> Lanes {
        each!(|i| {
            let q = (x.0[i] * self.inverse.0[i]).round_ties_even();
            q.mul_add(-self.p.0[i], x.0[i])
        })
    }

    /// The residue in `0 .. p`, for `|x| <= 2^53`.
    #[inline(always)]
    pub fn least(&self, x: Lanes) -> Lanes {
        let x = self.reduce(x);
        each!(|i| if x.0[i] < 0.0 { x.0[i] + self.p.0[i] } else { x.0[i] })
    }

    /// `x/p`, rounded.
    #[inline(always)]
    pub fn share(&self, x: Lanes) -> Lanes {
        each!(|i| x.0[i] * self.inverse.0[i])
    }

    /// An integer, reduced.
    #[inline(always)]
    pub fn integer(&self, n: i64) -> Lanes {
        let (high, low) = ((n >> 32) as f64, (n & 0xffff_ffff) as f64);
        self.reduce(self.mul(Lanes::splat(high), Lanes::splat(4_294_967_296.0)) + Lanes::splat(low))
    }

    /// `x^exponent` for reduced `x`, each lane with its own exponent.
    #[inline(always)]
    pub fn pow(&self, x: Lanes, exponents: [u64; LANES]) -> Lanes {
        let top = exponents.iter().fold(0, |all, exponent| all | exponent);
        let mut power = Lanes::ONE;
        for bit in (0..64 - top.leading_zeros()).rev() {
            power = self.reduce(self.mul(power, power));
            let factor = each!(|l| if exponents[l] >> bit & 1 == 1 { x.0[l] } else { 1.0 });
            power = self.reduce(self.mul(power, factor));
        }
        power
    }

    /// `1/x` for `x != 0`, by Fermat.
    #[inline(always)]
    pub fn reciprocal(&self, x: Lanes) -> Lanes {
        self.pow(self.reduce(x), self.p.integers().map(|p| p - 2))
    }

    /// A primitive root of unity of an order that divides `3 2^24`.
    #[inline(always)]
    pub fn root_of_unity(&self, order: usize) -> Lanes {
        self.pow(self.root, [ORDER / order as u64; LANES])
    }
}

/// How many groups of eight primes hold integers of absolute value below `2^bits`, with two bits to spare.
pub(crate) fn groups_for(bits: u32) -> usize {
    (bits + 3).div_ceil(BITS) as usize
}

/// The bits that so many groups hold, as [`groups_for`] counts.
pub(crate) fn capacity(groups: usize) -> u32 {
    BITS * groups as u32 - 3
}

/// The primes in falling order as far as they were looked for, with a root of unity each.
struct Found {
    /// The next candidate is `next ORDER + 1`.
    next: u64,
    primes: Vec<(u64, f64)>,
}

/// The first groups of primes, found once in a process; fewer where so many don't exist.
pub(crate) fn primes(groups: usize) -> Vec<Primes> {
    static FOUND: OnceLock<Mutex<Found>> = OnceLock::new();
    let found = FOUND.get_or_init(|| Mutex::new(Found { next: LARGEST, primes: Vec::new() }));
    let mut found = found.lock().unwrap_or_else(PoisonError::into_inner);
    while found.primes.len() < groups * LANES && found.next > LEAST + LANES as u64 {
        let factors = std::array::from_fn(|l| found.next - l as u64);
        let mut proved = [None; LANES];
        prove(&factors, &mut proved);
        found.primes.extend(proved.into_iter().flatten());
        found.next -= LANES as u64;
    }
    let group =
        |group: &[(u64, f64); LANES]| Primes::new(group.map(|(p, _)| p), Lanes(group.map(|(_, root)| root)));
    found.primes.as_chunks().0.iter().take(groups).map(group).collect()
}

vectorised! {
    /// Which of the numbers `c F + 1`, `F = 3 2^24`, are prime, each with a root of unity of order `F`.
    ///
    /// Pocklington (1914): since `c < F`, `n = c F + 1` is prime if some `r = a^c` has `r^F = 1` and neither
    /// `r^(F/2) - 1` nor `r^(F/3) - 1` has a factor in common with `n`. So it is if `r^(F/2) = -1` (`n` is odd) and
    /// `s = r^(F/3)` solves `s^2 + s + 1 = 0`: a common factor of `s - 1` and `n` would divide 3. `r` is the root then.
    fn prove(factors: &'a [u64; LANES], proved: &'a mut [Option<(u64, f64)>; LANES]) {
        let candidates = factors.map(|c| c * ORDER + 1);
        let n = Primes::new(candidates, Lanes::ONE);
        let mut open = [true; LANES];
        for base in BASES {
            let r = n.pow(Lanes::splat(base), *factors);
            let s = n.pow(r, [ORDER / 3; LANES]);
            let s2 = n.mul(s, s);
            let third = n.least(s2 + s + Lanes::ONE);
            let half = n.pow(r, [ORDER / 2; LANES]);
            let minus_one = n.least(half + Lanes::ONE);
            let one = n.least(n.mul(half, half) - Lanes::ONE);
            for l in 0..LANES {
                if open[l] && third.0[l] == 0.0 && minus_one.0[l] == 0.0 {
                    proved[l] = Some((candidates[l], r.0[l]));
                }
                // Fermat's theorem fails: composite.
                open[l] &= proved[l].is_none() && one.0[l] == 0.0;
            }
            if !open.contains(&true) {
                break;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Integer;
    use rug::integer::IsPrime;
    use rug::ops::RemRounding;

    /// Residues in `0 .. p` by integers.
    fn expected(x: i128, p: f64) -> f64 {
        x.rem_euclid(p as i128) as f64
    }

    #[test]
    fn the_largest_primes_of_the_form_are_found() {
        let groups = primes(6);
        let found: Vec<u64> = groups.iter().flat_map(|group| group.p.integers()).collect();
        let is_prime = |p: &u64| Integer::from(*p).is_probably_prime(25) != IsPrime::No;
        let all = (1..=LARGEST).rev().map(|c| c * ORDER + 1).filter(is_prime);
        assert_eq!(found, all.take(48).collect::<Vec<_>>());
        for (group, (l, &p)) in
            groups.iter().zip(found.chunks(8)).flat_map(|(g, p)| p.iter().enumerate().map(move |x| (g, x)))
        {
            let root = Integer::from(group.root.0[l] as i64).rem_euc(Integer::from(p));
            let power =
                |exponent: u64| root.clone().pow_mod(&Integer::from(exponent), &Integer::from(p)).unwrap();
            assert_eq!(power(ORDER), 1);
            assert!(power(ORDER / 2) != 1 && power(ORDER / 3) != 1, "{p}");
        }
        let product = found[..8].iter().fold(Integer::from(1), |product, &p| product * p);
        assert!(product.significant_bits() > BITS);
        // The smallest primes there can be.
        assert!(8.0 * ((LEAST * ORDER) as f64).log2() > f64::from(BITS));
    }

    /// Products and residues at the ends of every range that is promised, against integers.
    #[test]
    fn arithmetic_is_exact_at_the_extremes() {
        for primes in primes(2) {
            let p = primes.p.0[7];
            let half = (p + 1.0) / 2.0;
            let edges =
                [0.0, 1.0, 2.0, half - 2.0, half - 1.0, half, p - 1.0, p, p + 1.0, 1.5 * p - 0.5, 2.0 * p];
            let sums =
                [3.0 * p - 1.0, 4.0 * p, 5.0 * p + 3.0, 6.0 * p - 1.0, 8.0 * p - 1.0, 2f64.powi(52) - 1.0];
            let signed = |list: &[f64]| list.iter().flat_map(|&x| [x, -x]).collect::<Vec<f64>>();
            let small = signed(&edges);
            for x in signed(&[edges.as_slice(), &sums].concat()) {
                let reduced = primes.reduce(Lanes::splat(x)).0[7];
                assert!(reduced.abs() <= p / 2.0 + 2.0, "{x} {reduced}");
                assert_eq!(expected(reduced as i128 - x as i128, p), 0.0, "{x}");
                assert_eq!(primes.least(Lanes::splat(x)).0[7], expected(x as i128, p), "{x}");
                for &y in &small {
                    let share = (x / p * y / p).abs();
                    if share > 8.0 {
                        continue;
                    }
                    let product = primes.mul(Lanes::splat(x), Lanes::splat(y)).0[7];
                    assert!(product.abs() <= (0.5 + 0.375 * share) * p + 1.0, "{x} {y}: {product}");
                    assert_eq!(expected(product as i128 - x as i128 * y as i128, p), 0.0, "{x} {y}");
                }
            }
            for n in [0, -1, i64::MAX, i64::MIN, 1 << 50, -123_456_789_012_345_678] {
                assert_eq!(primes.least(primes.integer(n)).0[7], expected(n.into(), p));
            }
        }
    }

    /// Products of numbers all over the range, against integers.
    #[test]
    fn random_products_are_exact() {
        let primes = primes(1)[0];
        let mut state = 1u64;
        let mut next = |size: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state as i64 as f64 / 2f64.powi(63)) * size).round_ties_even()
        };
        for _ in 0..20_000 {
            let (x, y) = (next(8.0 * primes.p.0[0]), next(primes.p.0[0]));
            let product = primes.mul(Lanes::splat(x), Lanes::splat(y));
            for (product, p) in product.0.into_iter().zip(primes.p.0) {
                assert_eq!(expected(product as i128 - x as i128 * y as i128, p), 0.0, "{x} {y} {p}");
            }
        }
    }

    #[test]
    fn powers_and_reciprocals_are_right() {
        let primes = primes(1)[0];
        let x = primes.integer(-123_456_789_012_345);
        assert_eq!(primes.least(primes.mul(x, primes.reciprocal(x))), Lanes::ONE);
        let root = primes.root_of_unity(3072);
        assert_eq!(primes.least(primes.pow(root, [3072; LANES])), Lanes::ONE);
        for order in [1536, 1024] {
            assert!(primes.least(primes.pow(root, [order; LANES])).0.iter().all(|&power| power != 1.0));
        }
    }

    #[test]
    fn capacities_are_what_groups_hold() {
        for groups in [1, 2, 7, 100] {
            let bits = capacity(groups);
            assert_eq!([bits, bits + 1].map(groups_for), [groups, groups + 1]);
        }
        assert_eq!([0, 396, 397].map(groups_for), [1, 1, 2]);
    }
}
