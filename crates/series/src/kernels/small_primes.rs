//! Which small primes divide long integers, and how often.

use super::digits::{DIGIT_MASK, Digits, ROWS};
use super::lanes::{LANES, Lanes, each, turn, vectorised};
use rug::Integer;

/// Moduli are products of primes or powers of one, below it.
const LARGEST: u64 = 1 << 25;
/// Primes up to this one stand in moduli with as many powers as fit, larger ones once, with others.
const OFTEN: u64 = 64;
/// Most primes of a modulus: `67 * 71 * 73 * 79 < 2^25`.
const SLOTS: usize = 4;

/// Primes below `2^32`, in the order in which they come into use.
///
/// All remainders of four integers by primes below `2^25` come from one pass over their digits, eight moduli at a time. Cost: less than a tenth of a
/// greatest common divisor with a product of the primes.
pub(crate) struct SmallPrimes {
    /// Prime and the largest exponent that is seen.
    primes: Vec<(u64, u32)>,
    /// Every prime's modulus.
    places: Vec<usize>,
    /// The primes that have none, since they are too large.
    large: Vec<usize>,
    /// `2^(32 k)` modulo all moduli.
    powers: Digits,
    moduli: Vec<Moduli>,
}

/// Eight moduli.
struct Moduli {
    modulus: Lanes,
    inverse: Lanes,
    /// `2^32` modulo them.
    radix: Lanes,
    /// Their primes, as numbers and by place in the list; where there is none the number is NaN, which divides nothing.
    slots: [(Lanes, [usize; LANES]); SLOTS],
}

/// A prime that divides an integer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Divisor {
    /// Which integer.
    pub row: usize,
    /// Which prime.
    pub place: usize,
    pub exponent: u32,
    /// Whether it may divide more often.
    pub open: bool,
}

impl SmallPrimes {
    /// Integers that are looked at together.
    pub const ROWS: usize = ROWS;

    /// For integers of at most so many 64-bit words.
    pub fn new(primes: &[u64], words: usize) -> Self {
        let seen = |&prime: &u64| if prime < OFTEN { (prime, LARGEST.ilog(prime)) } else { (prime, 1) };
        let primes: Vec<(u64, u32)> = primes.iter().map(seen).collect();
        let mut moduli: Vec<(u64, Vec<usize>)> = Vec::new();
        let mut places = Vec::with_capacity(primes.len());
        let mut large = Vec::new();
        let mut open = None;
        for (place, &(prime, exponent)) in primes.iter().enumerate() {
            if prime >= LARGEST {
                large.push(place);
                places.push(0);
                continue;
            }
            let shared = open.filter(|&last: &usize| exponent == 1 && moduli[last].0 * prime < LARGEST);
            let index = shared.unwrap_or(moduli.len());
            if shared.is_none() {
                moduli.push((1, Vec::new()));
            }
            if exponent == 1 {
                open = Some(index);
            }
            moduli[index].0 *= prime.pow(exponent);
            moduli[index].1.push(place);
            places.push(index);
        }
        let mut powers = Digits::zero(2 * words, moduli.len());
        for (i, (modulus, _)) in moduli.iter().enumerate() {
            let mut power = 1 % modulus;
            for digit in 0..powers.lines() {
                powers.block_mut(digit, i / LANES)[i % LANES] = power as u32;
                power = (power << 32) % modulus;
            }
        }
        let moduli = moduli.chunks(LANES).map(|moduli| Moduli::new(moduli, &primes)).collect();
        Self { primes, places, large, powers, moduli }
    }

    /// The prime of a place.
    pub fn prime(&self, place: usize) -> u64 {
        self.primes[place].0
    }

    /// The groups of moduli that the first `count` primes need.
    pub fn groups_of(&self, count: usize) -> Vec<usize> {
        let moduli = self.places[..count].iter().max().map_or(0, |last| last + 1);
        (0..moduli.div_ceil(LANES)).collect()
    }

