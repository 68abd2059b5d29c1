//! A proved bound on the denominators of the trajectories' coefficients.

use restitution_law::Lattice;
use rug::Integer;

/// For every `(n, j)` a multiple of the denominators of `q_(n,i)`, `i <= j`, as a product of small factors.
///
/// Theorem 7 of `docs/error-bounds.md`, prime by prime. Without damping the motion is the inverse of
/// `t = x phi(x^(a+1))`, whose coefficients are known: a coefficient of `s^j` has at most the powers of the prime that
/// coefficients of `phi` have whose indices add up to `j`. Each order in the damping then costs one division by
/// `m = elastic j + damping n` or `m + unit`, somewhere on the way, and one by `elastic`.
pub(super) struct Denominators {
    /// The primes that occur, in the order in which they do; below `2^32`.
    primes: Vec<u64>,
    /// For every prime and `n` the least indices `j` at which its exponent reaches 1, 2, ...
    least: Vec<Vec<Least>>,
    /// For every `n`: `(j, factor)`, sorted by `j`; factors are products of primes and below `2^50`.
    growth: Vec<Vec<(usize, u64)>>,
}

/// Factors stay below it.
const LARGEST_FACTOR: u64 = 1 << 50;

impl Denominators {
    pub fn bound(lattice: Lattice, damping_order: usize, terms: usize) -> Self {
        let of_prime = |prime| {
            let local = Local::new(lattice, prime, damping_order, terms);
            let whole = |least: Least| least.into_iter().step_by(local.scale).skip(1).collect();
            let least: Vec<Least> = local.orders(damping_order).into_iter().map(whole).collect();
            // Exponents never fall from one order to the next.
            least[damping_order].first().copied().map(|first| (first, prime, least))
        };
        let primes = primes_of_all(lattice, damping_order, terms);
        let mut found: Vec<_> = primes.into_iter().filter_map(of_prime).collect();
        found.sort_unstable_by_key(|&(first, prime, _)| (first, prime));
        let gains = |n: usize| {
            let of_prime = |(_, prime, least): &(u32, u64, Vec<Least>)| {
                let prime = *prime;
                least[n].iter().map(|&j| (j as usize, prime)).collect::<Vec<_>>()
            };
            together(found.iter().flat_map(of_prime).collect())
        };
        let growth = (0..=damping_order).map(gains).collect();
        let (primes, least) = found.into_iter().map(|(_, prime, least)| (prime, least)).unzip();
        Self { primes, least, growth }
    }

    /// The primes that occur, in the order in which they do.
    pub fn primes(&self) -> &[u64] {
        &self.primes
    }

    /// How many of the primes occur below index `j`, at most.
    pub fn primes_below(&self, j: usize) -> usize {
        self.least.partition_point(|orders| orders.last().is_some_and(|least| (least[0] as usize) < j))
    }

    /// The exponent of a prime in the bound.
    pub fn exponent(&self, n: usize, j: usize, place: usize) -> u32 {
        self.least[place][n].partition_point(|&least| least as usize <= j) as u32
    }

    /// The factors by which the bound of order `n` grows at index `j`, as `(j, factor)`, in rising order of `j`.
    pub fn growth(&self, n: usize) -> &[(usize, u64)] {
        &self.growth[n]
    }

    /// The bounds themselves for order `n`.
    pub fn multiples(&self, n: usize, terms: usize) -> Vec<Integer> {
        let mut product = Integer::from(1);
        let mut multiples: Vec<Integer> = Vec::with_capacity(terms);
        for &(j, factor) in self.growth(n) {
            if multiples.len() < j {
                multiples.resize(j, product.clone());
            }
            product *= factor;
        }
        multiples.resize(terms, product);
        multiples
    }
}

/// Factors of the same index multiplied as far as they stay small.
fn together(mut gains: Vec<(usize, u64)>) -> Vec<(usize, u64)> {
    gains.sort_unstable();
    let mut growth: Vec<(usize, u64)> = Vec::with_capacity(gains.len());
    for (j, prime) in gains {
        match growth.last_mut() {
            Some((last, factor)) if *last == j && *factor < LARGEST_FACTOR / prime => *factor *= prime,
            _ => growth.push((j, prime)),
        }
    }
    growth
}

/// Least indices: `least[t]` is the first at which the bound of the exponent reaches `t/scale`; `least[0] = 0`, and it
/// never falls. What is not listed lies beyond the terms.
type Least = Vec<u32>;

