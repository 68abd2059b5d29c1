//! The bound on the coefficients that sums leave out, against those coefficients.
//!
//! The truth is computed here from the equation of motion by J. C. P. Miller's recurrence for powers
//! of a series, in balls of 320 bits; the bound itself uses neither.

use crate::support::{cases, generator, in_snapshots};
use num_rational::BigRational;
use num_traits::{One, Zero};
use proptest::prelude::*;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{TailBound, TurningPointSum};
use rug::Float;
use std::fmt::Write;

const BITS: u32 = 320;
/// How many coefficients beyond the head are compared.
const NEXT: usize = 60;

type Rows = Vec<Vec<Ball>>;

/// `q_(n,j) T^e` for `n <= orders`, `j < terms`.
struct Truth {
    exponents: Rows,
    trajectory: Rows,
}

impl Truth {
    /// ```text
    /// (e+1) e q_(n,j) = -(e/(gamma+1)) (F^(gamma+1))_(n-1,j) - (F^a)_(n,j-1)
    /// ```
    fn new(law: &ForceLaw, orders: usize, terms: usize) -> Self {
        let time = turning_time(law);
        let (elastic, damping) = (time.pow(&law.elastic_step()), time.pow(&law.damping_step()));
        let damping = damping / ball(&law.damping_step());
        let zeros = || vec![vec![Ball::zero(); terms]; orders + 1];
        let exponents = |n| (0..terms).map(|j| ball(&exponent(law, n, j))).collect();
        let mut truth = Self { exponents: (0..=orders).map(exponents).collect(), trajectory: zeros() };
        let (mut elastic_power, mut damping_power) = (zeros(), zeros());
        for n in 0..=orders {
            for j in 0..terms {
                let exponent = truth.exponents[n][j].clone();
                let mut force = Ball::zero();
                if j > 0 {
                    force += &elastic * &elastic_power[n][j - 1];
                }
                if n > 0 {
                    force += &damping * &exponent * &damping_power[n - 1][j];
                }
                truth.trajectory[n][j] = match (n, j) {
                    (0, 0) => Ball::from_integer(1, BITS),
                    _ => -(force / &exponent / (&exponent + Ball::from_integer(1, BITS))),
                };
                elastic_power[n][j] = truth.next_of_power(law.a(), &elastic_power, n, j);
                damping_power[n][j] = truth.next_of_power(&law.damping_step(), &damping_power, n, j);
            }
        }
        truth
    }

    /// `e (F^p)_e = sum_(e1 > 0) (p e1 - (e - e1)) q_(e1) (F^p)_(e - e1)`.
    fn next_of_power(&self, power: &BigRational, known: &Rows, n: usize, j: usize) -> Ball {
        if (n, j) == (0, 0) {
            return Ball::from_integer(1, BITS);
        }
        let (mut sum, power) = (Ball::zero(), ball(power));
        for m in 0..=n {
            for i in 0..=j {
                if (m, i) != (0, 0) {
                    let weight = &power * &self.exponents[m][i] - &self.exponents[n - m][j - i];
                    sum += weight * &self.trajectory[m][i] * &known[n - m][j - i];
                }
            }
        }
        sum / &self.exponents[n][j]
    }

    /// A lower bound of the next [`NEXT`] terms of a sum at the turning point.
    fn tail_down(&self, sum: TurningPointSum, n: usize, terms: usize) -> Float {
        let term = |j: usize| match sum {
            TurningPointSum::Position => self.trajectory[n][j].abs(),
            TurningPointSum::Velocity => self.trajectory[n][j].abs() * (&self.exponents[n][j] + Ball::one()),
        };
        (terms..terms + NEXT).fold(Ball::zero(), |total, j| total + term(j)).abs_down()
    }

    /// How far the bounds lie above the truth: the least of bound/truth over all coefficients and
    /// tails, and the largest over the tails. (A single coefficient can be small by accident.)
    fn slack(&self, bound: &TailBound, starts: &[usize]) -> (f64, f64) {
        let ratio = |bound: Float, truth: Float| Float::with_val(53, bound / truth).to_f64();
        let (mut least, mut largest) = (f64::INFINITY, 0.0f64);
        for (n, row) in self.trajectory.iter().enumerate() {
            // A coefficient that vanishes exactly is bounded by anything.
            let coefficients = row.iter().map(Ball::abs_down).enumerate().filter(|(_, q)| *q > 0);
            least = coefficients.map(|(j, q)| ratio(bound.coefficient_up(n, j), q)).fold(least, f64::min);
            for &terms in starts {
                for sum in [TurningPointSum::Position, TurningPointSum::Velocity] {
                    let bound = bound.tail_at_turning_point(sum, n, terms);
                    let slack = ratio(bound, self.tail_down(sum, n, terms));
                    (least, largest) = (least.min(slack), largest.max(slack));
                }
            }
        }
        (least, largest)
    }
}

fn ball(x: &BigRational) -> Ball {
    Ball::from_rational(x, BITS)
}

fn exponent(law: &ForceLaw, n: usize, j: usize) -> BigRational {
    let times = |step: BigRational, count: usize| step * BigRational::from_integer(count.into());
    times(law.elastic_step(), j) + times(law.damping_step(), n)
}