    /// The one that a prime needs.
    pub fn group_of(&self, place: usize) -> usize {
        self.places[place] / LANES
    }

    /// Which primes of some groups of moduli divide up to [`ROWS`](Self::ROWS) integers, and how often, as far as it is seen.
    pub fn divisors(&self, integers: &[Integer], groups: &[usize]) -> Vec<Divisor> {
        let mut digits = Vec::new();
        for (row, integer) in integers.iter().enumerate() {
            let words = integer.to_digits::<u64>(rug::integer::Order::Lsf);
            digits.resize((2 * words.len()).max(digits.len()), [0; ROWS]);
            for (digits, word) in digits.as_chunks_mut::<2>().0.iter_mut().zip(words) {
                (digits[0][row], digits[1][row]) = (word & DIGIT_MASK, word >> 32);
            }
        }
        let mut divisors = Vec::new();
        find(self, &digits, integers.len(), groups, &mut divisors);
        divisors
    }

    /// Which of the first `count` primes, of those without a modulus, divide integers, and how often.
    pub fn large_divisors(&self, integers: &[Integer], count: usize) -> Vec<Divisor> {
        let of_place = |&place: &usize| {
            let prime = Integer::from(self.primes[place].0);
            let divisor = move |(row, integer): (usize, &Integer)| {
                let exponent = integer.clone().remove_factor_mut(&prime);
                (exponent > 0).then_some(Divisor { row, place, exponent, open: false })
            };
            integers.iter().enumerate().filter_map(divisor)
        };
        self.large.iter().take_while(|&&place| place < count).flat_map(of_place).collect()
    }

    /// The primes of one modulus that divide a remainder.
    fn of_remainder(
        &self,
        row: usize,
        places: impl Iterator<Item = usize>,
        remainder: i64,
        out: &mut Vec<Divisor>,
    ) {
        for place in places {
            let (prime, most) = self.primes[place];
            let mut rest = remainder;
            let mut exponent = 0;
            while exponent < most && rest % prime as i64 == 0 {
                rest /= prime as i64;
                exponent += 1;
            }
            if exponent > 0 {
                out.push(Divisor { row, place, exponent, open: exponent == most });
            }
        }
    }
}

impl Moduli {
    fn new(moduli: &[(u64, Vec<usize>)], primes: &[(u64, u32)]) -> Self {
        let modulus = each!(|l| moduli.get(l).map_or(1.0, |(modulus, _)| *modulus as f64));
        let slot = |slot: usize| {
            let place = |l: usize| moduli.get(l).and_then(|(_, places)| places.get(slot)).copied();
            let prime = each!(|l| place(l).map_or(f64::NAN, |place| primes[place].0 as f64));
            (prime, std::array::from_fn(|l| place(l).unwrap_or(0)))
        };
        Self {
            modulus,
            inverse: each!(|l| 1.0 / modulus.0[l]),
            radix: each!(|l| ((1u64 << 32) % modulus.0[l] as u64) as f64),
            slots: std::array::from_fn(slot),
        }
    }

    /// `x` modulo the moduli for `|x| <= 2^52`: an integer of at most the modulus, hence exact when fused.
    #[inline(always)]
    fn reduce(&self, x: Lanes) -> Lanes {
        each!(|l| {
            let q = (x.0[l] * self.inverse.0[l]).round_ties_even();
            q.mul_add(-self.modulus.0[l], x.0[l])
        })
    }

    /// Whether any of the primes divides a remainder: the rounded quotient is right if the true one is an integer.
    #[inline(always)]
    fn any(&self, remainder: Lanes) -> bool {
        let mut any = false;
        for (primes, _) in &self.slots {
            let rest = each!(|l| {
                let q = (remainder.0[l] / primes.0[l]).round_ties_even();
                q.mul_add(-primes.0[l], remainder.0[l])
            });
            for rest in rest.0 {
                any |= rest == 0.0;
            }
        }
        any
    }
}

