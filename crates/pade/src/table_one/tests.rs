use super::*;
use crate::{PadeType, approximant};
use num_rational::BigRational;
use restitution_real::{Ball, Balls, Field, Rationals};

/// The formulas of Table I as printed in the documentation, on a grid of fractions, and the `[1/4]` approximant
/// of the series that they solve.
#[test]
fn the_closed_formulas_are_the_approximant_with_a5_zero() {
    let q = |n: i64, d: i64| BigRational::new(n.into(), d.into());
    let (zero, one, two, three) = (q(0, 1), q(1, 1), q(2, 1), q(3, 1));
    let grid = [q(3, 5), q(-1, 2), q(7, 3), q(1, 1), q(2, 1)];
    let mut seen = 0;
    for a2 in &grid {
        for a3 in &grid {
            for a4 in &grid {
                let found = table_one(&Rationals, a2, a3, a4);
                let d0 = a4 - &two * a3 - a2 * a2 + &three * a2 - &one;
                if d0 == zero {
                    assert_eq!(found, Err(PadeError::ClosedFormulaFails));
                    continue;
                }
                let d = [
                    &one - a2 + a3 - &two * a4 + (a2 - &one) * (&three * a2 - &two * a3),
                    (a3 - a2) * (&one - &two * a2) - a4,
                    a3 + a2 * a2 * (a2 - &one) - a4 * (a2 + &one),
                    a4 * (a3 - &one) + (a3 - a2) * (a2 * a2 - &two * a3),
                    &two * (a3 - a2) * (a4 - a2 * a3) - (a4 - a2 * a2) * (a4 - a2 * a2) - a3 * (a3 - a2 * a2),
                ]
                .map(|d| d / &d0);
                let (num, den) = (vec![one.clone(), d[0].clone()], [&[one.clone()][..], &d[1..]].concat());
                assert_eq!(found, RationalFunction::new(&Rationals, num, den), "{a2} {a3} {a4}");
                let series = [one.clone(), -one.clone(), a2.clone(), -a3.clone(), a4.clone(), zero.clone()];
                let asked = approximant(&Rationals, &series, PadeType::new(1, 4)).unwrap();
                assert_eq!(&found.unwrap(), asked.function(), "{a2} {a3} {a4}");
                seen += 1;
            }
        }
    }
    assert!(seen > 100, "{seen}");
    let third = Ball::from_ratio(1, 3, 53);
    let open = &third - &third; // d_0 = a_4 - 1 at a_2 = 2, a_3 = 1
    let field = Balls::new(53);
    let (one, two) = (field.ratio(1, 1), field.ratio(2, 1));
    let refused = table_one(&field, &two, &one, &field.add(&field.ratio(1, 1), &open));
    assert!(matches!(refused, Err(PadeError::Undecided { .. })), "{refused:?}");
}
