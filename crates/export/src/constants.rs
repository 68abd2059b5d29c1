//! The constants of an undamped collision, as `restitution` carries them.

use crate::evaluator_tables::HEAD;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use std::fmt::Write as _;

/// Bits of the closed forms before they are rounded.
const PREC: u32 = 200;

/// Returns `tables/constants.rs`: each constant is the f64 closest to its closed form.
///
/// With `s = (gamma + 1)/(a + 1)`, `t = 1/(a + 1)` and `c = (a + 1)/2` of the law of viscoelastic spheres:
///
/// ```text
/// -C_1 = 2 c^s B(s, 3/2)/(a + 1),   2 T = 2 c^t B(t, 1/2)/(a + 1),   y_0 = c^t,   delta/u = c^s
/// ```
///
/// (\[RPBS1999\], eqs. 14, 31, A32.)
///
/// # Panics
///
/// If a ball of 200 bits does not determine an f64.
pub fn constants() -> String {
    let law = ForceLaw::viscoelastic_spheres();
    let elastic = law.elastic_step();
    let (s, t) = (law.damping_step() / &elastic, elastic.recip());
    let ratio = |n: i64, d: i64| Ball::from_ratio(n, d, PREC);
    let beta = |p, half: i64| Ball::beta(p, &num_rational::BigRational::new(half.into(), 2.into()), PREC);
    let step = Ball::from_rational(&elastic, PREC);
    let power = |exponent| (step.clone() * ratio(1, 2)).pow(exponent);
    let twice = |ball: Ball| ball * ratio(2, 1) / step.clone();
    let slope = twice(power(&s) * beta(&s, 3));
    let duration = twice(power(&t) * beta(&t, 1));
    let mut text =
        format!("//! Constants of the undamped collision, each the f64 closest to its closed form.\n{HEAD}");
    for (name, what, value) in [
        ("SLOPE", "`-C_1`, the slope of `1 - epsilon` at `u = 0` (eqs. 31, A32 of \\[RPBS1999\\])", slope),
        ("DELTA_OVER_U", "`(5/4)^(3/5)`, which leads from `u` to `delta` of eq. (14)", power(&s)),
        ("ELASTIC_DURATION", "`2 T`, the duration in units of `tau`", duration),
        ("ELASTIC_COMPRESSION", "`(5/4)^(2/5)`, the maximal compression in units of `g tau`", power(&t)),
    ] {
        let (low, high) = (value.lower().to_f64(), value.upper().to_f64());
        assert!(low == high, "{name} lies between {low:e} and {high:e}");
        let _ = writeln!(
            text,
            "\n/// {what}.\n#[rustfmt::skip]\n#[allow(dead_code)]\npub(crate) const {name}: f64 = {low:?};"
        );
    }
    text
}
