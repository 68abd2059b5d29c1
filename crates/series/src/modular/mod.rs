//! Exact trajectories by way of many primes.
//!
//! The orders are found modulo eight primes at a time; a proved bound on denominators and sizes says how many primes
//! determine every coefficient.

mod denominators;
mod fractions;
mod motion;
mod residues;

use crate::kernels::{
    Fixed, LANES, Lanes, Level, Primes, SmallPrimes, Table, groups_for, keep_freed_memory, primes, turn,
    vectorised,
};
use crate::recurrence;
use crate::trajectories::index;
use crate::{TailBound, Trajectories, turning_time};
use denominators::Denominators;
use fractions::fractions;
use motion::Motion;
use num_rational::{BigRational, Ratio};
use rayon::prelude::*;
use residues::Residues;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use rug::Integer;
use rug::float::Round;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Terms up to which the plain rational recurrence is as fast.
const FEW_TERMS: usize = 24;
/// Steps by which fewer primes are used for smaller coefficients.
const LEVELS: usize = 16;
/// Terms for which one bound of their sizes is found: it gives away two or three bits for each.
const STRIDE: usize = 4;
/// Bits of logarithms behind the point.
const FRACTION: u32 = 20;
/// Coefficients that are reconstructed together.
const BLOCK: usize = 16;
/// Largest lattice index whose primes are looked for: all are below `2^32`.
const LARGEST_INDEX: i64 = 100_000_000;

impl Trajectories {
    /// Derives `x_0 .. x_N` for `N = damping_order` with the first `terms` coefficients each.
    ///
    /// The numerators over a proved multiple of the denominators are found modulo enough primes below
    /// `2^50` to determine them, by the proved bound of [`TailBound`] on their size (`docs/error-bounds.md`).
    /// Cost: `O(J log J)` operations for each prime and order, about `J` primes; split over all cores. Few terms,
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
        keep_freed_memory();
        let bounds = || {
            let denominators = || Denominators::bound(law.lattice(), damping_order, terms);
            let (sizes, denominators) = rayon::join(|| sizes(law, damping_order, terms), denominators);
            Some(Bounds { sizes: sizes?, denominators })
        };
        let exact = if is_large(law, damping_order, terms) { bounds() } else { None };
        let orders = exact.and_then(|bounds| reconstruct(law, damping_order, terms, &bounds, watch));
        // Where no bound on the sizes is known, fractions need none.
        let orders = orders.unwrap_or_else(|| recurrence::coefficients(law, damping_order, terms));
        Self::from_orders(law, terms, orders)
    }
}

/// Whether there are so many terms that primes are worth it, and no index so large that one of them could divide it.
fn is_large(law: &ForceLaw, damping_order: usize, terms: usize) -> bool {
    terms > FEW_TERMS && index(law, damping_order, terms) <= LARGEST_INDEX
}

/// For every `(n, j)` an exponent `s` with `|q_(n,j)| <= 2^s`; none where no bound is known.
fn sizes(law: &ForceLaw, damping_order: usize, terms: usize) -> Option<Vec<Vec<i64>>> {
    let bound = TailBound::find_rough(law, damping_order).ok()?;
    let checked = bound.checked_terms();
    let integer = |x: i64| Ball::from_integer(x, 64);
    let logarithm = turning_time(law, 64).ln() / integer(2).ln() * integer(1 << FRACTION);
    // The binary logarithm of T^-step, rounded up behind the fraction's bits.
    let up = |step: &BigRational| {
        let exact = -(&logarithm * Ball::from_rational(step, 64));
        exact.upper().to_integer_round(Round::Up).and_then(|(integer, _)| integer.to_i64())
    };
    let (elastic, damping) = (up(&law.elastic_step())?, up(&law.damping_step())?);
    let row = |n: usize| {
        let mut scaled = 0;
        let size = |j: usize| {
            // Beyond the head bounds fall with j: one holds for those that follow.
            if j <= checked || j.is_multiple_of(STRIDE) {
                let coefficient = bound.coefficient_up(n, j);
                scaled = if coefficient.is_zero() { 0 } else { i64::from(coefficient.get_exp()?) };
            }
            // Rounded up.
            Some(scaled - ((-elastic * j as i64 - damping * n as i64) >> FRACTION))
        };
        (0..terms).map(size).collect::<Option<Vec<i64>>>()
    };
    (0..=damping_order).into_par_iter().map(row).collect()
}

/// What is known of the coefficients before they are found.
struct Bounds {
    /// For every `(n, j)` an exponent `s` with `|q_(n,j)| <= 2^s`.
    sizes: Vec<Vec<i64>>,
    denominators: Denominators,
}

