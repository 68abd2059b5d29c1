use super::*;
use num_rational::BigRational;
use restitution_real::Rationals;

fn ints(p: &[i64]) -> Vec<BigRational> {
    p.iter().map(|&c| BigRational::from_integer(c.into())).collect()
}

/// The first coefficients of `P/Q`, by long division.
fn quotient(p: &[i64], q: &[i64], terms: usize) -> Vec<BigRational> {
    let (mut rest, q) = (ints(p), ints(q));
    rest.resize(terms + q.len(), ints(&[0])[0].clone());
    (0..terms)
        .map(|n| {
            let c = &rest[n] / &q[0];
            for (k, q) in q.iter().enumerate() {
                let part = &c * q;
                rest[n + k] -= part;
            }
            c
        })
        .collect()
}

fn reversed(p: &[i64]) -> Vec<i64> {
    p.iter().rev().copied().collect()
}

/// A quotient `P/Q` is found again from its expansions at 0 and at infinity, however the conditions
/// are shared between them.
#[test]
fn a_quotient_is_found_from_its_two_expansions() {
    let all: [(&[i64], &[i64]); 5] = [
        (&[2, 3], &[1, 1, 4, 5]),
        (&[1, -2, 3], &[1, 5, -1]),
        (&[7], &[1, 0, 0, 2]),
        (&[3, 0, -1, 2], &[1, 2, 0, 1, 6]),
        (&[0, 1], &[1, 1, 3]),
    ];
    for (p, q) in all {
        let asked = PadeType::new(p.len() - 1, q.len() - 1);
        for k in 0..=asked.denominator {
            let series = quotient(p, q, asked.conditions() - k);
            let infinity = AtInfinity::new(q.len() - p.len(), quotient(&reversed(p), &reversed(q), k));
            let found = two_point(&Rationals, &series, asked, &infinity).unwrap();
            assert_eq!(
                (found.num(), found.den()),
                (&ints(p)[..], &ints(q)[..]),
                "{p:?}/{q:?}, {k} at infinity"
            );
            assert_eq!((found.met_at_infinity(), found.deficiency()), (k, 0), "{p:?}/{q:?}, {k} at infinity");
            assert_eq!(found.contact().order(), series.len(), "{p:?}/{q:?}, {k} at infinity");
            let short = two_point(&Rationals, &series[1..], asked, &infinity);
            let needed = series.len();
            assert_eq!(short, Err(PadeError::NotEnoughCoefficients { asked, needed, known: needed - 1 }));
        }
    }
}

#[test]
fn conditions_that_do_not_fit_the_type_are_refused() {
    let (asked, series) = (PadeType::new(1, 2), ints(&[1, -1, 3, 4]));
    for k in 0..4 {
        let at =
            |decay| two_point(&Rationals, &series, asked, &AtInfinity::new(decay, ints(&[5, 6, 7][..k])));
        for decay in [0, 2, usize::MAX] {
            if k == 0 {
                assert_eq!(at(decay), crate::approximant(&Rationals, &series, asked));
            } else {
                assert_eq!(at(decay), Err(PadeError::WrongDecay { asked, decay }));
            }
        }
        if k < 3 {
            assert!(at(1).is_ok());
        } else {
            assert_eq!(at(1), Err(PadeError::TooManyConditions { asked, conditions: 3, limit: 2 }));
        }
    }
}

/// 1/(1 + x) as [1/2]: one degree is too many, so that one condition at infinity says nothing of it.
#[test]
fn a_degree_too_many_costs_a_condition_at_infinity() {
    let infinity = AtInfinity::new(1, ints(&[1, -1]));
    let found = two_point(&Rationals, &ints(&[1, -1]), PadeType::new(1, 2), &infinity).unwrap();
    assert_eq!((found.num(), found.den()), (&ints(&[1])[..], &ints(&[1, 1])[..]));
    assert_eq!((found.met_at_infinity(), found.contact().order(), found.deficiency()), (1, 2, 1));
}
