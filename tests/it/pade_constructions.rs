//! Two-point approximants, continued fractions, verdicts and balls, on cases known otherwise.

use crate::pade_series::{approximate_theory, cosine, exponential, generic, ints, lacunary, quotient, ratio};
use num_rational::BigRational;
use num_traits::{One, Zero};
use proptest::prelude::*;
use restitution_pade::{
    Approximant, AtInfinity, Bounds, Interval, PadeError, PadeType, RationalFunction, Trend, approximant,
    table_one, two_point, verdict, with_precision, zeros,
};
use restitution_real::{Ball, Balls, OrderedField, Rationals};

fn balls(series: &[BigRational], bits: u32) -> Vec<Ball> {
    series.iter().map(|c| Ball::from_rational(c, bits)).collect()
}

fn judge(series: &[BigRational], numerator: usize, denominator: usize) -> restitution_pade::Verdict {
    let entry = approximant(&Rationals, series, PadeType::new(numerator, denominator)).unwrap();
    verdict(&entry, &Interval::HalfLine).unwrap()
}

/// Numerator and denominator of a nondegenerate two-point approximant, checked on both ends.
fn check_two_point(series: &[BigRational], decay: usize, at_infinity: &[BigRational], numerator: usize) {
    let asked = PadeType::new(numerator, numerator + decay);
    let entry = two_point(&Rationals, series, asked, &AtInfinity::new(decay, at_infinity.to_vec())).unwrap();
    assert_eq!(entry.met_at_infinity(), at_infinity.len(), "{asked}");
    let order = asked.conditions() - at_infinity.len();
    assert!(entry.contact().order() >= order, "{asked}");
    assert_eq!(entry.function().series(order), series[..order], "{asked}");
    // Reversed polynomials give the series in 1/x.
    let reverse = |p: &[BigRational]| p.iter().rev().cloned().collect::<Vec<_>>();
    let at = RationalFunction::new(&Rationals, reverse(entry.num()), reverse(entry.den())).unwrap();
    assert_eq!(at.series(at_infinity.len()), at_infinity, "{asked}");
}

#[test]
fn both_ends_are_met() {
    let series = exponential(30).into_iter().enumerate();
    let decaying: Vec<_> = series.map(|(k, c)| if k % 2 == 0 { c } else { -c }).collect();
    for numerator in 0..6 {
        for conditions in 1..=4 {
            let at_infinity = [ratio(7, 3), ratio(0, 1), ratio(0, 1), ratio(1, 5)];
            check_two_point(&decaying, 5, &at_infinity[..conditions], numerator);
        }
    }
}

#[test]
fn a_rational_function_is_found_from_both_ends() {
    // (2 + 3 x)/(1 + x + 4 x^3) = x^-2 (3/4 + 1/2 x^-1 - 3/16 x^-2 + ...)
    let series = quotient(&[2, 3], &[1, 1, 0, 4], 10);
    let infinity = AtInfinity::new(2, vec![ratio(3, 4), ratio(1, 2), ratio(-3, 16)]);
    for numerator in 1..4 {
        let entry =
            two_point(&Rationals, &series, PadeType::new(numerator, numerator + 2), &infinity).unwrap();
        assert_eq!((entry.num(), entry.den()), (&ints(&[2, 3])[..], &ints(&[1, 1, 0, 4])[..]));
    }
}

#[test]
fn two_point_requests_that_cannot_be_met() {
    let series = exponential(10);
    let infinity = AtInfinity::new(5, vec![ratio(1, 1), ratio(0, 1)]);
    let ask = |l, m| two_point(&Rationals, &series, PadeType::new(l, m), &infinity);
    assert!(matches!(ask(1, 5), Err(PadeError::WrongDecay { decay: 5, .. })));
    assert!(matches!(ask(usize::MAX, 3), Err(PadeError::WrongDecay { .. })));
    assert!(
        matches!(ask(3, 8), Err(PadeError::NotEnoughCoefficients { needed: 10, .. })) || ask(3, 8).is_ok()
    );
    assert!(matches!(ask(4, 9), Err(PadeError::NotEnoughCoefficients { needed: 12, known: 10, .. })));
    let many = AtInfinity::new(1, vec![ratio(1, 1); 2]);
    let asked = PadeType::new(0, 1);
    assert!(matches!(
        two_point(&Rationals, &series, asked, &many),
        Err(PadeError::TooManyConditions { limit: 1, .. })
    ));
}

