use super::*;
use crate::time_series::Pace;

const BITS: u32 = 48;

fn equation(law: &str) -> Equation {
    Equation::new(&law.parse().unwrap(), &Ball::from_ratio(1, 2, BITS), BITS)
}

fn bound(x: f64) -> Ball {
    Ball::from_f64(x, BOUND_BITS)
}

/// `first 2^(-fall k)` with changing signs, in units of `2^-bits`.
fn falling(count: u32, first: f64, fall: u32) -> Vec<Integer> {
    let first = Integer::from_f64(first * f64::from(BITS).exp2()).unwrap();
    (0..count).map(|k| Integer::from(&first >> (fall * k)) * if k % 2 == 0 { 1 } else { -1 }).collect()
}

/// A step by hand: six degrees, of which the last are some units.
struct Hand {
    equation: Equation,
    chart: TimeChart,
    series: TimeSeries,
    length: f64,
}

impl Hand {
    fn of(law: &str) -> Self {
        let equation = equation(law);
        let chart = TimeChart::of(&equation).unwrap();
        let square = if chart.inner == 2 || chart.outer == 2 { falling(5, 0.7, 9) } else { vec![] };
        let series = TimeSeries {
            z: falling(7, 0.875, 9),
            v: falling(6, 0.625, 9),
            square,
            force: falling(5, 0.5, 9),
            u: Integer::from(1) << (BITS - 1),
            u_error: bound(1.5 * f64::exp2(-41.0)),
        };
        Self { equation, chart, series, length: 0.75 }
    }

    fn defect(&self) -> Option<Defect> {
        let Self { equation, chart, series, length } = self;
        let series = TimeSeries {
            z: series.z.clone(),
            v: series.v.clone(),
            square: series.square.clone(),
            force: series.force.clone(),
            u: series.u.clone(),
            u_error: series.u_error.clone(),
        };
        TimeArc { equation, chart, series, length: bound(*length), ranges: vec![] }.defect()
    }
}

#[test]
fn small_coefficients_at_the_end_are_taken_together() {
    let of = |bits: &[u32]| head(&bits.iter().map(|b| (Integer::from(1) << *b) - 1).collect::<Vec<_>>(), 100);
    assert_eq!([of(&[60, 51, 52, 51, 40]), of(&[90, 51]), of(&[1, 1, 1]), of(&[60, 60])], [3, 1, 1, 2]);
}

fn norm(c: &[Integer]) -> f64 {
    c.iter().map(|c| c.to_f64().abs()).sum::<f64>() * (-f64::from(BITS)).exp2()
}

/// Laws with `m = B - 1` and `e = A - B` of every kind that is followed in time, and their `q`.
const LAWS: [(&str, u32, u32, f64); 5] =
    [("1,0", 0, 1, 1.0), ("2,0", 0, 2, 1.0), ("2,1", 1, 1, 1.0), ("3,2", 2, 1, 1.0), ("3/2,1/2", 2, 2, 2.0)];

/// Prop. 9 counted: a unit of every division and of `u v`, two of `z^2` and of `z^m f`, and what lies beyond the degrees.
#[test]
fn what_a_step_leaves_over_is_counted() {
    for (law, m, e, q) in LAWS {
        for u_error in [1.5 * f64::exp2(-41.0), 0.01] {
            let mut hand = Hand::of(law);
            hand.series.u_error = bound(u_error);
            let s = &hand.series;
            assert_eq!((hand.chart.outer, hand.chart.inner), (m, e));
            let (n, unit, h) = (6.0, (-f64::from(BITS)).exp2(), hand.length);
            let envelope = Envelope::tightest(&s.z, BITS);
            let square_cut =
                beyond(envelope, envelope, 5, 6).to_f64() + 2.0 * norm(&s.z[..1]) * norm(&s.z[5..]);
            let in_square = 2.0 * n * unit + square_cut;
            let in_elastic = if e == 2 { in_square } else { norm(&s.z[5..]) };
            let in_force = in_elastic + n * unit + (0.5 + u_error) * norm(&s.v[5..]) + u_error * norm(&s.v);
            let (outer, in_outer, cut) = match m {
                0 => (1.0, 0.0, 0.0),
                1 => (norm(&s.z), 0.0, product_cut(&s.z, &s.force, BITS).to_f64()),
                _ => (norm(&s.square), in_square, product_cut(&s.square, &s.force, BITS).to_f64()),
            };
            let force = norm(&s.force);
            let left = h * (cut + 2.0 * n * unit + outer * in_force + force * in_outer + in_outer * in_force);
            let defect = hand.defect().expect("little is cut off");
            for (found, wanted) in [
                (&defect.in_z, q * n * unit),
                (&defect.in_v, n * unit + left),
                (&defect.most_in_z, q * n * n * unit / h),
                (&defect.most_in_v, n * n * unit + left),
                (&defect.pull, (outer + in_outer) * (force + in_force)),
            ] {
                assert!((found.to_f64() / wanted - 1.0).abs() < 1e-14, "{law}: {found:?} {wanted:e}");
            }
        }
    }
}

