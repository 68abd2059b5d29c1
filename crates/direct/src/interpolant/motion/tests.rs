use super::super::{Dampings, Variable};
use super::*;
use crate::collision::Collision;

/// The motions of a law with `u` around 1/2, of three columns.
fn motion(law: &str) -> Motion {
    let collision = Collision::new(&law.parse().unwrap(), End::ZeroCompression).unwrap();
    let [from, to] = [31, 33].map(|n: i64| BigRational::new(n.into(), 64.into()));
    collision.motion(&Dampings::of(&from, &to, Variable::Damping, 96), 3, 64).unwrap()
}

fn bound(x: f64) -> Ball {
    Ball::from_f64(x, BOUND_BITS)
}

fn range(low: f64, high: f64) -> Range {
    Range { low: bound(low), high: bound(high) }
}

/// A jet of three numbers in units of `2^-96`.
fn jet(c: [f64; 3]) -> Vec<Integer> {
    c.map(|c| Integer::from_f64(c * f64::exp2(96.0)).unwrap()).to_vec()
}

fn near(found: &Ball, wanted: f64) {
    assert!((found.to_f64() / wanted - 1.0).abs() < 1e-12, "{found:?} {wanted:e}");
}

/// A course of which only the bounds count.
fn course(place: Range, speed: Range, defect: f64, largest: f64, length: f64) -> Course {
    let nothing = || Jets::constant(&jet([0.0; 3]), 96);
    Course {
        coordinate: nothing(),
        velocity: nothing(),
        balance: nothing(),
        balance_error: zero(),
        place,
        speed,
        largest_defect: bound(largest),
        defect: bound(defect),
        cut_off: zero(),
        length: bound(length),
    }
}

fn state(z: [f64; 3], v: [f64; 3], energy: f64, measure: Measure) -> State {
    State { z: jet(z), v: jet(v), energy: bound(energy), measure }
}

fn at(energy: f64) -> State {
    state([1.0, 0.0, 0.0], [1.0, 0.0, 0.0], energy, Measure::Speed)
}

#[test]
fn little_may_be_cut_off() {
    let part = f64::exp2(-52.0);
    assert!([0.0, 0.5, 1.0].iter().all(|x| is_little(&Ball::from_f64(x * part, BOUND_BITS), 60)));
    assert!([1.001, 2.0, 1e9].iter().all(|x| !is_little(&Ball::from_f64(x * part, BOUND_BITS), 60)));
    assert!(!is_little(&Ball::whole_line(BOUND_BITS), 60));
}

#[test]
fn the_energy_by_speed_shrinks_but_for_the_defect() {
    let motion = motion("3/2,1/2");
    for signs in [1.0, -1.0] {
        let speed = if signs > 0.0 { range(0.5, 0.75) } else { range(-0.75, -0.5) };
        let course = course(range(0.5, 0.625), speed, 0.01, 1.0, 0.25);
        // v is c v here: energies c^2 of what they were; 4 (|v| + m) m for what the start misses, 2 max|v| Int|D|.
        let found = motion.by_speed(&at(0.02), &course, &range(0.875, 1.25), &bound(0.003));
        let (all_along, end) = found.expect("room");
        let start = 0.02 * 1.25 * 1.25 + 4.0 * 0.753 * 0.003;
        let grown = 2.0 * 0.75 * 0.01;
        near(&all_along, start + grown);
        let rate = 0.8 * (31.0 / 64.0) * 0.875 * 0.5 * 0.5 * 0.25;
        near(&end, start * f64::exp(-rate) + grown);
        // The energy stays below the square of the least speed.
        let even = range(1.0, 1.0);
        let limit = 0.25 - grown;
        assert!(motion.by_speed(&at(0.999 * limit), &course, &even, &zero()).is_some());
        for beyond in [1.001 * limit, 0.4, 0.9, 1.2, 5.0] {
            assert!(motion.by_speed(&at(beyond), &course, &even, &zero()).is_none(), "{beyond}");
        }
    }
    let turning = course(range(0.5, 0.625), range(-0.1, 0.75), 0.01, 1.0, 0.25);
    assert!(motion.by_speed(&at(0.0), &turning, &range(1.0, 1.0), &zero()).is_none());
    // From z = 0 on nothing is known to be kept.
    let first = course(range(-0.1, 0.625), range(0.5, 0.75), 0.01, 1.0, 0.25);
    let (_, end) = motion.by_speed(&at(0.02), &first, &range(1.0, 1.0), &zero()).unwrap();
    near(&end, 0.02 + 2.0 * 0.75 * 0.01);
}

