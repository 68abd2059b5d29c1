//! What steps around the turning point leave over of the equation of motion, from the equation alone.

use super::*;
use crate::polynomial::{at, derivative, integral, number, of_integers, plus, scaled, times};

/// `Int |(1 + v K) p' + h v| + Int |v (K - K(p)) p'|` of the polynomials `p` and `K`, in units of `2^scale`.
fn left_over(equation: &Equation, problem: &Problem, series: &Series, u: &Float) -> f64 {
    let bits = i64::from(equation.prec);
    let (p, ratio) = (of_integers(&series.y, -bits), of_integers(&series.ratio, -bits));
    let unit = |n: i64| number(1) << i32::try_from(n).unwrap();
    let small = unit(-problem.velocity_scale);
    let v =
        vec![number(&problem.start_v) * &small, (number(&problem.end_v) - number(&problem.start_v)) * &small];
    let force = plus(&vec![number(1)], &times(&v, &ratio));
    let right = scaled(&v, &(number(&v[1]) * unit(2 * problem.velocity_scale - problem.scale)));
    let moved = derivative(&p);
    let in_motion = integral(&plus(&times(&force, &moved), &right));
    let float = |x: &BigRational| number(Ball::from_rational(x, crate::polynomial::BITS).mid());
    let (c, step) = (float(&exponent(equation)), float(&equation.law.elastic_step()));
    let parts = 16;
    let in_ratio = (0..parts).map(|i| {
        let theta = number(2 * i + 1) / (2 * parts);
        let y = number(&step * at(&p, &theta)) * unit(problem.scale);
        let true_ratio = (-(y.ln() * &c)).exp() * u * unit(problem.velocity_scale);
        (at(&v, &theta) * (at(&ratio, &theta) - true_ratio) * at(&moved, &theta)).abs().to_f64()
    });
    in_motion + in_ratio.sum::<f64>() / f64::from(parts)
}

/// Steps of few degrees and of many, before, through and after the turning point, with a damping that is not exact.
#[test]
fn the_defect_is_counted() {
    // A law, the damping and the binary logarithm of its width, from where and how fast, bits.
    let cases = [
        ("3/2,1/2", 0.5, 0, 0.4, 0.5, 64),
        ("3/2,1/2", 0.5, -62, 0.4, -0.5, 70),
        ("3/2,1/2", 100.0, 0, 0.01, 0.25, 90),
        ("3/2,1/2", 1e-6, 0, 0.5, 0.125, 100),
        ("1,0", 1.5, 0, 0.25, -0.25, 64),
        ("1/2,3/2", 2.0, 0, 0.25, 0.25, 80),
        ("1/2,3/2", 2.0, -66, 0.25, -0.125, 80),
        ("1,1", 3.0, 0, 0.25, 0.25, 64),
        ("3,-9/10", 0.25, 0, 0.1, 0.5, 100),
        ("9/4,2", 1.0, 0, 0.25, 0.0, 64),
        ("1/8,9/5", 5.0, -70, 0.25, -0.05, 80),
    ];
    let mut closest = [0.0_f64; 2];
    for (law, u, wide, y, v, bits) in cases {
        for order in [6, 13, 38, 70] {
            let mut damping = Ball::from_f64(u, bits);
            if wide != 0 {
                damping.widen(&(Float::with_val(64, 1) << wide));
            }
            let equation = Equation { order, ..Equation::new(&law.parse().unwrap(), &damping, bits) };
            let (y, v) = (Float::with_val(bits, y), Float::with_val(bits, v));
            let from = TurningPoint { v: v.clone(), y, spread: zero(), energy: zero() };
            let (mut proved, mut length) = (0, 0.5);
            for _ in 0..60 {
                let target = Float::with_val(bits, &v - length);
                let end = crate::stepper::rounded_to_step(&target, length);
                length *= 0.7;
                let step = Problem::pose(&equation, &from, &end).and_then(|problem| {
                    let series = problem.solve(&equation)?;
                    let range = Range::of(&equation, &problem, &series, -6)?;
                    let counted = defect(&equation, &problem, &series, &range)?.0.to_f64();
                    Some((problem, series, counted))
                });
                let Some((problem, series, counted)) = step else { continue };
                proved += 1;
                let middle = number(damping.mid());
                for u in [number(&middle - damping.rad()), number(&middle + damping.rad()), middle] {
                    let left = left_over(&equation, &problem, &series, &u);
                    assert!(left <= counted, "{law} {order} {v} to {end}: {left:e} beyond {counted:e}");
                    let many = usize::from(order >= 38);
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
