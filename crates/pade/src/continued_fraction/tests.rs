use super::*;
use crate::{PadeType, approximant};
use num_rational::BigRational;
use restitution_real::{Balls, Rationals};

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

/// Every approximant, in degenerate blocks too, equals its continued fraction, and no link is zero.
#[test]
fn the_fraction_equals_the_approximant() {
    for n in 0..243_i64 {
        let series: Vec<_> = (0..5).map(|k| ratio(n / 3_i64.pow(k) % 3 - 1, 1)).collect();
        for asked in (0..5).flat_map(|l| (0..5 - l).map(move |m| PadeType::new(l, m))) {
            let found = approximant(&Rationals, &series, asked).unwrap();
            let fraction = found.continued_fraction().unwrap();
            assert_eq!(&fraction.to_rational().unwrap(), found.function(), "{asked} of {series:?}");
            let zero = ratio(0, 1);
            assert!(
                fraction.links.iter().all(|l| l.coefficient != zero && l.power > 0),
                "{asked} of {series:?}"
            );
        }
    }
}

#[test]
fn links_of_the_exponential_and_of_a_gap_are_known() {
    let mut series = vec![ratio(1, 1)];
    for n in 1..9 {
        series.push(&series[n - 1] / ratio(n as i64, 1));
    }
    // e^x = 1 + x/(1 - x/2/(1 + x/6/(1 - x/6/(1 + x/10/(1 - x/10/(1 + ...
    let known = [(1, 1), (-1, 2), (1, 6), (-1, 6), (1, 10), (-1, 10), (1, 14), (-1, 14)];
    let known = known.map(|(n, d)| Link { coefficient: ratio(n, d), power: 1 });
    let fraction =
        approximant(&Rationals, &series, PadeType::new(4, 4)).unwrap().continued_fraction().unwrap();
    assert_eq!((&fraction.constant, &fraction.links[..]), (&ratio(1, 1), &known[..]));
    // 5 - 2 x^3/(1 + 7 x^2) = 5 + O(x^3)
    let gap = [5, 0, 0, -2, 0, 14, 0, -98].map(|c| ratio(c, 1));
    let fraction = approximant(&Rationals, &gap, PadeType::new(3, 2)).unwrap().continued_fraction().unwrap();
    let known = [Link { coefficient: ratio(-2, 1), power: 3 }, Link { coefficient: ratio(7, 1), power: 2 }];
    assert_eq!((&fraction.constant, &fraction.links[..]), (&ratio(5, 1), &known[..]));
}

/// With balls the powers are those of the exact fraction, and its coefficients are inside.
#[test]
fn balls_keep_exact_zeros_and_contain_the_links() {
    let field = Balls::new(200);
    let series =
        [(1, 3), (0, 1), (1, 7), (0, 1), (2, 9), (0, 1), (5, 11), (0, 1), (1, 13)].map(|(n, d)| ratio(n, d));
    let balls: Vec<_> = series.iter().map(|c| field.rational(c)).collect();
    for asked in [PadeType::new(4, 4), PadeType::new(3, 4), PadeType::new(2, 2), PadeType::new(8, 0)] {
        let exact = approximant(&Rationals, &series, asked).unwrap().continued_fraction().unwrap();
        let near = approximant(&field, &balls, asked).unwrap().continued_fraction().unwrap();
        assert_eq!(near.links.len(), exact.links.len(), "{asked}");
        for (ball, link) in near.links.iter().zip(&exact.links) {
            assert_eq!(ball.power, link.power, "{asked}");
            assert!(ball.coefficient.contains_rational(&link.coefficient), "{asked}");
        }
    }
}

/// `c/(1 - x + x^2) = c + c x + 0 x^2 + ...`: the end is seen by the zero of the series, which is exact,
/// where the polynomials have only a difference of balls.
#[test]
fn an_exact_zero_of_the_series_ends_the_fraction() {
    let (field, c) = (Balls::new(100), ratio(-2, 7));
    for asked in [PadeType::new(0, 2), PadeType::new(1, 1)] {
        let series = [c.clone(), c.clone(), ratio(0, 1)];
        let balls = series.each_ref().map(|c| field.rational(c));
        let exact = approximant(&Rationals, &series, asked).unwrap().continued_fraction().unwrap();
        let near = approximant(&field, &balls, asked).unwrap().continued_fraction().unwrap();
        assert_eq!(near.links.len(), exact.links.len(), "{asked}");
        for (ball, link) in near.links.iter().zip(&exact.links) {
            assert_eq!(ball.power, link.power, "{asked}");
            assert!(ball.coefficient.contains_rational(&link.coefficient), "{asked}");
        }
    }
}
