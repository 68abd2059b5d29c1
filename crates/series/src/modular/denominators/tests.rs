use super::*;
use crate::recurrence;
use num_traits::Zero;
use restitution_law::ForceLaw;
use restitution_real::convert::rug_integer;

/// The bits of the multiple and of the true denominator, which must divide it, at the last index of every order.
fn bits(law: &ForceLaw, damping_order: usize, terms: usize) -> Vec<(u32, u32)> {
    let bound = Denominators::bound(law.lattice(), damping_order, terms);
    let orders = recurrence::coefficients(law, damping_order, terms);
    let of_order = |(n, row): (usize, &Vec<_>)| {
        let multiples = bound.multiples(n, terms);
        let mut largest = Integer::from(1);
        for (j, (q, multiple)) in row.iter().zip(&multiples).enumerate() {
            let denominator = rug_integer(num_rational::BigRational::denom(q));
            assert!(multiple.is_divisible(&denominator), "{law} {n} {j}: {denominator} and {multiple}");
            largest.lcm_mut(&denominator);
        }
        (multiples[terms - 1].significant_bits(), largest.significant_bits())
    };
    orders.iter().enumerate().map(of_order).collect()
}

/// Laws whose exponents share primes with each other, with their denominators and with the damping in many ways.
#[test]
fn true_denominators_of_random_laws_divide() {
    let mut state = 1u64;
    let mut below = |limit: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 33) % limit) as i64
    };
    let times: usize = std::env::var("RESTITUTION_TEST_MULTIPLIER").map_or(1, |x| x.parse().unwrap_or(1));
    for case in 0..30 * times {
        let (p, r) = (1 + below(12), 1 + below(12));
        let (q, s) = (1 + below(30), below(30) - r + 1);
        let Ok(law) = format!("{q}/{p},{s}/{r}").parse::<ForceLaw>() else { continue };
        let (order, terms) = [(1, 16), (3, 9), (6, 5), (0, 24)][case % 4];
        bits(&law, order, terms);
    }
}

/// High orders in time and in the damping: multiples are close above, where whole trees gave a third too much.
#[test]
fn multiples_are_close_above_the_denominators() {
    for (law, order, terms, most) in [
        ("3/2,1/2", 1, 90, 1.12),
        ("3/2,1/2", 3, 40, 1.3),
        ("3/2,1/2", 12, 8, 1.35),
        ("5/3,1/4", 2, 24, 1.25),
        ("1,0", 2, 40, 1.7),
    ] {
        let law: ForceLaw = law.parse().unwrap();
        for (n, (multiple, denominator)) in bits(&law, order, terms).into_iter().enumerate() {
            assert!(
                f64::from(multiple) <= most * f64::from(denominator),
                "{law} {n}: {multiple} and {denominator}"
            );
        }
    }
}

/// Without damping, for primes that divide neither exponent nor 2, weights are what the coefficients of
/// `t = x phi(x^(a+1))` have, `phi_k = C(2k,k)/(2^k (1 + (a+1) k)) (unit/elastic)^k`.
#[test]
fn weights_are_the_exponents_of_the_inverse() {
    for (law, prime) in
        [("3/2,1/2", 7u64), ("3/2,1/2", 13), ("3/2,1/2", 3), ("3/2,1/2", 5), ("2,1", 2), ("5/3,2/3", 2)]
    {
        let law: ForceLaw = law.parse().unwrap();
        let lattice = law.lattice();
        let local = Local::new(lattice, prime, 0, 60);
        let mut coefficient = num_rational::BigRational::from_integer(1.into());
        let fraction = |p: i64, q: i64| num_rational::BigRational::new(p.into(), q.into());
        for k in 1..60i64 {
            coefficient *= fraction((2 * k - 1) * lattice.unit, k * lattice.elastic);
            let phi = &coefficient * fraction(lattice.unit, lattice.unit + lattice.elastic * k);
            assert!(!phi.is_zero());
            let exponent =
                |x: &num_bigint::BigInt| i64::from(rug_integer(x).remove_factor(&Integer::from(prime)).1);
            assert_eq!(
                local.weight(k as usize),
                exponent(phi.denom()) - exponent(phi.numer()),
                "{law} {prime} {k}"
            );
        }
    }
}