/// `T` as twice the integral that gives the maximal compression, in gamma functions (A16).
fn turning_time(law: &ForceLaw) -> Ball {
    let half = BigRational::new(1.into(), 2.into());
    let root = law.elastic_step().recip();
    let gamma = |x: &BigRational| ball(x).gamma();
    let beta = gamma(&root) * gamma(&half) / gamma(&(&root + &half));
    (ball(&law.elastic_step()) / Ball::from_integer(2, BITS)).pow(&root) * beta / ball(&law.elastic_step())
}

fn law(text: &str) -> ForceLaw {
    text.parse().expect("a force law")
}

#[test]
fn every_coefficient_of_spheres_is_bounded() {
    let spheres = ForceLaw::viscoelastic_spheres();
    let bound = TailBound::find(&spheres, 4).expect("spheres are bounded");
    let terms = bound.checked_terms() + NEXT;
    let truth = Truth::new(&spheres, 4, terms + NEXT);
    let (least, largest) = truth.slack(&bound, &[0, 7, 40, bound.checked_terms(), terms]);
    assert!(least >= 1.0, "bound/truth falls to {least}");
    // Twelve decimal digits are 17 terms of the series, at most, that need not have been summed.
    assert!(largest < 1e13, "bound/truth reaches {largest}");
}

/// What `docs/error-bounds.md`, section 7, shows.
#[test]
fn slack_of_spheres() {
    let spheres = ForceLaw::viscoelastic_spheres();
    let bound = TailBound::find(&spheres, 4).expect("spheres are bounded");
    let truth = Truth::new(&spheres, 4, 120 + NEXT);
    let mut text = String::from(
        "velocity sums of spheres: what J terms leave out\nn  J    bound    truth    bound/truth\n",
    );
    for n in 0..=4 {
        for terms in [20, 41, 60, 80, 120] {
            let bound = bound.tail_at_turning_point(TurningPointSum::Velocity, n, terms).to_f64();
            let truth = truth.tail_down(TurningPointSum::Velocity, n, terms).to_f64();
            writeln!(text, "{n}  {terms:3}  {bound:.1e}  {truth:.1e}  {:.1e}", bound / truth).expect("text");
        }
    }
    in_snapshots("bounds", || insta::assert_snapshot!("slack", text));
}

#[test]
fn enclosed_coefficients_are_bounded_to_the_last_bit_of_a_radius() {
    let spheres = ForceLaw::viscoelastic_spheres();
    let bound = TailBound::find(&spheres, 2).expect("spheres are bounded");
    for (n, row) in Truth::new(&spheres, 2, 30).trajectory.iter().enumerate() {
        for (j, q) in row.iter().enumerate() {
            let slack = bound.coefficient_up(n, j) / q.abs_down();
            assert!((1.0..1.0 + 1e-8).contains(&slack), "{n} {j} {slack}");
        }
    }
}

#[test]
fn as_many_terms_as_are_asked_for_suffice() {
    let bound = TailBound::find(&ForceLaw::viscoelastic_spheres(), 12).expect("spheres are bounded");
    for bits in [1, 100, 400, 3400] {
        let terms = bound.terms_for(bits);
        let below = |terms| {
            (0..=12).all(|n| {
                let tail = bound.tail_at_turning_point(TurningPointSum::Velocity, n, terms);
                tail < Float::with_val(32, 1) >> i32::try_from(bits).expect("few bits")
            })
        };
        assert!(below(terms) && !below(terms - 1), "{bits} bits, {terms} terms");
        // The singularity at 2T allows no more than 5/2 bits a term.
        assert!(terms as f64 <= 15.0 + f64::from(bits) / 2.34, "{bits} bits, {terms} terms");
    }
}

#[test]
fn laws_at_the_edge_are_bounded_or_refused() {
    for text in ["1,0", "1001/1000,0", "3/2,-99/100", "1/500000,-499999/500000", "3,2", "5,4", "3/2,7"] {
        let law = law(text);
        let bound = TailBound::find(&law, 2).expect("a bound");
        assert!(bound.ratio() > 1.0, "{text}");
        let truth = Truth::new(&law, 2, bound.checked_terms() + 20 + NEXT);
        let (least, _) = truth.slack(&bound, &[bound.checked_terms(), bound.checked_terms() + 20]);
        assert!(least >= 1.0, "{text}: bound/truth falls to {least}");
    }
    let error = TailBound::find(&law("100000,1"), 1).expect_err("no bound");
    insta::assert_snapshot!(error.to_string(), @"no convergence beyond the turning point could be proved for the law 100000,1 with 320 leading terms: choose exponents A,GAMMA nearer to 3/2,1/2");
}

#[test]
fn random_laws_are_bounded() {
    let fraction = |n: i64, d: i64| BigRational::new(n.into(), d.into());
    let input = (1i64..36, -7i64..20, 0usize..4, 0usize..80);
    let test = |(a, gamma, orders, start): (i64, i64, usize, usize)| {
        let law = ForceLaw::new(fraction(a, 12), fraction(gamma, 8)).expect("a > 0 and gamma > -1");
        let bound = TailBound::find(&law, orders).expect("a < 3 leaves room beyond the turning point");
        let truth = Truth::new(&law, orders, 80 + NEXT);
        let (least, largest) = truth.slack(&bound, &[start]);
        prop_assert!(least >= 1.0, "{law}: bound/truth falls to {least}");
        // For a = 1 the truth at order 0 is the sine, which has no singularity.
        prop_assert!(largest < 1e15 || a == 12, "{law}: bound/truth reaches {largest}");
        Ok(())
    };
    generator(9, cases(12)).run(&input, test).expect("bounds");
}