vectorised! {
    fn find(small: &'a SmallPrimes, digits: &'a [[u64; ROWS]], rows: usize, groups: &'a [usize], out: &'a mut Vec<Divisor>) {
        for &block in groups {
            let moduli = &small.moduli[block];
            // Both parts are below 2^32 for every 128 digits.
            let sums = small.powers.multiply(digits, block);
            for row in 0..rows {
                turn();
                let high = moduli.reduce(Lanes::of(&sums.high[row]));
                let low = Lanes::of(&sums.low[row]);
                // Below 2^25 2^25 + 2^51.
                let remainder = moduli.reduce(each!(|l| high.0[l] * moduli.radix.0[l] + low.0[l]));
                if moduli.any(remainder) {
                    for l in 0..LANES {
                        let slots = moduli.slots.iter().filter(|(primes, _)| !primes.0[l].is_nan());
                        small.of_remainder(row, slots.map(|(_, places)| places[l]), remainder.0[l] as i64, out);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PRIMES: [u64; 28] = [
        7, 2, 3, 67, 101, 5, 61, 59, 71, 73, 79, 83, 1009, 1013, 11, 13, 17, 19, 33_554_393, 5807, 97, 103,
        4093, 23, 999_983, 107, 33_554_467, 98_765_431,
    ];

    /// Products of powers of the primes with a large one, and numbers next to them.
    #[test]
    fn exponents_are_those_of_the_factors() {
        let mut state = 1u64;
        let mut below = |limit: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % limit
        };
        let small = SmallPrimes::new(&PRIMES, 700);
        for case in 0..60 {
            let mut integers = Vec::new();
            for _ in 0..1 + below(4) {
                let mut integer: Integer = (Integer::from(1) << (below(20_000) as u32)) - 1;
                for prime in PRIMES {
                    for _ in 0..if below(2) == 0 { 0 } else { below(40) } {
                        integer *= prime;
                    }
                }
                integers.push(if below(2) == 0 { -integer } else { integer });
            }
            let count = if case == 0 { 0 } else { below(PRIMES.len() as u64 + 1) as usize };
            let mut found = small.divisors(&integers, &small.groups_of(count));
            found.extend(small.large_divisors(&integers, count));
            for (row, integer) in integers.iter().enumerate() {
                for (place, &prime) in PRIMES.iter().enumerate().take(count) {
                    let mut rest = integer.clone();
                    let exponent = rest.remove_factor_mut(&Integer::from(prime));
                    let seen = found.iter().filter(|d| (d.row, d.place) == (row, place)).collect::<Vec<_>>();
                    assert!(seen.len() <= 1);
                    let large = prime >= LARGEST;
                    let most = if large { u32::MAX } else { small.primes[place].1 };
                    let expected = exponent.min(most);
                    assert_eq!(seen.first().map_or(0, |d| d.exponent), expected, "{prime} {exponent}");
                    assert!(seen.iter().all(|d| d.open == (d.exponent == most)));
                }
            }
            assert!(found.iter().all(|d| d.row < integers.len() && integers[d.row].is_divisible_u(PRIMES[d.place] as u32)));
        }
    }

    /// Remainders that no prime of a group divides are not looked at again; primes of later groups and places are not named.
    #[test]
    fn only_what_divides_is_looked_at() {
        let small = SmallPrimes::new(&PRIMES, 10);
        for moduli in &small.moduli {
            assert!(!moduli.any(Lanes::splat(1.0)) && moduli.any(Lanes::ZERO));
            for (primes, _) in &moduli.slots {
                for prime in primes.0.into_iter().filter(|prime| !prime.is_nan()) {
                    assert!(moduli.any(Lanes::splat(-3.0 * prime)), "{prime}");
                }
            }
        }
        let last = *small.large.last().unwrap();
        let multiple = [Integer::from(PRIMES[last])];
        assert_eq!([last, last + 1].map(|count| small.large_divisors(&multiple, count).len()), [0, 1]);
    }
}