/// For primes that divide the unit the coefficients of the velocity, `psi_k = C(2k,k)/(2^k (2k - 1)) (unit/elastic)^k` in
/// `x' = 1 - sum_k psi_k x^((a+1) k)`, may be worse than those of the time, which there count by `unit phi_k` and one part more.
#[test]
fn weights_count_the_velocity_where_a_prime_divides_the_unit() {
    for (law, prime) in
        [("3/2,1/2", 2u64), ("4/3,1/3", 3), ("6/5,1/5", 5), ("10/9,1/9", 3), ("8/7,1/7", 7), ("5/4,1/4", 2)]
    {
        let law: ForceLaw = law.parse().unwrap();
        let lattice = law.lattice();
        let local = Local::new(lattice, prime, 2, 60);
        let fraction = |p: i64, q: i64| num_rational::BigRational::new(p.into(), q.into());
        let part = |x: &num_bigint::BigInt| i64::from(rug_integer(x).remove_factor(&Integer::from(prime)).1);
        let exponent = |x: &num_rational::BigRational| part(x.denom()) - part(x.numer());
        let mut coefficient = fraction(1, 1);
        for k in 1..60i64 {
            coefficient *= fraction((2 * k - 1) * lattice.unit, k * lattice.elastic);
            let time = exponent(&(&coefficient / fraction(lattice.unit + lattice.elastic * k, 1)));
            let velocity = exponent(&(&coefficient / fraction(2 * k - 1, 1)));
            let scale = local.scale as i64;
            assert_eq!(
                local.weight(k as usize),
                (scale * time + 1).max(scale * velocity),
                "{law} {prime} {k}"
            );
        }
    }
}

/// Theorem 7 written out, in parts of `1/scale` at every index, from the weights alone.
fn theorem_7(local: &Local, damping_order: usize) -> Vec<Vec<i64>> {
    let Lattice { elastic, damping, unit } = local.lattice;
    let scale = local.scale as i64;
    let mut undamped = vec![0; local.terms];
    for j in 1..local.terms {
        let with = |k: usize| undamped[j - k] + local.weight(k).max(0);
        undamped[j] = (1..=j).map(with).max().unwrap().max(undamped[j - 1]);
    }
    let mut orders = vec![undamped];
    let mut steps = vec![vec![0; local.terms]];
    for n in 1..=damping_order {
        let step = |j: usize| {
            let m = elastic * j as i64 + damping * n as i64;
            let divisions = valuation(m, local.prime).max(valuation(m + unit, local.prime));
            let part = i64::from(valuation(unit, local.prime) > 0);
            orders[n - 1][j] + scale * (valuation(elastic, local.prime) + divisions) + part
        };
        steps.push((0..local.terms).map(step).collect());
        let largest = |j: usize| {
            let of = |k: usize| {
                let pairs = (0..=j).flat_map(move |i| (0..=j - i).map(move |other| (i, other)));
                pairs.map(|(i, other)| steps[k][i] + orders[n - k][other]).max().unwrap()
            };
            (1..=n).map(of).max().unwrap()
        };
        let order = (0..local.terms).map(largest).collect();
        orders.push(order);
    }
    orders
}

/// Primes that divide the unit, `elastic`, both or neither of them; at every index and order, no more and no less.
#[test]
fn exponents_are_those_of_theorem_7() {
    for (law, primes) in [
        ("3/2,1/2", [2u64, 3, 5, 7]),
        ("5/4,1/3", [2, 3, 13, 11]),
        ("2,1", [2, 3, 5, 7]),
        ("11/3,-1/2", [2, 3, 7, 29]),
        ("7/2,5/4", [2, 3, 5, 17]),
        ("17/8,1/27", [2, 3, 5, 13]),
    ] {
        let law: ForceLaw = law.parse().unwrap();
        for prime in primes {
            let local = Local::new(law.lattice(), prime, 3, 28);
            let expected = theorem_7(&local, 3);
            for (n, (least, expected)) in local.orders(3).into_iter().zip(expected).enumerate() {
                let first = |value: i64| expected.iter().position(|&found| found >= value).unwrap() as u32;
                let expected: Vec<u32> = (0..=*expected.last().unwrap()).map(first).collect();
                assert_eq!(least, expected, "{law} {prime} {n}");
            }
        }
    }
}

#[test]
fn factors_of_one_index_are_multiplied_below_a_limit() {
    let largest = 1 << 49;
    assert_eq!(together(vec![(3, 5), (1, 7), (3, 2), (4, 3)]), [(1, 7), (3, 10), (4, 3)]);
    assert_eq!(together(vec![(2, 2); 60]), [(2, largest), (2, 1 << 11)]);
    assert_eq!(LARGEST_FACTOR, 2 * largest);
}

#[test]
fn primes_are_those_of_a_sieve() {
    for (law, order, terms) in [
        ("3/2,1/2", 3, 60),
        ("1,0", 0, 30),
        ("997/1009,5/7", 2, 40),
        ("47/12,13/10", 4, 30),
        ("1/2,1", 2, 14),
    ] {
        let Lattice { elastic, damping, unit } = law.parse::<ForceLaw>().unwrap().lattice();
        let largest = elastic * terms as i64 + damping * order as i64 + unit;
        let divides = |number: i64, prime: u64| number > 0 && number % prime as i64 == 0;
        let occurs = |&prime: &u64| {
            [2, unit, elastic].into_iter().any(|number| divides(number, prime))
                || (0..=order as i64).any(|n| {
                    (0..terms as i64)
                        .map(|j| elastic * j + damping * n)
                        .any(|m| divides(m, prime) || divides(m + unit, prime))
                })
        };
        let expected: Vec<u64> = primes_up_to(largest as u64).filter(occurs).collect();
        assert_eq!(primes_of_all(Lattice { elastic, damping, unit }, order, terms), expected, "{law}");
    }
}