/// All coefficients, order by order; none if there are not primes enough.
fn reconstruct(
    law: &ForceLaw,
    damping_order: usize,
    terms: usize,
    bounds: &Bounds,
    watch: &(dyn Fn(Ratio<usize>) + Sync),
) -> Option<Vec<Vec<BigRational>>> {
    let Bounds { sizes, denominators } = bounds;
    let multiples: Vec<Vec<Integer>> =
        (0..=damping_order).into_par_iter().map(|n| denominators.multiples(n, terms)).collect();
    let bits = |n: usize, j: usize| bits_of_product(&multiples[n][j], sizes[n][j]);
    let most =
        (0..=damping_order).flat_map(|n| (0..terms).map(move |j| (n, j))).map(|(n, j)| bits(n, j)).max();
    let count = groups_for(most.unwrap_or(0));
    let primes = primes(count);
    if primes.len() < count {
        return None;
    }
    let done = AtomicUsize::new(0);
    let mut residues = vec![Lanes::ZERO; count * (damping_order + 1) * terms];
    let stride = (damping_order + 1) * terms;
    let fill = |(primes, rows): (&Primes, &mut [Lanes])| {
        numerators_modulo(*primes, law, (damping_order, terms), denominators, rows);
        watch(Ratio::new_raw(done.fetch_add(1, Ordering::Relaxed) + 1, count));
    };
    primes.par_iter().zip(residues.par_chunks_mut(stride)).for_each(fill);
    let needed = |place: usize| groups_for(bits(place / terms, place % terms));
    let numerators = integers(&primes, &residues, stride, needed);
    let words = numerators.iter().map(Integer::significant_digits::<u64>).max();
    let small = SmallPrimes::new(denominators.primes(), words.unwrap_or(0));
    let reduce = |n: usize, from: usize, numerators: &[Integer]| {
        let multiples = &multiples[n][from..from + numerators.len()];
        fractions(&small, denominators, (n, from), numerators, multiples)
    };
    let row = |(n, numerators): (usize, &[Integer])| {
        let chunks = numerators.par_chunks(SmallPrimes::ROWS).enumerate();
        chunks.flat_map_iter(|(i, chunk)| reduce(n, i * SmallPrimes::ROWS, chunk)).collect()
    };
    Some(numerators.chunks(terms).enumerate().map(row).collect())
}

/// Bits of the product of a multiple and a number of at most `2^size`; 0 where the product is below 1.
fn bits_of_product(multiple: &Integer, size: i64) -> u32 {
    u32::try_from(i64::from(multiple.significant_bits()) + size).unwrap_or(0)
}

/// Words for integers modulo so many groups of primes below `2^50`.
fn words_for(groups: usize) -> usize {
    groups * LANES * 50 / 64 + 1
}

/// The integers with the given residues at every place, of which each needs so many groups of primes.
fn integers(
    primes: &[Primes],
    residues: &[Lanes],
    stride: usize,
    needed: impl Fn(usize) -> usize,
) -> Vec<Integer> {
    let scales = vec![Lanes::ONE; primes.len()];
    let table = Table { values: residues, stride, scales: &scales };
    let step = primes.len().div_ceil(LEVELS);
    let mut integers = vec![Integer::new(); stride];
    let levels: Vec<usize> =
        (0..stride).map(|place| needed(place).next_multiple_of(step).min(primes.len())).collect();
    let of_level = |count: usize| {
        let level = Level::new(&primes[..count], 0);
        let width = words_for(count);
        let places: Vec<usize> = (0..stride).filter(|&place| levels[place] == count).collect();
        let block = |places: &[usize]| {
            let mut words = vec![0; width * places.len()];
            level.write(&primes[..count], &table, places, &mut words);
            let found = Fixed::from_words(words, width);
            (0..found.len()).map(|i| found.integer(i)).collect::<Vec<_>>()
        };
        let found: Vec<Integer> = places.par_chunks(BLOCK).flat_map_iter(block).collect();
        places.into_iter().zip(found).collect::<Vec<_>>()
    };
    let counts = (0..=primes.len()).into_par_iter().filter(|count| levels.contains(count));
    for (place, integer) in counts.flat_map_iter(of_level).collect::<Vec<_>>() {
        integers[place] = integer;
    }
    integers
}

/// The coefficients times the multiples of their denominators, modulo eight primes, order by order.
fn numerators_modulo(
    primes: Primes,
    law: &ForceLaw,
    (damping_order, terms): (usize, usize),
    denominators: &Denominators,
    rows: &mut [Lanes],
) {
    let field = Residues::new(primes);
    let motion = Motion { field: &field, lattice: law.lattice(), shared: law.is_viscoelastic(), terms };
    let orders = motion.orders(damping_order);
    for (n, (row, order)) in rows.chunks_exact_mut(terms).zip(orders).enumerate() {
        row.copy_from_slice(&order);
        multiply_by_growth(&primes, row, denominators.growth(n));
    }
}