fn there_and_back<F: OrderedField>(entry: &Approximant<F>) -> RationalFunction<F> {
    entry.continued_fraction().unwrap().to_rational().unwrap()
}

#[test]
fn continued_fractions_there_and_back() {
    for series in [
        exponential(20),
        cosine(20),
        lacunary(20),
        approximate_theory(20),
        quotient(&[0, 0, 1], &[1, 3], 20),
        ints(&[0; 20]),
    ] {
        for numerator in 0..7 {
            for denominator in 0..7 {
                let entry = approximant(&Rationals, &series, PadeType::new(numerator, denominator)).unwrap();
                assert_eq!(&there_and_back(&entry), entry.function(), "[{numerator}/{denominator}]");
            }
        }
    }
}

#[test]
fn the_continued_fraction_of_the_exponential() {
    // Perron: exp x = 1 + x/(1 - (x/2)/(1 + (x/6)/(1 - (x/6)/(1 + (x/10)/(1 - ...
    let entry = approximant(&Rationals, &exponential(7), PadeType::new(3, 3)).unwrap();
    let fraction = entry.continued_fraction().unwrap();
    let links: Vec<_> = fraction.links.iter().map(|link| (link.coefficient.clone(), link.power)).collect();
    let expected = [ratio(1, 1), ratio(-1, 2), ratio(1, 6), ratio(-1, 6), ratio(1, 10), ratio(-1, 10)];
    assert_eq!(links, expected.map(|c| (c, 1)));
    let even =
        approximant(&Rationals, &cosine(9), PadeType::new(4, 4)).unwrap().continued_fraction().unwrap();
    assert!(even.links.iter().all(|link| link.power == 2));
}

#[test]
fn verdicts() {
    let decaying = quotient(&[1], &[1, 1], 9);
    assert_eq!(judge(&decaying, 0, 1).bounds, Bounds::Within);
    assert_eq!(judge(&decaying, 0, 0).trend, Trend::Constant);
    assert_eq!(judge(&decaying, 1, 0).zeros, Some(1)); // 1 - x
    let pole = judge(&quotient(&[1], &[1, -1], 9), 0, 1);
    assert_eq!((pole.poles, pole.trend, pole.bounds), (1, Trend::Broken, Bounds::Unbounded));
    // (1 + x)/(1 + x^2) rises to 1.207 at x = sqrt(2) - 1, then falls.
    let hump = judge(&quotient(&[1, 1], &[1, 0, 1], 9), 1, 2);
    assert_eq!((hump.poles, hump.trend, hump.bounds), (0, Trend::Turning(1), Bounds::AboveOne));
    // 1/(1 - x + x^2/3): slope zero at 3/2, value 4 there.
    let bell = approximant(&Rationals, &quotient(&[3], &[3, -3, 1], 9), PadeType::new(0, 2)).unwrap();
    let until = |end| verdict(&bell, &Interval::UpTo(end)).unwrap().trend;
    assert_eq!((until(ratio(1, 1)), until(ratio(2, 1))), (Trend::Increasing, Trend::Turning(1)));
    // (1 - x)^2: a double zero, not monotone, never negative, yet not positive.
    let touching = judge(&ints(&[1, -2, 1]), 2, 0);
    assert_eq!(
        (touching.zeros, touching.trend, touching.bounds),
        (Some(1), Trend::Turning(1), Bounds::NotPositive)
    );
    assert_eq!(judge(&ints(&[0; 9]), 2, 2).zeros, None);
}

#[test]
fn balls_enclose_what_is_exact() {
    let (exact, enclosed) = (generic(20), balls(&generic(20), 200));
    for numerator in 0..9 {
        for denominator in 0..9 {
            let asked = PadeType::new(numerator, denominator);
            let p = approximant(&Rationals, &exact, asked).unwrap();
            let b = approximant(&Balls::new(200), &enclosed, asked).unwrap();
            assert_eq!(p.exact_type(), b.exact_type());
            let proved = asked.conditions()..=p.contact().order();
            assert!(proved.contains(&b.contact().order()), "{asked}");
            let coefficients = p.num().iter().chain(p.den()).zip(b.num().iter().chain(b.den()));
            assert!(coefficients.into_iter().all(|(r, b)| b.contains_rational(r)), "{asked}");
            let interval = Interval::HalfLine;
            assert_eq!(verdict(&p, &interval), verdict(&b, &Interval::HalfLine), "{asked}");
        }
    }
}

