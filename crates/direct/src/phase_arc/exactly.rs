//! What arcs leave over of the equation of motion, from the equation alone: a term that a bound forgot would show.

use super::*;
use crate::polynomial::{Polynomial, derivative, integral, number, of_integers, plus, power, scaled, times};
use num_rational::BigRational;
use num_traits::ToPrimitive;

fn float(x: &BigRational) -> Float {
    number(Ball::from_rational(x, crate::polynomial::BITS).mid())
}

/// `z^(n-1) dz/dtheta` on the way of the arc.
fn side(equation: &Equation, arc: &PhaseArc, n: &BigRational) -> Polynomial {
    let (start, end) = (number(&arc.start), number(&arc.end));
    if equation.coordinate.crosses_zero() {
        let length = number(&end - &start);
        let n = n.to_integer().to_u32().unwrap();
        return scaled(&power(&vec![start, length.clone()], n - 1), &length);
    }
    let length = number(&end / &start).ln();
    let rate = float(n) * &length;
    let mut term = (start.ln() * float(n)).exp() * length;
    let mut out = vec![term.clone()];
    for k in 1..arc.coefficients.len() as u32 + 90 {
        term = term * &rate / k;
        out.push(term.clone());
    }
    out
}

/// `2 Int |d|` with `P P' = -(elastic + u damping P) + d`.
fn defect(equation: &Equation, arc: &PhaseArc, u: &Float) -> f64 {
    let p = of_integers(&arc.coefficients, arc.scale - i64::from(arc.bits));
    let q = float(&equation.coordinate.q);
    let elastic = scaled(&side(equation, arc, &equation.coordinate.elastic), &q);
    let damping = scaled(&side(equation, arc, &equation.coordinate.damping), &number(&q * u));
    2.0 * integral(&plus(&times(&p, &derivative(&p)), &plus(&elastic, &times(&damping, &p))))
}

/// Steps of few degrees, where all is cut off, and of many, where all is rounding; straight ones and those in `ln z`, from and to
/// contact, along the slow manifold, with a damping that is not exact.
#[test]
fn the_energy_exceeds_the_defect() {
    // A law, the damping and the binary logarithm of its width, from where and how fast, forth or back, bits.
    let cases = [
        ("3/2,1/2", 0.5, 0, 0.0, 1.0, 1.0, 80),
        ("3/2,1/2", 0.5, 0, 0.75, -0.5, -1.0, 64),
        ("3/2,1/2", 2.0, -70, 0.5, 0.75, 1.0, 90),
        ("3/2,1/2", 1000.0, 0, 0.5, -0.00025, -1.0, 70),
        ("1,1", 2000.0, 0, 0.5, -0.0005, -1.0, 137),
        ("1,0", 1.0, -90, 0.25, -0.75, -1.0, 100),
        ("5,4", 1.0, 0, 0.5, 0.875, 1.0, 64),
        ("1/2,3/2", 3.0, 0, 0.25, -0.5, -1.0, 64),
        ("13/11,1/11", 1.0, 0, 0.125, 0.9, 1.0, 64),
        ("3/4,3/5", 0.5, 0, 0.001, 0.9, 1.0, 64),
        ("3/4,3/5", 100.0, -75, 0.5, -0.5, -1.0, 80),
        ("33/100,-6/25", 1.0, 0, 1e-9, -0.5, -1.0, 100),
        ("1001/1000,1/1000", 300.0, 0, 0.125, -0.0005, -1.0, 90),
        ("1/8,9/5", 5.0, 0, 0.5, -0.5, -1.0, 64),
    ];
    let mut closest = [0.0_f64; 2];
    for (law, u, wide, z, v, way, bits) in cases {
        for order in [13, 38, 70] {
            let mut damping = Ball::from_f64(u, bits);
            if wide != 0 {
                damping.widen(&(Float::with_val(64, 1) << wide));
            }
            let equation = Equation { order, ..Equation::new(&law.parse().unwrap(), &damping, bits) };
            let from =
                PhasePoint { z: Float::with_val(bits, z), v: Float::with_val(bits, v), energy: zero() };
            let mut proved = 0;
            let mut length: f64 = if equation.coordinate.crosses_zero() && way < 0.0 { z } else { 4.0 };
            for _ in 0..60 {
                let mut end = equation.coordinate.advance(&from.z, way * length);
                end = end.max(&Float::new(bits));
                length *= 0.7;
                let Some(arc) = PhaseArc::follow(&equation, &from, &end) else { continue };
                proved += 1;
                let middle = number(damping.mid());
                for u in [number(&middle - damping.rad()), number(&middle + damping.rad()), middle] {
                    let (left, counted) = (defect(&equation, &arc, &u), arc.energy.to_f64());
                    assert!(left <= counted, "{law} {order} {z} to {end}: {left:e} beyond {counted:e}");
                    let many = usize::from(order > 38);
                    closest[many] = closest[many].max(left / counted);
                }
                if proved == 3 {
                    break;
                }
            }
            assert!(proved == 3, "{law} {order}");
        }
    }
    assert!(closest.iter().all(|&c| c > 0.05), "{closest:?}");
}