#[test]
fn a_step_that_cuts_off_too_much_is_refused() {
    type Coefficient = fn(&mut TimeSeries) -> &mut Integer;
    // z^2, u v and z f each alone.
    let cases: [(&str, Coefficient); 3] =
        [("2,0", |s| &mut s.z[6]), ("1,0", |s| &mut s.v[5]), ("2,1", |s| &mut s.force[4])];
    for (law, coefficient) in cases {
        let mut hand = Hand::of(law);
        assert!(hand.defect().is_some(), "{law}");
        *coefficient(&mut hand.series) = Integer::from(1) << (BITS - 8);
        assert!(hand.defect().is_none(), "{law}");
    }
}

/// The products beyond those of a force's degrees, summed, are held by their bound.
#[test]
fn what_a_product_cuts_off_is_bounded() {
    for (first, fall) in [(0.75, 3), (0.9, 6)] {
        for count in [5, 7] {
            let (x, force) = (falling(count, first, fall), falling(5, 0.8, fall));
            let mut cut = Integer::new();
            for (i, x) in x.iter().enumerate() {
                for (j, y) in force.iter().enumerate() {
                    if i + j >= force.len() {
                        cut += Integer::from(x * y).abs();
                    }
                }
            }
            let truth = cut.to_f64() * (-2.0 * f64::from(BITS)).exp2();
            let bound = product_cut(&x, &force, BITS).to_f64();
            assert!(truth <= bound && bound < 40.0 * truth, "{first} {fall} {count}: {truth:e} {bound:e}");
        }
    }
}

#[test]
fn what_a_product_with_the_constant_cuts_off_is_bounded() {
    let unit = Integer::from(1) << (BITS - 4);
    let x: Vec<Integer> = [9, 0, 0, 0, 0, 2, -1].map(|c| Integer::from(&unit * c)).to_vec();
    let force: Vec<Integer> =
        vec![Integer::from(&unit * 8), Integer::from(1), Integer::new(), Integer::new(), Integer::new()];
    let bound = product_cut(&x, &force, BITS).to_f64();
    let truth = 3.0 / 16.0 * 0.5;
    assert!(truth <= bound && bound < 1.1 * truth, "{bound}");
}

#[test]
fn a_velocity_that_is_rounded_costs_energy() {
    let from =
        PhasePoint { z: Float::with_val(80, 1), v: Float::with_val(80, -1.3125), energy: bound(0.001) };
    let point = rounded(from, 4);
    assert_eq!(point.v, -1.25);
    let wanted = 0.001 + 1.3125 * 1.3125 - 1.25 * 1.25;
    assert!((point.energy.to_f64() / wanted - 1.0).abs() < 1e-14, "{point:?}");
}

/// A proof by hand for ranges of `z` and `v`.
fn arc<'a>(hand: &'a Hand, ranges: &[[f64; 4]]) -> TimeArc<'a> {
    let between = |low: f64, high: f64| {
        Ball::between(&Float::with_val(64, low), &Float::with_val(64, high), BOUND_BITS)
    };
    let ranges = ranges.iter().map(|[a, b, c, d]| (between(*a, *b), between(*c, *d))).collect();
    let none = || vec![];
    let (u, u_error) = (Integer::new(), zero());
    let series = TimeSeries { z: none(), v: none(), square: none(), force: none(), u, u_error };
    TimeArc { equation: &hand.equation, chart: &hand.chart, series, length: bound(0.25), ranges }
}

fn defect([in_z, in_v, most_in_z, most_in_v, pull]: [f64; 5]) -> Defect {
    let [in_z, in_v, most_in_z] = [in_z, in_v, most_in_z].map(bound);
    Defect { in_z, in_v, most_in_z, most_in_v: bound(most_in_v), pull: bound(pull) }
}

fn point(z: f64, v: f64, energy: f64) -> PhasePoint {
    PhasePoint { z: Float::with_val(BITS, z), v: Float::with_val(BITS, v), energy: bound(energy) }
}

#[test]
fn without_a_turning_point_the_speed_must_exceed_its_error() {
    let hand = Hand::of("3/2,1/2");
    for sign in [1.0, -1.0] {
        let speeds = |low: f64, high: f64| if sign > 0.0 { [low, high] } else { [-high, -low] };
        let ranges = [speeds(0.5, 0.75), speeds(0.625, 1.75)].map(|[c, d]| [0.25, 0.5, c, d]);
        let arc = arc(&hand, &ranges);
        let along = |energy: f64, d: [f64; 5]| arc.along(&point(0.25, sign, energy), &defect(d));
        // The energy and 2 (Int |h delta| |z^m f| + |v| |D|).
        let energy = along(0.01, [0.02, 0.01, 0.3, 0.3, 1.5]).expect("room").to_f64();
        let wanted = 0.01 + 2.0 * (0.02 * 1.5 + 1.75 * 0.01);
        assert!((energy / wanted - 1.0).abs() < 1e-12, "{energy}");
        // Below the square of the least speed, 1/4, with |delta| below it.
        assert!(along(0.249, [0.0, 0.0, 0.49, 9.0, 1.0]).is_some());
        for energy in [0.251, 0.4, 0.9, 1.1, 4.0] {
            assert!(along(energy, [0.0, 0.0, 0.49, 9.0, 1.0]).is_none(), "{energy}");
        }
        for most in [0.501, 0.9, 2.0] {
            assert!(along(0.249, [0.0, 0.0, most, 9.0, 1.0]).is_none(), "{most}");
        }
    }
}

