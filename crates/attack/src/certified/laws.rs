//! Random laws, dampings and digits.

use crate::random::{Source, by_ratio, choose};
use num_bigint::BigInt;
use num_rational::BigRational;
use rand::RngExt;
use restitution_direct::End;
use restitution_law::ForceLaw;

/// Laws on the edge of something: a branch, a vanishing exponent, a neighbour of a special case.
const HARD: [&str; 28] = [
    "3/4,3/5",
    "3/4,7/10",
    "3/2,501/1000",
    "3/2,499/1000",
    "1001/1000,0",
    "1001/1000,1/1000",
    "1/1000,0",
    "1/10,1/20",
    "3/2,-9/10",
    "3/2,-99/100",
    "1,0",
    "3,0",
    "5,4",
    "12,11",
    "1/2,3",
    "9/4,2",
    "47/12,13/10",
    "7/3,5/6",
    "3,1/3",
    "1/50,1/10",
    "2,1/3",
    "1/4,1/5",
    "9,-13/100",
    "3/2,1/5",
    "1,1/7",
    "2,19/10",
    "2,2",
    "7/5,11/10",
];

/// A request for `epsilon(u)`.
#[derive(Clone, Debug)]
pub struct Request {
    /// The force law.
    pub law: ForceLaw,
    /// The damping.
    pub u: BigRational,
    /// Where the contact ends.
    pub end: End,
    /// Digits that are asked for.
    pub digits: usize,
}

impl std::fmt::Display for Request {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let end = if self.end == End::ZeroForce { "zero-force" } else { "zero-compression" };
        write!(f, "epsilon --u {} --law {} --end {end} --digits {}", self.u, self.law, self.digits)
    }
}

pub fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

/// A fraction between `low` and `high` with a denominator up to `largest`.
fn fraction(random: &mut Source, low: f64, high: f64, largest: i64) -> BigRational {
    let d = random.random_range(1..=largest);
    let end = |x: f64| (x * d as f64).round() as i64;
    ratio(random.random_range(end(low)..=end(high)), d)
}

/// A law of any kind.
pub fn law(random: &mut Source) -> ForceLaw {
    loop {
        let a = match random.random_range(0..6) {
            0 => fraction(random, 0.1, 8.0, 12),
            _ => fraction(random, 0.25, 4.0, 5),
        };
        let found = match random.random_range(0..20) {
            0..=6 => return ForceLaw::viscoelastic_spheres(),
            7..=9 => ForceLaw::new(a.clone(), a - ratio(1, 1)),
            10..=11 => ForceLaw::new(a.clone(), (a - ratio(1, 1)) / ratio(2, 1)),
            12..=14 => {
                let hard = *choose(random, &HARD);
                hard.parse()
            }
            15 => ForceLaw::new(a.clone(), a + fraction(random, -0.1, 0.1, 50)),
            _ => ForceLaw::new(a, fraction(random, -0.75, 3.0, 5)),
        };
        if let Ok(law) = found {
            return law;
        }
    }
}

/// A damping of any size.
pub fn damping(random: &mut Source) -> BigRational {
    let typed = |x: f64| {
        // Five digits, as people write them.
        let exponent = x.log10().floor() as i32 - 4;
        let digits = BigInt::from((x / 10f64.powi(exponent)).round() as i64);
        BigRational::from_integer(digits) * BigRational::from_integer(10.into()).pow(exponent)
    };
    match random.random_range(0..12) {
        0 => typed(by_ratio(random, 1e-30, 1e-3)),
        1 => typed(by_ratio(random, 10.0, 1e6)),
        2 => ratio(random.random_range(1..60), random.random_range(1..20)),
        3 => ratio(random.random_range(1..1_000_000), random.random_range(1..1_000_000)),
        4 => typed(by_ratio(random, 1e-3, 1e-1)),
        _ => typed(by_ratio(random, 1e-2, 10.0)),
    }
}

/// The largest damping that a law is asked for, by its exponent `p` of the velocity: beyond, where `epsilon ~ u^(-1/p)` is
/// far below what anybody measures, a request takes minutes or more steps than are allowed.
fn largest_damping(law: &ForceLaw) -> BigRational {
    let p = law.velocity_exponent();
    if p >= ratio(1, 5) {
        ratio(1_000_000, 1)
    } else if num_traits::Signed::abs(&p) >= ratio(1, 100) {
        ratio(10, 1)
    } else {
        ratio(2, 1)
    }
}

/// A request of any kind, small ones most often.
pub fn request(random: &mut Source) -> Request {
    let law = law(random);
    let largest = largest_damping(&law);
    let mut u = damping(random);
    if u > largest {
        u = largest / u;
    }
    let zero_force = law.a() > law.gamma() && random.random_bool(0.5);
    let end = if zero_force { End::ZeroForce } else { End::ZeroCompression };
    Request { u, end, digits: digits(random), law }
}

/// 5 to 60 digits, few most often.
pub fn digits(random: &mut Source) -> usize {
    match random.random_range(0..10) {
        0 if random.random_bool(0.3) => random.random_range(30..=60),
        0..=2 => random.random_range(15..=30),
        _ => random.random_range(5..=15),
    }
}
