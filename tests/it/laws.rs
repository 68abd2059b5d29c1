//! The equation of motion itself, written with the operations of series and nothing of the appendix.

use crate::numbers::{law, ratio};
use crate::support::{cases, generator};
use num_rational::BigRational;
use num_traits::{One, Zero};
use proptest::prelude::*;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{FractionalSeries as Series, Trajectories};

/// Bits of the balls that a long recurrence is checked in; it loses two for each term.
const BITS: u32 = 800;

/// The powers `F^p = sum_n u^n P_n` of `F = x/t = sum_n u^n F_n`, by Miller's formula in `u`.
///
/// ```text
/// n F_0 P_n = sum_(i=1..n) (p i - (n - i)) F_i P_(n-i)
/// ```
fn powers(shapes: &[Series], exponent: &BigRational) -> Vec<Series> {
    let inverse = shapes[0].recip().expect("F_0 begins with 1");
    let mut powers = vec![shapes[0].power(exponent).expect("F_0 begins with 1")];
    for n in 1..shapes.len() {
        let term = |i: usize| {
            let weight = exponent * ratio(i as i64, 1) - ratio((n - i) as i64, 1);
            let product = shapes[i].multiply(&powers[n - i]).expect("one unit");
            let scaled = product.coefficients().iter().map(|c| c * &weight).collect();
            Series::new(product.unit(), scaled)
        };
        let sum = (2..=n).fold(term(1), |sum, i| sum.add(&term(i)).expect("one unit"));
        powers.push(sum.multiply(&inverse).expect("one unit").scaled(1, n as i64));
    }
    powers
}

/// `t^steps/unit` times a series.
fn shifted(series: &Series, steps: i64) -> Series {
    let zeros = std::iter::repeat_with(BigRational::zero).take(steps as usize);
    Series::new(series.unit(), zeros.chain(series.coefficients().iter().cloned()).collect())
}

/// `x'' + u x^gamma x' + x^a` at `u^n`, where `x^gamma x' = (x^(gamma+1))'/(gamma+1)`.
fn residuals(law: &ForceLaw, trajectories: &[Series]) -> Vec<Series> {
    let lattice = law.lattice();
    let shape = |x: &Series| Series::new(x.unit(), x.coefficients()[x.unit() as usize..].to_vec());
    let shapes: Vec<Series> = trajectories.iter().map(shape).collect();
    let (elastic, friction) = (powers(&shapes, law.a()), powers(&shapes, &law.damping_step()));
    let residual = |n: usize| {
        let acceleration = trajectories[n].derivative().and_then(|v| v.derivative()).expect("no pole");
        let sum = acceleration.add(&shifted(&elastic[n], lattice.elastic - lattice.unit)).expect("one unit");
        if n == 0 {
            return sum;
        }
        let drag = shifted(&friction[n - 1], lattice.damping).derivative().expect("no pole");
        sum.add(&drag.scaled(lattice.unit, lattice.damping)).expect("one unit")
    };
    (0..trajectories.len()).map(residual).collect()
}

fn trajectories(text: &str, damping_order: usize, terms: usize) -> Vec<Series> {
    let exact = Trajectories::exact(&law(text), damping_order, terms);
    (0..=damping_order).map(|n| exact.order_n(n).expect("derived")).collect()
}

fn assert_solved(text: &str, damping_order: usize, terms: usize) {
    let trajectories = trajectories(text, damping_order, terms);
    let residuals = residuals(&law(text), &trajectories);
    for (n, (x, residual)) in trajectories.iter().zip(&residuals).enumerate() {
        // Two derivatives cost two powers of t; everything else is known further.
        assert_eq!(residual.order(), x.order() - 2 * x.unit() as usize, "{text}, n = {n}");
        assert_eq!(residual.valuation(), residual.order(), "{text}, n = {n}: {residual}");
    }
}

#[test]
fn trajectories_of_spheres_solve_the_equation_of_motion_to_order_12() {
    assert_solved("3/2,1/2", 12, 9);
}

#[test]
fn trajectories_of_other_laws_solve_the_equation_of_motion() {
    assert_solved("2,1", 8, 8);
    assert_solved("5/3,1/4", 5, 5);
    assert_solved("1,0", 6, 12);
}

#[test]
fn trajectories_modulo_primes_solve_the_equation_of_motion() {
    assert_solved("3/2,1/2", 3, 30);
}

#[test]
fn a_wrong_coefficient_is_noticed() {
    let mut trajectories = trajectories("3/2,1/2", 2, 4);
    let mut wrong = trajectories[1].coefficients().to_vec();
    let place = wrong.iter().rposition(|c| !c.is_zero()).expect("x_1 is not zero");
    wrong[place] += ratio(1, 1_000_000_000);
    trajectories[1] = Series::new(2, wrong);
    let residuals = residuals(&law("3/2,1/2"), &trajectories);
    assert_eq!(residuals[0].valuation(), residuals[0].order());
    assert!(residuals[1].valuation() < residuals[1].order());
}