#[test]
fn a_pivot_that_may_be_zero_is_an_answer_of_its_own() {
    let series = quotient(&[1, 1], &[1, 0, 7, 3], 12);
    let asked = PadeType::new(3, 4);
    let undecided = approximant(&Balls::new(100), &balls(&quotient(&[3], &[3, 1], 12), 100), asked);
    assert!(matches!(undecided, Err(PadeError::Undecided { .. })));
    // 1e-40 needs more than 100 bits to be told from 0.
    let nearly = |bits: u32| {
        let mut series = balls(&series, bits);
        series[5] = series[5].clone()
            + Ball::from_rational(&BigRational::new(1.into(), num_bigint::BigInt::from(10).pow(40)), bits);
        Ok::<_, PadeError>(approximant(&Balls::new(bits), &series, asked).map(|_| bits))
    };
    assert!(matches!(with_precision(64, 4096, nearly), Ok(256..)));
    let degenerate =
        |bits| Ok::<_, PadeError>(approximant(&Balls::new(bits), &balls(&series, bits), asked).map(|_| ()));
    let exhausted = with_precision(64, 1000, degenerate);
    assert!(matches!(exhausted, Err(PadeError::PrecisionExhausted { reached_bits: 512, .. })));
}

#[test]
fn zeros_of_balls_agree_with_exact_ones() {
    let polynomial = [ratio(6, 1), ratio(-5, 1), ratio(-2, 1), ratio(1, 1)];
    assert_eq!(zeros(&Balls::new(100), &balls(&polynomial, 100), &Interval::HalfLine), Ok(Some(2)));
    let double =
        ints(&[1, -2, 1]).iter().map(|c| Ball::from_rational(&(c / ratio(3, 1)), 100)).collect::<Vec<_>>();
    assert!(matches!(
        zeros(&Balls::new(100), &double, &Interval::HalfLine),
        Err(PadeError::Undecided { .. })
    ));
}

/// A small fraction.
fn small() -> impl Strategy<Value = BigRational> {
    (-50i64..50, 1i64..30).prop_map(|(n, d)| ratio(n, d))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn table_one_is_the_general_algorithm(a2 in small(), a3 in small(), a4 in small()) {
        let zero = BigRational::zero();
        let series = [BigRational::one(), -BigRational::one(), a2.clone(), -a3.clone(), a4.clone(), zero];
        let general = approximant(&Rationals, &series, PadeType::new(1, 4)).unwrap();
        match table_one(&Rationals, &a2, &a3, &a4) {
            Ok(closed) => prop_assert_eq!(&closed, general.function()),
            Err(error) => {
                prop_assert_eq!(error, PadeError::ClosedFormulaFails);
                prop_assert!(general.deficiency() > 0 || general.exact_type() != PadeType::new(1, 4));
            }
        }
    }

    #[test]
    fn quotients_of_small_polynomials_come_back(
        num in prop::collection::vec(-9i64..9, 1..5),
        tail in prop::collection::vec(-9i64..9, 0..5),
    ) {
        let den: Vec<i64> = std::iter::once(1).chain(tail).collect();
        let series = quotient(&num, &den, 20);
        let entry = approximant(&Rationals, &series, PadeType::new(num.len() - 1, den.len() - 1)).unwrap();
        prop_assert_eq!(entry.function().series(20), series);
        prop_assert_eq!(&there_and_back(&entry), entry.function());
    }

    #[test]
    fn sturm_counts_the_roots_that_were_put_in(roots in prop::collection::vec(-6i64..6, 0..7), end in 1i64..6) {
        let linear = |p: Vec<BigRational>, r: &i64| {
            let shifted = std::iter::once(BigRational::zero()).chain(p.iter().cloned());
            let scaled = p.iter().map(|c| c * ratio(*r, 1)).chain([BigRational::zero()]);
            shifted.zip(scaled).map(|(a, b)| a - b).collect()
        };
        let p = roots.iter().fold(ints(&[1]), linear);
        let distinct = |inside: &dyn Fn(i64) -> bool| {
            (0..6).filter(|r| inside(*r) && roots.contains(r)).count()
        };
        prop_assert_eq!(zeros(&Rationals, &p, &Interval::HalfLine).unwrap(), Some(distinct(&|_| true)));
        let until = Interval::UpTo(ratio(end, 1));
        prop_assert_eq!(zeros(&Rationals, &p, &until).unwrap(), Some(distinct(&|r| r <= end)));
    }
}
