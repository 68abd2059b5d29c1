//! Formulas for the coefficient of restitution in f64, as a simulation would write them.

/// `-C_1`, with which the paper's velocity `s = (g/g*)^(1/5)` is `-C_1 u` (\[RPBS1999\], eqs. 31 and 32).
pub const SLOPE: f64 = 1.153_448_858_095_288_8;

/// Returns `c_0 + c_1 x + …` by Horner's scheme.
#[inline(always)]
pub fn polynomial<const N: usize>(c: &[f64; N], x: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// Returns a quotient of polynomials.
#[inline(always)]
pub fn quotient<const L: usize, const M: usize>(num: &[f64; L], den: &[f64; M], x: f64) -> f64 {
    polynomial(num, x) / polynomial(den, x)
}

/// Formula (35) of \[RPBS1999\] with `s = (g/g*)^(1/5)` and the constants its Table I prints.
#[inline(always)]
pub fn printed_35(s: f64) -> f64 {
    quotient(&[1.0, 2.5839], &[1.0, 3.5839, 2.9839, 1.1487, 0.3265], s)
}

/// The [1/4] formula of \[MP2011\] as printed, for contacts that end at zero force.
#[inline(always)]
pub fn printed_mp_1_4(u: f64) -> f64 {
    quotient(&[1.0, 0.501086], &[1.0, 0.501086, 1.15345, 0.577977, 0.532178], u.sqrt())
}

/// The numerator of the [3/6] formula of \[MP2011\] as printed.
const MP_NUM: [f64; 4] = [1.0, 1.07232, 0.574198, 0.141552];
/// Its denominator.
const MP_DEN: [f64; 7] = [1.0, 1.07232, 1.72765, 1.37842, 1.19449, 0.467273, 0.235585];

/// The [3/6] formula of \[MP2011\] as printed, for contacts that end at zero force.
#[inline(always)]
pub fn printed_mp_3_6(u: f64) -> f64 {
    quotient(&MP_NUM, &MP_DEN, u.sqrt())
}

/// The same with a power for each term, as simulation codes evaluate it.
pub fn printed_mp_3_6_by_powers(u: f64) -> f64 {
    let v = u.sqrt();
    let sum = |c: &[f64]| c.iter().enumerate().map(|(k, c)| c * v.powf(k as f64)).sum::<f64>();
    sum(&MP_NUM) / sum(&MP_DEN)
}

/// The approximate theory of \[RPBS1999\], eq. (27), `eps + s eps^(3/5) = 1`, by Newton's iteration.
///
/// In `y = eps^(1/5)` it is `y^5 + s y^3 = 1`, convex and increasing for `y > 0`: from `y = 1` the
/// iteration falls to the root and ends when it no longer falls.
pub fn approximate_theory(u: f64) -> f64 {
    let s = SLOPE * u;
    let mut y = 1.0_f64;
    loop {
        let y2 = y * y;
        let next = y - (y2 * y * (y2 + s) - 1.0) / (y2 * (5.0 * y2 + 3.0 * s));
        if next >= y || next.is_nan() {
            return y2 * y2 * y;
        }
        y = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use restitution_law::ForceLaw;
    use restitution_real::Ball;
    use restitution_series::ApproximateTheory;

    #[test]
    fn the_approximate_theory_is_that_of_the_library() {
        let theory = ApproximateTheory::new(&ForceLaw::viscoelastic_spheres());
        for u in [1e-9, 0.03, 0.5, 1.0, 3.0, 7.5, 1e4] {
            let s = Ball::from_f64(SLOPE, 100) * Ball::from_f64(u, 100);
            let error = approximate_theory(u) / theory.restitution(&s).to_f64() - 1.0;
            assert!(error.abs() < 1e-14, "{u}: {error:e}");
        }
        assert_eq!(approximate_theory(0.0), 1.0);
    }

    #[test]
    fn the_two_ways_to_write_a_formula_agree() {
        for u in [0.0, 0.3, 2.0, 7.5] {
            assert!((printed_mp_3_6(u) - printed_mp_3_6_by_powers(u)).abs() < 1e-15);
        }
    }
}
