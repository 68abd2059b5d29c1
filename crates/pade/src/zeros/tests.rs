use super::*;
use num_rational::BigRational;
use restitution_real::{Ball, Balls, Magnitude, Rationals};

/// A ball with a centre and a radius.
fn wide_ball(mid: f64, rad: f64) -> Ball {
    Ball::new(Ball::from_f64(mid, 64).mid().clone(), &Magnitude::exact(rad).to_float())
}

fn from_roots(roots: &[i64]) -> Vec<BigRational> {
    let int = |n: i64| BigRational::from_integer(n.into());
    roots.iter().fold(vec![int(1)], |p, &r| polynomial::product(&Rationals, &p, &[int(-r), int(1)]))
}

#[test]
fn multiple_zeros_count_once_and_change_sign_if_odd() {
    let p = from_roots(&[0, 0, 1, 2, 2, 3, 3, 3, -4, 5, 5, 5, 5]);
    assert_eq!(zeros(&Rationals, &p, &Interval::HalfLine), Ok(Some(5)));
    assert_eq!(sign_changes(&Rationals, &p, &Interval::HalfLine), Ok(Some(2)));
    for (end, count, changes) in [(2, 3, 1), (3, 4, 2), (4, 4, 2)] {
        let end = Interval::UpTo(BigRational::from_integer(end.into()));
        assert_eq!(zeros(&Rationals, &p, &end), Ok(Some(count)));
        assert_eq!(sign_changes(&Rationals, &p, &end), Ok(Some(changes)));
    }
}

#[test]
fn constants_have_no_zeros() {
    assert_eq!(zeros(&Rationals, &from_roots(&[]), &Interval::HalfLine), Ok(Some(0)));
    assert_eq!(sign_changes(&Rationals, &from_roots(&[]), &Interval::HalfLine), Ok(Some(0)));
}

/// Polynomials with zeros that are known, each so often, and a factor without real zeros.
#[test]
fn counts_are_those_of_the_zeros() {
    let int = |n: i64| BigRational::from_integer(n.into());
    let factors = [vec![int(1)], vec![int(3), int(-2), int(1)], vec![int(-5), int(1), int(-7)]];
    for roots in [
        vec![],
        vec![1],
        vec![-1, -3],
        vec![0, 1],
        vec![0, 0, -2],
        vec![1, 2],
        vec![2, 2],
        vec![1, 2, 3],
        vec![1, 1, 1, 4],
        vec![-2, 1, 1, 3, 5],
        vec![0, 2, 2, 2, 3, 3],
    ] {
        for factor in &factors {
            let p = polynomial::product(&Rationals, &from_roots(&roots), factor);
            for end in [None, Some(1), Some(2), Some(4), Some(100)] {
                let within = |root: &i64| end.is_none_or(|end| *root <= end);
                let interval = end.map_or(Interval::HalfLine, |end| Interval::UpTo(int(end)));
                let distinct: std::collections::BTreeSet<i64> =
                    roots.iter().copied().filter(|root| *root >= 0 && within(root)).collect();
                let times = |root: i64| roots.iter().filter(|other| **other == root).count();
                let odd = distinct.iter().filter(|root| **root > 0 && times(**root) % 2 == 1).count();
                assert_eq!(zeros(&Rationals, &p, &interval), Ok(Some(distinct.len())), "{roots:?} {end:?}");
                assert_eq!(sign_changes(&Rationals, &p, &interval), Ok(Some(odd)), "{roots:?} {end:?}");
            }
        }
    }
}

/// Among balls: what is certain is counted, what is not is said to be open.
#[test]
fn counts_of_balls_are_certain_or_open() {
    let field = Balls::new(64);
    let ball = |n: i64, rad: f64| wide_ball(n as f64, rad);
    let wide = |p: &[i64], rad: f64| p.iter().map(|&c| ball(c, rad)).collect::<Vec<_>>();
    let count = |p: &[Ball], interval: &Interval<Ball>| zeros(&field, p, interval);
    // (x - 1)(x + 2)(x - 3)
    for (rad, found) in [(0.0, Some(2)), (1e-6, Some(2)), (7.0, None)] {
        let p = wide(&[6, -5, -2, 1], rad);
        assert_eq!(count(&p, &Interval::HalfLine).ok().flatten(), found, "{rad}");
        assert_eq!(sign_changes(&field, &p, &Interval::HalfLine).ok().flatten(), found, "{rad}");
    }
    let p = wide(&[6, -5, -2, 1], 1e-6);
    assert_eq!(count(&p, &Interval::UpTo(ball(2, 0.0))), Ok(Some(1)));
    assert!(matches!(count(&p, &Interval::UpTo(ball(3, 0.0))), Err(PadeError::Undecided { .. })));
    // (x - 1)^2 may have two zeros, one or none.
    let double = wide(&[1, -2, 1], 1e-6);
    assert!(matches!(count(&double, &Interval::HalfLine), Err(PadeError::Undecided { .. })));
    // (x + 1)^2 has none, whatever the radii: no coefficient changes its sign.
    assert_eq!(count(&wide(&[1, 2, 1], 1e-6), &Interval::HalfLine), Ok(Some(0)));
    // A constant term that may vanish, a leading one that may.
    assert!(matches!(
        count(&[ball(0, 1.0), ball(1, 0.0)], &Interval::HalfLine),
        Err(PadeError::Undecided { .. })
    ));
    assert!(matches!(
        count(&[ball(1, 0.0), ball(0, 1.0)], &Interval::HalfLine),
        Err(PadeError::Undecided { .. })
    ));
}

/// Signs in a row, `None` where open.
#[test]
fn an_open_sign_between_two_opposite_ones_does_not_matter() {
    let field = Balls::new(64);
    let sign = |sign: char| match sign {
        '?' => wide_ball(0.0, 1.0),
        '0' => Ball::from_integer(0, 64),
        sign => Ball::from_integer(if sign == '+' { 1 } else { -1 }, 64),
    };
    for (signs, changes) in [
        ("", Some(0)),
        ("+", Some(0)),
        ("+-", Some(1)),
        ("+0-", Some(1)),
        ("+0+", Some(0)),
        ("+-+-", Some(3)),
        ("+?-", Some(1)),
        ("-?+-", Some(2)),
        ("+?+", None),
        ("?-", None),
        ("+?", None),
        ("0?0", None),
        ("+??-", None),
        ("+-?+", Some(2)),
    ] {
        let values: Vec<Ball> = signs.chars().map(sign).collect();
        assert_eq!(variations(&field, &values).ok(), changes, "{signs}");
    }
}
