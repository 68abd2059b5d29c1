//! The Taylor coefficients of a step in time, in fixed point.

use crate::equation::Equation;
use crate::fixed::to_fixed;
use crate::online::Online;
use num_traits::ToPrimitive;
use restitution_real::Ball;
use restitution_real::convert::rug_integer;
use rug::Integer;

/// Largest power of the coordinate that is multiplied out.
const LARGEST_POWER: u32 = 2;

/// The equation of motion in the time `s`, `dt = z^(q-1) ds`, for laws in which its powers are low.
///
/// ```text
/// dz/ds = v/q,    dv/ds = -z^m f,    f = z^e + u v,    m = B - 1,  e = A - B
/// ```
pub(crate) struct TimeChart {
    pub(crate) outer: u32,
    pub(crate) inner: u32,
    /// Numerator and denominator of `q`.
    q: (Integer, Integer),
}

impl TimeChart {
    /// The chart of a law; `None` where its powers are not low integers.
    pub(crate) fn of(equation: &Equation) -> Option<Self> {
        let c = &equation.coordinate;
        let integer = |n: &num_rational::BigRational| n.is_integer().then(|| n.to_u32()).flatten();
        let outer = integer(&c.damping)?.checked_sub(1)?;
        let inner = integer(&c.force_power())?;
        let q = (rug_integer(c.q.numer()), rug_integer(c.q.denom()));
        (outer <= LARGEST_POWER && (1..=LARGEST_POWER).contains(&inner)).then_some(Self { outer, inner, q })
    }

    /// A step of about `length`, exact as a multiple of `q`.
    pub(crate) fn pace(&self, length: f64) -> Pace {
        let (q, _) = &self.q;
        let units = (length / q.to_f64() * 2f64.powi(40)).round();
        let units = Integer::from_f64(units).unwrap_or_default();
        Pace { in_z: Integer::from(&self.q.1 * &units), in_v: q * units }
    }
}

/// The length `h` of a step, as `h/q` and `h` in units of `2^-40`.
pub(crate) struct Pace {
    in_z: Integer,
    in_v: Integer,
}

impl Pace {
    /// `h`, exactly.
    pub(crate) fn length(&self) -> Ball {
        Ball::from_big_integer(&self.in_v, 128).shifted(-40)
    }
}

/// A point of the motion in units of `2^-bits`.
#[derive(Clone)]
pub(crate) struct FixedPoint {
    pub(crate) z: Integer,
    pub(crate) v: Integer,
}

impl FixedPoint {
    /// The same point with fewer bits.
    pub(crate) fn cut(&self, drop: u32) -> Self {
        Self { z: Integer::from(&self.z >> drop), v: Integer::from(&self.v >> drop) }
    }
}

/// The polynomials of one step on `0 <= theta <= 1`, in units of `2^-bits`.
pub(crate) struct TimeSeries {
    /// Degrees 0 to `n`.
    pub(crate) z: Vec<Integer>,
    /// Degrees 0 to `n - 1`.
    pub(crate) v: Vec<Integer>,
    /// `z^2`, degrees 0 to `n - 2`; empty where it is not needed.
    pub(crate) square: Vec<Integer>,
    /// `z^e + u v`, degrees 0 to `n - 2`.
    pub(crate) force: Vec<Integer>,
    /// The damping.
    pub(crate) u: Integer,
    /// Bound of its error.
    pub(crate) u_error: Ball,
}

impl TimeSeries {
    /// Solves the equation of motion degree by degree up to `order`; each division truncates.
    ///
    /// `z^2` is off by less than two units, as is `z^m f` before the division.
    pub(crate) fn solve(
        chart: &TimeChart,
        equation: &Equation,
        from: &FixedPoint,
        pace: &Pace,
        order: usize,
    ) -> Self {
        let bits = equation.prec;
        let mut u_error = crate::fixed::zero();
        let u = to_fixed(&equation.u, bits, &mut u_error);
        let (mut s, mut squares, mut products) = (
            Self {
                z: vec![from.z.clone()],
                v: vec![from.v.clone()],
                square: vec![],
                force: vec![],
                u,
                u_error,
            },
            Online::rounded(order, bits),
            Online::rounded(order, bits),
        );
        for k in 0..order {
            let degree = Integer::from(k + 1) << 40u32;
            s.z.push(Integer::from(&pace.in_z * &s.v[k]) / &degree);
            if k + 2 > order {
                break;
            }
            if chart.outer == 2 || chart.inner == 2 {
                let next = complete(squares.square(&s.z[..k]), &s.z, &s.z, k);
                s.square.push(next >> bits);
            }
            let elastic = if chart.inner == 2 { &s.square[k] } else { &s.z[k] };
            let damping = Integer::from(&s.u * &s.v[k]) >> bits;
            s.force.push(damping + elastic);
            let pull = match chart.outer {
                0 => Integer::from(&s.force[k] << bits),
                1 => complete(products.product(&s.z[..k], &s.force[..k]), &s.z, &s.force, k),
                _ => complete(products.product(&s.square[..k], &s.force[..k]), &s.square, &s.force, k),
            };
            s.v.push(-(pull * &pace.in_v) / (degree << bits));
        }
        s
    }

    /// The point at the end.
    pub(crate) fn end(&self) -> FixedPoint {
        FixedPoint { z: self.z.iter().sum(), v: self.v.iter().sum() }
    }
}

/// Adds the products with the first coefficients, which the sum over `0 < i < k` leaves out.
fn complete(inner: Integer, x: &[Integer], y: &[Integer], k: usize) -> Integer {
    let first = inner + &x[0] * &y[k];
    if k == 0 { first } else { first + &x[k] * &y[0] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_low_powers_are_multiplied_out() {
        for (law, is) in
            [("3/2,1/2", true), ("2,1", true), ("3/2,1", false), ("3,1/2", false), ("7/3,5/6", false)]
        {
            let equation = Equation::new(&law.parse().unwrap(), &Ball::from_integer(1, 64), 64);
            assert_eq!(TimeChart::of(&equation).is_some(), is, "{law}");
        }
    }
}