/// What is known of one prime `l`.
struct Local {
    lattice: Lattice,
    prime: u64,
    terms: usize,
    /// Exponents are counted in fractions `1/scale`; `1/(l-1)` is at most one of them if `l` divides `unit`.
    scale: usize,
    /// The exponents of `l` in `unit` and in `elastic`.
    unit: i64,
    elastic: i64,
    /// The powers of `l` up to the largest `m + unit`.
    powers: Vec<i64>,
}

/// Largest scale: a finer one is worth little.
const FINEST: u64 = 12;

impl Local {
    fn new(lattice: Lattice, prime: u64, damping_order: usize, terms: usize) -> Self {
        let largest = lattice.elastic as u64 * terms as u64 + lattice.damping as u64 * damping_order as u64;
        let power = |&power: &u64| power <= largest + lattice.unit as u64;
        let powers = std::iter::successors(Some(prime), |power| power.checked_mul(prime)).take_while(power);
        let unit = valuation(lattice.unit, prime);
        Self {
            lattice,
            prime,
            terms,
            scale: if unit == 0 { 1 } else { (prime - 1).min(FINEST) as usize },
            unit,
            elastic: valuation(lattice.elastic, prime),
            powers: powers.map(|power| power as i64).collect(),
        }
    }

    /// `N_0 .. N_N`.
    fn orders(&self, damping_order: usize) -> Vec<Least> {
        let mut orders = vec![self.undamped()];
        let mut steps: Vec<Least> = Vec::with_capacity(damping_order);
        for n in 1..=damping_order {
            steps.push(self.step(n, &orders[n - 1]));
            let pairs = steps.iter().zip(orders.iter().rev());
            orders.push(self.largest_sum(pairs));
        }
        orders
    }

    /// `E`: the largest sum of weights whose indices add up to at most `j`.
    ///
    /// Where the prime divides neither `unit` nor `elastic`, only indices count at which it divides `unit + elastic k`: elsewhere a
    /// weight is not positive, or, for 2 and even `k`, below `k`, while index 1 weighs at least 1.
    fn undamped(&self) -> Least {
        let mut items: Vec<(usize, usize)> = Vec::new();
        let mut offer = |k: usize| {
            let weight = usize::try_from(self.weight(k)).unwrap_or(0);
            // One that comes later and weighs no more is never better.
            if weight > items.last().map_or(0, |&(_, heaviest)| heaviest) {
                items.push((k, weight));
            }
        };
        if (self.unit, self.elastic) != (0, 0) {
            (1..self.terms).for_each(&mut offer);
        } else if let Some(Indices { first, period }) = self.indices(self.prime as i64, self.lattice.unit) {
            (first..self.terms).step_by(period).for_each(&mut offer);
        }
        let mut least = vec![0u32];
        loop {
            let sum = |&(k, weight): &(usize, usize)| k + least[least.len().saturating_sub(weight)] as usize;
            match items.iter().map(sum).min() {
                Some(next) if next < self.terms => least.push(next as u32),
                _ => return least,
            }
        }
    }

    /// `w(k) scale`: what the coefficient of `x^((a+1) k)` in `phi` or in the velocity costs.
    fn weight(&self, k: usize) -> i64 {
        let Lattice { elastic, unit, .. } = self.lattice;
        let (scale, count) = (self.scale as i64, k as i64);
        // C(2k,k)/2^k (unit/elastic)^k, Kummer: as many powers as there are carries.
        let carries: i64 = self.powers.iter().map(|power| 2 * count / power - count / power * 2).sum();
        let mut common = count * (self.elastic - self.unit) - carries;
        if self.prime == 2 {
            common += count;
        }
        let position = common + valuation(unit + elastic * count, self.prime) - self.unit;
        if self.unit == 0 {
            return position;
        }
        let velocity = common + valuation(2 * count - 1, self.prime);
        (scale * (position + self.unit) + 1).max(scale * velocity)
    }

    /// `U_n`: one division by `m` or `m + unit` after order `n - 1`.
    fn step(&self, n: usize, before: &Least) -> Least {
        let shift = self.lattice.damping * n as i64;
        let of_power = |(&power, gain): (&i64, usize)| {
            let indices = |shift| self.indices(power, shift).map(|indices| (gain * self.scale, indices));
            [indices(shift), indices(shift + self.lattice.unit)]
        };
        let events: Vec<(usize, Indices)> =
            self.powers.iter().zip(1..).flat_map(of_power).flatten().collect();
        let cost = self.elastic as usize * self.scale + usize::from(self.unit > 0);
        let known = |t: usize| before.get(t).map(|&j| j as usize);
        let mut least = vec![0u32];
        loop {
            let t = least.len();
            let plain = known(t.saturating_sub(cost));
            let at = |(gain, indices): &(usize, Indices)| {
                known(t.saturating_sub(cost + gain)).map(|from| indices.from(from))
            };
            match events.iter().filter_map(at).chain(plain).min() {
                Some(next) if next < self.terms => least.push(next as u32),
                _ => return least,
            }
        }
    }

