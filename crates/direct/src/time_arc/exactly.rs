//! What steps in time leave over of the equation of motion, from the equation alone.

use super::*;
use crate::polynomial::{
    Polynomial, derivative, integral, norm, number, of_integers, plus, power, scaled, times,
};

/// `h delta = q dz/dtheta - h v` and `D = dv/dtheta + h z^m (z^e + u v)`.
fn left_over(arc: &TimeArc, u: &Float) -> [Polynomial; 2] {
    let bits = i64::from(arc.equation.prec);
    let (z, v) = (of_integers(&arc.series.z, -bits), of_integers(&arc.series.v, -bits));
    let q = number(Ball::from_rational(&arc.equation.coordinate.q, crate::polynomial::BITS).mid());
    let length = number(arc.length.mid());
    let in_z = plus(&scaled(&derivative(&z), &q), &scaled(&v, &-length.clone()));
    let force = plus(&power(&z, arc.chart.inner), &scaled(&v, u));
    let in_v = plus(&derivative(&v), &scaled(&times(&power(&z, arc.chart.outer), &force), &length));
    [in_z, in_v]
}

/// Steps of few degrees and of many, at contact, in between, at the turning point and on the way out, with a damping that is not exact.
#[test]
fn the_defect_exceeds_what_is_left_over() {
    let mut closest = [0.0_f64; 4];
    for law in ["1,0", "2,0", "2,1", "3,2", "3/2,1/2", "1/2,0"] {
        for (u, wide, z, v, bits) in [
            (0.5, 0, 0.0, 1.0, 64),
            (2.0, -66, 0.5, 0.5, 80),
            (0.25, 0, 0.75, -0.5, 100),
            (7.0, -80, 0.25, 0.01, 90),
        ] {
            let mut damping = Ball::from_f64(u, bits);
            if wide != 0 {
                damping.widen(&(Float::with_val(64, 1) << wide));
            }
            let equation = Equation::new(&law.parse().unwrap(), &damping, bits);
            let chart = TimeChart::of(&equation).unwrap();
            let fixed = |x: f64| Integer::from_f64(x * f64::from(bits).exp2()).unwrap();
            let from = FixedPoint { z: fixed(z), v: fixed(v) };
            for order in [6, 13, 40, 80] {
                let (mut proved, mut length) = (0, 1.0);
                for _ in 0..60 {
                    let arc = TimeArc::expand(&equation, &chart, &from, &chart.pace(length), order);
                    length *= 0.7;
                    let Some(defect) = arc.defect() else { continue };
                    proved += 1;
                    let middle = number(damping.mid());
                    for u in [number(&middle - damping.rad()), number(&middle + damping.rad()), middle] {
                        let [in_z, in_v] = left_over(&arc, &u);
                        let left = [
                            integral(&in_z),
                            norm(&in_z) / arc.length.to_f64(),
                            integral(&in_v),
                            norm(&in_v),
                        ];
                        let counted = [&defect.in_z, &defect.most_in_z, &defect.in_v, &defect.most_in_v];
                        for ((left, counted), closest) in left.iter().zip(counted).zip(&mut closest) {
                            let part = left / counted.to_f64();
                            assert!(part <= 1.0, "{law} {u} {order} {length}: {left:e} beyond {counted:?}");
                            *closest = closest.max(part);
                        }
                    }
                    if proved == 3 {
                        break;
                    }
                }
                assert!(proved == 3, "{law} {order}");
            }
        }
    }
    assert!(closest.iter().all(|&c| c > 0.05), "{closest:?}");
}