/// `K = u z^(B-A)`, also where it grows with `z`, and the room that a 64th of `z` leaves for `y = z^A/(a+1)`.
#[test]
fn the_force_is_bounded_in_a_neighbourhood() {
    for (law, a, power, step) in [("3/2,1/2", 5, -2, 2.5), ("1/2,3/2", 3, 2, 1.5)] {
        let motion = motion(law);
        let force = motion.force(&range(0.75, 1.5), &range(-0.25, 0.375), &bound(0.125)).unwrap();
        let (low, high) = (0.75 * (1.0 - 1.0 / 64.0), 1.5 * (1.0 + 1.0 / 64.0));
        let ratio = 33.0 / 64.0 * f64::max(f64::powi(low, power), f64::powi(high, power));
        near(&force.ratio, ratio);
        near(&force.greatest, 1.0 + 0.5 * ratio);
        near(&force.room, f64::powi(0.75, a) / step / 64.0);
        let inward = motion.force(&range(0.75, 1.5), &range(0.25, 0.375), &bound(0.125)).unwrap();
        near(&inward.least, 1.0 - 0.125 * ratio);
        // 1 + v K > 0
        let limit = 1.0 / ratio;
        let least = |v: f64| motion.force(&range(0.75, 1.5), &range(-v, 0.375), &bound(0.125 * limit));
        near(&least(0.5 * limit).unwrap().least, 0.375);
        assert!(least(0.874 * limit).is_some() && least(0.876 * limit).is_none());
        assert!(motion.force(&range(-0.1, 1.5), &range(0.25, 0.375), &zero()).is_none());
        assert!(motion.force(&range(0.0, 1.5), &range(0.25, 0.375), &zero()).is_none());
    }
}

#[test]
fn the_energy_by_force_stays_in_its_neighbourhood() {
    let motion = motion("3/2,1/2");
    let (place, speed) = (|| range(0.75, 1.5), || range(-0.25, 0.125));
    let from = |energy: f64| state([1.0, 0.0, 0.0], [0.1, 0.0, 0.0], energy, Measure::Force);
    let missed = 1e-4;
    let force = motion.force(&place(), &speed(), &bound(missed)).unwrap();
    let (ratio, room, least) = (force.ratio.to_f64(), force.room.to_f64(), force.least.to_f64());
    let by_force = |energy: f64, defect: f64, largest: f64, missed: f64| {
        let course = course(place(), speed(), defect, largest, 0.25);
        motion.by_force(&from(energy), &course, &bound(missed))
    };
    // F(y, v) moves with v by |v| and by K |y - Y|; max|v| Int|D|.
    let (energy, end) = by_force(1e-5, 2e-4, 1e-3, missed).expect("room");
    near(&energy, 1e-5 + missed * (0.25 + missed + ratio * room) + 0.25 * 2e-4);
    near(&end, energy.to_f64());
    let least_alone = motion.force(&place(), &speed(), &zero()).unwrap().least.to_f64();
    assert!(least_alone > least);
    let limit = room * least_alone;
    assert!(by_force(0.999 * limit, 0.0, 1e-3, 0.0).is_some());
    for beyond in [1.001 * limit, 2.0 * limit, 0.1, 0.6, 1.1] {
        assert!(by_force(beyond, 0.0, 1e-3, 0.0).is_none(), "{beyond}");
    }
    // h z^(A-1) (1 + v K) > |D|
    let falls = f64::powi(0.75, 4) * 0.25 * least_alone;
    assert!(by_force(1e-6, 0.0, 0.999 * falls, 0.0).is_some());
    for beyond in [1.001 * falls, 0.1, 0.3, 0.6, 1.5] {
        assert!(by_force(1e-6, 0.0, beyond, 0.0).is_none(), "{beyond}");
    }
}

/// Where a step ends at the turning point its velocity is 0, but what is cut off of it still moves the energy.
#[test]
fn a_velocity_that_is_replaced_costs_the_force_on_the_error() {
    near(&slack(&range(-0.25, 0.5), &zero(), &bound(0.125)), 4.0 * 0.625 * 0.125);
    let turning = range(-1e-9, 1e-9);
    near(&slack(&turning, &bound(0.01), &bound(1e-9)), (8e-9 + 0.01) * 1e-9);
    let force = motion("3/2,1/2").force(&range(0.75, 1.5), &turning, &zero()).unwrap();
    near(&force.pull(), force.ratio.to_f64() * force.room.to_f64());
}