    /// The largest sum of the two of any pair at indices that add up to at most `j`.
    fn largest_sum<'a>(&self, pairs: impl Iterator<Item = (&'a Least, &'a Least)> + Clone) -> Least {
        let len = pairs.clone().map(|(a, b)| a.len() + b.len() - 1).max().unwrap_or(1);
        let mut least = vec![u32::MAX; len];
        for (a, b) in pairs {
            for (t, &first) in a.iter().enumerate() {
                // Beyond this one sums only grow.
                let within = b.partition_point(|&second| ((first + second) as usize) < self.terms);
                for (sum, &second) in least[t..].iter_mut().zip(&b[..within]) {
                    *sum = (*sum).min(first + second);
                }
            }
        }
        let mut next = u32::MAX;
        for j in least.iter_mut().rev() {
            next = next.min(*j);
            *j = next;
        }
        least.truncate(least.partition_point(|&j| (j as usize) < self.terms));
        least
    }

    /// The indices `j` at which `elastic j + shift` is a multiple of a power.
    fn indices(&self, power: i64, shift: i64) -> Option<Indices> {
        let gcd = num_integer::Integer::extended_gcd(&self.lattice.elastic, &power);
        if shift % gcd.gcd != 0 {
            return None;
        }
        let period = power / gcd.gcd;
        let first = (i128::from(gcd.x) * i128::from(-shift / gcd.gcd)).rem_euclid(i128::from(period));
        Some(Indices { first: usize::try_from(first).ok()?, period: usize::try_from(period).ok()? })
    }
}

/// `first`, `first + period`, ...
struct Indices {
    first: usize,
    period: usize,
}

impl Indices {
    /// The least that is not below `j`.
    fn from(&self, j: usize) -> usize {
        self.first + j.saturating_sub(self.first).div_ceil(self.period) * self.period
    }
}

/// How often a prime divides a number that is not zero.
fn valuation(mut number: i64, prime: u64) -> i64 {
    let mut times = 0;
    while number % prime as i64 == 0 {
        number /= prime as i64;
        times += 1;
    }
    times
}

/// The primes that divide an exponent's unit, `elastic`, or any `m` or `m + unit`, and 2: no other has a weight or an event.
fn primes_of_all(lattice: Lattice, damping_order: usize, terms: usize) -> Vec<u64> {
    let Lattice { elastic, damping, unit } = lattice;
    let orders = 0..=damping_order as i64;
    let indices = orders.flat_map(|n| (0..terms as i64).map(move |j| elastic * j + damping * n));
    let numbers = [2, unit, elastic].into_iter().chain(indices.flat_map(|m| [m, m + unit]));
    let numbers = numbers.filter(|&number| number > 0).map(|number| number as u64);
    let largest = numbers.clone().max().unwrap_or(0);
    let mut small: Vec<(u64, bool)> = primes_up_to(largest.isqrt()).map(|prime| (prime, false)).collect();
    let mut primes = Vec::new();
    for number in numbers {
        let mut rest = number;
        for (prime, divides) in &mut small {
            if prime.pow(2) > rest {
                break;
            }
            while rest.is_multiple_of(*prime) {
                rest /= *prime;
                *divides = true;
            }
        }
        // Nothing or a prime.
        primes.push(rest);
    }
    primes.extend(small.into_iter().filter_map(|(prime, divides)| divides.then_some(prime)));
    primes.sort_unstable();
    primes.dedup();
    primes.retain(|&prime| prime > 1);
    primes
}

/// The sieve of Eratosthenes.
fn primes_up_to(limit: u64) -> impl Iterator<Item = u64> {
    let limit = usize::try_from(limit).unwrap_or(usize::MAX - 1);
    let mut composite = vec![false; limit + 1];
    for i in (2..).take_while(|i| i * i <= limit) {
        if !composite[i] {
            (i * i..=limit).step_by(i).for_each(|multiple| composite[multiple] = true);
        }
    }
    (2..=limit).filter(move |&i| !composite[i]).map(|i| i as u64)
}

#[cfg(test)]
mod tests;
