//! Hard cases of the expansion: docs/stability.md has their figures.

use crate::numbers::{law, ratio};
use crate::support::cases;
use num_rational::BigRational;
use num_traits::Zero;
use restitution_direct::{Collision, End};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{Quantity, SeriesError, Trajectories, coefficients, turning_time};

fn restitution(law: &ForceLaw, order: usize, digits: usize) -> Vec<Ball> {
    coefficients(Quantity::Restitution, law, order, digits).expect("the expansion exists")
}

/// `C_0 + C_1 u + ...`
fn sum(coefficients: &[Ball], u: &BigRational) -> Ball {
    let u = Ball::from_rational(u, 300);
    coefficients.iter().rev().fold(Ball::zero(), |sum, c| sum * &u + c)
}

fn direct(law: &ForceLaw) -> Collision {
    Collision::new(law, End::ZeroCompression).expect("every law ends there")
}

/// Law, a damping small for it, the most bits of working precision that may be lost at order 8.
const LAWS: [(&str, &str, i64); 14] = [
    ("3/2,1/2", "1/10000", 54),
    ("3/2,501/1000", "1/10000", 55),
    ("3/2,499/1000", "1/10000", 55),
    ("1001/1000,0", "1/10000", 51),
    ("1001/1000,1/1000", "1/10000", 51),
    ("1/1000,0", "1/10000", 52),
    ("1/1000,999/1000", "1/10000", 59),
    ("3/2,-9/10", "1/100000", 62),
    ("3/2,-99/100", "1/1000000", 67),
    ("1,0", "1/10000", 48),
    ("3,0", "1/10000", 68),
    ("5,4", "1/10000", 74),
    ("12,11", "1/10000", 94),
    ("1/2,3", "1/10000", 74),
];

/// Direct integration shares no formula with the expansion; nine orders leave out about `C_9 u^9`.
#[test]
fn hard_laws_lose_few_bits_and_agree_with_direct_integration() {
    for (text, u, limit) in LAWS {
        let (law, u): (ForceLaw, BigRational) = (law(text), u.parse().expect("a fraction"));
        let c = restitution(&law, 8, 40);
        let lost = i64::from(c[8].prec()) - c[8].relative_bits().expect("a ball");
        println!("{text}: {lost} bits lost, C_8 = {:?}", c[8]);
        assert!(lost <= limit, "{text}: {lost} bits lost");
        let step = Ball::from_rational(&u, 300);
        let left_out = (&c[8] * &c[8] / &c[7] * step.powi(9)).abs_up();
        assert!(left_out < 1e-28, "{text}: {left_out}");
        let difference = sum(&c, &u) - direct(&law).epsilon(&u, 42).expect("digits");
        assert!(difference.abs_up() < left_out.clone() * 4 + 1e-40, "{text}: {difference:?} {left_out}");
    }
}

#[test]
fn a_law_and_its_neighbours_agree() {
    // Continuity in gamma at gamma = a - 1, where both forces share their powers: the mean of the
    // neighbours is off by the second difference.
    let c = |text| restitution(&law(text), 6, 20);
    let (below, at, above) = (c("3/2,4999/10000"), c("3/2,1/2"), c("3/2,5001/10000"));
    for k in 1..=6 {
        let middle = (&below[k] + &above[k]).shifted(-1);
        assert!((middle - &at[k]).abs_up() < 1e-7, "k = {k}");
        assert!((&below[k] - &above[k]).abs_down() > 1e-6, "k = {k}");
    }
}

/// Where `p = -1/m`, `C_2m` is zero: no enclosure shows that, and digits would be sought in vain.
#[test]
fn coefficients_that_vanish_are_exactly_zero() {
    // The last law has p = -3/7 and no such coefficient.
    for (text, order) in [("3,0", 4), ("2,0", 6), ("7,1", 4), ("5/2,0", 0)] {
        let law = law(text);
        let c = restitution(&law, 8, 45);
        for (k, c) in c.iter().enumerate() {
            assert_eq!(c.is_zero(), k == order && k > 0, "{text}, C_{k} = {c:?}");
        }
        // The direct method sees it: what remains of eps at u = 2^-20 has no term of that order.
        let u = ratio(1, 1 << 20);
        let difference = sum(&c, &u) - direct(&law).epsilon(&u, 50).expect("digits");
        assert!(difference.abs_up() < 1e-47, "{text}: {difference:?}");
    }
}

/// At the damping next to R = 1.38836... the terms hardly fall: they alternate and enclose the sum.
#[test]
fn partial_sums_next_to_the_radius_of_convergence_enclose_the_integrated_value() {
    const ORDER: usize = 60;
    let spheres = ForceLaw::viscoelastic_spheres();
    let c = restitution(&spheres, ORDER, 20);
    let u = ratio(138, 100);
    let epsilon = direct(&spheres).epsilon(&u, 25).expect("digits");
    let mut sums: Vec<Ball> = (0..=ORDER).map(|k| sum(&c[..=k], &u)).collect();
    for pair in sums.windows(2) {
        assert!((&pair[0] - &epsilon).is_positive() != (&pair[1] - &epsilon).is_positive(), "{pair:?}");
    }
    // Euler's means of neighbours: ten digits of a sum whose terms have fallen to 1/5 only.
    while sums.len() > 15 {
        sums = sums.windows(2).map(|pair| (&pair[0] + &pair[1]).shifted(-1)).collect();
    }
    let difference = sums.last().expect("sums") - &epsilon;
    assert!(difference.abs_up() < 1e-10, "{difference:?}");
}