#[test]
fn an_error_of_the_speed_becomes_one_of_the_force_and_back() {
    let motion = motion("3/2,1/2");
    // In: |v - V| <= energy/|v|, and dy/dv is v at most.
    let inward = |energy: f64| state([1.0, 0.0, 0.0], [0.5, 0.125, 0.0], energy, Measure::Speed);
    let by_force = motion.by_force_from(&inward(1e-4)).expect("room");
    let off = 1e-4 / 0.375;
    let spread = off * (0.625 + off);
    let force = motion.force(&range(1.0, 1.0), &range(0.375, 0.625), &bound(off)).unwrap();
    near(&by_force.energy, spread * force.greatest.to_f64());
    assert_eq!(by_force.measure, Measure::Force);
    // The spread stays in the room, 0.4/64.
    let energy = |spread: f64| 0.375 * ((0.625_f64.powi(2) / 4.0 + spread).sqrt() - 0.3125);
    assert!(motion.by_force_from(&inward(energy(0.999 * 0.4 / 64.0))).is_some());
    for beyond in [1.001 * 0.4 / 64.0, 0.0125, 0.03] {
        assert!(motion.by_force_from(&inward(energy(beyond))).is_none(), "{beyond}");
    }
    assert!(motion.by_force_from(&state([1.0, 0.0, 0.0], [0.1, 0.2, 0.0], 1e-9, Measure::Speed)).is_none());

    // Out: the energy over the force is the error of y, of which v^2 moves by twice as much at most.
    let outward = |v: f64, energy: f64| state([1.0, 0.0, 0.0], [v, -0.0625, 0.0], energy, Measure::Force);
    let least =
        |v: f64| motion.force(&range(1.0, 1.0), &range(v - 0.0625, v + 0.0625), &zero()).unwrap().least;
    let by_speed = motion.by_speed_from(&outward(-0.5, 1e-4)).expect("room");
    near(&by_speed.energy, 2.0 * 1e-4 / least(-0.5).to_f64());
    assert_eq!(by_speed.measure, Measure::Speed);
    // It is in the room, and 8 times it below the square of the least speed.
    for (v, limit) in [(-0.5, 0.4 / 64.0), (-0.1875, 0.125_f64.powi(2) / 8.0), (-1.125, 0.4 / 64.0)] {
        let of = |part: f64| motion.by_speed_from(&outward(v, part * limit * least(v).to_f64()));
        assert!(of(0.999).is_some(), "{v}");
        for beyond in [1.001, 1.5, 3.0, 7.0] {
            assert!(of(beyond).is_none(), "{v} {beyond}");
        }
    }
    assert!(motion.by_speed_from(&state([1.0, 0.0, 0.0], [0.5, 0.1, 0.0], 1e-9, Measure::Force)).is_none());
}

/// `v/c` for a jet of the pace, against the division at single places.
#[test]
fn a_velocity_in_common_time_is_off_by_what_is_said() {
    for (width, scale) in [(3, 1.0), (2, 0.5)] {
        let v = Jets::constant(&jet([-0.5, 0.125 * scale, 0.03125])[..width], 96);
        let pace = Jets::constant(&jet([1.0, 0.25, -0.125])[..width], 96);
        let paces = pace.range();
        let leg = Leg {
            course: course(range(0.5, 1.0), range(-1.0, -0.5), 0.0, 0.0, 1.0),
            reached: at(0.0),
            energy: zero(),
            pace: pace.clone(),
            paces,
        };
        let (quotient, lost) = leg.in_common_time(&v, 96).unwrap();
        let value = |jet: &Jets, d: f64| {
            let c = jet.row(0).iter().rev().map(|c| c.to_f64() * f64::exp2(-96.0));
            c.fold(0.0, |sum, c| sum * d + c)
        };
        let mut worst = 0.0_f64;
        for d in [-1.0, -0.5, 0.5, 1.0] {
            worst = worst.max((value(&v, d) / value(&pace, d) - value(&quotient, d)).abs());
        }
        let lost = lost.to_f64();
        assert!(worst <= lost && lost < 4.0 * worst && lost > 1e-3, "{width}: {worst} {lost}");
    }
}