vectorised! {
    /// Every value times all factors that are listed up to its place, in rising order of places.
    fn multiply_by_growth(primes: &'a Primes, values: &'a mut [Lanes], growth: &'a [(usize, u64)]) {
        let primes = *primes;
        let mut multiple = Lanes::ONE;
        let mut factors = growth.iter().peekable();
        for (j, value) in values.iter_mut().enumerate() {
            turn();
            while let Some((_, factor)) = factors.next_if(|(at, _)| *at <= j) {
                multiple = primes.reduce(primes.mul(multiple, Lanes::splat(*factor as f64)));
            }
            *value = primes.reduce(primes.mul(*value, multiple));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::Signed;

    #[test]
    fn modular_and_rational_arithmetic_give_the_same() {
        for (law, order, terms) in
            [("3/2,1/2", 4, 36), ("5/3,1/4", 2, 36), ("2,1", 3, 30), ("1,0", 2, 30), ("3,-1/2", 2, 30)]
        {
            let law: ForceLaw = law.parse().unwrap();
            let bounds = Bounds {
                sizes: sizes(&law, order, terms).unwrap(),
                denominators: Denominators::bound(law.lattice(), order, terms),
            };
            let shares = std::sync::Mutex::new(Vec::new());
            let exact = reconstruct(&law, order, terms, &bounds, &|share| shares.lock().unwrap().push(share));
            let exact = exact.unwrap();
            let mut shares = shares.into_inner().unwrap();
            shares.sort_unstable();
            let count = shares.len();
            assert!(shares.into_iter().eq((1..=count).map(|done| Ratio::new(done, count))), "{law}");
            let plain = recurrence::coefficients(&law, order, terms);
            let given = Trajectories::exact(&law, order, terms);
            assert!(
                exact.iter().enumerate().all(|(n, row)| given.coefficients(n) == Ok(row.as_slice())),
                "{law}"
            );
            for (n, plain) in plain.iter().enumerate() {
                // Fractions are equal in other than lowest terms, too: numerators and denominators are compared.
                let parts = |q: &BigRational| (q.numer().clone(), q.denom().clone());
                let [exact, plain] = [&exact[n], plain].map(|row| row.iter().map(parts).collect::<Vec<_>>());
                assert_eq!(exact, plain, "{law} {n}");
            }
        }
    }

    /// Never below the coefficients, and above them by less than a tenth of their bits.
    #[test]
    fn sizes_are_close_above_the_coefficients() {
        for (law, order, terms, slack) in
            [("3/2,1/2", 3, 60, 30), ("5/3,1/4", 2, 40, 30), ("3,-1/2", 2, 40, 30), ("12,11", 1, 30, 60)]
        {
            let law: ForceLaw = law.parse().unwrap();
            let sizes = sizes(&law, order, terms).unwrap();
            let exact = Trajectories::exact(&law, order, terms);
            for (n, sizes) in sizes.iter().enumerate() {
                for (j, (q, size)) in exact.coefficients(n).unwrap().iter().zip(sizes).enumerate() {
                    let bits = q.numer().bits() as i64 - q.denom().bits() as i64;
                    let two = BigRational::from_integer(2.into());
                    assert!(
                        q.abs() <= num_traits::Pow::pow(two, *size as i32),
                        "{law} {n} {j}: {q} and 2^{size}"
                    );
                    assert!(*size - bits <= slack + bits.abs() / 10, "{law} {n} {j}: 2^{bits} and 2^{size}");
                }
            }
        }
    }

    /// A bound on the coefficient over a power of the turning time, rounded up once for each: from its formula, within two bits.
    #[test]
    fn sizes_are_bounds_over_powers_of_the_turning_time() {
        for (law, order, terms) in
            [("3/2,1/2", 3, 60), ("5/3,1/4", 2, 40), ("3,-1/2", 2, 40), ("12,11", 1, 30)]
        {
            let law: ForceLaw = law.parse().unwrap();
            let bound = TailBound::find_rough(&law, order).unwrap();
            let sizes = sizes(&law, order, terms).unwrap();
            let turning_time = turning_time(&law, 64).to_f64().log2();
            let [elastic, damping] = [law.elastic_step(), law.damping_step()]
                .map(|step| restitution_real::Ball::from_rational(&step, 64).to_f64());
            for (n, sizes) in sizes.iter().enumerate() {
                for j in (0..terms).filter(|&j| j <= bound.checked_terms() || j.is_multiple_of(STRIDE)) {
                    let scaled = bound.coefficient_up(n, j);
                    let (mantissa, exponent) = scaled.to_f64_exp();
                    let exact = mantissa.log2() + exponent as f64
                        - (elastic * j as f64 + damping * n as f64) * turning_time;
                    let over = sizes[j] as f64 - exact;
                    assert!((0.0..2.1).contains(&over), "{law} {n} {j}: {over}");
                }
            }
        }
    }

    #[test]
    fn few_terms_and_large_indices_are_done_in_fractions() {
        let spheres = ForceLaw::viscoelastic_spheres();
        assert_eq!(
            [1, FEW_TERMS, FEW_TERMS + 1, 1000].map(|terms| is_large(&spheres, 2, terms)),
            [false, false, true, true]
        );
        let law: ForceLaw = "99999,0".parse().unwrap();
        assert_eq!(index(&law, 0, 1000), LARGEST_INDEX);
        assert_eq!([0, 1].map(|order| is_large(&law, order, 1000)), [true, false]);
    }

    #[test]
    fn products_have_the_bits_of_both() {
        let multiple = Integer::from(1000);
        assert_eq!([-11, -10, -9, 0, 5].map(|size| bits_of_product(&multiple, size)), [0, 0, 1, 10, 15]);
        assert_eq!([0, 1, 2, 16].map(words_for), [1, 7, 13, 101]);
    }
}
