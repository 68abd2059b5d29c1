use super::*;
use num_rational::BigRational;
use restitution_real::{Ball, Balls, Rationals};

fn ints(p: &[i64]) -> Vec<BigRational> {
    p.iter().map(|&c| BigRational::from_integer(c.into())).collect()
}

#[test]
fn values_degrees_and_series() {
    let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
    // (6 + 4 x + 0 x^2)/(2 - 6 x + 2 x^2)
    let f = RationalFunction::new(&Rationals, ints(&[6, 4, 0]), ints(&[2, -6, 2])).unwrap();
    assert_eq!((f.num(), f.den()), (ints(&[3, 2]).as_slice(), ints(&[1, -3, 1]).as_slice()));
    assert_eq!((f.degrees(), f.is_zero()), (PadeType::new(1, 2), false));
    assert_eq!(f.value(&ratio(1, 2)), Ok(ratio(-16, 1)));
    // Q A = P, coefficient by coefficient
    let a = f.series(7);
    for n in 0..7 {
        let q = f.den();
        let sum: BigRational = (0..=n.min(2)).map(|k| &q[k] * &a[n - k]).sum();
        assert_eq!(sum, f.num().get(n).cloned().unwrap_or_else(|| ratio(0, 1)), "{n}");
    }
    let nothing = RationalFunction::new(&Rationals, ints(&[0, 0]), ints(&[3])).unwrap();
    assert!(nothing.is_zero() && nothing.degrees() == PadeType::new(0, 0));
    assert_eq!(nothing.series(2), ints(&[0, 0]));
    let pole = RationalFunction::new(&Rationals, ints(&[1]), ints(&[1, -1])).unwrap();
    assert!(matches!(pole.value(&ratio(1, 1)), Err(PadeError::Undecided { .. })));
    assert_eq!(RationalFunction::new(&Rationals, ints(&[1]), ints(&[])), Err(PadeError::PoleAtZero));
}

/// A value of balls contains the values of all functions in them.
#[test]
fn values_of_balls_contain_the_value() {
    let field = Balls::new(64);
    let third = |n: i64| Ball::from_ratio(n, 3, 64);
    let f = RationalFunction::new(&field, vec![third(1), third(2)], vec![third(3), third(-1)]).unwrap();
    // (1/3 + 2/3 x)/(1 - x/3) at 1/2
    let value = f.value(&Ball::from_ratio(1, 2, 64)).unwrap();
    assert!(value.contains(&Ball::from_ratio(4, 5, 256)) && !value.is_exact());
    assert!(matches!(f.value(&Ball::from_integer(3, 64)), Err(PadeError::Undecided { .. })));
}