#[test]
fn a_small_loss_has_all_its_digits_by_either_method() {
    let spheres = ForceLaw::viscoelastic_spheres();
    let c = restitution(&spheres, 4, 40);
    let u: BigRational = "1/1000000000000".parse().expect("a fraction");
    let loss = Ball::from_integer(1, 300) - sum(&c, &u);
    let integrated = direct(&spheres).one_minus_epsilon(&u, 12).expect("digits");
    assert_eq!(loss.to_digits(12), integrated.to_digits(12));
    assert_eq!(loss.to_digits(12).as_deref(), Some("1.15344885809e-12"));
}

#[test]
fn bits_are_lost_in_proportion_to_the_order() {
    let spheres = ForceLaw::viscoelastic_spheres();
    for order in [10, 20, 40, 80] {
        let c = &restitution(&spheres, order, 20)[order];
        let lost = i64::from(c.prec()) - c.relative_bits().expect("a ball");
        println!("order {order}: {lost} of {} bits lost", c.prec());
        // 42 bits once and less than a bit for each order: C_k itself falls by half a bit each.
        assert!(lost as f64 <= 46.0 + 0.9 * order as f64, "order {order}: {lost} bits lost");
    }
}

/// Sums at `T` and what they cancel: `log2(sum |q_(n,j)| T^e/|x_n(T)|)`, to `y_n` nothing more is lost.
#[test]
fn little_cancels_at_the_turning_point() {
    const BITS: u32 = 400;
    let spheres = ForceLaw::viscoelastic_spheres();
    let time = turning_time(&spheres, BITS);
    let trajectories = Trajectories::exact(&spheres, 20, 90);
    let y = coefficients(Quantity::Compression, &spheres, 20, 20).expect("the expansion exists");
    for (n, limit) in [(0, 1.2), (1, 1.6), (5, 2.6), (10, 3.8), (20, 6.1)] {
        // The terms of x_n(T) in units of T.
        let term = |(j, q): (usize, &BigRational)| {
            Ball::from_rational(q, BITS) * time.pow(&ratio((5 * j + 3 * n) as i64, 2))
        };
        let terms: Vec<Ball> =
            trajectories.coefficients(n).expect("derived").iter().enumerate().map(term).collect();
        let total = terms.iter().fold(Ball::zero(), |sum, q| sum + q);
        let size = terms.iter().fold(Ball::zero(), |sum, q| sum + q.abs());
        let bits = |x: &Ball| x.abs().to_f64().log2();
        let cancelled = bits(&size) - bits(&total);
        assert!(cancelled < limit, "n = {n}: {cancelled} bits");
        assert!(bits(&(total * &time)) < bits(&y[n]) + 0.1, "n = {n}");
    }
}

#[test]
fn what_cannot_be_expanded_is_said() {
    let message =
        |quantity, text| coefficients(quantity, &law(text), 2, 10).expect_err("no digits").to_string();
    insta::assert_snapshot!(message(Quantity::Restitution, "100000,1"), @"no error bound could be proved for the expansion of the law 100000,1: choose exponents A,GAMMA nearer to 3/2,1/2");
    insta::assert_snapshot!(message(Quantity::Restitution, "3/2,1000"), @"no error bound could be proved for the expansion of the law 3/2,1000: choose exponents A,GAMMA nearer to 3/2,1/2");
    insta::assert_snapshot!(message(Quantity::DelayedRecovery, "3/2,2"), @"with the law 3/2,2 the force vanishes at no small compression: the zero-force end needs A > GAMMA");
    let digits = 2_000_000;
    let error = coefficients(Quantity::Restitution, &law("3/2,1/2"), 1, digits).expect_err("too many digits");
    insta::assert_snapshot!(error.to_string(), @"2000000 digits could not be proved with 4000000 bits of working precision: ask for fewer digits");
}

#[test]
#[ignore = "slow: order 100, two minutes"]
fn order_100_reverses_in_time() {
    let c = restitution(&ForceLaw::viscoelastic_spheres(), 100, 30);
    crate::identities::assert_time_reversal(c, 1e-15);
}

/// Laws whose powers are large, and a damping at which six orders leave out little.
const LARGE_POWERS: [(&str, &str); 8] = [
    ("5,40", "1/10000000"),
    ("100,0", "1/10000"),
    ("20,60", "1/1000000"),
    ("20,1", "1/10000"),
    ("95,0", "1/10000"),
    ("120,0", "1/10000"),
    ("100,-1/2", "1/100000"),
    ("3/2,40", "1/100000"),
];

/// Their terms fall slowly and their powers have large norms; both are proved all the same.
#[test]
fn laws_of_large_powers_agree_with_direct_integration() {
    for (text, u) in LARGE_POWERS.iter().take(cases(2)) {
        let (law, u): (ForceLaw, BigRational) = (law(text), u.parse().expect("a fraction"));
        let c = restitution(&law, 6, 20);
        let left_out = (&c[6] * &c[6] / &c[5] * Ball::from_rational(&u, 300).powi(7)).abs_up();
        assert!(left_out < 1e-26, "{text}: {left_out}");
        // The digits of C_k that stand for u^k beyond these are not known.
        let unknown = (&c[1] * Ball::from_rational(&u, 300)).abs_up() * 1e-20;
        let difference = sum(&c, &u) - direct(&law).epsilon(&u, 42).expect("digits");
        assert!(difference.abs_up() < left_out * 4 + unknown + 1e-40, "{text}: {difference:?}");
    }
}

/// What no attempt could prove is refused without a search of half a minute.
#[test]
fn a_law_beyond_proof_is_refused() {
    for text in ["3/2,1000", "3/2,50", "1/2,60", "100000,1"] {
        let refused = coefficients(Quantity::Restitution, &law(text), 5, 20);
        assert!(matches!(refused, Err(SeriesError::Unproved { .. })), "{text}: {refused:?}");
    }
}