/// Time order 500: the exact coefficients against the recurrence of the equation, in balls.
#[test]
fn two_hundred_terms_solve_the_recurrence() {
    const TERMS: usize = 200;
    let spheres = ForceLaw::viscoelastic_spheres();
    let exact = Trajectories::exact(&spheres, 1, TERMS);
    assert_eq!(exact.exponent(0, TERMS - 1), num_rational::Ratio::new(997, 2));
    let balls = |n| -> Vec<Ball> {
        exact.coefficients(n).expect("derived").iter().map(|q| Ball::from_rational(q, BITS)).collect()
    };
    let q = [balls(0), balls(1)];
    let force = miller(&q, (3, 2));
    for n in 0..2 {
        for j in usize::from(n == 0)..TERMS {
            let e = Ball::from_integer((5 * j + 3 * n) as i64, BITS).shifted(-1);
            let mut pull = if j > 0 { force[n][j - 1].clone() } else { Ball::zero() };
            if n == 1 {
                pull += &force[0][j] * &e * Ball::from_ratio(2, 3, BITS);
            }
            let acceleration = (&e + Ball::one()) * &e * &q[n][j];
            let residual = &acceleration + &pull;
            assert!(residual.contains_zero(), "n = {n}, j = {j}: {residual:?}");
            assert!(*residual.rad() < acceleration.abs_down() >> 200, "n = {n}, j = {j}: {residual:?}");
        }
    }
    assert!(exact.coefficients(0).expect("derived")[TERMS - 1].denom().bits() > 3000);
}

/// `(F^p)_(n,j)` for `n < 2`: `e (F^p)_e = sum (p e1 - (e - e1)) q_(e1) (F^p)_(e - e1)`.
fn miller(q: &[Vec<Ball>; 2], (numerator, denominator): (i64, i64)) -> [Vec<Ball>; 2] {
    let grade = |n: usize, j: usize| (5 * j + 3 * n) as i64;
    let mut power = [Vec::new(), Vec::new()];
    for n in 0..2 {
        for j in 0..q[0].len() {
            let mut sum = Ball::zero();
            for m in 0..=n {
                for i in 0..=j {
                    if (m, i) != (0, 0) {
                        let (e1, rest) = (grade(m, i), grade(n - m, j - i));
                        let weight = Ball::from_ratio(numerator * e1 - denominator * rest, denominator, BITS);
                        sum += weight * &q[m][i] * &power[n - m][j - i];
                    }
                }
            }
            let next = if (n, j) == (0, 0) {
                Ball::from_integer(1, BITS)
            } else {
                sum / Ball::from_integer(grade(n, j), BITS)
            };
            power[n].push(next);
        }
    }
    power
}

/// `q_(n,j)` by the recurrence of their equation, powers by Miller's formula in both variables at once:
///
/// ```text
/// (e+1) e q_(n,j) = -e/(gamma+1) (F^(gamma+1))_(n-1,j) - (F^a)_(n,j-1),   e = (a+1) j + (gamma+1) n
/// ```
fn recurrence(law: &ForceLaw, orders: usize, terms: usize) -> Vec<Vec<BigRational>> {
    let (elastic, damping) = (law.elastic_step(), law.damping_step());
    let grade = |n: usize, j: usize| &elastic * ratio(j as i64, 1) + &damping * ratio(n as i64, 1);
    let mut q = vec![vec![BigRational::one()]];
    let exponents = [law.a().clone(), damping.clone()];
    let mut powers = [vec![vec![BigRational::one()]], vec![vec![BigRational::one()]]];
    for (n, j) in (0..=orders).flat_map(|n| (0..terms).map(move |j| (n, j))).skip(1) {
        let e = grade(n, j);
        let pull = if j > 0 { powers[0][n][j - 1].clone() } else { BigRational::zero() };
        let drag = if n > 0 { &powers[1][n - 1][j] * &e / &damping } else { BigRational::zero() };
        q.resize(n + 1, Vec::new());
        q[n].push(-(pull + drag) / (&e * (&e + BigRational::one())));
        for (power, exponent) in powers.iter_mut().zip(&exponents) {
            power.resize(n + 1, Vec::new());
            let mut sum = BigRational::zero();
            for (m, i) in (0..=n).flat_map(|m| (0..=j).map(move |i| (m, i))).skip(1) {
                let first = grade(m, i);
                sum += (exponent * &first - (&e - &first)) * &q[m][i] * &power[n - m][j - i];
            }
            power[n].push(sum / &e);
        }
    }
    q
}

/// The plain recurrence and the way through primes, for laws at random: were the denominators' bound no
/// multiple of the true denominators, or the bound on sizes too small, some fraction would differ.
#[test]
fn exact_trajectories_of_random_laws_are_those_of_plain_fractions() {
    // Denominators 2 to 8; gamma up to 2 a, beyond which plain fractions grow too fast to compare with.
    let input =
        (1i64..5, 2i64..13, -3i64..9, 0usize..3).prop_filter_map("a force law", |(d, a, gamma, order)| {
            let law = ForceLaw::new(ratio(a, 2 * d), ratio(gamma, 2 * d)).ok()?;
            (gamma <= 2 * a).then_some((law, order))
        });
    let test = |(law, order): (ForceLaw, usize)| {
        let modular = Trajectories::exact(&law, order, 28);
        for (n, plain) in recurrence(&law, order, 28).iter().enumerate() {
            prop_assert_eq!(modular.coefficients(n).expect("derived"), plain, "{} {}", &law, n);
        }
        Ok(())
    };
    generator(12, cases(8)).run(&input, test).expect("equal fractions");
}
