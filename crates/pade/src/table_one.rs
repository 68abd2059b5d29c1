use crate::{PadeError, RationalFunction};
use restitution_real::{OrderedField, ZeroTest};

/// A polynomial in `a_2`, `a_3`, `a_4` as its terms: a factor and the indices that are multiplied.
type Terms = &'static [(i64, &'static [usize])];

/// `d_0` and the products `d_k d_0`, multiplied out.
const CONSTANTS: [Terms; 6] = [
    &[(1, &[4]), (-2, &[3]), (-1, &[2, 2]), (3, &[2]), (-1, &[])],
    &[(1, &[]), (-4, &[2]), (3, &[3]), (-2, &[4]), (3, &[2, 2]), (-2, &[2, 3])],
    &[(1, &[3]), (-1, &[2]), (-2, &[2, 3]), (2, &[2, 2]), (-1, &[4])],
    &[(1, &[3]), (1, &[2, 2, 2]), (-1, &[2, 2]), (-1, &[2, 4]), (-1, &[4])],
    &[(1, &[3, 4]), (-1, &[4]), (1, &[2, 2, 3]), (-2, &[3, 3]), (-1, &[2, 2, 2]), (2, &[2, 3])],
    &[
        (2, &[3, 4]),
        (-2, &[2, 3, 3]),
        (-2, &[2, 4]),
        (3, &[2, 2, 3]),
        (-1, &[4, 4]),
        (2, &[2, 2, 4]),
        (-1, &[2, 2, 2, 2]),
        (-1, &[3, 3]),
    ],
];

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
pub fn table_one<F: OrderedField>(
    field: &F,
    a2: &F::Number,
    a3: &F::Number,
    a4: &F::Number,
) -> Result<RationalFunction<F>, PadeError> {
    let coefficient = |k: usize| [a2, a3, a4][k - 2];
    let [d0, d1, d2, d3, d4, d5] = CONSTANTS.map(|polynomial| {
        polynomial.iter().fold(field.zero(), |sum, (factor, indices)| {
            let product = |product, k: &usize| field.mul(&product, coefficient(*k));
            field.add(&sum, &indices.iter().fold(field.ratio(*factor, 1), product))
        })
    });
    match field.zero_test(&d0) {
        ZeroTest::Zero => Err(PadeError::ClosedFormulaFails),
        ZeroTest::Undecided => {
            Err(PadeError::Undecided { what: "whether d_0 of the closed formulas is zero" })
        }
        ZeroTest::NonZero => RationalFunction::new(field, vec![d0.clone(), d1], vec![d0, d2, d3, d4, d5]),
    }
}

#[cfg(test)]
mod tests;