#[test]
fn through_the_turning_point_the_velocity_falls_and_the_force_is_bounded() {
    // Spheres, u = 1/2: y = (2/5) z^5, K = u/z^2; the second part is the lowest and has the least force.
    let hand = Hand::of("3/2,1/2");
    let turning = arc(&hand, &[[1.0, 1.0, 0.25, 0.5], [0.99, 0.99, -0.5, 0.25], [1.25, 1.25, 0.0, 0.25]]);
    let turn = |from: &PhasePoint, d: [f64; 5]| {
        let [z, v] = [1.0, -0.5].map(|x| Ball::from_f64(x, BITS));
        turning.turn(from, &defect(d), &z, &v)
    };
    let start = |energy: f64| point(1.0, 0.5, energy);
    let entered = |energy: f64| enter(&hand.equation, &start(energy)).unwrap().energy.to_f64();
    // The square of a ball ends at m^2 - 2 m r - r^2.
    let (m, r) = (0.99, 0.99 / 64.0);
    let force = 1.0 - 0.25 / (m * m - 2.0 * m * r - r * r);
    let room = 0.4 * f64::powi(0.99, 5) / 64.0 * force;
    // Int of (|delta| (h |z^m f| + |D|) + (|v| + |delta|) |D|), over the force; v^2 moves by twice that of y at most.
    let found = turn(&start(1e-4), [1e-4, 2e-4, 0.25, 0.125, 2.0]).expect("room").energy.to_f64();
    let energy = entered(1e-4) + 1e-4 * (2.0 + 0.125 / 0.25) + (0.5 + 0.25) * 2e-4;
    assert!((found / (2.0 * energy / force) - 1.0).abs() < 1e-6, "{found} {energy}");
    // The energy stays below that of the neighbourhood in which the bounds hold.
    let of = |energy: f64| [energy / 2.0, 0.0, 0.25, 0.125, 1.5];
    assert!(turn(&start(0.0), of(0.999 * room)).is_some());
    for beyond in [1.001 * room, 2.0 * room, 0.1, 0.3, 0.9, 2.0] {
        assert!(turn(&start(0.0), of(beyond)).is_none(), "{beyond}");
    }
    // h z^m f > |D|
    let falls = 0.25 * f64::powi(0.99, 2) * (f64::powi(0.99, 2) - 0.25);
    assert!(turn(&start(0.0), [0.0, 0.0, 0.0, 0.999 * falls, 1.0]).is_some());
    for beyond in [1.001 * falls, 0.2, 0.23, 0.3, 0.9, 2.0] {
        assert!(turn(&start(0.0), [0.0, 0.0, 0.0, beyond, 1.0]).is_none(), "{beyond}");
    }
    // 1 + v K > 0 in the neighbourhood, not only on the way.
    for (v, holds) in [(-1.9, true), (-1.95, false)] {
        let arc = arc(&hand, &[[1.0, 1.0, v, 0.5]]);
        let [z, v] = [1.0, v].map(|x| Ball::from_f64(x, BITS));
        let found = arc.turn(&start(0.0), &defect([0.0, 0.0, 0.0, 0.0, 1.0]), &z, &v);
        assert_eq!(found.is_some(), holds, "{v:?}");
    }
}

#[test]
fn the_point_reached_is_the_end_of_the_polynomials() {
    let bits = 200;
    let equation = Equation::new(&"3/2,1/2".parse().unwrap(), &Ball::from_ratio(1, 2, bits), bits);
    let chart = TimeChart::of(&equation).unwrap();
    let from = FixedPoint { z: Integer::new(), v: Integer::from(1) << bits };
    let start = PhasePoint { z: Float::new(bits), v: Float::with_val(bits, 1), energy: zero() };
    let pace: Pace = chart.pace(0.5);
    let arc = TimeArc::expand(&equation, &chart, &from, &pace, 120);
    let step = arc.prove(&start).expect("a short step");
    assert_eq!(from_fixed(&step.end.z, bits, 2 * bits).mid(), &step.reached.z);
    let (end, v) = (from_fixed(&step.end.v, bits, 2 * bits), Ball::exact(step.reached.v.clone()));
    let off = (&end * &end - &v * &v).abs_up();
    assert!(off <= step.reached.energy.upper() && step.reached.energy.upper() < Float::with_val(9, 1e-50));
}
