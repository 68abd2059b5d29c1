//! Fractions in lowest terms.

use super::denominators::Denominators;
use crate::kernels::SmallPrimes;
use num_rational::BigRational;
use num_traits::Zero;
use restitution_real::convert::big_integer;
use rug::Integer;

/// The numerators over the multiples, which have no other primes than the bound, in lowest terms; the first is that of `(n, j)`.
///
/// What the primes' remainders show is divided out; primes that may divide once more are looked at again.
pub(super) fn fractions(
    small: &SmallPrimes,
    bound: &Denominators,
    (n, j): (usize, usize),
    numerators: &[Integer],
    multiples: &[Integer],
) -> Vec<BigRational> {
    let count = bound.primes_below(j + numerators.len());
    let mut numerators = numerators.to_vec();
    let mut cancelled = vec![Integer::from(1); numerators.len()];
    // How often each prime was taken out.
    let mut times = vec![vec![0; bound.primes().len()]; numerators.len()];
    let mut groups = small.groups_of(count);
    let mut found = small.large_divisors(&numerators, count);
    loop {
        found.extend(small.divisors(&numerators, &groups));
        groups.clear();
        let mut common = vec![Integer::from(1); numerators.len()];
        for divisor in found.drain(..) {
            let times = &mut times[divisor.row][divisor.place];
            let most = bound.exponent(n, j + divisor.row, divisor.place) - *times;
            let exponent = divisor.exponent.min(most);
            *times += exponent;
            common[divisor.row] *= small.prime(divisor.place).pow(exponent);
            if divisor.open && exponent < most {
                groups.push(small.group_of(divisor.place));
            }
        }
        for ((numerator, cancelled), common) in numerators.iter_mut().zip(&mut cancelled).zip(&common) {
            numerator.div_exact_mut(common);
            *cancelled *= common;
        }
        if groups.is_empty() {
            break;
        }
        groups.sort_unstable();
        groups.dedup();
    }
    let fraction = |((numerator, cancelled), multiple): ((&Integer, &Integer), &Integer)| {
        if numerator.is_zero() {
            return BigRational::zero();
        }
        let denominator = Integer::from(multiple.div_exact_ref(cancelled));
        BigRational::new_raw(big_integer(numerator), big_integer(&denominator))
    };
    numerators.iter().zip(&cancelled).zip(multiples).map(fraction).collect()
}
