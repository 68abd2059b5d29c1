//! A proved bound on the denominators of the trajectories' coefficients.

use restitution_law::Lattice;
use rug::Integer;

/// For every `(n, j)` a multiple of the denominators of `q_(n,i)`, `i <= j`, as a product of small factors.
///
/// In lattice units `m = elastic j + damping n = unit e` the recurrence reads
///
/// ```text
/// q_(n,j) = - unit^2/(m (m + unit)) (F^a)_(n,j-1) - unit^2/(damping (m + unit)) (F^(gamma+1))_(n-1,j)
/// ```
///
/// so `q_(n,j)` is a sum over trees of `n + j` nodes: a node `(n,j)` spends one unit of `j` or of `n`, its
/// children share the rest. Take a prime `l`.
///
/// * If `l` does not divide `unit`, binomial coefficients of `a` and `gamma + 1` are `l`-integers, and `l`
///   divides the denominator at most as often as nodes of a tree have `l^i | m + unit` or, where an elastic
///   unit was spent, `l^i | m`, counted for every `i`, besides the powers of `l` in `damping^n`.
///   [`Thresholds`] finds the least `j` at which a tree can have so many such nodes.
/// * If `l^d` is the power of `l` in `unit`, `d > 0`, a node with `k` children costs `l^(k (d + 1/(l-1)))`
///   more, in all less than `l^((n+j)(d + 1/(l-1)))`; its `unit^2` outweighs the powers up to `l^d` in `m` and
///   `m + unit`, so that only `i > d` count.
pub(super) struct Denominators {
    /// For every `n`: the pairs `(j, l)`, sorted, at which the bound gains a factor `l`.
    gains: Vec<Vec<(usize, u64)>>,
    /// The prime factors of `unit`, with `d`.
    ramified: Vec<(u64, u32)>,
    damping: u64,
}

impl Denominators {
    pub fn bound(lattice: Lattice, damping_order: usize, terms: usize) -> Self {
        let largest = lattice.elastic as u64 * terms as u64 + lattice.damping as u64 * damping_order as u64;
        let mut gains = vec![Vec::new(); damping_order + 1];
        let mut ramified = Vec::new();
        for prime in primes_up_to(largest + lattice.unit as u64) {
            let mut power = prime;
            let mut exponent = 0;
            while (lattice.unit as u64).is_multiple_of(power) {
                exponent += 1;
                power *= prime;
            }
            if exponent > 0 {
                ramified.push((prime, exponent));
            }
            while power <= largest + lattice.unit as u64 {
                let thresholds = Thresholds::find(lattice, power as i64, damping_order, terms);
                for (n, own) in gains.iter_mut().enumerate() {
                    own.extend(thresholds.up_to(n, terms).map(|j| (j, prime)));
                }
                power = power.saturating_mul(prime);
            }
        }
        gains.iter_mut().for_each(|own| own.sort_unstable());
        Self { gains, ramified, damping: lattice.damping as u64 }
    }

    /// Calls `visit(j, factor)` for the factors by which the bound of order `n` grows up to index `j`, in
    /// rising order of `j`, beginning with what belongs to `n` alone.
    pub fn growth(&self, n: usize, terms: usize, mut visit: impl FnMut(usize, u64)) {
        (0..n).for_each(|_| visit(0, self.damping));
        let mut gains = self.gains[n].iter().peekable();
        let mut spent = vec![0; self.ramified.len()];
        for j in 0..terms {
            while let Some((_, prime)) = gains.next_if(|(at, _)| *at <= j) {
                visit(j, *prime);
            }
            for ((prime, d), spent) in self.ramified.iter().zip(&mut spent) {
                // floor((n + j)(d + 1/(l - 1))) factors in all.
                let allowed = (n + j) as u64 * (u64::from(*d) * (prime - 1) + 1) / (prime - 1);
                while *spent < allowed {
                    visit(j, *prime);
                    *spent += 1;
                }
            }
        }
    }

    /// The bounds themselves for order `n`.
    pub fn multiples(&self, n: usize, terms: usize) -> Vec<Integer> {
        let mut product = Integer::from(1);
        let mut multiples: Vec<Integer> = Vec::with_capacity(terms);
        self.growth(n, terms, |j, factor| {
            while multiples.len() < j {
                multiples.push(product.clone());
            }
            product *= factor;
        });
        multiples.resize(terms, product);
        multiples
    }
}

/// The least index `j` at which a forest with at most `n` units of damping can have `t` events, where an
/// event is a node whose `m + unit` or (for an elastic node) `m` is a multiple of `power`.
struct Thresholds {
    /// `forests[n][t]`; never falls with `t`, never rises with `n`.
    forests: Vec<Vec<usize>>,
}

impl Thresholds {
    fn find(lattice: Lattice, power: i64, damping_order: usize, terms: usize) -> Self {
        let mut forests = vec![vec![0usize]; damping_order + 1];
        for t in 1.. {
            let mut row: Vec<usize> = Vec::with_capacity(damping_order + 1);
            for n in 0..=damping_order {
                let least = |from: usize, shift: i64| {
                    solve(lattice.elastic, -lattice.damping * n as i64 - shift, power).map(
                        |(residue, period)| {
                            let steps = from.saturating_sub(residue).div_ceil(period);
                            residue + steps * period
                        },
                    )
                };
                let elastic = forests[n][t - 1] + 1;
                let mut best =
                    least(elastic, 0).unwrap_or(terms).min(least(elastic, lattice.unit).unwrap_or(terms));
                if n > 0 {
                    let damped = least(forests[n - 1][t - 1], lattice.unit).unwrap_or(terms);
                    best = best.min(damped).min(row[n - 1]);
                }
                for part in 0..=n {
                    for i in 1..t {
                        best = best.min(forests[part][i] + forests[n - part][t - i]);
                    }
                }
                row.push(best.min(terms));
            }
            if row.iter().all(|&j| j >= terms) {
                break;
            }
            row.into_iter().zip(&mut forests).for_each(|(j, forest)| forest.push(j));
        }
        Self { forests }
    }

    fn up_to(&self, n: usize, terms: usize) -> impl Iterator<Item = usize> {
        self.forests[n].iter().skip(1).copied().filter(move |&j| j < terms)
    }
}

/// The least solution `j >= 0` of `a j = b mod power` and the distance of the solutions.
fn solve(a: i64, b: i64, power: i64) -> Option<(usize, usize)> {
    let gcd = num_integer::Integer::extended_gcd(&a, &power);
    if b % gcd.gcd != 0 {
        return None;
    }
    let period = power / gcd.gcd;
    let residue = i128::from(gcd.x) * i128::from(b / gcd.gcd) % i128::from(period);
    let residue = (residue + i128::from(period)) % i128::from(period);
    Some((usize::try_from(residue).ok()?, usize::try_from(period).ok()?))
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
