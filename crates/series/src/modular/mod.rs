//! Exact trajectories by way of many word-size primes.
//!
//! The series are derived modulo one prime after the other; a proved bound on denominators and sizes says how many
//! primes determine every coefficient.

mod damped;
mod denominators;
mod linearised;
mod modulus;
mod reconstruct;
mod undamped;

use crate::kernels::Prime;
use crate::recurrence;
use crate::trajectories::index;
use crate::{BoundError, TailBound, Trajectories, turning_time};
use damped::damped_orders;
use denominators::Denominators;
use modulus::Modulus;
use num_rational::{BigRational, Ratio};
use num_traits::One;
use rayon::prelude::*;
use reconstruct::Basis;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_real::convert::big_integer;
use rug::Integer;
use std::sync::atomic::{AtomicUsize, Ordering};
use undamped::Undamped;

/// Terms up to which the plain rational recurrence is as fast.
const FEW_TERMS: usize = 24;
/// Largest lattice index that the sieve for the denominators is made for.
const LARGEST_INDEX: i64 = 100_000_000;

impl Trajectories {
    /// Derives `x_0 .. x_N` for `N = damping_order` with the first `terms` coefficients each.
    ///
    /// The numerators over a proved multiple of the denominators are found modulo enough primes below
    /// `2^62` to determine them, by the proved bound of [`TailBound`] on their size (`docs/error-bounds.md`).
    /// Cost: `O(J log J)` word operations for each prime and order, about `J` primes; split over all cores. Few terms,
    /// and laws without such a bound, are done in plain fractions.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_law::ForceLaw;
    /// use restitution_series::Trajectories;
    ///
    /// let exact = Trajectories::exact(&ForceLaw::viscoelastic_spheres(), 1, 40);
    /// assert_eq!(exact.coefficients(1)?[3].to_string(), "61216/426391875");
    /// assert!(exact.coefficients(2).is_err());
    /// # Ok::<(), restitution_series::SeriesError>(())
    /// ```
    pub fn exact(law: &ForceLaw, damping_order: usize, terms: usize) -> Self {
        Self::exact_watched(law, damping_order, terms, &|_| ())
    }

    /// As [`Trajectories::exact`], telling `watch` the share of the primes that is done, from 0 to 1.
    pub fn exact_watched(
        law: &ForceLaw,
        damping_order: usize,
        terms: usize,
        watch: &(dyn Fn(Ratio<usize>) + Sync),
    ) -> Self {
        let small = terms <= FEW_TERMS || index(law, damping_order, terms) > LARGEST_INDEX;
        let sizes = if small { None } else { sizes(law, damping_order, terms).ok() };
        match sizes {
            // Where no bound on the sizes is known, fractions need none.
            None => Self::from_orders(law, terms, recurrence::coefficients(law, damping_order, terms)),
            Some(sizes) => reconstruct_all(law, damping_order, terms, &sizes, watch),
        }
    }
}

/// For every `(n, j)` an exponent `s` with `|q_(n,j)| <= 2^s`.
fn sizes(law: &ForceLaw, damping_order: usize, terms: usize) -> Result<Vec<Vec<i64>>, BoundError> {
    let bound = TailBound::find(law, damping_order)?;
    let time = turning_time(law, 64);
    let elastic = Ball::one() / time.pow(&law.elastic_step());
    let damping = Ball::one() / time.pow(&law.damping_step());
    let mut row_scale = Ball::one();
    let mut rows = Vec::with_capacity(damping_order + 1);
    for n in 0..=damping_order {
        let mut scale = row_scale.clone();
        let size = |j| {
            let size = (Ball::exact(bound.coefficient_up(n, j)) * &scale).abs_up();
            scale *= &elastic;
            size.get_exp().map_or(0, i64::from)
        };
        rows.push((0..terms).map(size).collect());
        row_scale *= &damping;
    }
    Ok(rows)
}

fn reconstruct_all(
    law: &ForceLaw,
    damping_order: usize,
    terms: usize,
    sizes: &[Vec<i64>],
    watch: &(dyn Fn(Ratio<usize>) + Sync),
) -> Trajectories {
    let denominators = Denominators::bound(law.lattice(), damping_order, terms);
    let multiples: Vec<Vec<Integer>> =
        (0..=damping_order).map(|n| denominators.multiples(n, terms)).collect();
    let bits = |n: usize, j: usize| {
        u32::try_from(i64::from(multiples[n][j].significant_bits()) + sizes[n][j]).unwrap_or(0)
    };
    let most =
        (0..=damping_order).flat_map(|n| (0..terms).map(move |j| (n, j))).map(|(n, j)| bits(n, j)).max();
    // Every prime has more than 61 bits.
    let count = most.unwrap_or(0) as usize / 61 + 1;
    let primes: Vec<Prime> = Prime::falling().take(count).collect();
    let done = AtomicUsize::new(0);
    let residues = |&prime: &Prime| {
        let rows = numerators_modulo(prime, law, damping_order, terms, &denominators);
        watch(Ratio::new_raw(done.fetch_add(1, Ordering::Relaxed) + 1, count));
        rows
    };
    let residues: Vec<Vec<Vec<u64>>> = primes.par_iter().map(residues).collect();
    let basis = Basis::new(primes);
    let coefficient = |n: usize, j: usize| {
        let numerator = basis.integer(residues.iter().map(|rows| rows[n][j]), bits(n, j));
        let common = Integer::from(numerator.gcd_ref(&multiples[n][j]));
        let denominator = Integer::from(multiples[n][j].div_exact_ref(&common));
        BigRational::new_raw(big_integer(&numerator.div_exact(&common)), big_integer(&denominator))
    };
    let row = |n: usize| (0..terms).into_par_iter().map(move |j| coefficient(n, j)).collect();
    Trajectories::from_orders(law, terms, (0..=damping_order).map(row).collect())
}

/// The coefficients times the multiples of their denominators, modulo one prime.
fn numerators_modulo(
    prime: Prime,
    law: &ForceLaw,
    damping_order: usize,
    terms: usize,
    denominators: &Denominators,
) -> Vec<Vec<u64>> {
    let modulus = Modulus::new(prime);
    let undamped = Undamped::solve(&modulus, law, terms);
    let rows = damped_orders(&modulus, law, undamped, damping_order);
    let numerators = |(n, row): (usize, Vec<u64>)| {
        let mut values: Vec<u64> = row.into_iter().map(|q| prime.value(q)).collect();
        let mut multiple = prime.one;
        let mut done = 0;
        denominators.growth(n, terms, |j, factor| {
            values[done..j].iter_mut().for_each(|value| *value = prime.mul(*value, multiple));
            done = done.max(j);
            multiple = prime.mul(multiple, prime.form(factor as i64));
        });
        values[done..].iter_mut().for_each(|value| *value = prime.mul(*value, multiple));
        values
    };
    rows.into_iter().enumerate().map(numerators).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modular_and_rational_arithmetic_give_the_same() {
        for (law, order, terms) in
            [("3/2,1/2", 4, 60), ("5/3,1/4", 2, 40), ("2,1", 3, 30), ("1,0", 2, 30), ("3,-1/2", 2, 30)]
        {
            let law: ForceLaw = law.parse().unwrap();
            let exact = Trajectories::exact(&law, order, terms);
            let plain = recurrence::coefficients(&law, order, terms);
            for (n, plain) in plain.iter().enumerate() {
                assert_eq!(exact.coefficients(n).unwrap(), plain, "{law} {n}");
            }
        }
    }
}
