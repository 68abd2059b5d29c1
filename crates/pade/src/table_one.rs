use crate::{PadeError, RationalFunction, RealField};
use restitution_series::ZeroTest;

/// Returns the Padé formula (35) from the closed formulas of Table I of \[RPBS1999\].
///
/// ```text
/// eps = (1 + d_1 s)/(1 + d_2 s + d_3 s^2 + d_4 s^3 + d_5 s^4),    s = (g/g*)^(1/5)
///
/// d_0 = a_4 - 2 a_3 - a_2^2 + 3 a_2 - 1
/// d_1 d_0 = 1 - a_2 + a_3 - 2 a_4 + (a_2 - 1)(3 a_2 - 2 a_3)
/// d_2 d_0 = (a_3 - a_2)(1 - 2 a_2) - a_4
/// d_3 d_0 = a_3 + a_2^2 (a_2 - 1) - a_4 (a_2 + 1)
/// d_4 d_0 = a_4 (a_3 - 1) + (a_3 - a_2)(a_2^2 - 2 a_3)
/// d_5 d_0 = 2 (a_3 - a_2)(a_4 - a_2 a_3) - (a_4 - a_2^2)^2 - a_3 (a_3 - a_2^2)
/// ```
///
/// These are the `[1/4]` approximant of `1 - s + a_2 s^2 - a_3 s^3 + a_4 s^4 - a_5 s^5` with `a_5 = 0`:
/// five unknowns from four coefficients, which the paper does not say. Exact for rationals.
///
/// # Errors
///
/// [`PadeError::ClosedFormulaFails`] if `d_0 = 0`, [`PadeError::Undecided`] if a ball leaves that open.
pub fn table_one<F: RealField>(a2: &F, a3: &F, a4: &F) -> Result<RationalFunction<F>, PadeError> {
    let one = F::one;
    let product = |x: F, y: F| x * y;
    let double = |x: &F| x.clone() + x;
    let square = |x: &F| x.times(x);
    let minus = |x: &F, y: &F| x.clone() - y;
    let d0 = minus(a4, &double(a3)) - square(a2) + double(a2) + a2 - one();
    let d1 = product(minus(a2, &one()), double(a2) + a2 - double(a3)) + one() - a2 + a3 - double(a4);
    let d2 = product(minus(a3, a2), one() - double(a2)) - a4;
    let d3 = product(square(a2), minus(a2, &one())) + a3 - product(a4.clone(), one() + a2);
    let d4 = product(a4.clone(), minus(a3, &one())) + product(minus(a3, a2), square(a2) - double(a3));
    let d5 = product(double(&minus(a3, a2)), minus(a4, &a2.times(a3)))
        - square(&(a4.clone() - square(a2)))
        - product(a3.clone(), a3.clone() - square(a2));
    match d0.zero_test() {
        ZeroTest::Zero => Err(PadeError::ClosedFormulaFails),
        ZeroTest::Undecided => {
            Err(PadeError::Undecided { what: "whether d_0 of the closed formulas is zero" })
        }
        ZeroTest::NonZero => RationalFunction::new(vec![d0.clone(), d1], vec![d0, d2, d3, d4, d5]),
    }
}
