use super::*;
use restitution_real::{Ball, Balls, Magnitude, Rationals};

/// A ball with a centre and a radius.
fn wide(mid: f64, rad: f64) -> Ball {
    Ball::new(Ball::from_f64(mid, 64).mid().clone(), &Magnitude::exact(rad).to_float())
}

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

fn from_roots(roots: &[BigRational]) -> Vec<BigRational> {
    roots
        .iter()
        .fold(vec![ratio(1, 1)], |p, root| polynomial::product(&Rationals, &p, &[-root.clone(), ratio(1, 1)]))
}

/// Every zero alone in its enclosure, in order, and no wider than asked.
fn check(roots: &[BigRational], digits: usize) {
    let mut expected: Vec<BigRational> = roots.iter().filter(|x| **x >= ratio(0, 1)).cloned().collect();
    expected.sort();
    expected.dedup();
    let found = places(&Rationals, &from_roots(roots), digits).unwrap();
    assert_eq!(found.len(), expected.len(), "{roots:?}: {found:?}");
    let scale = ratio(10, 1).pow(i32::try_from(digits).unwrap());
    for ((low, high), root) in found.iter().zip(&expected) {
        assert!(low <= root && root <= high, "{root}: {low} {high}");
        assert!((high - low) * &scale <= *low, "{root}: {low} {high}");
        // A zero at the lower end is enclosed by itself.
        let others =
            expected.iter().filter(|x| (low < x && *x <= high) || (low == high && *x == low)).count();
        assert_eq!(others, 1, "{root}: {low} {high}");
    }
}

#[test]
fn zeros_are_enclosed_one_by_one() {
    let all = [
        vec![],
        vec![ratio(-3, 1)],
        vec![ratio(0, 1)],
        vec![ratio(0, 1), ratio(0, 1), ratio(5, 1)],
        vec![ratio(0, 1), ratio(-1, 1), ratio(1, 1000), ratio(2, 1)],
        // On the edge of what is searched, and in its middle.
        vec![ratio(8, 7)],
        vec![ratio(4, 7), ratio(16, 7)],
        vec![ratio(32, 7), ratio(1, 3), ratio(2, 3)],
        // Of even multiplicity, where the sign does not change.
        vec![ratio(1, 3), ratio(1, 3)],
        vec![ratio(1, 3), ratio(1, 3), ratio(7, 2), ratio(7, 2), ratio(7, 2)],
        vec![ratio(0, 1), ratio(2, 3), ratio(2, 3), ratio(-5, 1), ratio(9, 1)],
        vec![ratio(2, 1), ratio(2, 1), ratio(8, 7), ratio(8, 7)],
        // Behind a place that is a zero itself.
        vec![ratio(8, 7), ratio(2, 1), ratio(2, 1)],
        vec![ratio(0, 1), ratio(0, 1), ratio(1, 3), ratio(1, 3)],
        // Far away, close by, close to each other.
        vec![ratio(1_000_000, 1), ratio(1, 1_000_000)],
        vec![ratio(1, 1), ratio(1_000_000_001, 1_000_000_000), ratio(3, 1)],
    ];
    for roots in all {
        for digits in [1, 3, 12] {
            check(&roots, digits);
        }
    }
}

/// Zeros that four hundred halvings don't tell apart are said to be open, not sought for ever.
#[test]
fn zeros_too_close_to_each_other_are_open() {
    let close = |halvings: i32| [ratio(1, 3), ratio(1, 3) + ratio(1, 2).pow(halvings)];
    assert!(places(&Rationals, &from_roots(&close(300)), 2).is_ok());
    let found = places(&Rationals, &from_roots(&close(500)), 2);
    assert!(matches!(found, Err(PadeError::Undecided { .. })));
}

/// Halving goes on while it must, and no longer.
#[test]
fn enclosures_are_as_wide_as_the_digits_allow() {
    for digits in [2, 5, 9] {
        for root in [ratio(1, 3), ratio(11, 3), ratio(355, 113)] {
            let found = places(&Rationals, &from_roots(&[root]), digits).unwrap();
            let (low, high) = &found[0];
            let scale = ratio(10, 1).pow(i32::try_from(digits).unwrap());
            // The interval before was twice as wide, and its lower end no higher than this one's upper end.
            assert!((high - low) * ratio(2, 1) * &scale > low - (high - low), "{low} {high}");
        }
    }
}

#[test]
fn zeros_of_balls_are_enclosed_or_open() {
    let field = Balls::new(200);
    let ball = |n: i64| Ball::from_integer(n, 200);
    let two = ratio(2, 1);
    let found = places(&field, &[ball(-2), ball(0), ball(1)], 30).unwrap();
    let [(low, high)] = found.as_slice() else { panic!("{found:?}") };
    assert!(low * low < two && high * high > two);
    // Too wide for so many digits, or for a double zero.
    let p = [wide(-2.0, 1e-10), ball(0), ball(1)];
    assert!(places(&field, &p, 5).is_ok());
    assert!(matches!(places(&field, &p, 30), Err(PadeError::Undecided { .. })));
    let third = Ball::from_ratio(1, 3, 200);
    let double = [third.clone() * &third, ball(-2) * &third, ball(1)];
    assert!(matches!(places(&field, &double, 5), Err(PadeError::Undecided { .. })));
    assert!(places(&Rationals, &[], 5).unwrap().is_empty());
}
